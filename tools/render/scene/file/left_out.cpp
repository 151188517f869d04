// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/import.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"

namespace crevice {

namespace {

// Of .mtl files, in lower case.
const std::vector<std::string> kMtlRead = {"newmtl", "kd", "d",    "tr", "map_kd", "map_d",
                                           "ks",     "ns", "norm", "ke", "map_ke"};
constexpr std::pair<std::string_view, const char*> kMtlHarmless[] = {
    {"ka", "ambient light is that of the config"},
    {"map_ka", "ambient light is that of the config"},
    {"illum", "lighting is that of the config"},
    {"ni", "nothing is refracted"},
};
constexpr std::pair<std::string_view, const char*> kMtlLook[] = {
    {"map_ks", "maps of highlights"}, {"map_ns", "maps of highlights"},
    {"tf", "coloured glass"},         {"bump", "bump maps"},
    {"map_bump", "bump maps"},        {"refl", "reflections"},
};

constexpr std::size_t kLongestMtl = 64u << 20;

template <class Rows>
auto rowOf(const Rows& rows, std::string_view key)
{
    return std::find_if(std::begin(rows), std::end(rows),
                        [&](const auto& each) { return each.first == key; });
}

void findLeftOutOfLine(std::string_view line, LeftOut& left_out)
{
    std::string text(line);
    for (char& c : text) c = c == '\t' || c == '\r' ? ' ' : c;
    std::vector<std::string> words;
    for (const std::string_view word : split(text, ' '))
        if (!word.empty()) words.emplace_back(word);
    if (words.empty() || words[0][0] == '#') return;
    const std::string key = lowerCase(words[0]);
    const auto look = rowOf(kMtlLook, key);
    if (look != std::end(kMtlLook)) {
        left_out.look.insert(look->second);
        return;
    }
    const bool known =
        contains(kMtlRead, key) || rowOf(kMtlHarmless, key) != std::end(kMtlHarmless);
    if (!known) left_out.shape.insert("the key '" + words[0] + "' of its materials");
    if (startsWith(key, "map_") && words.size() > 2 && words[1][0] == '-')
        left_out.shape.insert("the option '" + words[1] + "' of " + words[0]);
}

}  // namespace

Diagnostic LeftOut::warning(const std::string& path) const
{
    std::vector<std::string> parts;
    for (const std::set<std::string>& names : {shape, look})
        parts.insert(parts.end(), names.begin(), names.end());
    return asWarning({Code::scene_features,
                      "the scene '" + path + "' is drawn without " + joined(parts),
                      shape.empty() ? "ambient occlusion needs none of it"
                                    : "compare the picture with another viewer's"});
}

void findLeftOutOfMtl(const std::string& file, LeftOut& left_out)
{
    if (lowerExtension(file) != ".mtl") return;
    const FileBytes text = readBytes(file, kLongestMtl);
    for (const std::string_view line : split(text.bytes, '\n')) findLeftOutOfLine(line, left_out);
}

std::string mtlTable()
{
    std::string text = "| key of .mtl | |\n|---|---|\n";
    for (const std::string& key : kMtlRead) text += "| `" + key + "` | read |\n";
    for (const auto& [key, why] : kMtlHarmless)
        text += "| `" + std::string(key) + "` | changes nothing: " + why + " |\n";
    for (const auto& [key, what] : kMtlLook)
        text += "| `" + std::string(key) + "` | named: " + what + " |\n";
    return text;
}

}  // namespace crevice
