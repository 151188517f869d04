// SPDX-License-Identifier: MIT
// A host that draws a scene by GL calls of its own: depth, and normals in its own view space.
#pragma once

#include "backends/gl/objects.h"
#include "tools/scene/scene.h"

namespace crevice {

class HostScene {
public:
    /// The table must outlive it. Nothing of a device takes part.
    HostScene(const GlApi& gl, const Scene& scene, Extent extent);

    /// Under the clip control of the context. `reversed` tests and clears depth the other way.
    void draw(const glm::dmat4& view_from_world, const glm::mat4& clip_from_view, bool reversed);

    GLuint depth() const { return depth_.name(); }    ///< Format::depth32f
    GLuint normal() const { return normal_.name(); }  ///< Format::rgba16f, n * 0.5 + 0.5
    Extent extent() const { return extent_; }

private:
    void uploadMeshes(const Scene& scene);
    GLuint compiled(GLenum type, const char* text);

    const GlApi& gl_;
    Extent extent_;
    GlTexture depth_, normal_;
    GlFramebuffer framebuffer_;
    GlBuffer vertices_, indices_;
    GlVertexArray array_;
    GlProgram program_;
    GLsizei count_ = 0;
};

}  // namespace crevice
