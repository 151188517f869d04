// SPDX-License-Identifier: MIT
// How each JSON form becomes a C++ value, and what is said when it does not; and what the decoding
// visitor does with keys: missing, unknown, refused, badly named.
#include "core/config/decode_reader.h"

#include "core/base/text.h"
#include "core/config/values.h"
#include "core/json/merge.h"

#include <cmath>

namespace crevice::table {
namespace {

// The largest whole number up to which a float holds every one: what an int param can be.
constexpr double kMaxWholeParam = 16777216.0;

constexpr std::pair<std::string_view, const char*> kWordsOfGl[] = {
    {"lequal", "less_equal"}, {"gequal", "greater_equal"}, {"clamp_to_edge", "clamp"}};

bool isScalar(const Node& node)
{
    return node.kind == Node::Kind::boolean || node.kind == Node::Kind::number ||
           node.kind == Node::Kind::string;
}

std::string found(const Node& node)
{
    switch (node.kind) {
    case Node::Kind::array: return "a list";
    case Node::Kind::object: return "an object";
    case Node::Kind::null: return "null";
    default: return std::string("the ") + kindName(node.kind) + " " + brief(node);
    }
}

// Without a way out of its own, the help is the table's sentence.
bool wrongType(Report& report, const Cursor& cursor, const std::string& wanted,
               std::string way_out = {})
{
    report.atValue(cursor, Code::wrong_type,
                   cursor.label + ": found " + found(cursor.node) + ", wanted " + wanted,
                   std::move(way_out));
    return false;
}

bool wrongLength(Report& report, const Cursor& cursor, const std::string& wanted)
{
    report.atValue(cursor, Code::bad_length,
                   cursor.label + ": found a list of " + std::to_string(cursor.node.items.size()) +
                       ", wanted " + wanted);
    return false;
}

// Calls `each` with the value, or with each item when it is a list.
template <class F>
bool forEachItem(Report& report, const Cursor& cursor, F each)
{
    if (cursor.node.kind != Node::Kind::array) return each(cursor);
    if (cursor.node.items.empty()) return wrongLength(report, cursor, "at least one entry");
    if (cursor.node.items.size() > kMaxMembers)
        return wrongLength(report, cursor, "at most " + std::to_string(kMaxMembers));
    bool good = true;
    for (std::size_t i = 0; i < cursor.node.items.size(); ++i) good &= each(cursor.item(i));
    return good;
}

// What to write where a number is wanted; of what is no text or list, the table's sentence.
std::string wayToNumber(const Node& node, bool whole, const Rule& rule)
{
    const std::string unit = rule.unit.empty() ? "1" : std::string(rule.unit);
    const std::string in_unit = unit == "1" ? "" : ", in " + unit;
    if (node.kind == Node::Kind::array && node.items.size() == 1)
        return "write " + brief(node.items[0]) + ", without brackets";
    if (node.kind == Node::Kind::number) return "a whole number has no point: 16";
    if (node.kind != Node::Kind::string) return {};
    std::string text = node.text;
    std::replace(text.begin(), text.end(), ',', '.');
    const double value = parseNumber(text).value_or(NAN);
    if (std::isfinite(value) && !(whole && value != std::floor(value)))
        return "write " + numberText(value) + in_unit + ", without quotes";
    if (rule.length) return kLengthForms;
    return "write a number, such as " + std::string(whole ? "16" : "0.8") + in_unit +
           ", with no quotes or letters";
}

bool isMacroName(std::string_view name)
{
    return !name.empty() && isWordStart(name.front()) && name.substr(0, 3) != "GL_" &&
           !has(name, "__") && allOf(name, isWord);
}

// One GLSL line holds it with room to spare, and the shortest limit among drivers is far longer.
constexpr std::size_t kMaxNameBytes = 64;

const std::vector<std::string> kSections = {"params", "features", "imports", "generated",
                                            "boxes",  "targets",  "shaders", "interfaces",
                                            "passes", "outputs",  "views"};

}  // namespace

bool isNumber(Report& report, const Cursor& cursor, bool whole, Rule rule, double least,
              double most)
{
    const Node& node = cursor.node;
    const bool fraction = whole && node.text.find_first_of(".eE") != std::string::npos;
    if (node.kind != Node::Kind::number || fraction) {
        const std::string wanted = whole ? "a whole number" : "a number";
        return wrongType(report, cursor, wanted, wayToNumber(node, whole, rule));
    }
    rule.min = std::max(rule.min, least);
    rule.max = std::min(rule.max, most);
    if (cursor.node.number >= rule.min && cursor.node.number <= rule.max) return true;
    const bool plain = rule.unit.empty() || rule.unit == "1";
    report.atValue(cursor, Code::out_of_range,
                   cursor.label + " " + node.text + " is outside [" + numberText(rule.min) + ", " +
                       numberText(rule.max) + "]" + (plain ? "" : " " + std::string(rule.unit)),
                   "the nearest that is allowed is " +
                       numberText(std::min(std::max(node.number, rule.min), rule.max)));
    return false;
}

bool expectObject(Report& report, const Cursor& cursor, const std::vector<std::string>& keys)
{
    return cursor.node.kind == Node::Kind::object ||
           wrongType(report, cursor, "an object", wayToObject(cursor.pointer, cursor.node, keys));
}

bool readWord(Report& report, const Cursor& cursor, const std::vector<std::string>& words,
              std::size_t& index)
{
    if (cursor.node.kind != Node::Kind::string)
        return wrongType(report, cursor, "a string",
                         suggestName(cursor.node.text, words, "allowed"));
    const auto word = std::find(words.begin(), words.end(), cursor.node.text);
    index = static_cast<std::size_t>(word - words.begin());
    if (word != words.end()) return true;
    std::string meant = lowerCase(cursor.node.text);
    for (const auto& [theirs, ours] : kWordsOfGl)
        if (meant == theirs || meant == "gl_" + std::string(theirs)) meant = ours;
    report.atValue(cursor, Code::bad_enum,
                   cursor.label + ": found " + found(cursor.node) + ", wanted one of the " +
                       std::to_string(words.size()) + " allowed words",
                   suggestName(meant, words, "allowed"));
    return false;
}

bool read(Report& report, const Cursor& cursor, bool& out, const Rule&)
{
    if (cursor.node.kind != Node::Kind::boolean)
        return wrongType(report, cursor, "true or false", "write true or false, without quotes");
    out = cursor.node.boolean;
    return true;
}

bool read(Report& report, const Cursor& cursor, std::string& out, const Rule&)
{
    if (cursor.node.kind != Node::Kind::string)
        return wrongType(report, cursor, "a string", "put text in double quotes");
    out = cursor.node.text;
    return true;
}

bool read(Report& report, const Cursor& cursor, Reference& out, const Rule&)
{
    if (cursor.node.kind != Node::Kind::string)
        return wrongType(report, cursor, "a name", "write one name, in double quotes");
    out = {{cursor.node.text, cursor.node.place, cursor.pointer}, cursor.node.origins};
    return true;
}

bool read(Report& report, const Cursor& cursor, std::vector<Reference>& out, const Rule& rule)
{
    if (cursor.node.kind == Node::Kind::array && cursor.node.items.empty()) return true;
    return forEachItem(report, cursor, [&](const Cursor& item) {
        return read(report, item, out.emplace_back(), rule);
    });
}

bool read(Report& report, const Cursor& cursor, std::vector<Format>& out, const Rule&)
{
    const std::vector<std::string>& names = formatNames();
    return forEachItem(report, cursor, [&](const Cursor& item) {
        std::size_t index = 0;
        if (!readWord(report, item, names, index)) return false;
        out.push_back(allFormats()[index].format);
        return true;
    });
}

bool read(Report& report, const Cursor& cursor, std::map<std::string, std::string>& out,
          const Rule&)
{
    if (!expectObject(report, cursor)) return false;
    for (const Member& member : cursor.node.members) {
        const Cursor child = cursor.child(member);
        if (isExtension(member.key)) continue;
        if (!isMacroName(member.key))
            report.atKey(child, Code::bad_name,
                         "found the macro '" + member.key + "', which GLSL does not allow",
                         "write letters, digits and '_', no '__' and no 'GL_' in front");
        if (!isScalar(member.value)) wrongType(report, child, "a number, boolean or string");
        const bool boolean = member.value.kind == Node::Kind::boolean;
        out[member.key] = boolean ? (member.value.boolean ? "1" : "0") : member.value.text;
    }
    return true;
}

bool read(Report& report, const Cursor& cursor, Numbers out, const Rule& rule)
{
    const double most = out.whole ? kMaxWholeParam : kMaxParam;
    const auto one = [&](const Cursor& item, float& value) {
        if (!isNumber(report, item, out.whole, rule, -most, most)) return false;
        value = static_cast<float>(item.node.number);
        return true;
    };
    if (out.count == 0) return true;  // its type is broken, which has been said
    if (out.count == 1)
        return (rule.length && takeLength(cursor.node.text, out.values)) ||
               one(cursor, out.values[0]);
    if (out.fills && cursor.node.kind != Node::Kind::array) {
        const bool good = one(cursor, out.values[0]);
        out.values.fill(out.values[0]);
        return good;
    }
    const std::string wanted = std::to_string(out.count) + " numbers";
    if (cursor.node.kind != Node::Kind::array) {
        const std::string text = cursor.node.text;
        const bool number = cursor.node.kind == Node::Kind::number;
        const std::string all =
            number ? joined(std::vector<std::string>(std::size_t(out.count), text)) : text;
        return wrongType(report, cursor, "a list of " + wanted,
                         text.empty() ? "" : "write [" + all + "]");
    }
    if (cursor.node.items.size() != static_cast<std::size_t>(out.count))
        return wrongLength(report, cursor, wanted);
    bool good = true;
    for (std::size_t i = 0; i < cursor.node.items.size(); ++i) {
        if (one(cursor.item(i), out.values[i])) continue;
        report.last().mistake = "numbers of " + cursor.pointer;
        good = false;
    }
    return good;
}

bool read(Report& report, const Cursor& cursor, Words out, const Rule&)
{
    if (cursor.node.kind != Node::Kind::array)
        return wrongType(report, cursor, "a list", "write a list such as [\"off\", \"on\"]");
    if (cursor.node.items.size() < 2) return wrongLength(report, cursor, "at least two words");
    std::set<std::string> seen;
    const auto one = [&](const Cursor& item) {
        const std::string& word = out.words.emplace_back(item.node.text);
        if (item.node.kind != Node::Kind::string) return wrongType(report, item, "a word");
        if (word.empty() || word.front() == '_' || !isName("x_" + word)) {
            report.atValue(item, Code::bad_name,
                           item.label + ": found '" + word + "', wanted snake_case",
                           "write lower-case letters, digits and '_'");
            return false;
        }
        if (seen.insert(word).second) return true;
        report.atValue(item, Code::name_collision, item.label + ": '" + word + "' is there twice",
                       "take one of them away");
        return false;
    };
    return forEachItem(report, cursor, one);
}

bool read(Report& report, const Cursor& cursor, Choice out, const Rule& rule)
{
    bool flag = false;
    if (out.boolean && !read(report, cursor, flag, rule)) return false;
    std::size_t index = flag ? 1 : 0;
    const bool unknown = out.words.empty();  // they are broken, which has been said
    if (!out.boolean && !unknown && !readWord(report, cursor, out.words, index)) return false;
    out.index = static_cast<int>(index);
    return true;
}

bool read(Report& report, const Cursor& cursor, OneOf out, const Rule&)
{
    std::size_t index = 0;
    if (!readWord(report, cursor, out.allowed, index)) return false;
    out.word = out.allowed[index];
    return true;
}

bool read(Report& report, const Cursor& cursor, Scalars out, const Rule&)
{
    return forEachItem(report, cursor, [&](const Cursor& item) {
        if (!isScalar(item.node)) return wrongType(report, item, "a boolean, number or string");
        const bool boolean = item.node.kind == Node::Kind::boolean;
        out.texts.push_back(!boolean ? item.node.text : item.node.boolean ? "true" : "false");
        return true;
    });
}

bool read(Report& report, const Cursor& cursor, ProductDesc& out, const Rule& rule)
{
    const bool list = cursor.node.kind == Node::Kind::array;
    out = {1.0};
    return forEachItem(report, cursor, [&](const Cursor& item) {
        double number = 1.0;
        const bool name = item.node.kind == Node::Kind::string;
        const bool good = name ? read(report, item, out.params.emplace_back(), Rule{})
                               : read(report, item, number, list ? range(1e-6, 1e6) : rule);
        out.factor *= number;
        return good;
    });
}

bool isName(std::string_view name)
{
    const auto allowed = [](char c) { return isLower(c) || isDigit(c) || c == '_'; };
    return !name.empty() && isLower(name.front()) && name.size() <= kMaxNameBytes &&
           allOf(name, allowed) && !has(name, "__") && name.substr(0, 3) != "gl_";
}

Place lastPlace(const Node& object)
{
    Place place = object.place;
    for (const Member& member : object.members)
        if (member.value.place.source != object.place.source) place = member.value.place;
    return place;
}

// Of what stands under the name of a module.
std::string nestedHelp(const std::string& name)
{
    return "params are not nested by module: write '" + name + "' without the braces around it";
}

void checkName(Report& report, const Cursor& cursor)
{
    if (isName(cursor.key)) return;
    Reported& error =
        report.atKey(cursor, Code::bad_name,
                     "found the name '" + cursor.key + "', wanted snake_case of at most " +
                         std::to_string(kMaxNameBytes) + " letters, without '__' or 'gl_'",
                     "write lower-case letters, digits and '_', a letter first: ao_blur");
    if (cursor.key.find('/') == std::string::npos || cursor.node.members.empty()) return;
    error.help = nestedHelp(cursor.node.members[0].key);
    error.mistake = "nested " + cursor.pointer;
}

bool isRetyped(Report& report, const Cursor& entry)
{
    const Node* type = entry.node.find("type");
    if (!type || type->place.source == entry.node.place.source) return false;
    std::string was = startsWith(entry.pointer, "/params/") ? "\"float\"" : "\"bool\"";
    for (const Place& first : type->origins)
        was = lineOf(first.source->text, first.line)
                  .substr(std::size_t(first.column) - 1, std::size_t(first.length));
    if (brief(*type) == was) return false;
    report.add({Code::wrong_type,
                "'" + entry.key + "' is declared as " + was + ", and here as " + brief(*type),
                "leave out 'type', or declare one of another name",
                type->place,
                entry.pointer + "/type",
                {{entry.node.place, "it is declared here"}}});
    return true;
}

// Says of an entry that no file declares which was meant; the help so far says how to declare one.
// An object is a declaration that lacks something, unless there is one like it.
void sayUndeclared(const Report& report, const std::string& section, const std::string& name,
                   bool bare, Reported& error)
{
    const Node& entries = *locate(report.document(), memberPointer("", section)).node;
    std::vector<std::string> declared;
    for (const Member& member : entries.members)
        if (member.value.kind == Node::Kind::object && member.key != name)
            declared.push_back(member.key);
    const std::string help =
        declaredBy(report.sources, section, name) + suggestName(name, declared, section);
    error.help = help + "; to declare one of your own, " + error.help;
    if (!report.document().find("passes"))
        error.help = "begin with a config that has it: \"extends\": [\"balanced\"]";
    for (const Member& gone : entries.deleted)
        if (gone.key == name)
            error.notes.push_back({gone.key_place, "what declared it was left out here"});
    const bool like = startsWith(help, "did you") || startsWith(help, "declared by");
    if (!bare && !like && error.notes.empty()) return;
    error.code = Code::unknown_param;
    const std::size_t end = endsWith(section, "ses") ? 2 : section.back() == 's';
    error.message = section.substr(0, section.size() - end) + " '" + name +
                    "' is set here, and no file declares it";
}

void reportUndeclared(Report& report, const Cursor& section, const Cursor& entry)
{
    if (report.full()) return report.count();
    Reported& error = report.atKey(entry, Code::unknown_param, "",
                                   "write {\"default\": " + brief(entry.node) + "}");
    sayUndeclared(report, section.key, entry.key, true, error);
    if (const std::string other = report.otherSection(section.key, entry.key); !other.empty())
        error.help = other;
    else if (report.leavesOut(entry.key_place))
        Report::leaveOut(error);
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
    if (!reportUnknown())  // else the key that is missing was surely meant
        for (const auto& [key, doc] : missing_)
            if (!report_.errorAt(cursor_.pointer)) reportMissing(key, doc);
    return missing_.empty();
}

// Whether there was one.
bool Reader::reportUnknown()
{
    bool reported = false;
    if (cursor_.pointer.empty())
        keys_.insert(keys_.end(), {"extends", "needs", "replaces", "variants"});
    for (const Member& member : cursor_.node.members) {
        if (contains(keys_, member.key) || isExtension(member.key)) continue;
        if (report_.full()) {
            report_.count();
            continue;
        }
        std::string help =
            cursor_.pointer.empty() ? report_.otherSection("", member.key) : std::string();
        if (contains(kSections, member.key)) help = "it stands at the top of a config";
        if (help.empty() && !startsWith(help = suggestName(member.key, keys_, "keys"), "did you"))
            help += "; a key of your own begins with 'x-'";
        const bool nested = !report_.otherSection("", member.key).empty() &&
                            startsWith(cursor_.pointer, "/params/");
        if (nested) help = nestedHelp(member.key);
        reported = true;
        Reported& error =
            report_.atKey(cursor_.child(member), Code::unknown_key,
                          "found the key '" + member.key + "', which the format does not have here",
                          std::move(help));
        if (nested) error.mistake = "nested " + cursor_.pointer;
    }
    return reported;
}

// At the null of the patch that took it away, where there is one.
void Reader::reportMissing(const std::string& key, const std::string& doc)
{
    const std::string where = cursor_.key.empty() ? "the config" : "'" + cursor_.key + "'";
    const std::string message = where + " has no '" + key + "', which must be there";
    for (const Member& deleted : cursor_.node.deleted)
        if (deleted.key == key) {
            report_.atKey(cursor_.child(deleted), Code::missing_key, message,
                          "give it a value instead of null, or leave it as it was");
            return;
        }
    Reported& error =
        report_.atKey(cursor_, Code::missing_key, message, "add \"" + key + "\": " + doc);
    const std::vector<std::string> path = pointerKeys(cursor_.pointer);
    if (path.size() == 2) sayUndeclared(report_, path[0], path[1], false, error);
}

}  // namespace crevice::table
