// SPDX-License-Identifier: MIT
// The C API as a C99 program sees it: every function with null, errors and their places, what there
// is to set. Exits with 0, 1 (wrong), or 77 (no GL here).
#include <crevice/crevice.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(what) ((what) ? (void)0 : fail(__LINE__, #what))
/// The error has that code, 0 for none; it is freed.
#define EXPECT(code, call) expect(__LINE__, #call, code, call)

static void fail(int line, const char* what)
{
    printf("api_test.c:%d: failed: %s\n", line, what);
    ++failures;
}

static void expect(int line, const char* call, int code, crevice_error* error)
{
    if (crevice_error_code(error) != code) {
        fail(line, call);
        printf("wanted CV%d: %s\n", code, crevice_error_text(error));
    }
    crevice_error_free(error);
}

static const char kConfig[] =
    "{ \"format\": 1, \"name\": \"ao\","
    "\"extends\": [\"geometry/host_depth\", \"ssao/gtao\", \"filter/bilateral_normal\"] }";

/// Null instead of every handle and pointer, in every function.
static void check_nulls(void)
{
    const int none = 6011;
    crevice_effect* effect = NULL;
    crevice_device* device = NULL;
    CHECK(crevice_version() == CREVICE_VERSION);
    CHECK(crevice_error_text(NULL)[0] == 0);
    CHECK(crevice_error_code(NULL) == 0 && crevice_error_count(NULL) == 0);
    CHECK(!crevice_error_get(NULL, 0, NULL));
    crevice_error_free(NULL);
    EXPECT(none, crevice_context_create("egl", NULL));
    EXPECT(none, crevice_context_make_current(NULL));
    CHECK(crevice_context_find("glClear", NULL) == NULL);
    CHECK(crevice_context_find(NULL, NULL) == NULL);
    crevice_context_destroy(NULL);
    EXPECT(none, crevice_device_create(NULL, &device));
    EXPECT(none, crevice_device_get_info(NULL, NULL));
    crevice_device_abandon(NULL);
    crevice_device_destroy(NULL);
    EXPECT(none, crevice_effect_create(NULL, NULL, &effect));
    EXPECT(none, crevice_effect_reload(NULL, kConfig));
    EXPECT(none, crevice_effect_resize(NULL, 1, 1));
    crevice_effect_destroy(NULL);
    CHECK(crevice_effect_warnings(NULL) == NULL);
    EXPECT(none, crevice_effect_set_projection(NULL, NULL));
    EXPECT(none, crevice_effect_set_view(NULL, NULL));
    EXPECT(none, crevice_effect_cut(NULL));
    EXPECT(none, crevice_effect_shift_origin(NULL, NULL));
    EXPECT(none, crevice_effect_set_clip_control(NULL, true, false));
    EXPECT(none, crevice_effect_set_depth_range(NULL, 0, 1));
    EXPECT(none, crevice_effect_set_texture(NULL, "depth", NULL));
    EXPECT(none, crevice_effect_set_param(NULL, "radius", NULL, 1));
    EXPECT(none, crevice_effect_set_scale(NULL, 1, 1));
    EXPECT(none, crevice_effect_set_feature(NULL, "quality", NULL));
    EXPECT(none, crevice_effect_render(NULL));
    EXPECT(none, crevice_effect_warm(NULL, NULL));
    CHECK(crevice_effect_output_count(NULL) == 0);
    CHECK(crevice_effect_output_name(NULL, 0)[0] == 0);
    EXPECT(none, crevice_effect_get_output(NULL, "ao", NULL));
    EXPECT(none, crevice_effect_present(NULL, "ao", NULL));
    EXPECT(none, crevice_effect_get_value(NULL, "ao", NULL, NULL));
    EXPECT(none, crevice_effect_read_output(NULL, "ao", NULL, 0));
    crevice_mesh* mesh = NULL;
    EXPECT(none, crevice_mesh_create(NULL, NULL, &mesh));
    EXPECT(none, crevice_mesh_adopt(NULL, NULL, &mesh));
    crevice_mesh_destroy(NULL);
    CHECK(crevice_draw_call_matrix(NULL, "clip_from_model") == NULL);
    EXPECT(none, crevice_effect_set_views(NULL, NULL, 0));
    EXPECT(none, crevice_effect_set_view_texture(NULL, 1, "depth", NULL));
    EXPECT(none, crevice_effect_get_view_output(NULL, 1, "ao", NULL));
    EXPECT(none, crevice_effect_set_draws(NULL, NULL, 0));
    EXPECT(none, crevice_effect_set_materials(NULL, NULL, 0));
    EXPECT(none, crevice_effect_set_lights(NULL, NULL, 0));
    EXPECT(none, crevice_effect_set_ambient_light(NULL, NULL));
    EXPECT(none, crevice_effect_set_timing(NULL, true));
    CHECK(crevice_effect_pass_time_count(NULL) == 0);
    EXPECT(none, crevice_effect_get_pass_time(NULL, 0, NULL));
    EXPECT(none, crevice_effect_govern(NULL, NULL));
    EXPECT(none, crevice_effect_add_time(NULL, 1, 0));
    EXPECT(none, crevice_effect_set_budget(NULL, 1));
    EXPECT(none, crevice_effect_get_governor(NULL, NULL));
    CHECK(crevice_effect_param_count(NULL) == 0);
    EXPECT(none, crevice_effect_get_param(NULL, 0, NULL));
    CHECK(crevice_effect_feature_count(NULL) == 0);
    EXPECT(none, crevice_effect_get_feature(NULL, 0, NULL));
    CHECK(crevice_effect_import_count(NULL) == 0);
    EXPECT(none, crevice_effect_get_import(NULL, 0, NULL));
    EXPECT(none, crevice_effect_get_patch(NULL, NULL));
}

/// Null instead of what an effect is to be given.
static void check_nulls_of(crevice_effect* effect)
{
    const int none = 6011;
    crevice_texture texture = {.struct_size = sizeof texture};
    crevice_target target = {.struct_size = sizeof target};
    EXPECT(0, crevice_effect_reload(effect, NULL));
    EXPECT(none, crevice_effect_set_projection(effect, NULL));
    EXPECT(none, crevice_effect_set_view(effect, NULL));
    EXPECT(none, crevice_effect_shift_origin(effect, NULL));
    EXPECT(none, crevice_effect_set_texture(effect, NULL, &texture));
    EXPECT(none, crevice_effect_set_texture(effect, "depth", NULL));
    EXPECT(none, crevice_effect_set_texture(effect, "depth", &texture));
    EXPECT(none, crevice_effect_set_param(effect, NULL, NULL, 1));
    EXPECT(none, crevice_effect_set_param(effect, "radius", NULL, 1));
    EXPECT(none, crevice_effect_set_feature(effect, "quality", NULL));
    EXPECT(none, crevice_effect_get_output(effect, NULL, NULL));
    EXPECT(none, crevice_effect_present(effect, NULL, &target));
    EXPECT(none, crevice_effect_present(effect, "ao", NULL));
    EXPECT(none, crevice_effect_get_value(effect, "ao", NULL, NULL));
    EXPECT(none, crevice_effect_read_output(effect, "ao", NULL, 0));
    EXPECT(none, crevice_effect_set_views(effect, NULL, 1));
    EXPECT(none, crevice_effect_set_view_texture(effect, 0, NULL, &texture));
    EXPECT(none, crevice_effect_set_view_texture(effect, 0, "depth", NULL));
    EXPECT(none, crevice_effect_get_view_output(effect, 0, "ao", NULL));
    EXPECT(none, crevice_effect_set_draws(effect, NULL, 1));
    EXPECT(none, crevice_effect_set_materials(effect, NULL, 1));
    EXPECT(none, crevice_effect_set_lights(effect, NULL, 1));
    EXPECT(none, crevice_effect_set_ambient_light(effect, NULL));
    EXPECT(none, crevice_effect_get_pass_time(effect, 0, NULL));
    EXPECT(none, crevice_effect_govern(effect, NULL));
    EXPECT(none, crevice_effect_get_governor(effect, NULL));
    EXPECT(none, crevice_effect_get_patch(effect, NULL));
}

/// A mistake in JSON text ends at its line and column, with the nearest name.
static void check_places(crevice_device* device)
{
    crevice_effect* effect = NULL;
    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 64, .height = 36};
    desc.config = "{ \"format\": 1, \"name\": \"ao\",\n  \"extends\": [\"geometry/host_dept\"] }";
    crevice_error* error = crevice_effect_create(device, &desc, &effect);
    crevice_diagnostic first = {.struct_size = sizeof first};
    CHECK(effect == NULL && crevice_error_code(error) == 1201);
    CHECK(crevice_error_get(error, 0, &first) && !first.warning);
    CHECK(first.line == 2 && first.column == 15 && strcmp(first.file, "(JSON text)") == 0);
    CHECK(strstr(first.help, "geometry/host_depth") != NULL);
    CHECK(strstr(first.text, "CV1201") != NULL && strstr(crevice_error_text(error), first.text));
    CHECK(!crevice_error_get(error, -1, &first));
    CHECK(!crevice_error_get(error, crevice_error_count(error), &first));
    first.struct_size = sizeof(size_t);
    CHECK(!crevice_error_get(error, 0, &first));
    crevice_error_free(error);

    desc.config = NULL;
    EXPECT(6011, crevice_effect_create(device, &desc, &effect));
    desc.config = kConfig;
    desc.output_count = 1;
    EXPECT(6011, crevice_effect_create(device, &desc, &effect));
    desc.output_count = 0;
    desc.width = -1;
    EXPECT(4005, crevice_effect_create(device, &desc, &effect));
    desc.width = 64;
    desc.patch = "{\"params\": {\"radiuss\": 1}}";
    error = crevice_effect_create(device, &desc, &effect);
    first.struct_size = sizeof first;
    CHECK(crevice_error_get(error, 0, &first) && strcmp(first.file, "(patch)") == 0);
    crevice_error_free(error);
}

static crevice_param param_of(const crevice_effect* effect, const char* name)
{
    crevice_param param = {.struct_size = sizeof param};
    for (int i = 0; i < crevice_effect_param_count(effect); ++i) {
        EXPECT(0, crevice_effect_get_param(effect, i, &param));
        if (strcmp(param.name, name) == 0) return param;
    }
    fail(__LINE__, name);
    return param;
}

static void check_settings(crevice_effect* effect)
{
    const float radius = 0.75f, far_too_large = 1e20f, two[2] = {1, 1};
    crevice_param param = param_of(effect, "radius");
    CHECK(param.components == 1 && !param.integer && param.tooltip[0] && param.label[0]);
    CHECK(strcmp(param.unit, "scene units") == 0 && param.min == 0 && param.soft_max < param.max);
    CHECK(param.value[0] == param.default_value[0]);
    EXPECT(0, crevice_effect_set_param(effect, "radius", &radius, 1));
    CHECK(strcmp(param.name, "radius") == 0);  // strings stay while values change
    param = param_of(effect, "radius");
    CHECK(param.value[0] == radius && param.default_value[0] != radius);

    EXPECT(4004, crevice_effect_set_param(effect, "radiuss", &radius, 1));
    EXPECT(4001, crevice_effect_set_param(effect, "radius", &far_too_large, 1));
    EXPECT(3006, crevice_effect_set_param(effect, "radius", two, 2));
    EXPECT(2105, crevice_effect_set_feature(effect, "no_such", "true"));
    crevice_texture texture = {.struct_size = sizeof texture, .name = 1, .format = "depth24"};
    texture.width = texture.height = 1;
    EXPECT(2102, crevice_effect_set_texture(effect, "dept", &texture));
    texture.format = "depth42";
    EXPECT(6011, crevice_effect_set_texture(effect, "depth", &texture));
    EXPECT(6011, crevice_effect_get_param(effect, 1000, &param));
    EXPECT(6011, crevice_effect_get_param(effect, -1, &param));
}

static void check_lists(crevice_effect* effect)
{
    crevice_import import = {.struct_size = sizeof import};
    int depths = 0;
    for (int i = 0; i < crevice_effect_import_count(effect); ++i) {
        EXPECT(0, crevice_effect_get_import(effect, i, &import));
        if (strcmp(import.name, "depth") != 0) continue;
        ++depths;
        CHECK(strcmp(import.type, "texture") == 0 && strcmp(import.format, "depth24") == 0);
    }
    CHECK(depths == 1);

    crevice_output output = {.struct_size = sizeof output};
    CHECK(crevice_effect_output_count(effect) == 1);
    CHECK(strcmp(crevice_effect_output_name(effect, 0), "ao") == 0);
    CHECK(crevice_effect_output_name(effect, 1)[0] == 0);
    EXPECT(0, crevice_effect_get_output(effect, "ao", &output));
    CHECK(output.width == 64 && output.height == 36 && output.channels == 1 && output.texture);
    CHECK(strcmp(output.format, "r8") == 0);
    EXPECT(2102, crevice_effect_get_output(effect, "aoo", &output));
    float pixel;
    EXPECT(7006, crevice_effect_read_output(effect, "ao", &pixel, 1));
}

/// Words of a feature that sets other values, and a patch that makes the same effect again.
static void check_patch(crevice_device* device)
{
    const float share[] = {0, 5, 0};
    const char* text = NULL;
    crevice_effect* effect = NULL;
    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 64, .height = 36};
    const char* outputs[] = {"ao"};
    desc.config = "quality";
    desc.outputs = outputs;
    desc.output_count = 1;
    EXPECT(0, crevice_effect_create(device, &desc, &effect));
    EXPECT(0, crevice_effect_get_patch(effect, &text));
    CHECK(strcmp(text, "{}") == 0);

    crevice_feature feature = {.struct_size = sizeof feature};
    for (int i = 0; i < crevice_effect_feature_count(effect); ++i) {
        EXPECT(0, crevice_effect_get_feature(effect, i, &feature));
        if (strcmp(feature.name, "quality") == 0) break;
    }
    CHECK(strcmp(feature.name, "quality") == 0 && feature.word_count > 2 && !feature.boolean);
    CHECK(strcmp(feature.label, "Quality") == 0 && feature.tooltip[0]);
    const int last = feature.word_count - 1;
    const int other = feature.word == last ? 0 : last;
    EXPECT(0, crevice_effect_set_feature(effect, "quality", feature.words[other]));
    EXPECT(2106, crevice_effect_set_feature(effect, "quality", "best"));
    EXPECT(0, crevice_effect_set_param(effect, "radius", share, 3));
    EXPECT(0, crevice_effect_set_scale(effect, 20, 0));
    EXPECT(0, crevice_effect_get_patch(effect, &text));
    CHECK(strstr(text, "\"5%\"") != NULL);

    desc.patch = text;
    crevice_effect* again = NULL;
    EXPECT(0, crevice_effect_create(device, &desc, &again));
    const char* text_again = NULL;
    EXPECT(0, crevice_effect_get_patch(again, &text_again));
    CHECK(strcmp(text, text_again) == 0);
    crevice_effect_destroy(again);
    crevice_effect_destroy(effect);
}

/// What a config may ask for at most.
static void check_limits(crevice_device* device)
{
    crevice_effect* effect = NULL;
    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 64, .height = 36};
    desc.config = kConfig;
    desc.max_passes = 1;
    EXPECT(1209, crevice_effect_create(device, &desc, &effect));
    desc.max_passes = -1;
    EXPECT(6011, crevice_effect_create(device, &desc, &effect));
    desc.max_passes = 0;
    desc.max_bytes = 1;
    EXPECT(1209, crevice_effect_create(device, &desc, &effect));
    desc.max_bytes = -1;
    EXPECT(6011, crevice_effect_create(device, &desc, &effect));
    CHECK(effect == NULL);
}

int main(void)
{
    check_nulls();
    crevice_context* context = NULL;
    crevice_error* error = crevice_context_create(NULL, &context);
    if (error) {
        fputs(crevice_error_text(error), stderr);
        crevice_error_free(error);
        return failures > 0 ? 1 : getenv("CREVICE_REQUIRE_GL") ? 1 : 77;
    }
    crevice_device_desc device_desc = {.struct_size = sizeof device_desc};
    crevice_device* device = NULL;
    EXPECT(6011, crevice_device_create(&device_desc, &device));  // without a loader
    device_desc.loader = crevice_context_find;
    device_desc.user = context;
    EXPECT(6011, crevice_device_create(&device_desc, NULL));
    EXPECT(0, crevice_device_create(&device_desc, &device));
    EXPECT(0, crevice_context_make_current(context));
    crevice_context* no_context = context;
    EXPECT(6012, crevice_context_create("vulkan", &no_context));
    CHECK(no_context == NULL);
    crevice_device_info info = {.struct_size = sizeof info};
    EXPECT(0, crevice_device_get_info(device, &info));
    CHECK(info.version >= 300 && info.name[0] && info.max_texture_size >= 2048);

    crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 64, .height = 36};
    desc.config = kConfig;
    crevice_effect* effect = NULL;
    EXPECT(6011, crevice_effect_create(device, &desc, NULL));
    EXPECT(0, crevice_effect_create(device, &desc, &effect));
    check_nulls_of(effect);
    check_places(device);
    check_settings(effect);
    check_lists(effect);
    check_patch(device);
    check_limits(device);
    EXPECT(6010, crevice_effect_render(effect));  // without its texture
    bool ready = true;
    EXPECT(6010, crevice_effect_warm(effect, &ready));
    CHECK(!ready);
    EXPECT(6011, crevice_effect_warm(effect, NULL));
    EXPECT(1201, crevice_effect_reload(effect, "no_such_config"));
    EXPECT(0, crevice_effect_resize(effect, 32, 18));
    EXPECT(4005, crevice_effect_resize(effect, 0, 18));
    EXPECT(0, crevice_effect_cut(effect));
    crevice_device_destroy(device);  // the effect keeps it alive
    EXPECT(0, crevice_effect_resize(effect, 64, 36));
    crevice_effect_destroy(effect);
    crevice_context_destroy(context);
    if (failures == 0) puts("all checks passed");
    return failures > 0 ? 1 : 0;
}
