// SPDX-License-Identifier: MIT
#include "tools/render/device/float_device.h"

namespace crevice {

Format floatFormat(Format format)
{
    const FormatInfo& info = formatInfo(format);
    if (info.format_class == FormatClass::depth) return format;
    if (info.channels == 1) return Format::r32f;
    return info.channels == 2 ? Format::rg32f : Format::rgba32f;
}

Result<TextureId> FloatDevice::createTexture(const TextureDesc& desc)
{
    TextureDesc wide = desc;
    wide.format = floatFormat(desc.format);
    return device_.createTexture(caps().canRender(wide.format) ? wide : desc);
}

}  // namespace crevice
