// SPDX-License-Identifier: MIT
// A host samples outputs in shaders of its own, by their native names.
#include "tests/backends/stage.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

namespace {

/// The host's own program, framebuffer and way to draw, without the library.
struct Host : GlFixture {
    Host()
    {
        program = gl.CreateProgram();
        attach(GL_VERTEX_SHADER, kFullscreenVertex);
        attach(GL_FRAGMENT_SHADER,
               fragment("uniform highp sampler2D seen;\n"
                        "in vec2 uv;\n"
                        "out highp uvec4 bits;\n"
                        "void main() { bits = floatBitsToUint(texture(seen, uv)); }"));
        gl.LinkProgram(program);
        GLint linked = 0;
        gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
        REQUIRE(linked);
        gl.GenVertexArrays(1, &vertex_array);
        gl.GenTextures(1, &target);
        gl.BindTexture(GL_TEXTURE_2D, target);
        gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32UI, 64, 64);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        gl.GenFramebuffers(1, &framebuffer_name);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_name);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    }

    ~Host()
    {
        gl.UseProgram(
            0);  // else it lives until another takes its place, and cannot be put back then
        gl.DeleteFramebuffers(1, &framebuffer_name);
        gl.DeleteTextures(1, &target);
        gl.DeleteVertexArrays(1, &vertex_array);
        gl.DeleteProgram(program);
    }

    void attach(GLenum kind, const std::string& text)
    {
        const GLuint shader = gl.CreateShader(kind);
        const char* source = text.c_str();
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }

    /// What the host's shader sees of the texture, as many channels as it has.
    std::vector<float> sampled(GLuint name, Extent extent, int channels)
    {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_name);
        gl.Viewport(0, 0, extent.width, extent.height);
        gl.UseProgram(program);
        gl.BindVertexArray(vertex_array);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<float> all(std::size_t{4} * extent.width * extent.height), wanted;
        gl.ReadPixels(0, 0, extent.width, extent.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                      all.data());
        for (std::size_t i = 0; i < all.size(); ++i)
            if (static_cast<int>(i % 4) < channels) wanted.push_back(all[i]);
        return wanted;
    }

    void checkSame(TextureId id)
    {
        const Image image = read(id);
        REQUIRE(device->nativeName(id) != 0);
        CHECK(sampled(device->nativeName(id), image.extent, image.channels) == image.pixels);
    }

    GLuint program = 0, vertex_array = 0, target = 0, framebuffer_name = 0;
};

}  // namespace

TEST_CASE_METHOD(Host, "A host's own shader sees of an output what is read back, frame after frame")
{
    Stage stage(*device);
    const std::string config = GENERATE("balanced", "mobile", "gtao_temporal");
    INFO(config);
    const auto renderer = stage.make(config);
    // The host's bindings stay as they are between frames, its texture included.
    for (int i = 0; i < 4; ++i) {
        stage.frame.camera.view_from_world[3][0] += 0.05;
        need(renderer->render(stage.frame));
        for (const PlanOutput& output : renderer->plan().outputs) {
            INFO(output.name);
            checkSame(renderer->output(output.name));
        }
    }
    need(renderer->resize({16, 9}));
    need(renderer->render(stage.frame));
    checkSame(renderer->output("ao"));
    need(renderer->setParam("intensity", 0.0f));
    need(renderer->render(stage.frame));
    checkSame(renderer->output("ao"));
}

TEST_CASE_METHOD(Host,
                 "A texture of any format is whole for a host's sampler without a sampler object")
{
    for (const FormatInfo& format : allFormats()) {
        INFO(format.name);
        if (!device->caps().canRender(format.format)) continue;
        const TextureId id = texture(format.format, {2, 2});
        const bool depth = format.format_class == FormatClass::depth;
        const FramebufferId into = depth ? framebuffer({}, id) : framebuffer({id});
        PassInfo pass = wholePass(into, {2, 2}, depth ? 0 : 1);
        pass.has_depth = depth;
        pass.depth_load = LoadOp::clear;
        pass.depth_store = StoreOp::store;
        pass.clear_depth = 0.5f;
        std::fill(std::begin(pass.clear_color[0]), std::end(pass.clear_color[0]), 1.0f);
        clearPass(pass);
        checkSame(id);
        CHECK(read(id).at(0, 0) > 0.4f);
        device->destroy(into);
        device->destroy(id);
    }
}
