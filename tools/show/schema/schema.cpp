// SPDX-License-Identifier: MIT
// A whole JSON Schema from the forms of the table, with what only a file has: `extends`,
// `variants`, nulls that delete, and names that an editor may offer.
#include "tools/show/schema/schema.h"

#include <crevice/document.h>

#include "core/base/text.h"

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

/// The JSON files that can be read, by their names in `extends`: "ssao/gtao", "learnopengl".
using Files = std::map<std::string, Node>;

Files filesOf(const SourceSet& sources)
{
    Files files;
    for (const std::string& path : sources.list()) {
        if (!endsWith(path, kSuffix)) continue;
        Result<Node> document = parseDocument(sources.find(path));
        const std::size_t begin = startsWith(path, kConfigs) ? kConfigs.size() : 0;
        const std::string name = path.substr(begin, path.size() - begin - kSuffix.size());
        if (document) files[name] = std::move(*document);
    }
    return files;
}

/// What `extends` may name, with what each says of itself.
Json extendsForm(const Files& files)
{
    Json names = Json::array(), texts = Json::array();
    for (const auto& [name, document] : files) {
        names.push_back(name);
        texts.push_back(textOf(document, "description"));
    }
    return {{"title", "extends"},
            {"description",
             "Modules and configs that this file is laid over, from left to right: names, "
             "or paths that begin with './' or '../' and end in '.json'."},
            {"type", "array"},
            {"items",
             {{"anyOf", {{{"enum", names}, {"enumDescriptions", texts}}, {{"type", "string"}}}}}}};
}

Json wordsForm(const char* key, const char* description)
{
    return {{"title", key},
            {"description", description},
            {"type", "array"},
            {"items", {{"type", "string"}}}};
}

/// The words of a feature, for people: " One of: view, normal."
std::string valuesOf(const Node& feature)
{
    std::vector<std::string> words;
    if (const Node* values = feature.find("values"))
        for (const Node& word : values->items) words.push_back(word.text);
    return words.empty() ? "" : " One of: " + joined(words) + '.';
}

/// The names that modules declare in a section, so that an editor can offer them.
Json offeredNames(const Files& files, const std::string& section, const char* definition)
{
    Json names = Json::object();
    for (const auto& [file, document] : files) {
        const bool is_module = file.find('/') != std::string::npos;
        const Node* entries = is_module ? document.find(section) : nullptr;
        for (const Member& entry : entries ? entries->members : std::vector<Member>()) {
            if (names.contains(entry.key)) continue;
            const std::string tooltip = textOf(entry.value, "tooltip");
            names[entry.key] = {
                {"title", section + '.' + entry.key},
                {"description",
                 (tooltip.empty() ? "Declared by " + file + '.' : tooltip) + valuesOf(entry.value)},
                {"allOf", Json::array({reference(definition)})}};
        }
    }
    return names;
}

/// A name of a target or shader: those of the shipped modules for completion, and any other.
Json nameForm(const Files& files, const std::string& section)
{
    const Json offered = offeredNames(files, section, "");
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

/// The entry of an object keyed by name: the form of "targets.NAME" for "targets".
Json& entryOf(Json& form) { return form["patternProperties"].back(); }

/// What every file has and the merged config has not.
Json fileProperties(const Files& files)
{
    return {{"$schema",
             {{"type", "string"},
              {"description", "The JSON Schema that editors check this file with; not read."}}},
            {"extends", extendsForm(files)},
            {"needs", wordsForm("needs",
                                "What this file is nothing without: where a later one replaces "
                                "one of these words, this one is left out.")},
            {"replaces", wordsForm("replaces",
                                   "What this file takes the place of: earlier files that need "
                                   "one of these words are left out, and so are values for what "
                                   "only they declare.")},
            {"variants", table::keyedForm("^(?!x-)", reference("patch"))}};
}

/// A param or feature may be its default alone.
void allowBareValues(Json& definitions)
{
    for (const char* tunable : {"param", "feature"}) {
        Json bare = definitions[tunable]["properties"]["default"];
        for (const char* key : {"title", "x-required"}) bare.erase(key);
        definitions[tunable] = table::anyForm({std::move(definitions[tunable]), std::move(bare)});
    }
}

}  // namespace

Result<Json> listJson(const SourceSet& sources, const std::map<std::string, std::string>& scenes,
                      const std::string& kind)
{
    std::map<std::string, std::map<std::string, std::string>> all = {{"scenes", scenes}};
    for (const auto& [name, document] : filesOf(sources)) {
        const std::string text = textOf(document, "description");
        const Node* shaders = document.find("shaders");
        const Node* ssao = shaders ? shaders->find("ssao") : nullptr;
        all[name.find('/') == name.npos ? "configs" : "modules"][name] = text;
        if (startsWith(name, "filter/")) all["filters"][name] = text;
        if (startsWith(name, "ssao/") && ssao && document.find("extends"))
            all["estimators"][name] = text;
    }
    Json list;
    std::vector<std::string> kinds;
    for (const auto& [each, texts] : all) {
        kinds.push_back(each);
        for (const auto& [name, text] : texts)
            if (kind.empty())
                list[each].push_back(name);
            else if (kind == each)
                list[each].push_back({{"name", name}, {"description", text}});
    }
    if (!list.is_null()) return list;
    return Diagnostic{Code::usage, "there is no list of '" + kind + "'",
                      suggestName(kind, kinds, "lists")};
}

std::string schemaJson(const SourceSet& sources)
{
    const Files files = filesOf(sources);
    Json form = table::configForm();
    offerNames(form);
    allowNulls(form);
    Json definitions = {{"target_name", nameForm(files, "targets")},
                        {"shader_name", nameForm(files, "shaders")}};
    Json keys = Json::object();
    for (const auto& [section, definition] :
         {std::pair{"params", "param"}, {"features", "feature"}}) {
        Json& all = form["properties"][section];
        definitions[definition] = std::exchange(entryOf(all), reference(definition));
        all["properties"] = offeredNames(files, section, definition);
    }
    allowBareValues(definitions);
    for (const auto& [key, value] : form["properties"].items()) {
        definitions[key] = value;
        keys[key] = reference(key);
    }
    definitions["patch"] = table::objectForm(keys);
    definitions["patch"]["description"] = "A patch over all else: only what differs.";

    Json own = fileProperties(files);
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

}  // namespace crevice
