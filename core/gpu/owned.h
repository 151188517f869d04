// SPDX-License-Identifier: MIT
// A device object that is destroyed with its owner.
#pragma once

#include <crevice/device.h>

namespace crevice {

/// Move-only; a moved-from one owns nothing. The device must outlive it.
template <class Id>
class Owned {
public:
    Owned() = default;
    Owned(Device& device, Id id) : device_(&device), id_(id) {}
    Owned(Owned&& other) noexcept : device_(other.device_), id_(std::exchange(other.id_, Id{})) {}
    Owned& operator=(Owned&& other) noexcept
    {
        std::swap(device_, other.device_);
        std::swap(id_, other.id_);
        return *this;
    }
    ~Owned()
    {
        if (id_) device_->destroy(id_);
    }

    Id id() const { return id_; }

private:
    Device* device_ = nullptr;
    Id id_ = {};
};

}  // namespace crevice
