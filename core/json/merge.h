// SPDX-License-Identifier: MIT
// Merging documents: RFC 7396 merge patches that remember where each value came from; and
// overrides, single values laid over a merged document, as `--set` takes them.
#pragma once

#include <crevice/document.h>

namespace crevice {

/// An object of one member. The key has the object's place.
Node objectOf(std::string_view key, const Place& place, Node value);

/// A string.
Node textNode(std::string text, const Place& place);

/// CV1009: an object has more than kMaxMembers, which are too many from `place` on.
Diagnostic tooManyMembers(const Place& place, std::string pointer);

/// Applies `patch` to `base`: objects merge key by key, null deletes, anything else replaces.
/// A replaced value's places go into `origins` of the new one.
///
/// Errors: CV1101 (null for a key that is not there) and CV1102 (an object replaced by something
/// else, or the reverse), each at the patch's place with a note for the base's; CV1009. They are
/// appended to `errors`; the merge goes on so that every error is found. `pointer` is the base's.
void mergePatch(Node& base, const Node& patch, Diagnostics& errors,
                const std::string& pointer = {});

/// The smallest patch that makes `now` of `base`. Requires two objects.
Node patchBetween(const Node& base, const Node& now);

/// The help where an object with some of `keys` is wanted: the one that `value` surely means.
std::string wayToObject(std::string_view pointer, const Node& value,
                        const std::vector<std::string>& keys);

/// The path of an override's text in a SourceText, whose files stand in the current folder.
constexpr const char* kOverridePath = "./--set";

/// "name=value", read.
struct Override {
    std::string name;
    Place place;  ///< Of the name, in a text called "--set name=value".
    Node value;
};

/// Where an override's text stands, as readOverride has it.
Place overridePlace(const std::string& text, const std::vector<std::string>& roots = {});

/// Reads the value by parseValue; files that it names lie below the current folder or `roots`.
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
/// Errors: those of readOverride and of any patch, and CV4004 when nothing has the name.
Status applyOverride(Node& document, const std::string& text,
                     const std::vector<std::string>& roots = {});

}  // namespace crevice
