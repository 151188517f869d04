// SPDX-License-Identifier: MIT
// What exported functions share: answers as JSON text.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/source.h>

#include <emscripten.h>
#include <nlohmann/json.hpp>

#define EXPORT extern "C" EMSCRIPTEN_KEEPALIVE

namespace crevice::page {

using Json = nlohmann::json;

/// Good until the next call.
const char* say(std::string text);
const char* say(const Json& json);

/// {"ok", "diagnostics"}.
Json answer(const Diagnostics& diagnostics);

/// Of a Status or Result.
template <class T>
Json answer(const T& result)
{
    return answer(result.diagnostics());
}

/// The texts of the page as they are in force: shipped modules and configs, and over them what the
/// user edited.
const SourceSet& sources();

}  // namespace crevice::page
