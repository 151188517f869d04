// SPDX-License-Identifier: MIT
// Declared names against each other: collisions, and sizes that follow.
#include "core/config/decode_steps.h"

#include "core/frame/frame_values.h"

#include <algorithm>
#include <map>
#include <set>

namespace crevice::table {

namespace {

// Names of things that `who` sees together, so that no two may have the same.
struct SharedNames {
    const char* who;
    Report& report;
    std::map<std::string, std::pair<Place, std::string>> seen = {};

    void add(const Named& named, const std::string& what)
    {
        const auto [entry, fresh] = seen.emplace(named.name, std::pair(named.place, what));
        if (fresh) return;
        const auto& [place, first] = entry->second;
        Reported& error = report.at(
            referenceTo(named), Code::name_collision,
            what + " '" + named.name + "' has the name of " + first + ", and " + who + " sees both",
            "rename one of them");
        error.notes.push_back({place, first + " is here"});
    }

    template <class T>
    void add(const std::vector<T>& list, const std::string& what)
    {
        for (const T& each : list) add(each, what);
    }
};

void checkCollisions(const Description& description, Report& report)
{
    SharedNames glsl{"GLSL", report};
    glsl.add(description.params, "a param");
    glsl.add(description.targets, "a target");
    glsl.add(description.generated, "a generated value");
    for (const ImportDesc& each : description.imports)
        if (each.type == ImportType::texture) glsl.add(each, "a texture import");
    for (const TargetDesc& each : description.targets)
        if (each.history) glsl.add({historyName(each), each.place, each.pointer}, "a history");

    SharedNames settable{"an override", report};
    settable.add(description.params, "a param");
    settable.add(description.features, "a feature");

    for (const ParamDesc& each : description.params)
        if (findNamed(kFrameValues, each.name))
            report.at(referenceTo(each), Code::name_collision,
                      "param '" + each.name + "' has the name of a uniform that each frame feeds",
                      "rename the param");
}

// Follows `size.of` from each target that no walk has come by, until one is met again.
void checkSizeCycles(const Description& description, Report& report)
{
    std::map<std::string, const TargetDesc*> named;
    for (const TargetDesc& each : description.targets) named.emplace(each.name, &each);
    std::set<const TargetDesc*> met;
    for (const TargetDesc& start : description.targets) {
        std::vector<const TargetDesc*> chain;
        const TargetDesc* at = &start;
        while (at && met.insert(at).second) {
            chain.push_back(at);
            const auto next = named.find(at->size.of.name);
            at = next == named.end() ? nullptr : next->second;
        }
        for (auto each = std::find(chain.begin(), chain.end(), at); each != chain.end(); ++each) {
            const TargetDesc& target = **each;
            Reported& error =
                report.at(target.size.of, Code::cycle,
                          "target '" + target.name + "' follows the size of '" +
                              target.size.of.name + "', which leads round in a circle",
                          "let one of them follow the output: leave out its 'of'");
            error.mistake = "sizes in a circle";
        }
    }
}

}  // namespace

void checkNames(const Description& description, Report& report)
{
    checkSizeCycles(description, report);
    checkCollisions(description, report);
}

}  // namespace crevice::table
