// SPDX-License-Identifier: MIT
// The config format for editors and for readers, out of the table that decoding uses
// (core/config/fields.h): what `crevice schema` prints.
#pragma once

#include <crevice/source.h>

namespace crevice {

/// A JSON Schema, draft 7, of a config or module as it is written. A file may hold but a part of
/// what it changes, so no key has to be there but `format`, and any value may be null, which
/// deletes. What several values say together (a default in its range, a name that exists) is for
/// `crevice validate`. Completion knows the modules and configs in `sources`, and
/// the params, features, targets and shaders that these declare.
std::string schemaJson(const SourceSet& sources);

/// Tables in Markdown: for each kind of object its keys, types, defaults, ranges and meaning.
std::string schemaMarkdown();

}  // namespace crevice
