// SPDX-License-Identifier: MIT
// The config format for editors and for readers, out of the table that decoding uses
// (core/config/fields.h): what `crevice schema` prints.
#pragma once

#include <crevice/diagnostic.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace crevice {

/// A JSON Schema, draft 7, of a config or module as it is written. A file may hold but a part of
/// what it changes, so no key has to be there but `format`, and any value may be null, which
/// deletes. What several values say together (a default in its range, a name that exists) is for
/// `crevice validate`. Completion knows the modules and configs in `sources`, and
/// the params, features, targets and shaders that these declare.
std::string schemaJson(const SourceSet& sources);

/// What there is to choose: of that kind, or the names of all where it is "": configs, modules,
/// filters, estimators, and scenes, whose texts by name `scenes` is. Errors: CV8001 for another.
Result<nlohmann::ordered_json> listJson(const SourceSet& sources,
                                        const std::map<std::string, std::string>& scenes,
                                        const std::string& kind);

/// Tables in Markdown: for each kind of object its keys, types, defaults, ranges and meaning.
std::string schemaMarkdown();

/// Pieces of schemas, private to tools/show/schema. A form is draft-07 but for "x-required", which
/// marks a key that must be there once all files are merged. No form allows null yet: a patch's
/// nulls come last.
namespace table {

using Json = nlohmann::ordered_json;

/// Of a whole config, by the table in core/config/fields.h.
Json configForm();

/// An object of these properties, of "x-" keys and nothing else.
Json objectForm(Json properties);

/// An object whose keys match the pattern, or begin with "x-".
Json keyedForm(const char* pattern, Json entry);

/// One of several forms, with the default of the first that has one.
Json anyForm(std::vector<Json> forms);

}  // namespace table

}  // namespace crevice
