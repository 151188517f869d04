// SPDX-License-Identifier: MIT
// The JSON Schema of each JSON form in core/config/field_types.h.
#include "tools/show/schema/form.h"

#include <climits>
#include <cmath>

namespace crevice::table {

namespace {

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

Json formOf(bool& member, const Rule&, const Path&)
{
    return {{"type", "boolean"}, {"default", member}};
}

Json formOf(int& member, const Rule& rule, const Path&)
{
    return numberForm("integer", member, rule);
}

Json formOf(unsigned& member, const Rule& rule, const Path&)
{
    Rule whole = rule;
    whole.min = std::max(rule.min, 0.0);
    whole.max = std::min(rule.max, double{UINT_MAX});
    return numberForm("integer", member, whole);
}

Json formOf(float& member, const Rule& rule, const Path&)
{
    return numberForm("number", double{member}, rule);
}

Json formOf(double& member, const Rule& rule, const Path&)
{
    return numberForm("number", member, rule);
}

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
    return any || member.fills ? anyForm({one, std::move(list)}) : list;
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

Json Describer::described(Json form, const Path& path, const char* doc, const Rule& rule)
{
    Json out = {{"title", path}, {"description", doc}};
    if (rule.required) out["x-required"] = true;
    out.update(form);
    return out;
}

Json Describer::take()
{
    if (properties_.empty()) return std::move(whole_);
    Json object = objectForm(std::move(properties_));
    return whole_.is_null() ? object : anyForm({std::move(object), std::move(whole_)});
}

}  // namespace crevice::table
