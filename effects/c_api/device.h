// SPDX-License-Identifier: MIT
// The handles of devices.
#pragma once

#include <crevice/crevice.h>
#include <crevice/device.h>

#include <memory>

/// The effects that were made on the device keep it alive too.
struct crevice_device {
    std::shared_ptr<crevice::Device> device;
};
