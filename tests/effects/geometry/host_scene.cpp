// SPDX-License-Identifier: MIT
#include "tests/effects/geometry/host_scene.h"

#include "tests/support/need.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <cstddef>

namespace crevice {
namespace {

const char* const kVertex = R"(#version 300 es
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 direction;
uniform mat4 clip_from_world;
uniform mat3 view_from_world;
out highp vec3 facing;
void main()
{
    facing = view_from_world * direction;
    gl_Position = clip_from_world * vec4(place, 1.0);
}
)";

const char* const kFragment = R"(#version 300 es
precision highp float;
in vec3 facing;
out vec4 normal;
void main() { normal = vec4(normalize(facing) * 0.5 + 0.5, 1.0); }
)";

GlTexture textureOf(const GlApi& gl, GLenum internal, Extent extent)
{
    GlTexture made = GlTexture::make(gl);
    gl.BindTexture(GL_TEXTURE_2D, made.name());
    gl.TexStorage2D(GL_TEXTURE_2D, 1, internal, extent.width, extent.height);
    return made;
}

}  // namespace

HostScene::HostScene(const GlApi& gl, const Scene& scene, Extent extent)
    : gl_(gl),
      extent_(extent),
      depth_(textureOf(gl, GL_DEPTH_COMPONENT32F, extent)),
      normal_(textureOf(gl, GL_RGBA16F, extent)),
      framebuffer_(GlFramebuffer::make(gl)),
      vertices_(GlBuffer::make(gl)),
      indices_(GlBuffer::make(gl)),
      array_(GlVertexArray::make(gl)),
      program_(gl, gl.CreateProgram())
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth(), 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, normal(), 0);
    const GlShader vertex(gl, compiled(GL_VERTEX_SHADER, kVertex));
    const GlShader fragment(gl, compiled(GL_FRAGMENT_SHADER, kFragment));
    gl.LinkProgram(program_.name());
    uploadMeshes(scene);
}

GLuint HostScene::compiled(GLenum type, const char* text)
{
    const GLuint shader = gl_.CreateShader(type);
    gl_.ShaderSource(shader, 1, &text, nullptr);
    gl_.CompileShader(shader);
    gl_.AttachShader(program_.name(), shader);
    return shader;
}

void HostScene::uploadMeshes(const Scene& scene)
{
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const SceneInstance& instance : scene.instances) {
        REQUIRE(instance.world_from_model == glm::dmat4(1.0));  // all is in the vertices
        const MeshDesc& mesh = scene.meshes[instance.mesh];
        for (const std::uint32_t index : mesh.indices)
            indices.push_back(static_cast<std::uint32_t>(vertices.size()) + index);
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    }
    count_ = static_cast<GLsizei>(indices.size());
    gl_.BindVertexArray(array_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, vertices.size() * sizeof(Vertex), vertices.data(),
                   GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof indices[0], indices.data(),
                   GL_STATIC_DRAW);
    const std::size_t offsets[] = {offsetof(Vertex, position), offsetof(Vertex, normal)};
    for (GLuint i = 0; i < 2; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                reinterpret_cast<const void*>(offsets[i]));
    }
    gl_.BindVertexArray(0);
}

void HostScene::draw(const glm::dmat4& view_from_world, const glm::mat4& clip_from_view,
                     bool reversed)
{
    const glm::mat4 clip(glm::dmat4(clip_from_view) * view_from_world);
    const glm::mat3 view{glm::dmat3(view_from_world)};
    const float far = reversed ? 0.0f : 1.0f, none[] = {0, 0, 0, 0};
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_.Viewport(0, 0, extent_.width, extent_.height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(reversed ? GL_GREATER : GL_LESS);
    gl_.ClearBufferfv(GL_DEPTH, 0, &far);
    gl_.ClearBufferfv(GL_COLOR, 0, none);
    gl_.UseProgram(program_.name());
    const GLint of_clip = gl_.GetUniformLocation(program_.name(), "clip_from_world");
    const GLint of_view = gl_.GetUniformLocation(program_.name(), "view_from_world");
    REQUIRE((of_clip >= 0 && of_view >= 0));
    gl_.UniformMatrix4fv(of_clip, 1, GL_FALSE, glm::value_ptr(clip));
    gl_.UniformMatrix3fv(of_view, 1, GL_FALSE, glm::value_ptr(view));
    gl_.BindVertexArray(array_.name());
    gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    gl_.BindVertexArray(0);
    gl_.UseProgram(0);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace crevice
