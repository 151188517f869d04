// SPDX-License-Identifier: MIT
// What the decoding visitor does with keys: missing, unknown, refused, badly named.
#include "core/config/decode_reader.h"

#include "core/base/text.h"
#include "core/config/decode_steps.h"

#include <algorithm>

namespace crevice::table {

namespace {

// One GLSL line holds it with room to spare, and the shortest limit among drivers is far longer.
constexpr std::size_t kMaxNameBytes = 64;

// What people write who know other systems, and what this format calls it.
constexpr struct {
    const char* written;
    const char* meant;
} kOtherWords[] = {
    {"value", "default"},    {"val", "default"},       {"description", "tooltip"},
    {"name", "label"},       {"options", "values"},    {"fmt", "format"},
    {"width", "size"},       {"height", "size"},       {"resolution", "size"},
    {"factor", "scale"},     {"relative", "of"},       {"msaa", "samples"},
    {"vs", "vertex"},        {"fs", "fragment"},       {"pixel", "fragment"},
    {"macros", "defines"},   {"program", "shader"},    {"enabled", "when"},
    {"enable", "when"},      {"disabled", "when"},     {"condition", "when"},
    {"if", "when"},          {"targets", "color"},     {"render_targets", "color"},
    {"textures", "inputs"},  {"samplers", "inputs"},   {"reads", "inputs"},
    {"source", "from"},      {"src", "from"},          {"texture", "from"},
    {"sampling", "filter"},  {"address", "wrap"},      {"culling", "cull"},
    {"import", "imports"},   {"parameters", "params"}, {"uniforms", "params"},
    {"textures", "targets"}, {"presets", "variants"},  {"profiles", "variants"},
    {"scale", "size"},       {"of", "size"},           {"sampler2D", "texture"},
    {"image", "texture"},    {"quad", "fullscreen"},   {"screen", "fullscreen"},
    {"mesh", "draw"},        {"scene", "draw"},        {"geometry", "draw"},
    {"double", "float"},     {"color", "vec3"},        {"rgb", "vec3"},
    {"rgba", "vec4"},        {"string", "enum"},       {"point", "nearest"},
    {"off", "none"},         {"lequal", "less_equal"}, {"gequal", "greater_equal"},
    {"d16", "depth16"},      {"d24", "depth24"},       {"d32", "depth32f"},
    {"d32f", "depth32f"},
};

// "_comment", "x_note", "Note": no key of a format.
bool looksOwn(std::string_view key)
{
    const char first = key.empty() ? ' ' : key[0];
    return !isLower(first) || startsWith(key, "x_") || startsWith(key, "comment");
}

// "radius": 0.8 at the top of a config is meant for its section.
std::string suggestPlace(const Node& document, const Member& member)
{
    for (const char* section : {"params", "features"}) {
        const Node* entries = document.find(section);
        if (!entries || !entries->find(member.key)) continue;
        return std::string("write \"") + section + "\": {" + jsonString(member.key) + ": " +
               brief(member.value) + "}; ";
    }
    return {};
}

}  // namespace

std::string spellName(std::string_view name)
{
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool hump = isUpper(name[i]) && i > 0 && !isUpper(name[i - 1]);
        const bool kept = isWord(name[i]) && name[i] != '_';
        if ((hump || !kept) && !out.empty() && out.back() != '_') out += '_';
        if (kept) out += name[i];
    }
    while (!out.empty() && out.back() == '_') out.pop_back();
    out = lowerCase(out);
    if (out.substr(0, 3) == "gl_") out.erase(0, 3);
    if (out.empty()) return "name";
    if (!isLower(out.front())) out.insert(0, "my_");
    return out.substr(0, kMaxNameBytes);
}

std::string suggestWord(std::string_view written, const std::vector<std::string>& allowed,
                        std::string_view what)
{
    std::string help = suggestName(written, allowed, what);
    if (startsWith(help, "did you mean")) return help;
    for (const auto& word : kOtherWords)
        if (written == word.written && contains(allowed, word.meant))
            return "did you mean '" + std::string(word.meant) + "'? " + help;
    return help;
}

bool isName(std::string_view name)
{
    const auto allowed = [](char c) { return isLower(c) || isDigit(c) || c == '_'; };
    return !name.empty() && isLower(name.front()) && name.size() <= kMaxNameBytes &&
           std::all_of(name.begin(), name.end(), allowed) &&
           name.find("__") == std::string_view::npos && name.substr(0, 3) != "gl_";
}

Place lastPlace(const Node& object)
{
    Place place = object.place;
    for (const Member& member : object.members)
        if (member.value.place.source != object.place.source) place = member.value.place;
    return place;
}

Place placeOf(const Cursor& object, std::string_view member)
{
    for (const Member& each : object.node.members)
        if (each.key == member) return each.value.place;
    return object.key_place;
}

void checkName(Report& report, const Cursor& cursor)
{
    if (isName(cursor.key)) return;
    report.atKey(cursor, Code::bad_name,
                 "found the name '" + cursor.key + "', wanted snake_case of at most " +
                     std::to_string(kMaxNameBytes) + " letters, without '__' or 'gl_'",
                 "write '" + spellName(cursor.key) + "'");
}

void reportUndeclared(Report& report, const Cursor& section, const Cursor& entry)
{
    const bool plural = section.key.back() == 's';
    const std::string what = plural ? section.key.substr(0, section.key.size() - 1) : section.key;
    Diagnostic& error =
        report.atKey(entry, Code::unknown_param,
                     what + " '" + entry.key + "' is set here, and no file declares it");
    if (report.leavesOut(entry)) {
        error.severity = Severity::warning;
        error.help = "it is left out: what declares it is not part of this config";
        return;
    }
    std::vector<std::string> declared;
    for (const Member& member : section.node.members)
        if (member.value.kind == Node::Kind::object) declared.push_back(member.key);
    error.help = suggestName(entry.key, std::move(declared), section.key) +
                 "; to declare one of your own, write {\"default\": " + brief(entry.node) + "}";
}

void Reader::refuse(const char* key, Code code, const char* reason)
{
    const Member* member = find(key);
    if (!member) return;
    const Cursor value = cursor_.child(*member);
    report_.atValue(value, code, value.label + ": " + reason,
                    "leave out '" + std::string(key) + "'");
}

void Reader::ordered(const char* min_key, double& min, const char* max_key, double& max)
{
    if (min <= max) return;
    const Member* at = find(min_key) ? find(min_key) : find(max_key);
    report_.atValue(cursor_.child(*at), Code::bad_range,
                    cursor_.key + ": '" + min_key + "' is above '" + max_key + "'",
                    "swap them, or leave out one");
    min = -kMaxParam;
    max = kMaxParam;
}

bool Reader::finish()
{
    if (!has_keys_) return true;
    if (!expectObject(report_, cursor_, keys_)) return false;
    reportUnknown();
    for (const Missing& missing : missing_) reportMissing(missing);
    return missing_.empty();
}

// A key that must be there and that an unknown one was meant to be is no mistake of its own.
void Reader::reportUnknown()
{
    if (cursor_.pointer.empty()) keys_.insert(keys_.end(), {"extends", "variants"});
    for (const Member& member : cursor_.node.members) {
        const bool known = std::find(keys_.begin(), keys_.end(), member.key) != keys_.end();
        if (known || isExtension(member.key)) continue;
        std::string help = suggestWord(member.key, keys_, "keys");
        if (looksOwn(member.key)) help += "; a key of your own begins with 'x-'";
        if (cursor_.pointer.empty()) help = suggestPlace(cursor_.node, member) + help;
        const auto meant = [&](const Missing& each) {
            return startsWith(help, "did you mean '" + std::string(each.key) + "'");
        };
        missing_.erase(std::remove_if(missing_.begin(), missing_.end(), meant), missing_.end());
        report_.atKey(cursor_.child(member), Code::unknown_key,
                      "found the key '" + member.key + "', which the format does not have here",
                      std::move(help));
    }
}

// At the null of the patch that took it away, where there is one.
void Reader::reportMissing(const Missing& missing)
{
    const std::string where = cursor_.key.empty() ? "the config" : "'" + cursor_.key + "'";
    const std::string message = where + " has no '" + missing.key + "', which must be there";
    const std::string help = std::string("add \"") + missing.key + "\": " + missing.doc;
    for (const Member& deleted : cursor_.node.deleted) {
        if (deleted.key != missing.key) continue;
        report_.atKey(cursor_.child(deleted), Code::missing_key, message,
                      "give it a value instead of null, or leave it as it was");
        return;
    }
    report_.atKey(cursor_, Code::missing_key, message, help);
}

const Member* Reader::find(std::string_view key) const
{
    for (const Member& member : cursor_.node.members)
        if (member.key == key) return &member;
    return nullptr;
}

Cursor Reader::child(const Member& member, const char* doc) const
{
    Cursor cursor = cursor_.child(member);
    cursor.doc = doc;
    return cursor;
}

}  // namespace crevice::table
