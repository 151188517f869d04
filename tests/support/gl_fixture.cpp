// SPDX-License-Identifier: MIT
#include "tests/support/gl_fixture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crevice {

const char* const kFullscreenVertex = R"(#version 300 es
out highp vec2 uv;
void main()
{
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

const char* const kMeshVertex = R"(#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
out highp vec3 normal;
out highp vec2 uv;
void main()
{
    normal = vertex_normal;
    uv = vertex_uv;
    gl_Position = vec4(position, 1.0);
}
)";

GlslStage stage(const std::string& text)
{
    GlslStage made;
    made.text = text;
    made.files = {std::make_shared<SourceText>(SourceText{"test.glsl", text})};
    made.explain = explainLog;
    return made;
}

std::string fragment(const std::string& body)
{
    return "#version 300 es\nprecision highp float;\nprecision highp int;\n" + body;
}

PassInfo wholePass(FramebufferId framebuffer, Extent extent, int colors)
{
    PassInfo pass;
    pass.label = "test pass";
    pass.framebuffer = framebuffer;
    pass.extent = extent;
    pass.color_count = colors;
    for (int i = 0; i < colors; ++i) pass.color_load[i] = LoadOp::clear;
    return pass;
}

std::vector<Vertex> step()
{
    std::vector<Vertex> all;
    const auto quad = [&all](glm::vec3 at, glm::vec3 x, glm::vec3 y, glm::vec3 n) {
        for (const glm::vec2 c : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
            const glm::vec3 p = at + x * c.x + y * c.y;
            all.push_back({{p.x, p.y, p.z}, {n.x, n.y, n.z}, {c.x, c.y}});
        }
    };
    quad({-1, -1, 1}, {2, 0, 0}, {0, 0, -1}, {0, 1, 0});
    quad({-1, -1, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1});
    quad({-1, 0, 0}, {2, 0, 0}, {0, 0, -1}, {0, 1, 0});
    return all;
}

MeshDesc square(float z)
{
    MeshDesc mesh;
    mesh.label = "square";
    for (float y : {-1.0f, 1.0f})
        for (float x : {-1.0f, 1.0f})
            mesh.vertices.push_back(
                {{x, y, z}, {0.25f, 0.5f, 1.0f}, {x * 0.5f + 0.5f, y * 0.5f + 0.5f}});
    mesh.indices = {0, 1, 2, 2, 1, 3};
    return mesh;
}

GLuint depthTexture(const GlApi& gl, Extent extent, const std::vector<float>& depths)
{
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, extent.width, extent.height);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, extent.width, extent.height, GL_DEPTH_COMPONENT,
                     GL_FLOAT, depths.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return name;
}

GlFixture::GlFixture(const GlDeviceOptions& options, Context& context)
{
    need(context.makeCurrent());
    gl = need(loadGlApi(context.loader()));
    device = need(makeGlDevice(context.loader(), options));
}

GlFixture::~GlFixture() { CHECK(takeErrors(gl, "the test").ok()); }

TextureId GlFixture::texture(Format format, Extent extent, const char* label)
{
    TextureDesc desc;
    desc.label = label;
    desc.format = format;
    desc.extent = extent;
    return need(device->createTexture(desc));
}

FramebufferId GlFixture::framebuffer(std::vector<TextureId> color, TextureId depth)
{
    return need(device->createFramebuffer({"framebuffer", std::move(color), depth}));
}

ProgramId GlFixture::program(const std::string& fragment_body, const char* vertex)
{
    return need(device->createProgram({"program", stage(vertex), stage(fragment(fragment_body))}));
}

int GlFixture::location(ProgramId program, const std::string& uniform)
{
    for (const UniformInfo& info : device->uniforms(program))
        if (info.name == uniform) return info.location;
    FAIL("no uniform " << uniform);
    return -1;
}

void GlFixture::drawInto(TextureId target, ProgramId program, Extent extent)
{
    const FramebufferId into = framebuffer({target});
    drawPass(wholePass(into, extent), [&] {
        device->setProgram(program, {});
        device->drawFullscreen();
    });
    device->destroy(into);
}

}  // namespace crevice
