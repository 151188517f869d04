// SPDX-License-Identifier: MIT
// A device whose new textures are full of loud values, so that what is read before it was written
// shows.
#pragma once

#include "tools/render/device/forwarding_device.h"

namespace crevice {

/// What the other device leaves undefined in a new texture, the poison fills: a colour that no pass
/// writes by chance, or not a number where `not_a_number` is set and the format can hold that.
class PoisonDevice : public ForwardingDevice {
public:
    PoisonDevice(Device& device, float poison, bool not_a_number)
        : ForwardingDevice(device),
          poison_(poison),
          not_a_number_(not_a_number)
    {
    }

    Result<TextureId> createTexture(const TextureDesc& desc) override;

private:
    Status fill(TextureId id, const TextureDesc& desc);

    float poison_;
    bool not_a_number_;
};

/// The 32-bit float format with at least the channels of `format`; `format` itself where it is one
/// of depth.
inline Format floatFormat(Format format)
{
    const FormatInfo& info = formatInfo(format);
    if (info.format_class == FormatClass::depth) return format;
    if (info.channels == 1) return Format::r32f;
    return info.channels == 2 ? Format::rg32f : Format::rgba32f;
}

/// A device that stores every colour target in 32-bit floats, so that what 8 and 16 bits round,
/// clamp or lose on the way in shows.
///
/// Not a number becomes 0 in a format of 8 bits, and 1.7 becomes 1: here both stay as the shader
/// wrote them. Depth keeps its format. What the plan knows of formats, such as the macros of their
/// steps, stays that of the formats asked for.
class FloatDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    Result<TextureId> createTexture(const TextureDesc& desc) override
    {
        TextureDesc wide = desc;
        wide.format = floatFormat(desc.format);
        return device_.createTexture(caps().canRender(wide.format) ? wide : desc);
    }
};

}  // namespace crevice
