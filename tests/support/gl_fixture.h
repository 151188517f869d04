// SPDX-License-Identifier: MIT
// What GL tests share: the process's one context, a fresh device for each test, and short ways to
// draw and read.
#pragma once

#include <crevice/context.h>

#include "backends/gl/api.h"
#include "tests/support/need.h"

namespace crevice {

/// "egl" or "osmesa": what the environment variable CREVICE_BACKEND asks for.
std::string testBackend();

/// The context that the tests run in; made before the first test.
Context& testContext();

/// A vertex shader for drawFullscreen, with `uv` over the picture.
extern const char* const kFullscreenVertex;

/// A vertex shader for meshes whose positions are in clip space; passes `normal` and `uv` on.
extern const char* const kMeshVertex;

/// A stage whose driver messages point into the text "test.glsl".
GlslStage stage(const std::string& text);

/// Fragment shader text with version and precision before `body`.
std::string fragment(const std::string& body);

/// A pass over all of a framebuffer with `colors` attachments, all cleared to zero and stored.
PassInfo wholePass(FramebufferId framebuffer, Extent extent, int colors = 1);

/// A host's GL_DEPTH_COMPONENT32F texture with these window depths, to be deleted by the caller.
GLuint depthTexture(const GlApi& gl, Extent extent, const std::vector<float>& depths);

/// A triangle list of rectangles over the clip-space square [-1, 1] at depth `z`.
MeshDesc square(float z);

/// Two floors and a wall between them, as triangles without indices. Their numbers are exact in
/// every type that a host's vertices may have.
std::vector<Vertex> step();

class GlFixture {
public:
    explicit GlFixture(const GlDeviceOptions& options = {}, Context& context = testContext());
    ~GlFixture();

    TextureId texture(Format format, Extent extent = {4, 4}, const char* label = "texture");
    FramebufferId framebuffer(std::vector<TextureId> color, TextureId depth = {});
    ProgramId program(const std::string& fragment_body, const char* vertex = kFullscreenVertex);
    int location(ProgramId program, const std::string& uniform);

    /// A frame of one pass, in which `draw` is called; it must end without errors.
    template <class Draw>
    void drawPass(const PassInfo& pass, const Draw& draw)
    {
        need(device->beginFrame());
        device->beginPass(pass);
        draw();
        device->endPass();
        need(device->endFrame());
    }
    void clearPass(const PassInfo& pass)
    {
        drawPass(pass, [] {});
    }

    /// Draws a fullscreen pass of `program` into `target`; the frame must end without errors.
    void drawInto(TextureId target, ProgramId program, Extent extent = {4, 4});

    Image read(TextureId id) { return need(device->readTexture(id)); }

    std::unique_ptr<Device> device;
    GlApi gl;  ///< For what the host would do itself.
};

}  // namespace crevice
