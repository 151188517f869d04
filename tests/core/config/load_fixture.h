// SPDX-License-Identifier: MIT
// What the tests of loading share: a small catalog, and short forms for results.
#pragma once

#include <crevice/config.h>

#include "tests/support/need.h"

#include <algorithm>

namespace crevice {

/// `members` as a whole file: `"format": 1` in front.
inline std::string file(const std::string& members)
{
    return "{\"format\": 1" + (members.empty() ? "" : ", " + members) + "}";
}

inline MemorySources smallCatalog()
{
    MemorySources sources;
    sources.add("geometry/plain.json", file(R"("targets": {"depth": {}})"));
    sources.add("ssao/hemisphere.json", file(R"("params": {"radius": {"default": 0.5, "min": 0},
                                   "samples": {"default": 16}},
                        "features": {"half": {"type": "bool", "default": false}},
                        "passes": {"ssao": {"when": {"half": true}}})"));
    sources.add("filter/box.json", file(R"("passes": {"box": {}})"));
    sources.add("configs/base.json",
                file(R"("extends": ["geometry/plain", "ssao/hemisphere", "filter/box"],
                        "name": "base",
                        "variants": {"fast": {"params": {"samples": {"default": 8}}}})"));
    sources.add("configs/fine.json", file(R"("extends": ["base"], "name": "fine",
                        "params": {"samples": {"default": 64}},
                        "variants": {"bare": {"passes": {"box": null}},
                                     "fast": {"params": {"radius": {"default": 0.1}}}})"));
    return sources;
}

inline Node loaded(const SourceSet& sources, const LoadRequest& request)
{
    return need(loadConfig(sources, request));
}

/// The value at "params/radius/default", or null.
inline const Node* at(const Node& document, const std::string& path)
{
    const Node* node = &document;
    for (std::size_t begin = 0; node && begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        node = node->find(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return node;
}

/// The only error of a request that must fail.
inline Diagnostic failure(const SourceSet& sources, const LoadRequest& request)
{
    const Result<Node> document = loadConfig(sources, request);
    REQUIRE_FALSE(document);
    INFO(toText(document.diagnostics()));
    REQUIRE(document.diagnostics().size() == 1);
    return document.diagnostics().front();
}

}  // namespace crevice
