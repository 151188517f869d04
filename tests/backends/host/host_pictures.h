// SPDX-License-Identifier: MIT
// A host with pictures of its own in every kind of object.
#pragma once

#include "backends/gl/objects.h"
#include "tests/support/gl_fixture.h"

namespace crevice {

struct HostPictures : GlFixture {
    explicit HostPictures(const GlDeviceOptions& options = {}) : GlFixture(options) {}

    /// Left bound.
    GLuint newTexture(GLenum internal, Extent extent, GLsizei levels = 1)
    {
        const GLuint name = textures.emplace_back(GlTexture::make(gl)).name();
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexStorage2D(GL_TEXTURE_2D, levels, internal, extent.width, extent.height);
        return name;
    }

    GLuint newRenderbuffer(GLenum internal, Extent extent, int samples = 0)
    {
        const GLuint name = renderbuffers.emplace_back(GlRenderbuffer::make(gl)).name();
        gl.BindRenderbuffer(GL_RENDERBUFFER, name);
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, extent.width,
                                          extent.height);
        return name;
    }

    /// Left bound.
    GLuint newFramebuffer()
    {
        const GLuint name = framebuffers.emplace_back(GlFramebuffer::make(gl)).name();
        gl.BindFramebuffer(GL_FRAMEBUFFER, name);
        return name;
    }

    /// "" where an output is drawn there, else why not.
    std::string refusal(const HostFramebuffer& target)
    {
        if (!shown) shown = texture(Format::rgba8);
        return reasonOf(device->present(shown, target).diagnostics());
    }

    /// "" where the picture is adopted, else why not.
    std::string refusal(const HostTexture& host)
    {
        return reasonOf(device->adoptTexture(host).diagnostics());
    }

    std::string reasonOf(const Diagnostics& found)
    {
        CHECK(gl.GetError() == GL_NO_ERROR);
        if (found.empty()) return "";
        REQUIRE(found.size() == 1);
        CHECK(found[0].code == Code::bad_input);
        CHECK(!found[0].help.empty());
        return found[0].message;
    }

    TextureId shown;
    std::vector<GlTexture> textures;
    std::vector<GlRenderbuffer> renderbuffers;
    std::vector<GlFramebuffer> framebuffers;
};

}  // namespace crevice
