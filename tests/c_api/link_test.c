// SPDX-License-Identifier: MIT
// The least that needs all of the static library: an effect that is refused, without GL.
#include <crevice/crevice.h>

#include <stdlib.h>

int main(void)
{
    crevice_effect* effect = NULL;
    crevice_context* context = NULL;
    crevice_error* refused = crevice_effect_create(NULL, NULL, &effect);
    crevice_error* unknown = crevice_context_create("vulkan", &context);
    const bool well = crevice_version() == CREVICE_VERSION && crevice_error_code(refused) == 6011 &&
                      crevice_error_code(unknown) == 6012;
    crevice_error_free(refused);
    crevice_error_free(unknown);
    return well ? 0 : 1;
}
