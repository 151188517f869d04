// SPDX-License-Identifier: MIT
// Answers as text; texts, and what was edited of them.
#include "tools/show/page/engine/answers.h"

#include "tools/show/schema/schema.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

namespace crevice::page {

const char* say(std::string text)
{
    static std::string kept;
    kept = std::move(text);
    return kept.c_str();
}

const char* say(const Json& json)
{
    return say(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

namespace {

/// Files as the page asks for them: "ssao/gtao.json", and not as a checkout has them.
void namePath(Json& json, const Place& place)
{
    if (place.source && !place.source->path.empty()) json["file"] = place.source->path;
}

MemorySources edits;

std::string descriptionOf(const std::string& name)
{
    const SourceRef source = sources().find("configs/" + name + ".json");
    if (!source) return {};
    const Result<Node> document = parseDocument(source);
    const Node* text = document ? document->find("description") : nullptr;
    return text ? text->text : std::string();
}

}  // namespace

Json answer(const Diagnostics& diagnostics)
{
    Json list = Json::parse(toJson(diagnostics));
    for (std::size_t i = 0; i < diagnostics.size(); ++i) {
        namePath(list[i], diagnostics[i].place);
        for (std::size_t k = 0; k < diagnostics[i].notes.size(); ++k)
            namePath(list[i]["notes"][k], diagnostics[i].notes[k].place);
    }
    return {{"ok", !hasErrors(diagnostics)}, {"diagnostics", std::move(list)}};
}

const SourceSet& sources()
{
    static const LayeredSources all({&edits, &shippedSources()});
    return all;
}

/// The text in force, or the shipped one; null where there is none.
EXPORT const char* page_source(const char* path, int shipped)
{
    const SourceRef source = shipped ? shippedSources().find(path) : sources().find(path);
    return say(source ? Json(source->text) : Json(nullptr));
}

/// Puts a text over the shipped one of that path, or beside the shipped ones; null takes it away.
EXPORT void page_set_source(const char* path, const char* text)
{
    if (text) return edits.add(path, text);
    MemorySources kept;
    for (const std::string& each : edits.list())
        if (each != path) kept.add(each, edits.find(each)->text);
    edits = std::move(kept);
}

/// Paths whose text is not the shipped one, sorted.
EXPORT const char* page_edited_paths()
{
    auto paths = Json::array();
    for (const std::string& path : edits.list()) {
        const SourceRef shipped = shippedSources().find(path);
        if (!shipped || shipped->text != edits.find(path)->text) paths.push_back(path);
    }
    return say(paths);
}

/// [{"name", "description"}] of all configs; the description is empty where it cannot be read.
EXPORT const char* page_configs()
{
    auto list = Json::array();
    for (const std::string& name : configNames(sources()))
        list.push_back({{"name", name}, {"description", descriptionOf(name)}});
    return say(list);
}

EXPORT const char* page_schema() { return say(schemaJson(sources())); }

}  // namespace crevice::page
