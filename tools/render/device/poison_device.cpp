// SPDX-License-Identifier: MIT
// Filling new textures by clearing them.
#include "tools/render/device/poison_device.h"

#include "core/gpu/owned.h"

#include <algorithm>
#include <limits>

namespace crevice {

Result<TextureId> PoisonDevice::createTexture(const TextureDesc& desc)
{
    Result<TextureId> id = device_.createTexture(desc);
    // What nothing can be drawn into is written by whoever made it.
    if (!id || !caps().canRender(desc.format)) return id;
    const Status filled = fill(*id, desc);
    if (filled) return id;
    device_.destroy(*id);
    return filled.diagnostics();
}

Status PoisonDevice::fill(TextureId id, const TextureDesc& desc)
{
    const FormatInfo& format = formatInfo(desc.format);
    const bool depth = format.format_class == FormatClass::depth;
    FramebufferDesc target{"poison in " + desc.label};
    if (depth)
        target.depth = id;
    else
        target.color = {id};
    const Result<FramebufferId> framebuffer = device_.createFramebuffer(target);
    if (!framebuffer) return framebuffer.diagnostics();
    const Owned<FramebufferId> owned(device_, *framebuffer);

    PassInfo pass;
    pass.label = "poison";
    pass.framebuffer = *framebuffer;
    pass.extent = desc.extent;
    pass.color_count = depth ? 0 : 1;
    pass.color_load[0] = LoadOp::clear;
    pass.color_store[0] = StoreOp::store;
    const bool loud = not_a_number_ && format.format_class == FormatClass::floating;
    const float value = loud ? std::numeric_limits<float>::quiet_NaN() : poison_;
    std::fill(std::begin(pass.clear_color[0]), std::end(pass.clear_color[0]), value);
    pass.has_depth = depth;
    pass.depth_load = LoadOp::clear;
    pass.depth_store = StoreOp::store;
    pass.clear_depth = poison_;
    if (Status status = device_.beginFrame(); !status) return status;
    for (; pass.first_layer < std::max(desc.depth, 1); ++pass.first_layer) {
        pass.makes_mips = pass.first_layer + 1 >= desc.depth;
        device_.beginPass(pass);
        device_.endPass();
    }
    return device_.endFrame();
}

}  // namespace crevice
