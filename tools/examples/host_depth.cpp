// SPDX-License-Identifier: MIT
// Ambient occlusion in an application's own lighting shader, from its own depth: SDL2, OpenGL ES 3.
//
//     host_depth [FRAMES]    without FRAMES it draws until its window is closed
//
// A frame is drawn in three steps: the scene's depth, AO made of it, and the scene lit with AO.
// host_scene.h is what the application had before.
#include <crevice/effect.h>
#include <crevice/gl_device.h>

#include <GLES3/gl3.h>
#include <SDL.h>

#include "host_scene.h"

#include <climits>

using namespace crevice;

namespace {

constexpr Extent kSize = {640, 360};

SDL_Window* openWindow()
{
    SDL_Init(SDL_INIT_VIDEO);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    SDL_Window* window =
        SDL_CreateWindow("host_depth", 0, 0, kSize.width, kSize.height, SDL_WINDOW_OPENGL);
    if (window && SDL_GL_CreateContext(window)) return window;
    std::fprintf(stderr, "no window with OpenGL ES 3: %s\n", SDL_GetError());
    std::exit(EXIT_FAILURE);
}

GLuint makeDepth()
{
    GLuint depth = 0;
    glGenTextures(1, &depth);
    glBindTexture(GL_TEXTURE_2D, depth);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, kSize.width, kSize.height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return depth;
}

/// A framebuffer that has nothing but depth.
GLuint makeFramebuffer(GLuint depth)
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    return framebuffer;
}

Effect makeEffect(Device& device, GLuint depth, const glm::mat4& projection)
{
    Effect effect = need(Effect::create(device, "mobile+geometry/host_depth", kSize));
    effect.setProjection(glm::value_ptr(projection));
    need(effect.setTexture("depth", depth, Format::depth24, kSize));
    need(effect.setParam("radius", 1.0f));
    return effect;
}

bool closed()
{
    SDL_Event event;
    while (SDL_PollEvent(&event))
        if (event.type == SDL_QUIT) return true;
    return false;
}

double meanLight() { return meanOf(0, 0, kSize.width, kSize.height); }

/// Draws the frames; gives how much of the light AO takes, in percent.
double run(SDL_Window* window, const GlLoader& loader, int frames)
{
    const auto projection =
        glm::perspective(glm::radians(60.0f), 1.0f * kSize.width / kSize.height, 0.1f, 100.0f);
    const Scene scene("#version 300 es\nprecision highp float;", projection);
    const GLuint depth = makeDepth();
    const GLuint depth_only = makeFramebuffer(depth);
    const auto device = need(makeGlDevice(loader));
    Effect effect = makeEffect(*device, depth, projection);
    for (int frame = 0; frame < frames && !closed(); ++frame) {
        glBindFramebuffer(GL_FRAMEBUFFER, depth_only);
        scene.draw(0);
        need(effect.render());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glBindTexture(GL_TEXTURE_2D, effect.nativeName("ao"));
        scene.draw(1);
        SDL_GL_SwapWindow(window);
    }
    scene.draw(0);
    const double open = meanLight();
    scene.draw(1);
    return 100 * (1 - meanLight() / open);
}

}  // namespace

int main(int argc, char** argv)
{
    SDL_Window* window = openWindow();
    const double taken =
        run(window, SDL_GL_GetProcAddress, argc > 1 ? std::atoi(argv[1]) : INT_MAX);
    SDL_DestroyWindow(window);
    SDL_Quit();
    std::printf("AO takes %.1f %% of the light\n", taken);
    return taken > 5 && taken < 30 ? EXIT_SUCCESS : EXIT_FAILURE;
}
