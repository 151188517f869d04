// SPDX-License-Identifier: MIT
// A whole JSON Schema from the forms of the table, with what only a file has: `extends`,
// `variants`, nulls that delete, and names that an editor may offer.
#include "tools/show/schema/schema.h"

#include "tools/show/schema/form.h"

#include <crevice/document.h>

#include "core/base/text.h"

#include <map>
#include <set>

namespace crevice {

using table::Json;

namespace {

constexpr std::string_view kConfigs = "configs/";
constexpr std::string_view kSuffix = ".json";

Json reference(const std::string& definition) { return {{"$ref", "#/definitions/" + definition}}; }

/// Lets every value below be null: merging deletes what a patch has as null.
void allowNulls(Json& form)
{
    for (const char* list : {"properties", "patternProperties"}) {
        if (!form.contains(list)) continue;
        for (Json& value : form[list]) {
            allowNulls(value);
            if (value.contains("anyOf"))
                value["anyOf"].push_back({{"type", "null"}});
            else if (value.contains("enum"))
                value["enum"].push_back(nullptr);
            else if (value.contains("type") && value["type"].is_array())
                value["type"].push_back("null");
            else if (value.contains("type"))
                value["type"] = {value["type"], "null"};
        }
    }
    if (form.contains("anyOf"))
        for (Json& each : form["anyOf"]) allowNulls(each);
}

/// A member of a shipped file that is a string; "" where there is none.
std::string textOf(const Node& document, std::string_view key)
{
    const Node* value = document.find(key);
    return value && value->kind == Node::Kind::string ? value->text : "";
}

/// What `extends` may name, as "ssao/gtao" and "learnopengl", with what each says of itself.
Json extendsForm(const SourceSet& sources)
{
    Json names = Json::array(), texts = Json::array();
    for (const std::string& path : sources.list()) {
        if (!endsWith(path, kSuffix)) continue;
        const auto document = parseDocument(sources.find(path));
        if (!document) continue;
        const std::size_t begin = startsWith(path, kConfigs) ? kConfigs.size() : 0;
        names.push_back(path.substr(begin, path.size() - begin - kSuffix.size()));
        texts.push_back(textOf(*document, "description"));
    }
    return {{"title", "extends"},
            {"description",
             "Modules and configs that this file is laid over, from left to right: names, "
             "or paths that begin with './' or '../' and end in '.json'."},
            {"type", "array"},
            {"items",
             {{"anyOf", {{{"enum", names}, {"enumDescriptions", texts}}, {{"type", "string"}}}}}}};
}

/// A list of words, of which those of the shipped files are offered.
Json wordsForm(const SourceSet& sources, const char* key, const char* description)
{
    std::set<std::string> words;
    for (const std::string& path : sources.list()) {
        if (!endsWith(path, kSuffix)) continue;
        const auto document = parseDocument(sources.find(path));
        const Node* list = document ? document->find(key) : nullptr;
        for (const Node& word : list ? list->items : std::vector<Node>()) words.insert(word.text);
    }
    return {{"title", key},
            {"description", description},
            {"type", "array"},
            {"items", {{"anyOf", {{{"enum", words}}, {{"type", "string"}}}}}}};
}

/// The words of a feature, for people: " One of: view, normal."
std::string valuesOf(const Node& feature)
{
    const Node* values = feature.find("values");
    std::string text;
    if (values)
        for (const Node& word : values->items)
            text += (text.empty() ? " One of: " : ", ") + word.text;
    return text.empty() ? text : text + '.';
}

/// The names that the modules declare in a section, so that an editor can offer them.
Json offeredNames(const SourceSet& sources, const std::string& section, const char* definition)
{
    Json names = Json::object();
    for (const std::string& path : sources.list()) {
        if (!endsWith(path, kSuffix) || startsWith(path, kConfigs)) continue;
        const auto document = parseDocument(sources.find(path));
        const Node* entries = document ? document->find(section) : nullptr;
        if (!entries) continue;
        for (const Member& entry : entries->members) {
            if (names.contains(entry.key)) continue;
            const std::string module = path.substr(0, path.size() - kSuffix.size());
            const std::string tooltip = textOf(entry.value, "tooltip");
            names[entry.key] = {
                {"title", section + '.' + entry.key},
                {"description", (tooltip.empty() ? "Declared by " + module + '.' : tooltip) +
                                    valuesOf(entry.value)},
                {"allOf", Json::array({reference(definition)})}};
        }
    }
    return names;
}

/// A name of a target or shader: those of the shipped modules for completion, and any other.
Json nameForm(const SourceSet& sources, const std::string& section)
{
    const Json offered = offeredNames(sources, section, "");
    Json names = Json::array();
    for (const auto& [name, form] : offered.items()) names.push_back(name);
    return {{"anyOf", {{{"enum", names}}, {{"type", "string"}}}}};
}

/// Lets every string of the form be a name of that definition.
void nameStrings(Json& form, const std::string& definition)
{
    if (form.contains("items")) nameStrings(form["items"], definition);
    if (form.contains("anyOf"))
        for (Json& each : form["anyOf"]) nameStrings(each, definition);
    if (!form.contains("type") || form["type"] != "string") return;
    form.erase("type");
    form["anyOf"] = Json::array({reference(definition)});
}

/// Finds, by their titles, the keys that name a target or shader.
void offerNames(Json& form)
{
    static const std::map<std::string, std::string> kNames = {
        {"targets.NAME.size.of", "target_name"},
        {"passes.NAME.shader", "shader_name"},
        {"passes.NAME.color", "target_name"},
        {"passes.NAME.depth", "target_name"},
        {"passes.NAME.bypass.NAME", "target_name"},
        {"passes.NAME.inputs.NAME", "target_name"},
        {"passes.NAME.inputs.NAME.from", "target_name"},
        {"outputs.NAME", "target_name"},
        {"views.NAME.target", "target_name"}};
    const auto named = kNames.find(form.value("title", ""));
    if (named != kNames.end()) return nameStrings(form, named->second);
    for (const char* list : {"properties", "patternProperties", "anyOf"})
        if (form.contains(list))
            for (Json& each : form[list]) offerNames(each);
}

/// "Where `type` is the word, `default` has this form", or is deleted.
Json typeRule(const std::string& word, Json form)
{
    return {
        {"if", {{"properties", {{"type", {{"const", word}}}}}, {"required", {"type"}}}},
        {"then",
         {{"properties", {{"default", table::anyForm({std::move(form), {{"type", "null"}}})}}}}}};
}

Json paramTypeRules()
{
    Json rules = Json::array();
    const auto words = table::spellings(ParamType{});
    for (std::size_t i = 0; i < words.size(); ++i) {
        ParamDesc param;
        param.type = static_cast<ParamType>(i);
        Json form = table::formOf(param, {}, "")["properties"]["default"];
        if (form.contains("anyOf")) form = Json(form["anyOf"].front());
        for (const char* key : {"title", "description", "x-required"}) form.erase(key);
        rules.push_back(typeRule(words[i], std::move(form)));
    }
    return rules;
}

Json featureTypeRules()
{
    return Json::array(
        {typeRule("bool", {{"type", "boolean"}}), typeRule("enum", {{"type", "string"}})});
}

/// The entry of an object keyed by name: the form of "targets.NAME" for "targets".
Json& entryOf(Json& form) { return form["patternProperties"].back(); }

/// What every file has and the merged config has not.
Json fileProperties(const SourceSet& sources)
{
    return {{"$schema",
             {{"type", "string"},
              {"description", "The JSON Schema that editors check this file with; not read."}}},
            {"extends", extendsForm(sources)},
            {"needs", wordsForm(sources, "needs",
                                "What this file is nothing without: where a later one replaces "
                                "one of these words, this one is left out.")},
            {"replaces", wordsForm(sources, "replaces",
                                   "What this file takes the place of: earlier files that need "
                                   "one of these words are left out, and so are values for what "
                                   "only they declare.")},
            {"variants", table::keyedForm("^(?!x-)", reference("patch"))}};
}

Json descriptionForm()
{
    Description description;
    return table::formOf(description, {}, "");
}

/// A param or feature may be its default alone.
void allowBareValues(Json& definitions)
{
    definitions["param"]["allOf"] = paramTypeRules();
    definitions["feature"]["allOf"] = featureTypeRules();
    for (const char* tunable : {"param", "feature"}) {
        Json bare = definitions[tunable]["properties"]["default"];
        for (const char* key : {"title", "x-required"}) bare.erase(key);
        definitions[tunable] = table::anyForm({std::move(definitions[tunable]), std::move(bare)});
    }
}

}  // namespace

std::string schemaJson(const SourceSet& sources)
{
    Json form = descriptionForm();
    offerNames(form);
    allowNulls(form);
    Json definitions = {{"target_name", nameForm(sources, "targets")},
                        {"shader_name", nameForm(sources, "shaders")}};
    Json keys = Json::object();
    for (const auto& [section, definition] :
         {std::pair{"params", "param"}, {"features", "feature"}}) {
        Json& all = form["properties"][section];
        definitions[definition] = std::exchange(entryOf(all), reference(definition));
        all["properties"] = offeredNames(sources, section, definition);
    }
    allowBareValues(definitions);
    for (const auto& [key, value] : form["properties"].items()) {
        definitions[key] = value;
        keys[key] = reference(key);
    }
    definitions["patch"] = table::objectForm(keys);
    definitions["patch"]["description"] = "A patch over all else: only what differs.";

    Json own = fileProperties(sources);
    own["variants"]["title"] = "variants";
    own["variants"]["description"] = "Named patches, of which --variant chooses one.";
    own.update(keys);
    Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                   {"title", "crevice config or module, format 1"},
                   {"allowComments", true},  // this and the next are read by VS Code
                   {"allowTrailingCommas", true}};
    schema.update(table::objectForm(own));
    schema["required"] = {"format"};
    schema["definitions"] = definitions;
    return schema.dump(2) + '\n';
}

std::optional<FormatKey> findFormatKey(const std::vector<std::string>& parts)
{
    Json form = descriptionForm();
    bool named = false;
    for (const std::string& part : parts) {
        if (form.contains("anyOf"))
            form = Json(form["anyOf"].front());  // what has keys comes first
        const bool fixed = form.contains("properties");
        named = !fixed && form.contains("patternProperties");
        if (fixed && form["properties"].contains(part))
            form = Json(form["properties"][part]);
        else if (named)
            form = Json(entryOf(form));
        else
            return std::nullopt;
    }
    const bool has_default = form.contains("default");
    return FormatKey{form.value("description", ""), has_default ? form["default"].dump() : "",
                     named};
}

}  // namespace crevice
