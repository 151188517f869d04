// SPDX-License-Identifier: MIT
// Figures and pictures in a page.
#include "tools/page_data.h"

#include "tools/report_page.h"

#include <fstream>
#include <iterator>

namespace crevice {
namespace {

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

}  // namespace

std::string pictureUri(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)),
                            std::istreambuf_iterator<char>());
    return bytes.empty() ? std::string() : "data:image/png;base64," + base64(bytes);
}

std::string pageWith(std::string_view page, std::string_view json)
{
    std::string safe;
    for (const char c : json) {
        if (c == '<') safe += "\\u003c";
        else safe += c;
    }
    std::string text(page);
    text.replace(text.find(kReportDataMark), kReportDataMark.size(), safe);
    return text;
}

}  // namespace crevice
