// SPDX-License-Identifier: MIT
// Declared names against each other: collisions, numbers taken from params, sizes that follow.
#include "core/config/decode_steps.h"

#include "core/frame/frame_values.h"
#include "core/sampling/generators.h"

#include <algorithm>
#include <map>
#include <set>

namespace crevice::table {

namespace {

struct Declared {
    const Named* named;
    std::string what;
};

template <class T>
void declare(std::vector<Declared>& declared, const std::vector<T>& list, const char* what)
{
    for (const T& each : list) declared.push_back({&each, what});
}

void reportCollisions(const std::vector<Declared>& declared, const char* who, Report& report)
{
    std::map<std::string, const Declared*> seen;
    for (const Declared& each : declared) {
        const auto [first, fresh] = seen.emplace(each.named->name, &each);
        if (fresh) continue;
        Diagnostic& error = report.at(referenceTo(*each.named), Code::name_collision,
                                      each.what + " '" + each.named->name + "' has the name of " +
                                          first->second->what + ", and " + who + " sees both",
                                      "rename one of them");
        error.notes.push_back({first->second->named->place, first->second->what + " is here"});
    }
}

void checkCollisions(const Description& description, Report& report)
{
    std::vector<Declared> glsl, settable;
    declare(glsl, description.params, "a param");
    declare(glsl, description.targets, "a target");
    declare(glsl, description.generated, "a generated value");
    for (const ImportDesc& each : description.imports)
        if (each.type == ImportType::texture) glsl.push_back({&each, "a texture import"});
    std::vector<Named> histories;
    for (const TargetDesc& each : description.targets)
        if (each.history) histories.push_back({historyName(each), each.place, each.pointer});
    declare(glsl, histories, "a history");
    reportCollisions(glsl, "GLSL", report);

    declare(settable, description.params, "a param");
    declare(settable, description.features, "a feature");
    reportCollisions(settable, "an override", report);

    for (const ParamDesc& each : description.params)
        if (findFrameValue(each.name))
            report.at(referenceTo(each), Code::name_collision,
                      "param '" + each.name + "' has the name of a uniform that each frame feeds",
                      "rename the param");
}

// What takes a number from a param.
struct Taker {
    std::string what;    // "generated 'kernel'"
    std::string number;  // "count"
    const Reference& name;
    bool whole;
    double min;
    double max;
};

// The param must fit and start inside the limits.
void checkTaken(const Node& document, const Description& description, const Taker& taker,
                Report& report)
{
    const std::string& name = taker.name.name;
    const ParamDesc* param = findNamed(description.params, name);
    if (!param || report.errorWithin(param->pointer)) return;
    if (param->type != ParamType::int_ && (taker.whole || param->type != ParamType::float_)) {
        const std::string type = taker.whole ? "int" : "float";
        report.at(taker.name, Code::reference_missing,
                  taker.what + " takes its " + taker.number + " from param '" + name +
                      "', which has another type",
                  "give '" + name + "' the type \"" + type + "\"");
    } else if (!(param->value[0] >= taker.min && param->value[0] <= taker.max)) {
        const Reference value = referenceAt(document, param->pointer + "/default");
        Diagnostic& error =
            report.at(value, Code::out_of_range,
                      name + " default " + value.name + " is outside [" + numberText(taker.min) +
                          ", " + numberText(taker.max) + "], the " + taker.number + "s that " +
                          taker.what + " may have",
                      "stay inside the range, and let '" + name + "' have it as min and max");
        error.notes.push_back({taker.name.place, "the " + taker.number + " is taken from it here"});
    }
}

void checkTakers(const Node& document, const Description& description, Report& report)
{
    for (const GeneratedDesc& each : description.generated)
        checkTaken(document, description,
                   {"generated '" + each.name + "'", "count", each.count_param, true, 1.0,
                    double(mostCount(each.generator))},
                   report);
    for (const TargetDesc& each : description.targets) {
        const std::string what = "target '" + each.name + "'";
        checkTaken(
            document, description,
            {what, "scale", each.size.scale_param, false, smallestScale(each.size), kLargestScale},
            report);
        checkTaken(document, description,
                   {what, "samples", each.samples_param, true, 1.0, double(kMaxSamples)}, report);
    }
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
            report.at(target.size.of, Code::cycle,
                      "target '" + target.name + "' follows the size of '" + target.size.of.name +
                          "', which leads round in a circle",
                      "let one of them follow the output: leave out its 'of'");
            report.sameMistake("sizes in a circle");
        }
    }
}

}  // namespace

void checkNames(const Node& document, const Description& description, Report& report)
{
    checkTakers(document, description, report);
    checkSizeCycles(description, report);
    checkCollisions(description, report);
}

}  // namespace crevice::table
