// SPDX-License-Identifier: MIT
// The shipped modules by what they declare, so that tests run over all of them and a new one is
// among them by itself.
#pragma once

#include <crevice/config.h>

#include <set>

namespace crevice {

/// What a module declares, together with all that it extends.
struct Module {
    std::string name;               ///< As in `extends`: "ssao/gtao".
    std::set<std::string> targets;  ///< Its own, and the host's textures that it imports.
    std::set<std::string> options;  ///< Its params and features.
    bool reads_normals = false;     ///< A shader of its own asks the surface for normals.
    bool host_textures = false;     ///< It reads textures of the host's.
    bool remembers = false;         ///< It has a history.
};

/// Inputs: all below geometry/ that say how a surface is found, from one sample a pixel.
const std::vector<Module>& shippedInputs();

/// Estimators: all below ssao/ that make `ao` by shaders of their own.
const std::vector<Module>& shippedEstimators();

/// Filters: all below filter/ that make another output `ao` from the target `ao`.
const std::vector<Module>& shippedFilters();

/// Sources with one config, "given", that extends `modules`, has `more` JSON after that and finds
/// the files, by path and text; over the shipped ones.
class GivenConfig {
public:
    using File = std::pair<std::string, std::string>;
    explicit GivenConfig(const std::vector<std::string>& modules, const std::string& more = "",
                         const std::vector<File>& files = {});
    const SourceSet& sources() const { return layers_; }
    Description description(const std::vector<std::string>& overrides = {}) const;

private:
    MemorySources mine_;
    LayeredSources layers_;
};

/// A filter over the occlusion that a line of GLSL gives where a surface is seen: of uv, the point
/// in the `world` and the `frame_index`. The target is of that format.
Description filterOver(const std::string& ao, const std::string& filter, const char* format,
                       const std::vector<std::string>& overrides = {}, const char* radius = "0.5");

}  // namespace crevice
