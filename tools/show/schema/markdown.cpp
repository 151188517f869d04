// SPDX-License-Identifier: MIT
// The forms of the table as Markdown: a section for each kind of object, a row for each key.
#include "tools/show/schema/schema.h"

#include "core/base/text.h"

namespace crevice {

using table::Json;

namespace {

bool hasKeys(const Json& form) { return form.contains("properties"); }

/// The entry of an object keyed by name, or null.
const Json* entryOf(const Json& form)
{
    const auto patterns = form.find("patternProperties");
    return !hasKeys(form) && patterns != form.end() ? &patterns->back() : nullptr;
}

/// The object that a form is, or may be besides a shorter form; null when it is none.
const Json* objectOf(const Json& form)
{
    if (hasKeys(form)) return &form;
    if (!form.contains("anyOf")) return nullptr;
    const Json& first = form["anyOf"].front();
    return hasKeys(first) ? &first : nullptr;
}

std::string linkTo(const std::string& path)
{
    std::string anchor = lowerCase(path);
    anchor.erase(std::remove(anchor.begin(), anchor.end(), '.'), anchor.end());
    return "[`" + path + "`](#" + anchor + ")";
}

std::string joinedJson(const Json& list, const std::string& separator, const std::string& quote)
{
    std::string text;
    for (const Json& each : list)
        text += (text.empty() ? "" : separator) + quote +
                (each.is_string() ? each.get<std::string>() : each.dump()) + quote;
    return text;
}

std::string typeText(const Json& form, const std::string& path);

std::string listText(const Json& form, const std::string& path)
{
    const bool counted = form.contains("maxItems");
    const std::string least = form.value("minItems", Json(0)).dump();
    const std::string most = counted ? form["maxItems"].dump() : "";
    const std::string count = !counted        ? ""
                              : least == most ? " " + most
                                              : " " + least + " to " + most;
    const bool word = form["items"].contains("type") && form["items"]["type"].is_string();
    return "list of" + count + " " + typeText(form["items"], path) + (word ? "s" : "");
}

/// "number", "`a`, `b`", "list of 4 numbers", "by name: [`targets.NAME`](#targetsname)".
std::string typeText(const Json& form, const std::string& path)
{
    if (form.contains("const")) return "`" + form["const"].dump() + "`";
    if (form.contains("enum")) return joinedJson(form["enum"], ", ", "`");
    if (hasKeys(form)) return linkTo(path);
    if (const Json* entry = entryOf(form)) return "by name: " + typeText(*entry, path + ".NAME");
    if (form.contains("items")) return listText(form, path);
    if (!form.contains("anyOf"))
        return form["type"].is_array() ? joinedJson(form["type"], " or ", "")
                                       : form["type"].get<std::string>();
    std::string text;
    for (const Json& each : form["anyOf"]) {
        const bool list_of_it = each.contains("items") && each["items"] == form["anyOf"][0];
        const std::string type =
            list_of_it && !each.contains("maxItems") ? "list of them" : typeText(each, path);
        text += (text.empty() ? "" : " or ") + type;
    }
    return text;
}

std::string rangeText(const Json& form)
{
    if (form.contains("minimum"))
        return "[" + form["minimum"].dump() + ", " + form["maximum"].dump() + "]";
    return form.contains("anyOf") ? rangeText(form["anyOf"][0]) : "";
}

std::string defaultText(const Json& form)
{
    if (form.contains("x-required")) return "required";
    if (!form.contains("default")) return "";
    const Json& value = form["default"];
    return "`" + (value.is_string() ? value.get<std::string>() : value.dump()) + "`";
}

std::string meaningText(const Json& form)
{
    const Json* entry = entryOf(form);
    std::string text = form.value("description", "");
    if (entry && entry->contains("description")) text += " " + entry->value("description", "");
    std::string escaped;
    for (const char c : text)
        escaped += c == '<' || c == '|' ? std::string("\\") + c : std::string(1, c);
    return escaped;
}

/// The section of an object, and those of the objects in it.
std::string sectionText(const Json& form, const std::string& path)
{
    std::string text = path.empty() ? "" : "\n## `" + path + "`\n";
    text += "\n| key | type | default | range | meaning |\n|---|---|---|---|---|\n";
    std::string below;
    for (const auto& [key, value] : form["properties"].items()) {
        const std::string at = path.empty() ? key : path + '.' + key;
        text += "| `" + key + "` | " + typeText(value, at) + " | " + defaultText(value) + " | " +
                rangeText(value) + " | " + meaningText(value) + " |\n";
        const Json* entry = entryOf(value);
        const Json* object = objectOf(entry ? *entry : value);
        if (object) below += sectionText(*object, entry ? at + ".NAME" : at);
    }
    return text + below;
}

}  // namespace

std::string schemaMarkdown() { return sectionText(table::configForm(), ""); }

}  // namespace crevice
