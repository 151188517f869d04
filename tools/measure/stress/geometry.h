// SPDX-License-Identifier: MIT
// Configs over other geometry modules, a host's own depth and normals among them.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/stress/case.h"

namespace crevice {

/// What stands in for geometry modules, so that any config that extends one of them becomes one
/// over another. Others stay as they are.
class Substitutes {
public:
    explicit Substitutes(const SourceSet& sources);

    /// Sources in which `geometry`, one of the names below, is extended instead; else those given.
    const SourceSet& over(const std::string& geometry) const;

private:
    struct Layer {
        Layer(MemorySources substitutes, const SourceSet& sources);

        MemorySources modules;
        LayeredSources all;
    };

    const SourceSet& own_;
    std::map<std::string, Layer> over_;
};

constexpr const char* kHostGeometry = "host";
constexpr const char* kPositionGeometry = "positions";
constexpr const char* kLinearGeometry = "linear depth";
constexpr const char* kDepthGeometry = "depth and normals";

/// Depth and normals on a device, of a host that draws the shot's scene and then does to them what
/// the shot says. The device must outlive them. Errors: those of the device.
Result<std::shared_ptr<const std::vector<ImportedTexture>>> changedTextures(Device& device,
                                                                            const StressShot& shot);

}  // namespace crevice
