// SPDX-License-Identifier: MIT
// Ambient occlusion from C: depth of a floor that meets a wall goes in, the mean of AO comes out.
//
//     cc hello.c $(pkg-config --static --cflags --libs crevice) -lGLESv2
//
// An application has a context and a depth texture of its own, and begins at crevice_device_create.
#include <crevice/crevice.h>

#include <GLES3/gl3.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef HELLO_BAKED  // by crevice bake gtao+geometry/host_depth --output ao --header hello_baked.h
#include "hello_baked.h"
#define CONFIG .baked = hello_baked, .baked_size = hello_baked_size
#else
#define CONFIG .config = "gtao+geometry/host_depth"
#endif

enum { kWidth = 256, kHeight = 144 };

static const float kNear = 0.1f, kFar = 100.0f, kScale = 1.7320508f;  // 60 degrees high

/// Ends the program where something failed, and says why.
static void need(crevice_error* error)
{
    if (!error) return;
    fputs(crevice_error_text(error), stderr);
    crevice_error_free(error);
    exit(EXIT_FAILURE);
}

/// Window depth of a row: the floor lies 1 below the camera, the wall 4 away.
static double depth_of_row(int row)
{
    const double slope = ((row + 0.5) / kHeight * 2 - 1) / kScale;
    const double distance = slope < -0.25 ? -1 / slope : 4;
    return kFar / (kFar - kNear) * (1 - kNear / distance);
}

/// What an application draws its scene into.
static GLuint make_depth(void)
{
    static GLuint pixels[kHeight][kWidth];
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) pixels[y][x] = (GLuint)(depth_of_row(y) * 4294967295.0);
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                    pixels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

static crevice_effect* make_effect(crevice_device* device)
{
    crevice_effect_desc desc = {
        .struct_size = sizeof desc, CONFIG, .width = kWidth, .height = kHeight};
    crevice_effect* effect = NULL;
    need(crevice_effect_create(device, &desc, &effect));
    return effect;
}

/// As gluPerspective makes it, by columns.
static void set_projection(crevice_effect* effect)
{
    const float depth = kNear - kFar, x = kScale * kHeight / kWidth;
    const float z = (kFar + kNear) / depth, w = 2 * kFar * kNear / depth;
    const float m[16] = {x, 0, 0, 0, 0, kScale, 0, 0, 0, 0, z, -1, 0, 0, w, 0};
    need(crevice_effect_set_projection(effect, m));
}

static void draw(crevice_effect* effect, GLuint depth_name)
{
    const float radius = 1.0f;
    crevice_texture depth = {.struct_size = sizeof depth, .name = depth_name, .format = "depth24"};
    depth.width = kWidth;
    depth.height = kHeight;
    set_projection(effect);
    need(crevice_effect_set_texture(effect, "depth", &depth));
    need(crevice_effect_set_param(effect, "radius", &radius, 1));
    need(crevice_effect_render(effect));
}

/// An application binds `ao.texture` and multiplies its ambient light by it.
static double mean_of(const crevice_effect* effect)
{
    crevice_output ao = {.struct_size = sizeof ao};
    need(crevice_effect_get_output(effect, "ao", &ao));
    static float pixels[kWidth * kHeight];
    need(crevice_effect_read_output(effect, "ao", pixels, kWidth * kHeight));
    double sum = 0;
    for (int i = 0; i < kWidth * kHeight; ++i) sum += pixels[i];
    printf("texture %u: %d x %d, %s\n", ao.texture, ao.width, ao.height, ao.format);
    return sum / (kWidth * kHeight);
}

int main(void)
{
    crevice_context* context = NULL;
    need(crevice_context_create("egl", &context));
    crevice_device_desc desc = {.struct_size = sizeof desc, .loader = crevice_context_find};
    desc.user = context;
    crevice_device* device = NULL;
    need(crevice_device_create(&desc, &device));

    const GLuint depth = make_depth();
    crevice_effect* effect = make_effect(device);
    draw(effect, depth);
    printf("mean AO %.4f\n", mean_of(effect));

    crevice_effect_destroy(effect);
    crevice_device_destroy(device);
    glDeleteTextures(1, &depth);
    crevice_context_destroy(context);
    return EXIT_SUCCESS;
}
