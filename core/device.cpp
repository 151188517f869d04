// SPDX-License-Identifier: MIT
// What every device can do.
#include "core/device.h"

namespace crevice {

DeviceCaps minimumCaps()
{
    DeviceCaps caps;
    caps.name = "minimum of OpenGL ES 3.0";
    for (const FormatInfo& info : allFormats()) {
        if (!info.core_renderable) continue;
        caps.renderable[static_cast<int>(info.format)] = true;
        caps.sample_counts[static_cast<int>(info.format)] = 1u << 3;  // GL_MAX_SAMPLES is 4 or more
    }
    return caps;
}

}  // namespace crevice
