// SPDX-License-Identifier: MIT
// What every device can do.
#include "core/device.h"

namespace crevice {

DeviceCaps minimumCaps()
{
    DeviceCaps caps;
    caps.name = "minimum of OpenGL ES 3.0";
    for (const FormatInfo& info : allFormats())
        caps.renderable[static_cast<int>(info.format)] = info.core_renderable;
    return caps;
}

}  // namespace crevice
