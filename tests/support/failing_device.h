// SPDX-License-Identifier: MIT
// A device over another one that fails on demand, as one without memory would.
#pragma once

#include "tools/device/forwarding_device.h"

namespace crevice {

class FailingDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    /// Makes the n-th coming call that creates or fills an object fail with CV6009; 0 makes none.
    void failAt(int n) { fail_in_ = n; }

    /// Objects that exist.
    int live() const { return live_; }

    Result<TextureId> createTexture(const TextureDesc& desc) override
    {
        return failsNow() ? no_memory_ : counted(ForwardingDevice::createTexture(desc));
    }
    Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) override
    {
        return failsNow() ? no_memory_ : counted(ForwardingDevice::createFramebuffer(desc));
    }
    Result<ProgramId> createProgram(const ProgramDesc& desc) override
    {
        return failsNow() ? no_memory_ : counted(ForwardingDevice::createProgram(desc));
    }
    Result<MeshId> createMesh(const MeshDesc& desc) override
    {
        return failsNow() ? no_memory_ : counted(ForwardingDevice::createMesh(desc));
    }
    void destroy(ObjectId id) override
    {
        if (id.value > 0) --live_;
        ForwardingDevice::destroy(id);
    }
    Status writeTexture(TextureId id, const Image& image) override
    {
        return failsNow() ? no_memory_ : ForwardingDevice::writeTexture(id, image);
    }

private:
    bool failsNow() { return fail_in_ > 0 && --fail_in_ == 0; }

    template <class Id>
    Result<Id> counted(Result<Id> made)
    {
        if (made) ++live_;
        return made;
    }

    const Diagnostic no_memory_{Code::out_of_memory, "no memory is left, as it was asked for"};
    int fail_in_ = 0;
    int live_ = 0;
};

}  // namespace crevice
