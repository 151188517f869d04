// SPDX-License-Identifier: MIT
// What a config costs on phones: what `crevice cost` prints.
//
// The compilers of phones' GPUs say what their hardware makes of each program, the plan how many
// pixels and bytes each pass has, and a drawn frame how often it fetches. No phone is needed, and
// no time is measured.
//
// Each pass is for something, so that the cost of ambient occlusion can be told from that of the
// picture; and a report can be compared with one that was approved.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/render/scene/options.h"

#include <crevice/plan.h>

#include <nlohmann/json.hpp>

namespace crevice {

enum class PassRole {
    ao,               ///< Fullscreen, on the way from depth to the output `ao`.
    geometry_for_ao,  ///< Draws the scene, and only AO reads what it writes: back faces, layers.
    geometry,         ///< Draws the scene for AO and for the picture; its depth is the scene's own.
    picture,          ///< All else: lighting, what it reads.
};

/// "AO", "geometry for AO", ...
const char* nameOf(PassRole role);

/// One for each pass of the plan. Where it has no output `ao`, all outputs count as such.
std::vector<PassRole> passRoles(const Plan& plan);

/// Bytes a frame of colour attachments that passes of the role `geometry` store for AO alone, such
/// as normals.
double bytesForAo(const Plan& plan, const std::vector<PassRole>& roles);

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

/// By how much a sum may grow: what the smallest changes of a shader do to a compiler's choices.
constexpr double kCostGrowth = 0.10;

struct ApprovedCost {
    CostReport report;
    CostOptions options;  ///< Under which it is measured again.
};

/// Reads what costJson wrote. The options become those of the text where it has them, so that
/// nothing but the shaders can differ. Errors: CV7009 for a text that holds no costs.
Result<ApprovedCost> readCost(const std::string& name, const std::string& text,
                              const CostOptions& options);

struct CostComparison {
    std::vector<std::string> worse;   ///< One sentence each: where, what was, what is.
    std::vector<std::string> better;  ///< Less than 1 / (1 + kCostGrowth).
};

/// Of each config's AO, with all that is drawn for it: worse is more than kCostGrowth more fetches
/// or, on any GPU, instructions, cycles, spills or fills; lower occupancy; and a refused pass.
/// Requires reports of the same configs and GPUs, as ApprovedCost::options gives them.
Result<CostComparison> compareCosts(const CostReport& approved, const CostReport& now);

}  // namespace crevice
