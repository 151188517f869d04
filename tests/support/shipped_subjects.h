// SPDX-License-Identifier: MIT
// What tests over everything that ships are about.
#pragma once

#include "tests/support/need.h"
#include "tests/support/nightly.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

namespace crevice {

struct Subject {
    std::string config;
    std::string variant = {};
};

/// Every shipped config, and again with each of its variants.
inline std::vector<Subject> subjects()
{
    std::vector<Subject> all;
    for (const std::string& name : configNames(shippedSources())) {
        all.push_back({name});
        const Node document =
            need(parseDocument(shippedSources().find("configs/" + name + ".json")));
        if (const Node* variants = document.find("variants"))
            for (const Member& variant : variants->members) all.push_back({name, variant.key});
    }
    return all;
}

/// All of them at night, else one of each kind: presets that march whole and in part, with forward
/// and deferred lighting, filters, histories and layers; light from occluders; authors' kernels.
inline std::vector<Subject> sampledSubjects()
{
    if (nightly()) return subjects();
    return {{"mobile"}, {"balanced_temporal"},    {"bitmask_layers"}, {"baked"},
            {"ssdo"},   {"learnopengl", "sound"}, {"ogldev45"}};
}

inline Description descriptionOf(const Subject& subject,
                                 const std::vector<std::string>& overrides = {},
                                 const SourceSet& sources = shippedSources())
{
    return need(
        decode(need(loadConfig(sources, {subject.config, subject.variant, overrides})), sources));
}

/// With all its whole numbers, counts most of them, at one end of their ranges.
inline Description withCounts(Description description, bool most)
{
    for (ParamDesc& param : description.params)
        if (param.type == ParamType::int_)
            param.value[0] = static_cast<float>(most ? param.max : param.min);
    return description;
}

}  // namespace crevice
