// SPDX-License-Identifier: MIT
#include "tools/show/report/page.h"

#include "core/base/text.h"
#include "tools/measure/line_file.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

using nlohmann::json;

/// Where in the page the figures go.
constexpr std::string_view kDataMark = "/*report.json*/";

/// The same with every text as it can be shown.
json shown(const json& data)
{
    if (data.is_string()) return printable(data.get_ref<const std::string&>());
    if (!data.is_structured()) return data;
    json copy = data.is_array() ? json::array() : json::object();
    for (const auto& [key, value] : data.items()) {
        if (data.is_array())
            copy.push_back(shown(value));
        else
            copy[printable(key)] = shown(value);
    }
    return copy;
}

}  // namespace

std::string pageOf(std::string_view page, const json& model)
{
    std::string figures;
    for (const char c : jsonLine(shown(model)))  // in which "</script>" must end nothing
        c == '<' ? figures += "\\u003c" : figures += c;
    std::string text(page);
    text.replace(text.find(kDataMark), kDataMark.size(), figures);
    return text;
}

}  // namespace crevice
