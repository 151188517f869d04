// SPDX-License-Identifier: MIT
// Where a value of a merged document came from: what `crevice explain --why` prints.
#pragma once

#include "core/document.h"

#include <string>

namespace crevice {

/// A value with the RFC 6901 pointer that leads to it.
struct FoundValue {
    std::string pointer;
    const Node* node = nullptr;  ///< Into the document that was searched.
};

/// Finds "/passes/ssao/inputs/depth", "passes.ssao.inputs.depth", or a param's or feature's default
/// by its bare name.
/// Errors: CV2102 that names the last part found and what it holds.
Result<FoundValue> findValue(const Node& document, const std::string& path);

/// The value, and each place that set it, the newest first.
std::string explainText(const FoundValue& value);

/// The same as {"pointer", "value", "places": [{"file", "line", "column", "text"}]}.
std::string explainJson(const FoundValue& value);

}  // namespace crevice
