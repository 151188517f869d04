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

}  // namespace crevice
