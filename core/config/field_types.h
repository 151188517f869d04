// SPDX-License-Identifier: MIT
// The words of core/config/fields.h: rules, enum spellings, JSON forms that no C++ type says.
#pragma once

#include <crevice/config.h>

#include <limits>

namespace crevice::table {

/// Bound of all params and their bounds: far past any scene, yet its square is a float.
constexpr double kMaxParam = 1e30;

/// What a value must satisfy beyond its type.
struct Rule {
    bool required = false;
    double min = -std::numeric_limits<double>::infinity();  ///< Inclusive, for each component.
    double max = std::numeric_limits<double>::infinity();   ///< Inclusive, for each component.
    std::string_view unit = {};                             ///< Of the range, for messages.
    bool length = false;                                    ///< "5%" and "40px" will do, too.
};

constexpr Rule required(Rule rule = {})
{
    rule.required = true;
    return rule;
}

constexpr Rule range(double min, double max, std::string_view unit = {}, bool length = false)
{
    return {false, min, max, unit, length};
}

/// The JSON spellings of an enum, in the order of its values.
using Spellings = std::vector<std::string>;
inline Spellings spellings(ParamType) { return {"float", "int", "vec2", "vec3", "vec4"}; }
inline Spellings spellings(Bind) { return {"uniform", "define"}; }
inline Spellings spellings(ParamSemantic) { return {"other", "length", "margin"}; }
inline Spellings spellings(ImportType) { return {"camera", "draw_list", "lights", "texture"}; }
inline Spellings spellings(Semantic) { return {"other", "view_position", "view_depth", "mask"}; }
inline Spellings spellings(PassType) { return {"draw", "fullscreen"}; }
inline Spellings spellings(Cull) { return {"none", "back", "front"}; }
inline Spellings spellings(Filter) { return {"nearest", "linear", "trilinear"}; }
inline Spellings spellings(Blend) { return {"none", "over", "min", "max"}; }
inline Spellings spellings(Wrap) { return {"clamp", "repeat"}; }
inline Spellings spellings(Compare)
{
    return {"always", "less", "less_equal", "greater", "greater_equal", "equal"};
}

/// The JSON spelling of an enum's value.
template <class T>
std::string word(T value)
{
    return spellings(value)[static_cast<std::size_t>(value)];
}

/// A number when `count` is 1, else a list of `count` numbers; anything when it is 0.
struct Numbers {
    std::array<float, 4>& values;
    int count;
    bool whole;
    bool fills = false;  ///< A number may stand for a list in which all are it.
};

/// A list of at least two different names.
struct Words {
    std::vector<std::string>& words;
};

/// true or false, or one of `words`; kept as its index.
struct Choice {
    int& index;
    const std::vector<std::string>& words;
    bool boolean;
};

/// One word of a list that is no enum.
struct OneOf {
    std::string& word;
    std::vector<std::string> allowed;
};

/// A boolean, number or string, or a list of them, as text.
struct Scalars {
    std::vector<std::string>& texts;
};

/// A value whose type depends on what is declared elsewhere: read after everything else.
struct Later {};

/// A number, or the name of something that stands for it.
template <class T>
struct NumberOrName {
    T& number;
    Reference& name;
};

}  // namespace crevice::table
