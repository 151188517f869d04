// SPDX-License-Identifier: MIT
// Baking: from configs to the bytes that readBaked reads (<crevice/baked.h>).
#pragma once

#include <crevice/baked.h>

namespace crevice {

/// "display=lit,no_ao": values that are baked of a feature, a param or a trait.
struct BakeValues {
    std::string name;
    std::vector<std::string> values;
};

/// A config to bake. Its description is as it was loaded.
struct BakeRequest {
    std::string name;
    std::vector<std::string> set = {};
    double ms = 0, error = 0;  ///< Of a level of a front.
    Description description = {};
};

struct BakeOptions {
    std::vector<std::string> outputs = {};  ///< Empty: all but those on request.
    std::vector<BakeValues> values = {};    ///< Of features and params; others as they are.
    std::vector<BakeValues> traits = {};    ///< Others as `scene` has them.
    SceneTraits scene = {};
};

/// Most plans that a config may need: one for each combination of what is listed.
constexpr std::size_t kMostBakedPlans = 1024;

/// Bakes the configs into one file. Deterministic: the same input gives the same bytes.
///
/// Errors: those of `compile`; CV8001 for values of what is not there, decides nothing, or cannot
/// be; and for more than kMostBakedPlans of a config.
Result<std::string> bake(const std::vector<BakeRequest>& requests, const BakeOptions& options);

/// A text with the same meaning to a driver: no comments, no #line, no branches and macros that are
/// decided, no functions and variables that `main` does not reach. `late` are macros whose value is
/// to be given later: they stay as they are, and their #defines go.
///
/// Errors: CV5009 where it cannot be read.
Result<std::string> stripped(const std::string& text, const std::vector<std::string>& late);

/// Which of the macros that the text begins with have no value that an #if of it asks for.
std::vector<std::string> lateMacros(const std::string& text, const std::vector<std::string>& names);

/// What `unpack` (core/bake/pack.h) reads.
std::string pack(std::string_view bytes);

/// The bytes as a C header: `static const unsigned char NAME[]`, and `NAME_size`.
std::string asHeader(std::string_view bytes, const std::string& name);

}  // namespace crevice
