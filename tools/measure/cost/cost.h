// SPDX-License-Identifier: MIT
// What a config costs on phones: what `crevice cost` prints.
//
// The compilers of phones' GPUs say what their hardware makes of each program, the plan how many
// pixels and bytes each pass has, and a drawn frame how often it fetches. No phone is needed, and
// no time is measured.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/render/scene/options.h"

#include <nlohmann/json.hpp>

namespace crevice {

struct CostOptions {
    std::vector<std::string> configs;
    ConfigOptions config;  ///< Of all of them; `config` itself is not looked at.
    SceneOptions scene;
    std::vector<std::string> gpus;  ///< Their names; empty: all.
    std::string compilers;          ///< Their folder; empty: the usual one.
};

/// The figures, as docs/cost/phones.json has them: what was drawn, then for each config its passes,
/// and the sums `ao`, from depth to AO of full size, and `ao_with_geometry`, with what is drawn for
/// AO alone. Of that, fetches are not counted, and cycles are those of one layer of fragments,
/// without vertices.
using CostReport = nlohmann::ordered_json;

/// Plans every config for the scene on a usual device, and asks compilers and a drawn frame.
/// Errors: CV6021, CV8001 for a GPU that is not known, those of loading, planning and the scene.
Result<CostReport> measureCost(const CostOptions& options, const SourceSet& sources);

/// Adds both sums to a config that has its passes.
void addSums(CostReport& config);

/// For people; the last line says where it is explained.
std::string costText(const CostReport& report);

/// JSON in which an object without lists inside takes one line, so that a difference of two files
/// reads well.
std::string costJson(const CostReport& report);

}  // namespace crevice
