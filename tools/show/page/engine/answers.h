// SPDX-License-Identifier: MIT
// What exported functions share: the engine, and answers as JSON text.
#pragma once

#include "tools/show/page/engine/engine.h"

#include <emscripten.h>
#include <nlohmann/json.hpp>

#define EXPORT extern "C" EMSCRIPTEN_KEEPALIVE

namespace crevice::page {

using Json = nlohmann::json;

/// Lives as long as the page.
extern Engine engine;

/// Good until the next call.
const char* say(std::string text);
const char* say(const Json& json);

/// {"ok", "diagnostics"}.
Json answer(const Diagnostics& diagnostics);
inline Json answer(const Status& status) { return answer(status.diagnostics()); }

template <class T>
Json answer(const Result<T>& result)
{
    return answer(result.diagnostics());
}

}  // namespace crevice::page
