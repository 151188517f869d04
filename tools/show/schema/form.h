// SPDX-License-Identifier: MIT
// The JSON Schema of a config, and pieces of such.
//
// Private to tools/show/schema*.cpp. A form is draft-07 but for "x-required", which marks a key
// that must be there once all files are merged. No form allows null yet: a patch's nulls come last.
#pragma once

#include <nlohmann/json.hpp>

#include <vector>

namespace crevice::table {

using Json = nlohmann::ordered_json;

/// Of a whole config, by the table in core/config/fields.h.
Json configForm();

/// An object of these properties, of "x-" keys and nothing else.
Json objectForm(Json properties);

/// An object whose keys match the pattern, or begin with "x-".
Json keyedForm(const char* pattern, Json entry);

/// One of several forms, with the default of the first that has one.
Json anyForm(std::vector<Json> forms);

}  // namespace crevice::table
