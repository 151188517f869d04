// SPDX-License-Identifier: MIT
// Plans as text, JSON and Graphviz: what `crevice explain` prints.
#pragma once

#include <crevice/plan.h>

#include <nlohmann/json_fwd.hpp>

namespace crevice {

/// Text for people, stable enough to compare in tests.
std::string toText(const Plan& plan);
std::string toJson(const Plan& plan);

/// JSON for people too: an object or list takes one line unless objects are in it.
std::string jsonLines(const nlohmann::ordered_json& json, const std::string& indent = "");

/// A drawing for Graphviz: passes are boxes, textures are ellipses, edges follow the data.
std::string toDot(const Plan& plan);

}  // namespace crevice
