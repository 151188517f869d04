// SPDX-License-Identifier: MIT
// Structs of other versions, as programs have them that were built with another header: cut short
// at every size, and longer than this library's. Exits with 0, 1 (wrong), or 77 (no EGL here).
#include "checks.h"

#include <GLES3/gl3.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { kGarbage = 0xAA, kLonger = 40, kLargest = 4096 };

static crevice_context* context = NULL;
static crevice_device* device = NULL;
static crevice_effect* effect = NULL;
static crevice_error* mistake = NULL;

#define END(type, member) (offsetof(type, member) + sizeof(((type*)NULL)->member))

static GLuint buffer_of(size_t size)
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, NULL, GL_STATIC_DRAW);
    return name;
}

/// A struct in memory of its own, where `behind` bytes of garbage follow it.
static void* memory_of(size_t size, size_t behind)
{
    const size_t least = size < sizeof size ? sizeof size : size;
    char* bytes = malloc(least + behind);
    memset(bytes, kGarbage, least + behind);
    memcpy(bytes, &size, sizeof size);
    return bytes;
}

static bool possible(size_t size)
{
    return size > sizeof size && size <= kLargest && size % sizeof size == 0;
}

// ---- Structs that are handed over ---------------------------------------------------------------

/// `needed`: the least size that has all members which `full` sets.
typedef struct taken {
    const char* name;
    const void* full;
    size_t size, needed;
    crevice_error* (*call)(const void* given);
} taken;

static crevice_error* make_device(const void* given)
{
    crevice_device* other = NULL;
    crevice_error* error = crevice_device_create(given, &other);
    CHECK((error == NULL) == (other != NULL));
    crevice_device_destroy(other);
    return error;
}

static crevice_error* make_effect(const void* given)
{
    crevice_effect* other = NULL;
    crevice_error* error = crevice_effect_create(device, given, &other);
    CHECK((error == NULL) == (other != NULL));
    crevice_effect_destroy(other);
    return error;
}

static crevice_error* set_texture(const void* given)
{
    return crevice_effect_set_texture(effect, "depth", given);
}

static crevice_error* present(const void* given)
{
    return crevice_effect_present(effect, "ao", given);
}

static crevice_error* make_mesh(const void* given)
{
    crevice_mesh* mesh = NULL;
    crevice_error* error = crevice_mesh_create(device, given, &mesh);
    CHECK((error == NULL) == (mesh != NULL));
    crevice_mesh_destroy(mesh);
    return error;
}

static crevice_error* adopt_mesh(const void* given)
{
    crevice_mesh* mesh = NULL;
    crevice_error* error = crevice_mesh_adopt(device, given, &mesh);
    CHECK((error == NULL) == (mesh != NULL));
    crevice_mesh_destroy(mesh);
    return error;
}

static crevice_error* set_draws(const void* given)
{
    return crevice_effect_set_draws(effect, given, 1);
}

static crevice_error* set_views(const void* given)
{
    return crevice_effect_set_views(effect, given, 1);
}

static crevice_error* set_materials(const void* given)
{
    return crevice_effect_set_materials(effect, given, 1);
}

static crevice_error* set_lights(const void* given)
{
    return crevice_effect_set_lights(effect, given, 1);
}

/// The code of what `call` says of the first bytes of a struct and of zeros after them.
static int code_of(const taken* each, size_t size, size_t behind)
{
    char* given = memory_of(size, behind);
    const size_t known = size < each->size ? size : each->size;
    if (size > sizeof size)
        memcpy(given + sizeof size, (const char*)each->full + sizeof size, known - sizeof size);
    if (size > each->size) memset(given + each->size, 0, size - each->size);
    crevice_error* error = each->call(given);
    const int code = crevice_error_code(error);
    crevice_error_free(error);
    free(given);
    return code;
}

/// A member of a later version that is set is not passed over.
static void check_unknown_member(const taken* each)
{
    char* given = memory_of(each->size + kLonger, 0);
    memcpy(given + sizeof(size_t), (const char*)each->full + sizeof(size_t),
           each->size - sizeof(size_t));
    memset(given + each->size, 0, kLonger);
    given[each->size + kLonger - 1] = 1;
    EXPECT(6011, each->call(given));
    free(given);
}

static void check_taken(const taken* each)
{
    for (size_t behind = 0; behind <= 64; behind += 64)
        for (size_t size = 0; size <= each->size + kLonger; ++size) {
            const int code = code_of(each, size, behind);
            const bool fine = possible(size) && size >= each->needed;
            if (fine != (code == 0) || (!possible(size) && code != 6011)) {
                fail(__FILE__, __LINE__, each->name);
                printf("of %zu bytes: CV%d\n", size, code);
            }
        }
    if (code_of(each, kLargest + sizeof(size_t), 0) != 6011) fail(__FILE__, __LINE__, each->name);
    check_unknown_member(each);
}

static void check_scene_taken(void)
{
    static const float positions[9] = {0};
    const GLuint buffer = buffer_of(sizeof positions);
    crevice_mesh* mesh = NULL;
    crevice_mesh_desc mesh_desc = {.positions = positions, .vertex_count = 3};
    crevice_host_mesh host = {.position = {.buffer = buffer}, .vertex_count = 3};
    mesh_desc.struct_size = sizeof mesh_desc;
    EXPECT(0, crevice_mesh_create(device, &mesh_desc, &mesh));
    crevice_draw draw = {.mesh = mesh};
    crevice_material material = {.shininess = 1};
    crevice_light light = {.color = {1, 1, 1}};
    crevice_view view = {.clip_from_view = {1}};
    const taken all[] = {
        {"crevice_mesh_desc", &mesh_desc, sizeof mesh_desc, END(crevice_mesh_desc, vertex_count),
         make_mesh},
        {"crevice_host_mesh", &host, sizeof host, END(crevice_host_mesh, vertex_count), adopt_mesh},
        {"crevice_draw", &draw, sizeof draw, END(crevice_draw, mesh), set_draws},
        {"crevice_material", &material, sizeof material, 0, set_materials},
        {"crevice_light", &light, sizeof light, 0, set_lights},
        {"crevice_view", &view, sizeof view, 0, set_views},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) check_taken(&all[i]);
    EXPECT(0, crevice_effect_set_views(effect, NULL, 0));
    crevice_mesh_destroy(mesh);
    glDeleteBuffers(1, &buffer);
}

static void check_all_taken(GLuint depth, GLuint color)
{
    crevice_device_desc device_desc = {.loader = crevice_context_find, .user = context};
    crevice_effect_desc effect_desc = {.config = "mobile", .width = 8, .height = 8};
    crevice_texture texture = {.name = depth, .format = "depth24", .width = 8, .height = 8};
    crevice_target target = {.texture = color, .width = 8, .height = 8};
    const taken all[] = {
        {"crevice_device_desc", &device_desc, sizeof device_desc, END(crevice_device_desc, user),
         make_device},
        {"crevice_effect_desc", &effect_desc, sizeof effect_desc, END(crevice_effect_desc, height),
         make_effect},
        {"crevice_texture", &texture, sizeof texture, END(crevice_texture, height), set_texture},
        {"crevice_target", &target, sizeof target, END(crevice_target, height), present},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) check_taken(&all[i]);
    check_scene_taken();
}

// ---- Structs that are filled in -----------------------------------------------------------------

typedef struct given {
    const char* name;
    size_t size;
    bool (*call)(void* into);
} given;

static bool went_well(crevice_error* error)
{
    const bool well = error == NULL;
    crevice_error_free(error);
    return well;
}

static bool get_diagnostic(void* into) { return crevice_error_get(mistake, 0, into); }

static bool get_info(void* into) { return went_well(crevice_device_get_info(device, into)); }

static bool get_output(void* into)
{
    return went_well(crevice_effect_get_output(effect, "ao", into));
}

static bool get_param(void* into) { return went_well(crevice_effect_get_param(effect, 0, into)); }

static bool get_feature(void* into)
{
    return went_well(crevice_effect_get_feature(effect, 0, into));
}

static bool get_import(void* into) { return went_well(crevice_effect_get_import(effect, 0, into)); }

/// Fills in a struct of that size; the bytes behind it stay as they were.
static char* filled(const given* each, size_t size, size_t behind)
{
    char* into = memory_of(size, behind);
    if (each->call(into) != possible(size)) fail(__FILE__, __LINE__, each->name);
    size_t kept = 0;
    memcpy(&kept, into, sizeof kept);
    CHECK(kept == size);
    const size_t end = size < sizeof size ? sizeof size : size;
    for (size_t i = 0; i < behind; ++i)
        if ((unsigned char)into[end + i] != kGarbage) fail(__FILE__, __LINE__, each->name);
    return into;
}

/// What is known is the same at every size, and what is not is zero.
static void check_given(const given* each)
{
    char* full = filled(each, each->size, 0);
    for (size_t behind = 0; behind <= 64; behind += 64)
        for (size_t size = 0; size <= each->size + kLonger; ++size) {
            char* into = filled(each, size, behind);
            for (size_t i = sizeof size; possible(size) && i < size; ++i)
                if (into[i] != (i < each->size ? full[i] : 0)) {
                    fail(__FILE__, __LINE__, each->name);
                    break;
                }
            free(into);
        }
    free(full);
}

static void check_all_given(void)
{
    const given all[] = {
        {"crevice_diagnostic", sizeof(crevice_diagnostic), get_diagnostic},
        {"crevice_device_info", sizeof(crevice_device_info), get_info},
        {"crevice_output", sizeof(crevice_output), get_output},
        {"crevice_param", sizeof(crevice_param), get_param},
        {"crevice_feature", sizeof(crevice_feature), get_feature},
        {"crevice_import", sizeof(crevice_import), get_import},
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) check_given(&all[i]);
}

static GLuint texture_of(GLenum format)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, 8, 8);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

int main(void)
{
    crevice_error* error = crevice_context_create("egl", &context);
    if (error) {
        fputs(crevice_error_text(error), stderr);
        crevice_error_free(error);
        return getenv("CREVICE_REQUIRE_GL") ? 1 : 77;
    }
    crevice_device_desc device_desc = {.struct_size = sizeof device_desc};
    device_desc.loader = crevice_context_find;
    device_desc.user = context;
    EXPECT(0, crevice_device_create(&device_desc, &device));
    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 8, .height = 8};
    desc.config =
        "{ \"format\": 1, \"name\": \"ao\", \"extends\": [\"mobile\", \"geometry/host_depth\"] }";
    EXPECT(0, crevice_effect_create(device, &desc, &effect));
    const GLuint depth = texture_of(GL_DEPTH_COMPONENT24), color = texture_of(GL_RGBA8);
    mistake = crevice_effect_resize(effect, -1, 1);
    check_all_taken(depth, color);
    EXPECT(0, crevice_effect_render(effect));
    check_all_given();
    crevice_error_free(mistake);
    crevice_effect_destroy(effect);
    crevice_device_destroy(device);
    glDeleteTextures(1, &depth);
    glDeleteTextures(1, &color);
    crevice_context_destroy(context);
    if (failures == 0) puts("all checks passed");
    return failures > 0 ? 1 : 0;
}
