/* SPDX-License-Identifier: MIT */
/* The least host, whose size tools/scripts/sizes.sh takes: AO of a depth texture by BAKED, a header
   of crevice bake, or by the config CONFIG; without either it does nothing. */
#include <stdio.h>

#if defined(BAKED) || defined(CONFIG)
#include <crevice/crevice.h>
#ifdef BAKED
#include "baked.h"
#endif

extern void* find_function(const char* name, void* user);

static int failed(crevice_error* error)
{
    if (error) fputs(crevice_error_text(error), stderr);
    return error != NULL;
}

int main(void)
{
    static const float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2f, 0};
    crevice_device_desc opened = {.struct_size = sizeof opened, .loader = find_function};
    crevice_effect_desc wanted = {.struct_size = sizeof wanted, .width = 640, .height = 360};
    crevice_texture depth = {
        .struct_size = sizeof depth, .name = 1, .format = "depth24", .width = 640, .height = 360};
    crevice_output ao = {.struct_size = sizeof ao};
    crevice_device* device = NULL;
    crevice_effect* effect = NULL;
#ifdef BAKED
    wanted.baked = baked;
    wanted.baked_size = baked_size;
#else
    wanted.config = CONFIG;
#endif
    if (failed(crevice_device_create(&opened, &device))) return 1;
    if (failed(crevice_effect_create(device, &wanted, &effect))) return 1;
    if (failed(crevice_effect_set_projection(effect, projection))) return 1;
    if (failed(crevice_effect_set_texture(effect, "depth", &depth))) return 1;
    if (failed(crevice_effect_render(effect))) return 1;
    if (failed(crevice_effect_get_output(effect, "ao", &ao))) return 1;
    printf("%u\n", ao.texture);
    crevice_effect_destroy(effect);
    crevice_device_destroy(device);
    return 0;
}
#else
int main(void)
{
    puts("nothing");
    return 0;
}
#endif
