// SPDX-License-Identifier: MIT
// SPIR-V in which mediump is computed as wanted.
//
// Mediump values are decorated RelaxedPrecision there. In half floats each of them is rounded as it
// arises: from 65520 on to infinity, below 2^-14 to 0, which is the least that every phone keeps.
// What a phone has no instruction for is taken apart first, so that what overflows on the way does
// so here too: normalize() is a dot product, an inverse root and a product, pow() a logarithm, a
// product and an exponential, a / b is a * (1 / b).
#pragma once

#include "tools/render/device/mediump_device.h"

#include <cstdint>
#include <vector>

namespace crevice {

/// The module `words`, all else as it was; none of its values is mediump any more. Of locations and
/// bindings only those of vertex inputs and fragment outputs stay: everything else goes by name.
std::vector<std::uint32_t> rewriteMediump(const std::vector<std::uint32_t>& words, Mediump mediump);

}  // namespace crevice
