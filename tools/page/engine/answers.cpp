// SPDX-License-Identifier: MIT
// Answers as text.
#include "tools/page/engine/answers.h"

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

Json answer(const Diagnostics& diagnostics)
{
    return {{"ok", !hasErrors(diagnostics)}, {"diagnostics", Json::parse(toJson(diagnostics))}};
}

}  // namespace crevice::page
