// SPDX-License-Identifier: MIT
// Directions over a surface that probe what is open: an even share of the cosine-weighted
// hemisphere each, in passes that are spread as evenly by themselves.
#pragma once

#include <vector>

namespace crevice {

/// A Hammersley point on the unit disc; the hemisphere's direction lies above it (Malley).
struct Probe {
    float radius_squared;  ///< Before its rotation.
    float cosine, sine;    ///< Of the angle.
};

/// All probes, pass by pass.
struct ProbePasses {
    std::vector<Probe> probes;
    std::vector<int> begins;  ///< Of each pass in `probes`, and then their number.
};

/// `count` probes, >= 1, in `passes`, a power of two of at most `count`. The probes are the same
/// for any number of passes, and one pass has them in their order.
ProbePasses makeProbes(int count, int passes);

}  // namespace crevice
