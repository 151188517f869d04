// SPDX-License-Identifier: MIT
// From a merged document to a description.
#include <crevice/config.h>

#include "core/base/text.h"
#include "core/config/decode_reader.h"
#include "core/config/fields.h"
#include "core/config/values.h"

#include <algorithm>

namespace crevice {

namespace {

// What such a section declares is not there, and all that refers to it would be reported.
bool hasMisspeltSection(const Node& document, const table::Report& report)
{
    return std::any_of(document.members.begin(), document.members.end(), [&](const Member& each) {
        return each.value.kind == Node::Kind::object && report.errorAt("/" + each.key);
    });
}

void noteDeleted(const Node& document, Description& description)
{
    for (const Member& each : document.deleted) {
        if (each.value.kind == Node::Kind::string)
            description.left_out.push_back({each.key, each.value.text});
        else
            description.deleted.push_back({each.key, each.key_place, memberPointer("", each.key)});
    }
    for (const Member& section : document.members) {
        const std::string pointer = memberPointer("", section.key);
        for (const Member& each : section.value.deleted)
            description.deleted.push_back(
                {each.key, each.key_place, memberPointer(pointer, each.key)});
    }
}

Status checkLimits(const Node& document, const Limits& limits)
{
    const std::pair<const char*, int> most[] = {{"passes", limits.passes},
                                                {"targets", limits.targets}};
    Diagnostics errors;
    for (const auto& [section, count] : most) {
        const Node* entries = document.find(section);
        if (!entries || static_cast<int>(entries->members.size()) <= count) continue;
        errors.push_back({Code::over_limit,
                          "the config has " + std::to_string(entries->members.size()) + " " +
                              section + ", and at most " + std::to_string(count) + " may be",
                          "leave some out, or raise Limits::" + std::string(section) +
                              " (--limit " + section + "=N)",
                          table::lastPlace(*entries), memberPointer("", section)});
    }
    return errors;
}

}  // namespace

int componentCount(ParamType type)
{
    constexpr int kCounts[] = {1, 1, 2, 3, 4};  // in the order of ParamType
    return kCounts[static_cast<int>(type)];
}

GlslType glslTypeOf(ParamType type)
{
    constexpr GlslType kTypes[] = {GlslType::float_, GlslType::int_, GlslType::vec2, GlslType::vec3,
                                   GlslType::vec4};
    return kTypes[static_cast<int>(type)];
}

Result<Description> decode(const Node& document, const SourceSet& sources, const Limits& limits)
{
    if (const Status fits = checkLimits(document, limits); !fits) return fits.diagnostics();
    Description description;
    description.limits = limits;
    description.place = document.place;
    noteDeleted(document, description);
    table::Report report(document, sources);
    table::read(report, table::Cursor{document, "", document.place}, description, {});
    table::checkNames(description, report);
    table::readLevels(document, description, report);
    std::set<std::string> referred;
    if (!hasMisspeltSection(document, report)) {
        referred = table::checkReferences(document, description, report);
        table::readShaderFiles(description, report);
    }
    Diagnostics diagnostics = report.take(document);
    if (hasErrors(diagnostics)) return diagnostics;
    for (const FeatureDesc& each : description.features) applyLevel(description, each.name);
    description.unused = std::move(diagnostics);  // of what is left out
    append(description.unused, table::unusedNames(document, description, std::move(referred)));
    cutShort(description.unused);
    return description;
}

}  // namespace crevice
