// SPDX-License-Identifier: MIT
// Texts and what was edited of them.
#include "tools/show/page/engine/texts.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

#include <nlohmann/json.hpp>

namespace crevice::page {
namespace {

std::string descriptionOf(const SourceSet& sources, const std::string& name)
{
    const SourceRef source = sources.find("configs/" + name + ".json");
    if (!source) return {};
    const Result<Node> document = parseDocument(source);
    const Node* text = document ? document->find("description") : nullptr;
    return text ? text->text : std::string();
}

}  // namespace

Texts::Texts() : all_({&edits_, &shippedSources()}) {}

void Texts::reset(const std::string& path)
{
    MemorySources kept;
    for (const std::string& each : edits_.list())
        if (each != path) kept.add(each, edits_.find(each)->text);
    edits_ = std::move(kept);
}

std::vector<std::string> Texts::edited() const
{
    std::vector<std::string> paths;
    for (const std::string& path : edits_.list()) {
        const SourceRef shipped = shippedSources().find(path);
        if (!shipped || shipped->text != edits_.find(path)->text) paths.push_back(path);
    }
    return paths;
}

nlohmann::json Texts::configs() const
{
    auto list = nlohmann::json::array();
    for (const std::string& name : configNames(all_))
        list.push_back({{"name", name}, {"description", descriptionOf(all_, name)}});
    return list;
}

}  // namespace crevice::page
