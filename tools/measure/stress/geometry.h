// SPDX-License-Identifier: MIT
// Configs over other geometry modules, a host's own depth and normals among them.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/stress/case.h"

#include <map>
#include <string>
#include <vector>

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

/// Depth and normals on a device, of a host that does something to them.
class ChangedTextures {
public:
    /// Draws the shot's scene as its host does, and does to the textures what the host does.
    /// Errors: those of the device.
    static Result<ChangedTextures> make(Device& device, const StressShot& shot);
    ~ChangedTextures();
    ChangedTextures(ChangedTextures&& other) noexcept;
    ChangedTextures(const ChangedTextures&) = delete;
    ChangedTextures& operator=(const ChangedTextures&) = delete;

    const std::vector<ImportedTexture>& textures() const { return textures_; }

private:
    explicit ChangedTextures(Device& device) : device_(&device) {}
    Status add(const char* name, Format format, const Image& image);

    Device* device_;
    std::vector<ImportedTexture> textures_;
};

}  // namespace crevice
