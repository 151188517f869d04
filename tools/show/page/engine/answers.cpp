// SPDX-License-Identifier: MIT
// Answers as text.
#include "tools/show/page/engine/answers.h"

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

}  // namespace crevice::page
