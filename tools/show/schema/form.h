// SPDX-License-Identifier: MIT
// The visitor of core/config/fields.h that describes: each `formOf` turns a member into the JSON
// Schema of what it may be written as, with the member's initial value as the default.
//
// Private to tools/show/schema*.cpp. A form is draft-07 but for "x-required", which marks a key
// that must be there once all files are merged. No form allows null yet: a patch's nulls come last.
#pragma once

#include "core/config/fields.h"

#include <nlohmann/json.hpp>

#include <string>
#include <type_traits>

namespace crevice::table {

using Json = nlohmann::ordered_json;

/// What an "x-" key may be, and a name that JSON, GLSL and C++ can share.
inline const char* const kExtensionPattern = "^x-";
inline const char* const kNamePattern = "^(?!gl_)(?!.*__)[a-z][a-z0-9_]{0,63}$";

/// Where a form stands in a config: "targets.NAME.size". NAME is any name; empty is the top.
using Path = std::string;

Json formOf(bool& member, const Rule& rule, const Path& path);
Json formOf(int& member, const Rule& rule, const Path& path);
Json formOf(unsigned& member, const Rule& rule, const Path& path);
Json formOf(float& member, const Rule& rule, const Path& path);
Json formOf(double& member, const Rule& rule, const Path& path);
Json formOf(std::string& member, const Rule& rule, const Path& path);
Json formOf(Reference& member, const Rule& rule, const Path& path);
Json formOf(std::vector<Reference>& member, const Rule& rule, const Path& path);
Json formOf(std::vector<Format>& member, const Rule& rule, const Path& path);
Json formOf(std::map<std::string, std::string>& member, const Rule& rule, const Path& path);
Json formOf(Numbers member, const Rule& rule, const Path& path);
Json formOf(Words member, const Rule& rule, const Path& path);
Json formOf(Choice member, const Rule& rule, const Path& path);
Json formOf(OneOf member, const Rule& rule, const Path& path);
Json formOf(Scalars member, const Rule& rule, const Path& path);
Json formOf(Later member, const Rule& rule, const Path& path);

template <class T>
Json formOf(NumberOrName<T> member, const Rule& rule, const Path& path);
template <class T>
Json formOf(std::vector<T>& member, const Rule& rule, const Path& path);
template <class T>
Json formOf(T& member, const Rule& rule, const Path& path);

/// An object of these properties, of "x-" keys and nothing else.
Json objectForm(Json properties);

/// An object whose keys match the pattern, or begin with "x-".
Json keyedForm(const char* pattern, Json entry);

/// One of several forms, with the default of the first that has one.
Json anyForm(std::vector<Json> forms);

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
    Json take();

private:
    static Json described(Json form, const Path& path, const char* doc, const Rule& rule);

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
    return keyedForm(std::is_base_of_v<Named, T> ? kNamePattern : any_name,
                     formOf(entry, {}, path + ".NAME"));
}

template <class T>
Json formOf(T& member, const Rule& rule, const Path& path)
{
    if constexpr (std::is_enum_v<T>) {
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

}  // namespace crevice::table
