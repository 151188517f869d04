// SPDX-License-Identifier: MIT
// Figures and pictures in a page.
#include "tools/show/report/page_data.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/show/report/page.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

constexpr std::size_t kMaxPictureBytes = 64u << 20;

std::string base64(std::string_view bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view three = bytes.substr(i, 3);
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= three.size() ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

/// The same with every text as it can be shown.
nlohmann::json shown(const nlohmann::json& data)
{
    if (data.is_string()) return printable(data.get_ref<const std::string&>());
    if (!data.is_structured()) return data;
    nlohmann::json copy = data.is_array() ? nlohmann::json::array() : nlohmann::json::object();
    for (const auto& [key, value] : data.items()) {
        if (data.is_array())
            copy.push_back(shown(value));
        else
            copy[printable(key)] = shown(value);
    }
    return copy;
}

}  // namespace

std::string pictureUri(const std::string& path, const std::string& folder)
{
    if (!isBelow(path, {folder.empty() ? "." : folder})) return {};
    const FileBytes file = readBytes(path, kMaxPictureBytes);
    const bool png = startsWith(file.bytes, "\x89PNG\r\n\x1a\n");
    return png ? "data:image/png;base64," + base64(file.bytes) : std::string();
}

std::string pageWith(std::string_view page, const nlohmann::json& data)
{
    std::string safe;
    for (const char c :
         shown(data).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    std::string text(page);
    text.replace(text.find(kReportDataMark), kReportDataMark.size(), safe);
    return text;
}

}  // namespace crevice
