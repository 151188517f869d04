// SPDX-License-Identifier: MIT
// Descriptions for tests, from a few lines of JSON and GLSL.
#pragma once

#include <crevice/config.h>

#include "tests/support/need.h"

namespace crevice {

struct TestFile {
    std::string path;
    std::string text;
};

/// Lets a document declare more than it uses, as the modules behind a config may.
inline Node asModule(Node document)
{
    document.place.source = std::make_shared<const SourceText>(*document.place.source);
    return document;
}

/// Reads `json` as the file "test.json" and decodes it with `files` as its GLSL. The test fails
/// here when there is an error in it.
inline Description describe(const std::string& json, const std::vector<TestFile>& files)
{
    MemorySources sources;
    for (const TestFile& file : files) sources.add(file.path, file.text);
    const Node document =
        need(parseDocument(std::make_shared<const SourceText>(SourceText{"test.json", json})));
    return need(decode(asModule(document), sources));
}

/// The first diagnostic of that code, or null.
inline const Diagnostic* findDiagnostic(const Diagnostics& diagnostics, Code code)
{
    for (const Diagnostic& each : diagnostics)
        if (each.code == code) return &each;
    return nullptr;
}

/// The text that a place underlines.
inline std::string textAt(const Place& place)
{
    if (!place.source || place.line < 1) return {};
    std::size_t start = 0;
    for (int line = 1; line < place.line; ++line) start = place.source->text.find('\n', start) + 1;
    return place.source->text.substr(start + static_cast<std::size_t>(place.column) - 1,
                                     static_cast<std::size_t>(place.length));
}

}  // namespace crevice
