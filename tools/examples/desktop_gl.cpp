// SPDX-License-Identifier: MIT
// Ambient occlusion of what lies in a window already: GLFW, OpenGL 3.3 core.
//
//     desktop_gl [FRAMES]    without FRAMES it draws until its window is closed
//
// The scene is drawn into the window, AO is made of the window's own depth and presented in a
// corner of it, as grey. host_scene.h is what the application had before.
#include <crevice/effect.h>
#include <crevice/gl_device.h>

#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>

#include "host_scene.h"

#include <climits>

using namespace crevice;

namespace {

constexpr Extent kSize = {640, 360};

[[noreturn]] void fail(const char* why)
{
    std::fprintf(stderr, "no window with OpenGL 3.3: %s\n", why);
    std::exit(EXIT_FAILURE);
}

GLFWwindow* openWindow()
{
    glfwSetErrorCallback([](int, const char* why) { fail(why); });
    glfwInit();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window =
        glfwCreateWindow(kSize.width, kSize.height, "desktop_gl", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    return window;
}

/// The depth of the window, of which each frame takes a copy.
HostTexture windowDepth()
{
    HostTexture depth;
    depth.kind = HostTexture::Kind::framebuffer;
    depth.name = 0;
    depth.format = Format::depth24;
    depth.extent = kSize;
    return depth;
}

/// The upper left corner of the window, a third as large; the sky is black there.
HostFramebuffer corner()
{
    HostFramebuffer target;
    target.y = kSize.height * 2 / 3;
    target.extent = {kSize.width / 3, kSize.height / 3};
    return target;
}

/// Draws the frames; gives the mean AO that the corner shows.
double run(GLFWwindow* window, const GlLoader& loader, int frames)
{
    const auto projection =
        glm::perspective(glm::radians(60.0f), 1.0f * kSize.width / kSize.height, 0.1f, 100.0f);
    const Scene scene("#version 330\n", projection);
    const auto device = need(makeGlDevice(loader));
    Effect effect = need(Effect::create(*device, "balanced+geometry/host_depth", kSize));
    effect.setProjection(glm::value_ptr(projection));
    need(effect.setTexture("depth", windowDepth()));
    need(effect.setParam("radius", 1.0f));
    double mean = 1;
    for (int frame = 0; frame < frames && !glfwWindowShouldClose(window); ++frame) {
        scene.draw(0);
        need(effect.render());
        need(effect.present("ao", corner()));
        mean = meanOf(corner().x, corner().y, corner().extent.width, corner().extent.height);
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    return mean;
}

}  // namespace

int main(int argc, char** argv)
{
    GLFWwindow* window = openWindow();
    const double mean = run(window, glfwGetProcAddress, argc > 1 ? std::atoi(argv[1]) : INT_MAX);
    glfwTerminate();
    std::printf("mean AO %.4f\n", mean);
    return mean > 0.5 && mean < 0.97 ? EXIT_SUCCESS : EXIT_FAILURE;
}
