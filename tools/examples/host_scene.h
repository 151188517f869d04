// SPDX-License-Identifier: MIT
// What an application has before it meets crevice: a scene, and a shader that lights it by
// sun + ambient. Include the headers of OpenGL first.
#pragma once

#include <crevice/diagnostic.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// Ends the program where something failed, and says why.
inline void need(const crevice::Status& status)
{
    if (status) return;
    std::fputs(toText(status.diagnostics()).c_str(), stderr);
    std::exit(EXIT_FAILURE);
}

template <class T>
T need(crevice::Result<T> result)
{
    if (!result) need(crevice::Status(result.diagnostics()));
    return std::move(*result);
}

/// Five columns on a floor, without a buffer; the camera is at the origin.
constexpr const char* kSceneVertex = R"(
uniform mat4 clip_from_view;
out vec3 point;
const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);
void main()
{
    int face = gl_VertexID / 6, corner = kCorners[gl_VertexID % 6];
    vec3 p = vec3(corner & 1, corner >> 1, face & 1) * 2.0 - 1.0;
    p = face < 2 ? p : face < 4 ? p.yzx : p.zxy;
    float column = float(gl_InstanceID);  // 0 is the floor
    point = gl_InstanceID == 0 ? p * vec3(9.0, 0.1, 9.0) + vec3(0.0, -1.1, -9.0)
                               : p * vec3(0.3, 1.0, 0.3) + vec3(column * 0.9 - 2.7, 0.0, -3.2);
    gl_Position = clip_from_view * vec4(point, 1.0);
})";

/// One line is for AO: ambient light is multiplied by it.
constexpr const char* kSceneFragment = R"(
uniform sampler2D ao;
uniform float ao_strength;  // 0 off, 1 on
in vec3 point;
out vec4 color;
void main()
{
    vec3 normal = normalize(cross(dFdx(point), dFdy(point)));
    float sun = 0.4 * max(dot(normal, normalize(vec3(1.0, 2.0, 1.5))), 0.0);
    float ambient = 0.6;
    ambient *= mix(1.0, texture(ao, gl_FragCoord.xy / vec2(textureSize(ao, 0))).r, ao_strength);
    color = vec4(vec3(sun + ambient), 1.0);
})";

class Scene {
public:
    /// `header` is what GLSL begins with here, such as "#version 330\n".
    Scene(const std::string& header, const glm::mat4& clip_from_view) : program_(glCreateProgram())
    {
        attach(GL_VERTEX_SHADER, header + kSceneVertex);
        attach(GL_FRAGMENT_SHADER, header + kSceneFragment);
        glLinkProgram(program_);
        glUseProgram(program_);
        glUniformMatrix4fv(glGetUniformLocation(program_, "clip_from_view"), 1, GL_FALSE,
                           glm::value_ptr(clip_from_view));
        glGenVertexArrays(1, &no_buffers_);
        glEnable(GL_DEPTH_TEST);
    }

    /// Draws into the bound framebuffer; the texture bound at unit 0 is AO.
    void draw(float ao_strength) const
    {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        glUniform1f(glGetUniformLocation(program_, "ao_strength"), ao_strength);
        glBindVertexArray(no_buffers_);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 6);
    }

private:
    void attach(GLenum kind, const std::string& text) const
    {
        const char* const texts[] = {text.c_str()};
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, texts, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    }

    GLuint program_;
    GLuint no_buffers_ = 0;
};

/// The mean of red in a rectangle of the bound framebuffer, 0 to 1.
inline double meanOf(int x, int y, int width, int height)
{
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * height * 4);
    glReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) sum += pixels[i];
    return sum / (255.0 * width * height);
}
