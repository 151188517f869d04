// SPDX-License-Identifier: MIT
// Fixed-function state of a pass, and how a texture is sampled.
#pragma once

namespace crevice {

/// Most samples that a pixel may have; what a device draws, `DeviceCaps::sample_counts` says.
constexpr int kMaxSamples = 32;

/// Draws the draw list, or one triangle over the target.
enum class PassType { draw, fullscreen };

enum class Cull { none, back, front };
enum class Compare { always, less, less_equal, greater, greater_equal, equal };
enum class Filter { nearest, linear };
enum class Wrap { clamp, repeat };

/// Fixed-function state.
struct StateDesc {
    Compare depth_test = Compare::always;  ///< A draw pass with a depth target defaults to less.
    bool depth_write = false;              ///< ... and to true.
    Cull cull = Cull::none;
};

}  // namespace crevice
