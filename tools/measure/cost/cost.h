// SPDX-License-Identifier: MIT
// What a config costs on phones: what `crevice cost` prints.
//
// The compilers of phones' GPUs say what their hardware makes of each program, the plan how many
// pixels and bytes each pass has, and a drawn frame how often it fetches. No phone is needed, and
// no time is measured.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/cost/compilers.h"
#include "tools/measure/cost/pass_roles.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/costs.h"

#include <optional>
#include <string>
#include <vector>

namespace crevice {

struct CostOptions {
    std::vector<std::string> configs;
    ConfigOptions config;  ///< Of all of them; `config` itself is not looked at.
    SceneOptions scene;
    std::vector<std::string> gpus;  ///< Their names; empty: all.
    std::string compilers;          ///< Their folder; empty: the usual one.
};

struct PassCost {
    std::string pass;
    PassRole role = PassRole::ao;
    Extent extent;
    double pixels = 0;  ///< Of the pass, for one of the picture.
    MovedBytes bytes;
    std::optional<double> fetches;  ///< For one pixel of the picture; not of passes that draw.
    std::vector<CompilerFigures> figures;  ///< Of its fragment shader, in the order of the GPUs.
};

struct ConfigCost {
    std::string config;
    std::string uncounted;             ///< Why there are no fetches; empty where they were counted.
    double geometry_bytes_for_ao = 0;  ///< What the picture's own geometry stores for AO alone.
    std::vector<PassCost> passes;      ///< In the order of the plan.
};

struct CostReport {
    std::string scene;
    Extent extent;
    std::string camera;            ///< As --camera had it.
    std::string variant;           ///< Of all configs, and
    std::vector<std::string> set;  ///< ... overrides in force in them.
    std::string version;           ///< Of the compilers: "Mesa 22.3.6".
    std::vector<const CostGpu*> gpus;
    std::vector<ConfigCost> configs;
};

/// What one GPU's compiler makes of several passes.
struct GpuSum {
    bool refused = false;  ///< It does not compile one of them; the rest is of the others.
    int instructions = 0;
    int spills = 0;  ///< Largest; with the fills of that shader.
    int fills = 0;
    int threads = 0;  ///< Lowest.
    double cycles =
        -1;  ///< For one pixel of the picture: those of each pass for each of its pixels.
    int code_bytes = 0;
    int arithmetic = -1;
    int half_arithmetic = -1;
};

/// What some of a config's passes cost together.
struct CostSum {
    int passes = 0;
    std::optional<double> fetches;  ///< For one pixel of the picture.
    MovedBytes bytes;
    std::vector<GpuSum> gpus;
};

/// AO from depth to its full-size output; with what is drawn for AO alone: of that, fetches are
/// not counted, and cycles are those of one layer of fragments, without vertices.
CostSum sumOfAo(const CostReport& report, const ConfigCost& config, bool with_geometry);

/// Plans every config for the scene on a usual device, and asks compilers and a drawn frame.
/// Errors: CV6021, CV8001 for a GPU that is not known, those of loading, planning and the scene.
Result<CostReport> measureCost(const CostOptions& options, const SourceSet& sources);

/// For people; the last line says where it is explained.
std::string toText(const CostReport& report);
/// The same with all figures; `readCost` reads it.
std::string toJson(const CostReport& report);
/// Errors: CV7009 where the text is none of toJson's.
Result<CostReport> readCost(const std::string& name, const std::string& text);

}  // namespace crevice
