// SPDX-License-Identifier: MIT
// The compilers of phones' GPUs, which tools/scripts/mobile_compilers.sh builds, at work.
#pragma once

#include "tools/measure/cost/gpus.h"

#include <crevice/plan.h>

namespace crevice {

/// Where they lie: in `folder`; where that is empty, in the one that CREVICE_MOBILE_COMPILERS
/// names, or where the script puts them. Errors: CV6021 where one of them is not there.
Result<std::string> findCompilers(std::string folder);

/// What the compiler of one GPU made of a plan's programs.
struct CompiledPrograms {
    std::string version;                   ///< "Mesa 22.3.6"
    std::vector<CompilerFigures> figures;  ///< One for each program, in their order.
};

/// Errors: CV6021 where the compiler does not run to its end.
Result<CompiledPrograms> compilePrograms(const std::string& folder, const CostGpu& gpu,
                                         const std::vector<PlanProgram>& programs);

}  // namespace crevice
