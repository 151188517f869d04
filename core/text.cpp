// SPDX-License-Identifier: MIT
// UTF-8, JSON strings and pointers.
#include "core/text.h"

#include <algorithm>

namespace crevice {

namespace {

unsigned char byteAt(std::string_view text, std::size_t at)
{
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

// The bytes that may follow a leading byte (Unicode 15, table 3-7); `length` 0 is no leading byte.
struct Lead {
    std::size_t length;
    unsigned char second_min, second_max;
};

Lead leadOf(unsigned char byte)
{
    if (byte < 0xC2) return {0, 0, 0};
    if (byte < 0xE0) return {2, 0x80, 0xBF};
    if (byte == 0xE0) return {3, 0xA0, 0xBF};
    if (byte == 0xED) return {3, 0x80, 0x9F};
    if (byte < 0xF0) return {3, 0x80, 0xBF};
    if (byte == 0xF0) return {4, 0x90, 0xBF};
    if (byte < 0xF4) return {4, 0x80, 0xBF};
    if (byte == 0xF4) return {4, 0x80, 0x8F};
    return {0, 0, 0};
}

void appendEscaped(std::string& out, unsigned char control)
{
    static const char kDigits[] = "0123456789abcdef";
    switch (control) {
    case '\n': out += "\\n"; break;
    case '\r': out += "\\r"; break;
    case '\t': out += "\\t"; break;
    default: out += {'\\', 'u', '0', '0', kDigits[control >> 4], kDigits[control & 15]};
    }
}

}  // namespace

bool startsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

bool endsWith(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

std::size_t utf8Length(std::string_view text, std::size_t at)
{
    const unsigned char first = byteAt(text, at);
    if (first < 0x80) return 1;
    const Lead lead = leadOf(first);
    const unsigned char second = byteAt(text, at + 1);
    if (lead.length == 0 || second < lead.second_min || second > lead.second_max) return 0;
    for (std::size_t i = 2; i < lead.length; ++i)
        if ((byteAt(text, at + i) & 0xC0) != 0x80) return 0;
    return lead.length;
}

std::string_view utf8Prefix(std::string_view text, std::size_t bytes)
{
    std::size_t end = std::min(bytes, text.size());
    while (end > 0 && end < text.size() && (byteAt(text, end) & 0xC0) == 0x80) --end;
    return text.substr(0, end);
}

std::string jsonString(std::string_view text)
{
    std::string out = "\"";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8Length(text, at);
        const unsigned char byte = byteAt(text, at);
        if (length == 0) out += "\xEF\xBF\xBD";
        else if (byte < 0x20) appendEscaped(out, byte);
        else if (byte == '"' || byte == '\\') out += {'\\', text[at]};
        else out += text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out + '"';
}

std::string_view lineOf(std::string_view text, int line)
{
    for (int at = 1; at < line; ++at) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
}

std::string upperCase(std::string_view text)
{
    std::string upper(text);
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator)
{
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += separator;
        text += word;
    }
    return text;
}

std::string memberPointer(std::string_view parent, std::string_view key)
{
    std::string pointer(parent);
    pointer += '/';
    for (const char c : key) {
        if (c == '~') pointer += "~0";
        else if (c == '/') pointer += "~1";
        else pointer += c;
    }
    return pointer;
}

std::vector<std::string> pointerKeys(std::string_view pointer)
{
    std::vector<std::string> keys;
    for (std::size_t at = 0; at < pointer.size(); ++at) {
        const std::string_view escape = pointer.substr(at, 2);
        if (pointer[at] == '/') keys.emplace_back();
        else if (escape == "~0" || escape == "~1") keys.back() += pointer[++at] == '0' ? '~' : '/';
        else keys.back() += pointer[at];
    }
    return keys;
}

}  // namespace crevice
