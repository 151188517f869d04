// SPDX-License-Identifier: MIT
// Configs over a host's own depth and normals: the same methods and filters, other geometry modules.
#pragma once

#include "tools/config_options.h"
#include "tools/stress_case.h"

#include <string>
#include <vector>

namespace crevice {

/// In the place of the geometry modules that draw depth, those that read a host's textures. So any config
/// that extends one of them becomes one over a host's; others stay as they are.
MemorySources hostModules();

/// Depth and normals on a device as a host brings them.
class HostTextures {
public:
    /// Draws the shot's scene as its host does, and does to the textures what the host does.
    /// Errors: those of the device.
    static Result<HostTextures> make(Device& device, const StressShot& shot,
                                     const SourceSet& sources);
    ~HostTextures();
    HostTextures(HostTextures&& other) noexcept;
    HostTextures(const HostTextures&) = delete;
    HostTextures& operator=(const HostTextures&) = delete;

    const std::vector<ImportedTexture>& textures() const { return textures_; }

private:
    explicit HostTextures(Device& device) : device_(&device) {}
    Status add(const char* name, Format format, const Image& image);

    Device* device_;
    std::vector<ImportedTexture> textures_;
};

}  // namespace crevice
