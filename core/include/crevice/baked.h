// SPDX-License-Identifier: MIT
// Baked effects: what `crevice bake` wrote, read by a library that has no JSON, compiler or shader.
//
//     auto baked = readBaked(bytes, sizeof bytes);             // of `crevice bake mobile --header`
//     auto effect = Effect::create(device, baked->front(), {1920, 1080});
//
// A baked effect has the plans of one or more configs for what was listed when it was baked: words
// of features, values of params that decide what is compiled, kinds of scenes and cameras. Sizes,
// formats, all other params, views, and what a device can do are free, as with a config, and it
// draws the same to the last bit. What is not in it is the error CV2301, which says what to bake.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// One config of a baked effect, or a level of a governor.
struct BakedConfig {
    std::string name;              ///< As it was baked: "mobile+geometry/host_depth".
    std::vector<std::string> set;  ///< What was set in it: "radius=1".
    double ms = 0;                 ///< Of a level of a front: GPU time; 0 of what is none.
    double error = 0;              ///< ... and its error; 0 where nobody knows.
    Description description;       ///< Without GLSL, and with its planner.
    SceneTraits scene = {};        ///< One that it was baked for; `camera` and `scale` are unknown.
    std::size_t plan_count = 0;    ///< Plans that were baked, and programs of all of them.
    std::size_t program_count = 0;
};

/// Reads a baked effect of `size` bytes at `data`, which it does not need any longer then.
///
/// Errors: CV1301 for bytes that are none, damaged or cut short; CV1302 for those of another
/// version of crevice. Its plans: CV2301 for what was not baked, CV6006, CV6007 and CV1209 for
/// sizes and formats that the device or the limits do not allow.
Result<std::vector<BakedConfig>> readBaked(const void* data, std::size_t size);

/// Whether they begin as a baked effect does.
bool isBaked(const void* data, std::size_t size);

/// That of the name; the first where it is empty. Errors: CV2301.
Result<BakedConfig> bakedConfig(std::vector<BakedConfig> baked, std::string_view name);

}  // namespace crevice
