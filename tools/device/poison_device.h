// SPDX-License-Identifier: MIT
// A device whose new textures are full of loud garbage, so that what is read before it was written shows.
#pragma once

#include "tools/device/forwarding_device.h"

namespace crevice {

/// What the other device leaves undefined in a new texture, the garbage fills: a colour that no pass writes
/// by chance, or not a number where `not_a_number` is set and the format can hold that.
class GarbageDevice : public ForwardingDevice {
public:
    GarbageDevice(Device& device, float garbage, bool not_a_number)
        : ForwardingDevice(device), garbage_(garbage), not_a_number_(not_a_number) {}

    Result<TextureId> createTexture(const TextureDesc& desc) override;

private:
    Status fill(TextureId id, const TextureDesc& desc);

    float garbage_;
    bool not_a_number_;
};

}  // namespace crevice
