// SPDX-License-Identifier: MIT
// Overrides: single values laid over a merged document, as `--set` takes them.
#pragma once

#include <crevice/document.h>

#include <string>

namespace crevice {

/// The path of an override's text in a SourceText: the files that it names stand in the current
/// folder.
constexpr const char* kOverridePath = "./--set";

/// "name=value", read.
struct Override {
    std::string name;
    Place place;  ///< Of the name, in a text called "--set name=value".
    Node value;
};

/// Where an override's text stands, as readOverride has it.
Place overridePlace(const std::string& text, const std::vector<std::string>& roots = {});

/// Reads the value by parseValue. A file that it names is seen from the current folder and lies
/// below that or below `roots`.
///
/// Errors: CV1206 when there is no name or no value, CV1001 to CV1006 for the value.
Result<Override> readOverride(const std::string& text, const std::vector<std::string>& roots = {});

/// The keys that lead to each value that a word of a feature gives the param or feature of that
/// name: {"features", "quality", "sets", "low", "steps"}.
std::vector<std::vector<std::string>> levelPaths(const Node& document, const std::string& name);

/// Applies "radius=0.8", which sets the default of the param or feature of that name and the value
/// at each level that sets it, or "/passes/blur/when=null", which sets or deletes what an RFC 6901
/// pointer names and makes the objects on the way.
///
/// Errors: those of readOverride, CV4004 when nothing has the name, CV1101 and CV1102 as for any
/// patch.
Status applyOverride(Node& document, const std::string& text,
                     const std::vector<std::string>& roots = {});

}  // namespace crevice
