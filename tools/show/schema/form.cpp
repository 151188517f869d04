// SPDX-License-Identifier: MIT
// The visitor of core/config/fields.h that describes: each `formOf` turns a member, in one of the
// JSON forms of core/config/field_types.h, into the JSON Schema of what it may be written as, with
// the member's initial value as the default.
#include "tools/show/schema/schema.h"

#include "core/config/fields.h"

#include <climits>
#include <cmath>
#include <type_traits>

namespace crevice::table {

namespace {

/// What an "x-" key may be, and a name that JSON, GLSL and C++ can share.
const char* const kExtensionPattern = "^x-";
const char* const kNamePattern = "^(?!gl_)(?!.*__)[a-z][a-z0-9_]{0,63}$";

/// Where a form stands in a config: "targets.NAME.size". NAME is any name; empty is the top.
using Path = std::string;

/// Whole numbers without a decimal point.
Json number(double value)
{
    if (value == std::floor(value) && std::abs(value) < 1e15) return static_cast<long long>(value);
    return value;
}

Json numberForm(const char* type, double value, const Rule& rule)
{
    if (rule.min == rule.max) return {{"const", number(rule.min)}};
    Json form = {{"type", type}};
    if (std::isfinite(rule.min)) form["minimum"] = number(rule.min);
    if (std::isfinite(rule.max)) form["maximum"] = number(rule.max);
    if (!rule.required) form["default"] = number(value);
    return form;
}

Json listForm(Json items, int least, int most)
{
    Json form = {{"type", "array"}, {"items", std::move(items)}};
    if (least > 0) form["minItems"] = least;
    if (most > 0) form["maxItems"] = most;
    return form;
}

Json stringForm() { return {{"type", "string"}}; }

/// The form, or a list of it.
Json oneOrSeveral(const Json& form, int least) { return anyForm({form, listForm(form, least, 0)}); }

Json scalarForm() { return {{"type", {"boolean", "number", "string"}}}; }

Json formOf(std::string&, const Rule&, const Path&) { return stringForm(); }

Json formOf(Reference&, const Rule&, const Path&) { return stringForm(); }

Json formOf(std::vector<Reference>&, const Rule&, const Path&)
{
    return oneOrSeveral(stringForm(), 0);
}

Json formOf(std::vector<Format>&, const Rule&, const Path&)
{
    Json words = Json::array();
    for (const FormatInfo& info : allFormats()) words.push_back(info.name);
    return oneOrSeveral({{"enum", std::move(words)}}, 1);
}

Json formOf(ProductDesc&, const Rule& rule, const Path&)
{
    const Json factor = numberForm("number", 1, range(1e-6, 1e6));
    return anyForm({numberForm("number", 0, rule), stringForm(),
                    listForm(anyForm({factor, stringForm()}), 1, 0)});
}

Json formOf(std::map<std::string, std::string>&, const Rule&, const Path&)
{
    return keyedForm("^(?!GL_)(?!.*__)[A-Za-z_][A-Za-z0-9_]*$", scalarForm());
}

// What a param that says no type may have, since another file may say it; exact for all but float.
Json formOf(Numbers member, const Rule& rule, const Path&)
{
    const Json one = numberForm(member.whole ? "integer" : "number", 0, rule);
    if (member.whole) return one;
    const bool any = member.count == 1;
    Json list = listForm(one, any ? 2 : member.count, any ? 4 : member.count);
    list["items"].erase("default");
    if (any) return anyForm({one, {{"pattern", "^[0-9.eE+]+(%|px)$"}, {"type", "string"}}, list});
    return member.fills ? anyForm({one, std::move(list)}) : list;
}

Json formOf(Words, const Rule&, const Path&)
{
    Json form = listForm(stringForm(), 2, 0);
    form["uniqueItems"] = true;
    return form;
}

Json formOf(Choice, const Rule&, const Path&) { return {{"type", {"boolean", "string"}}}; }

Json formOf(OneOf member, const Rule& rule, const Path&)
{
    Json form = {{"enum", member.allowed}};
    if (!rule.required) form["default"] = member.word;
    return form;
}

Json formOf(Scalars, const Rule&, const Path&) { return oneOrSeveral(scalarForm(), 1); }

Json formOf(Later, const Rule&, const Path&)
{
    return anyForm({scalarForm(), listForm({{"type", "number"}}, 2, 4)});
}

template <class T>
Json formOf(NumberOrName<T> member, const Rule& rule, const Path& path);
template <class T>
Json formOf(std::vector<T>& member, const Rule& rule, const Path& path);
template <class T>
Json formOf(T& member, const Rule& rule, const Path& path);

class Describer {
public:
    explicit Describer(Path path) : path_(std::move(path)) {}

    template <class T>
    bool field(const char* key, T&& member, const char* doc, const Rule& rule = {})
    {
        const Path path = path_.empty() ? key : path_ + '.' + key;
        properties_[key] = described(formOf(member, rule, path), path, doc, rule);
        return true;
    }

    template <class T>
    bool shorthand(const char* key, T&& member, const char* doc, const Rule& rule = {})
    {
        return itself(member, doc, rule) && field(key, member, doc, rule);
    }

    template <class T>
    bool itself(T&& member, const char* doc, const Rule& rule = {})
    {
        whole_ = described(formOf(member, rule, path_), path_, doc, rule);
        return true;
    }

    // What one value says about another is for decoding: a file may hold but a part of an object.
    bool has(const char*) const { return false; }
    void refuse(const char*, Code, const char*) {}
    void ordered(const char*, double&, const char*, double&) {}

    /// To be called last.
    Json take()
    {
        if (properties_.empty()) return std::move(whole_);
        Json object = objectForm(std::move(properties_));
        return whole_.is_null() ? object : anyForm({std::move(object), std::move(whole_)});
    }

private:
    static Json described(Json form, const Path& path, const char* doc, const Rule& rule)
    {
        Json out = {{"title", path}, {"description", doc}};
        if (rule.required) out["x-required"] = true;
        out.update(form);
        return out;
    }

    Path path_;
    Json properties_ = Json::object();
    Json whole_ = nullptr;  // the form that is no object with keys
};

template <class T>
Json formOf(NumberOrName<T> member, const Rule& rule, const Path& path)
{
    return anyForm({formOf(member.number, rule, path), formOf(member.name, {}, path)});
}

template <class T>
Json formOf(std::vector<T>&, const Rule&, const Path& path)
{
    T entry{};
    const char* const any_name = "^(?!x-)";
    return keyedForm(std::is_base_of_v<Reference, T> ? any_name : kNamePattern,
                     formOf(entry, {}, path + ".NAME"));
}

template <class T>
Json formOf(T& member, const Rule& rule, const Path& path)
{
    if constexpr (std::is_same_v<T, bool>) {
        return {{"type", "boolean"}, {"default", member}};
    } else if constexpr (std::is_arithmetic_v<T>) {
        Rule range = rule;
        if (std::is_unsigned_v<T>) range.min = std::max(rule.min, 0.0);
        if (std::is_unsigned_v<T>) range.max = std::min(rule.max, double{UINT_MAX});
        return numberForm(std::is_integral_v<T> ? "integer" : "number", double(member), range);
    } else if constexpr (std::is_enum_v<T>) {
        const std::vector<std::string> words = spellings(member);
        Json form = {{"enum", words}};
        if (!rule.required) form["default"] = words[static_cast<std::size_t>(member)];
        return form;
    } else {
        Describer describer(path);
        fields(describer, member);
        return describer.take();
    }
}

}  // namespace

Json objectForm(Json properties)
{
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"patternProperties", {{kExtensionPattern, Json::object()}}},
            {"additionalProperties", false}};
}

Json keyedForm(const char* pattern, Json entry)
{
    return {
        {"type", "object"},
        {"patternProperties", {{kExtensionPattern, Json::object()}, {pattern, std::move(entry)}}},
        {"additionalProperties", false}};
}

Json anyForm(std::vector<Json> forms)
{
    Json any = {{"anyOf", Json::array()}};
    for (Json& form : forms) {
        if (form.contains("default")) {
            any["default"] = form["default"];
            form.erase("default");
        }
        any["anyOf"].push_back(std::move(form));
    }
    return any;
}

Json configForm()
{
    Description description;
    return formOf(description, {}, "");
}

}  // namespace crevice::table
