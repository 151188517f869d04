// SPDX-License-Identifier: MIT
// The passes that a config's occlusion goes through, and which of them a failure begins with.
#pragma once

#include "tools/measure/stress/record.h"

#include <crevice/compile.h>

namespace crevice {

/// What a pass wrote of the occlusion, in 32-bit floats.
struct PassPicture {
    std::string pass;
    std::string target;
    Image occlusion = {};
};

/// From the estimator to the last filter: the writer of the output, and of what it says that it
/// keeps (`preserves_constant`), and so on. Without pictures.
std::vector<PassPicture> occlusionPasses(const Plan& plan, const Description& description,
                                         const std::string& output);

/// The first pass whose picture departs from the exact answer at least half as far as that which
/// `record` is about, and past the limits of the case; empty where none does, or what is expected
/// is not an amount. Of colours the last one, since no exact answer has those. `ordinary` are those
/// of the ordinary step.
std::string departingPass(const StressCase& stress, const StressShot& shot,
                          const std::vector<PassPicture>& passes,
                          const std::vector<PassPicture>& ordinary, const StressRecord& record);

}  // namespace crevice
