// SPDX-License-Identifier: MIT
// nlohmann-json for the files of core that read JSON; no public header includes this.
//
// They are built without exceptions, while a program that links them may use nlohmann-json with
// them. Both would emit inline functions of the same names but other content, of which the linker
// keeps one at random. A namespace of our own keeps them apart.
#pragma once

#define NLOHMANN_JSON_NAMESPACE nlohmann::crevice_core
#define NLOHMANN_JSON_NAMESPACE_BEGIN namespace nlohmann { inline namespace crevice_core {
#define NLOHMANN_JSON_NAMESPACE_END } }
#include <nlohmann/json.hpp>
