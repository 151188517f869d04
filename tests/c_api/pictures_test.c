// SPDX-License-Identifier: MIT
// Pictures of a host of C99 go in and out in every way: depth in a texture, a layer, a part, a
// renderbuffer and a framebuffer gives the same AO; AO is drawn into a texture and a framebuffer of
// the host's. Exits with 0, 1 (wrong), or 77 (no EGL here).
#include "checks.h"

#include <GLES3/gl3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { kWidth = 64, kHeight = 36, kCount = kWidth * kHeight, kLarger = 128, kX = 30, kY = 50 };

static GLuint depth_texture(GLenum target, int size_x, int size_y)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    if (target == GL_TEXTURE_2D)
        glTexStorage2D(target, 1, GL_DEPTH_COMPONENT24, size_x, size_y);
    else
        glTexStorage3D(target, 1, GL_DEPTH_COMPONENT24, size_x, size_y, 3);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

/// Steps of depth, handed to the bound texture: layer 2 of an array, at (x, y).
static void write_depth(GLenum target, int x, int y)
{
    static GLuint pixels[kHeight][kWidth];
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column)
            pixels[row][column] =
                (GLuint)((0.95 + 0.002 * (column / 8 % 4 + row / 12)) * 4294967295.0);
    if (target == GL_TEXTURE_2D)
        glTexSubImage2D(target, 0, x, y, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                        pixels);
    else
        glTexSubImage3D(target, 0, x, y, 2, kWidth, kHeight, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                        pixels);
}

/// A framebuffer with that depth, bound to be read and drawn into.
static GLuint framebuffer_of(GLenum target, GLuint depth)
{
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (target == GL_RENDERBUFFER)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth);
    else
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth, 0);
    return name;
}

/// A renderbuffer with the depth of a framebuffer.
static GLuint depth_renderbuffer(GLuint from)
{
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kWidth, kHeight);
    GLuint into = framebuffer_of(GL_RENDERBUFFER, name);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    glDeleteFramebuffers(1, &into);
    return name;
}

static crevice_device* make_device(crevice_context* context)
{
    crevice_device_desc desc = {.struct_size = sizeof desc, .loader = crevice_context_find};
    desc.user = context;
    crevice_device* device = NULL;
    EXPECT(0, crevice_device_create(&desc, &device));
    return device;
}

/// As gluPerspective makes it, by columns; for depth from 0 to 1 in clip space where that is said.
static void set_projection(crevice_effect* effect, bool zero_to_one)
{
    const float near = 0.1f, far = 10.0f;
    float m[16] = {0};
    m[0] = 1;
    m[5] = 16.0f / 9;
    m[10] = zero_to_one ? far / (near - far) : (far + near) / (near - far);
    m[11] = -1;
    m[14] = (zero_to_one ? 1.0f : 2.0f) * far * near / (near - far);
    EXPECT(0, crevice_effect_set_projection(effect, m));
}

static crevice_effect* make_effect(crevice_device* device)
{
    const float radius = 0.5f;
    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = kWidth, .height = kHeight};
    desc.config =
        "{ \"format\": 1, \"name\": \"ao\","
        "\"extends\": [\"geometry/host_depth\", \"ssao/gtao\", \"filter/bilateral_normal\"] }";
    crevice_effect* effect = NULL;
    EXPECT(0, crevice_effect_create(device, &desc, &effect));
    set_projection(effect, false);
    EXPECT(0, crevice_effect_set_param(effect, "radius", &radius, 1));
    return effect;
}

static crevice_texture picture(GLuint name)
{
    crevice_texture depth = {.struct_size = sizeof depth, .name = name, .format = "depth24"};
    depth.width = kWidth;
    depth.height = kHeight;
    return depth;
}

/// AO of a depth, drawn by an effect of its own.
static void draw(crevice_device* device, const crevice_texture* depth, float* ao)
{
    crevice_effect* effect = make_effect(device);
    EXPECT(0, crevice_effect_set_texture(effect, "depth", depth));
    EXPECT(0, crevice_effect_render(effect));
    EXPECT(0, crevice_effect_read_output(effect, "ao", ao, kCount));
    crevice_effect_destroy(effect);
}

static void check_same(int line, crevice_device* device, crevice_texture depth, const float* wanted)
{
    static float ao[kCount];
    draw(device, &depth, ao);
    if (memcmp(ao, wanted, sizeof ao) != 0)
        fail(__FILE__, line, "the same AO as of a whole texture");
}

/// What is not as it is said to be is refused, and the picture of before stays.
static void check_refused(crevice_device* device, GLuint array, crevice_texture plain,
                          const float* wanted)
{
    static float ao[kCount];
    crevice_effect* effect = make_effect(device);
    EXPECT(0, crevice_effect_set_texture(effect, "depth", &plain));
    crevice_texture wrong = picture(array);
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    wrong.kind = CREVICE_LAYER;
    wrong.layer = 3;
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    wrong.layer = -1;
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    wrong = plain;
    wrong.kind = (crevice_texture_kind)4;
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    wrong = plain;
    wrong.samples = -1;
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    wrong = plain;
    wrong.part = true;
    wrong.x = 1;
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &wrong));
    EXPECT(0, crevice_effect_render(effect));
    EXPECT(0, crevice_effect_read_output(effect, "ao", ao, kCount));
    CHECK(memcmp(ao, wanted, sizeof ao) == 0);
    crevice_effect_destroy(effect);
}

static void check_inputs(crevice_device* device, const float* wanted, crevice_texture plain)
{
    const GLuint array = depth_texture(GL_TEXTURE_2D_ARRAY, kWidth, kHeight);
    write_depth(GL_TEXTURE_2D_ARRAY, 0, 0);
    crevice_texture layer = picture(array);
    layer.kind = CREVICE_LAYER;
    layer.layer = 2;
    check_same(__LINE__, device, layer, wanted);

    crevice_texture part = picture(depth_texture(GL_TEXTURE_2D, kLarger, kLarger));
    write_depth(GL_TEXTURE_2D, kX, kY);
    part.part = true;
    part.x = kX;
    part.y = kY;
    check_same(__LINE__, device, part, wanted);

    crevice_texture framebuffer = picture(framebuffer_of(GL_TEXTURE_2D, plain.name));
    framebuffer.kind = CREVICE_FRAMEBUFFER;
    check_same(__LINE__, device, framebuffer, wanted);

    crevice_texture renderbuffer = picture(depth_renderbuffer(framebuffer.name));
    renderbuffer.kind = CREVICE_RENDERBUFFER;
    check_same(__LINE__, device, renderbuffer, wanted);

    check_refused(device, array, plain, wanted);
    glDeleteFramebuffers(1, &framebuffer.name);
    glDeleteRenderbuffers(1, &renderbuffer.name);
    glDeleteTextures(1, &array);
    glDeleteTextures(1, &part.name);
}

/// A projection of another clip control gives the same AO, once that is said.
static void check_clip_control(crevice_device* device, const crevice_texture* depth,
                               const float* wanted)
{
    static float ao[kCount];
    crevice_effect* effect = make_effect(device);
    set_projection(effect, true);
    EXPECT(0, crevice_effect_set_clip_control(effect, true, false));
    EXPECT(0, crevice_effect_set_texture(effect, "depth", depth));
    EXPECT(0, crevice_effect_render(effect));
    EXPECT(0, crevice_effect_read_output(effect, "ao", ao, kCount));
    float most = 0;
    for (int i = 0; i < kCount; ++i) most = fmaxf(most, fabsf(ao[i] - wanted[i]));
    CHECK(most <= 2.0f / 255);
    crevice_effect_destroy(effect);
}

/// The bound framebuffer has AO in the rectangle at (kX, kY), as grey, and green 1 around it.
static void check_presented(int line, const float* ao)
{
    static GLubyte pixels[kLarger][kLarger][4];
    glReadPixels(0, 0, kLarger, kLarger, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    int wrong = 0;
    for (int y = 0; y < kLarger; ++y)
        for (int x = 0; x < kLarger; ++x) {
            const int column = x - kX, row = y - kY;
            const bool inside = column >= 0 && column < kWidth && row >= 0 && row < kHeight;
            const int grey = inside ? (int)lroundf(ao[row * kWidth + column] * 255) : 0;
            for (int i = 0; i < 3; ++i)
                wrong += abs(pixels[y][x][i] - (i == 1 && !inside ? 255 : grey)) > 1;
        }
    if (wrong > 0) fail(__FILE__, line, "AO in the rectangle and nothing of it around");
}

static void clear_green(void)
{
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void check_present(crevice_device* device, const crevice_texture* depth, const float* ao)
{
    crevice_effect* effect = make_effect(device);
    EXPECT(0, crevice_effect_set_texture(effect, "depth", depth));
    EXPECT(0, crevice_effect_render(effect));
    GLuint texture = 0, framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 2 * kLarger, 2 * kLarger);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 1);

    crevice_target target = {.struct_size = sizeof target, .texture = texture, .level = 1};
    target.x = kX;
    target.y = kY;
    EXPECT(6011, crevice_effect_present(effect, "ao", &target));  // no pixels
    target.width = kWidth;
    target.height = kHeight;
    clear_green();
    EXPECT(2209, crevice_effect_present(effect, "aoo", &target));
    EXPECT(0, crevice_effect_present(effect, "ao", &target));
    check_presented(__LINE__, ao);

    clear_green();
    target.texture = 0;
    target.framebuffer = framebuffer;
    EXPECT(0, crevice_effect_present(effect, "ao", &target));
    check_presented(__LINE__, ao);
    target.framebuffer = 0;
    target.texture = depth->name;
    EXPECT(6005, crevice_effect_present(effect, "ao", &target));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    crevice_effect_destroy(effect);
}

int main(void)
{
    crevice_context* context = NULL;
    crevice_error* error = crevice_context_create("egl", &context);
    if (error) {
        fputs(crevice_error_text(error), stderr);
        crevice_error_free(error);
        return getenv("CREVICE_REQUIRE_GL") ? 1 : 77;
    }
    crevice_device* device = make_device(context);
    crevice_texture plain = picture(depth_texture(GL_TEXTURE_2D, kWidth, kHeight));
    write_depth(GL_TEXTURE_2D, 0, 0);
    static float ao[kCount];
    draw(device, &plain, ao);
    float least = 1;
    for (int i = 0; i < kCount; ++i) least = fminf(least, ao[i]);
    CHECK(least < 0.8f);
    check_inputs(device, ao, plain);
    check_clip_control(device, &plain, ao);
    check_present(device, &plain, ao);
    CHECK(glGetError() == GL_NO_ERROR);
    glDeleteTextures(1, &plain.name);
    crevice_device_destroy(device);
    crevice_context_destroy(context);
    if (failures == 0) puts("all checks passed");
    return failures > 0 ? 1 : 0;
}
