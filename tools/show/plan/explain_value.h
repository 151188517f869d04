// SPDX-License-Identifier: MIT
// Where a value of a merged document came from: what `crevice explain --why` prints.
#pragma once

#include <crevice/document.h>

namespace crevice {

/// A value with the RFC 6901 pointer that leads to it.
struct FoundValue {
    std::string pointer;
    const Node* node = nullptr;  ///< Into the document that was searched.
    /// Where a level sets it by its bare name, the default that counts for nothing, if that is
    /// another value; else empty.
    std::vector<FoundValue> overruled = {};
};

/// Finds "/passes/ssao/inputs/depth", "passes.ssao.inputs.depth", or a param's or feature's default
/// by its bare name.
/// Errors: CV2102 that names the last part found and what it holds, or what else has the name.
Result<FoundValue> findValue(const Node& document, const std::string& path);

/// The value, and each place that set it, the newest first, then the same of what it overrules; of
/// an object, those of all values in it.
std::string explainText(const FoundValue& value);

/// The same as {"pointer", "value", "places": [{"file", "line", "column", "text"}]}, where an
/// object has "members" and what overrules a default "overruled", lists of these.
std::string explainJson(const FoundValue& value);

}  // namespace crevice
