// SPDX-License-Identifier: MIT
// Merging documents: RFC 7396 merge patches that remember where each value came from.
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

/// The smallest patch that makes `now` of `base`; it has no member where they are the same.
/// Requires two objects.
Node patchBetween(const Node& base, const Node& now);

/// The help where a value stands and an object with some of `keys` is wanted: the object that was
/// surely meant.
std::string wayToObject(std::string_view pointer, const Node& value,
                        const std::vector<std::string>& keys);

}  // namespace crevice
