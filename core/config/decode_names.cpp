// SPDX-License-Identifier: MIT
// Declared names against each other: collisions, numbers taken from params, sizes that follow.
#include "core/config/decode_steps.h"

#include "core/frame/frame_values.h"
#include "core/sampling/generators.h"

#include <algorithm>
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

void reportSizeCycle(std::vector<const TargetDesc*> cycle, Report& report)
{
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    const TargetDesc& first = *cycle[0];
    Diagnostic& error = report.at(first.size.of, Code::cycle,
                                  "target '" + first.name + "' follows the size of '" +
                                      first.size.of.name + "', which leads back to it",
                                  "let one of them follow the output: leave out its 'of'");
    for (std::size_t i = 1; i < cycle.size(); ++i)
        error.notes.push_back({cycle[i]->size.of.place, "'" + cycle[i]->name + "' follows '" +
                                                            cycle[i]->size.of.name + "'"});
}

// Walks along `size.of` from each target that no walk has come by, until one is met again.
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
            const Reference& of = at->size.of;
            const auto next = of.pointer.empty() ? named.end() : named.find(of.name);
            at = next == named.end() ? nullptr : next->second;
        }
        const auto again = std::find(chain.begin(), chain.end(), at);
        if (again != chain.end()) reportSizeCycle({again, chain.end()}, report);
    }
}

// A default that was fine until a later file moved a bound over it: the bound is the mistake.
void blameBound(const Node& document, const ParamDesc& param, Report& report)
{
    Diagnostic* error = report.firstWithin(param.pointer + "/default");
    if (!error || error->code != Code::out_of_range) return;
    const Node& value = *locate(document, error->pointer).node;
    const Node& whole = *locate(document, param.pointer + "/default").node;
    const std::string key = value.number < param.min ? "min" : "max";
    const Node* bound = locate(document, param.pointer + "/" + key).node;
    if (!bound || bound->origins.size() <= whole.origins.size()) return;
    error->code = Code::bad_range;
    error->pointer = param.pointer + "/" + key;
    error->help = "change the default as well, or write " + value.text;
    blame(*error, bound->place, "the default is here");
}

}  // namespace

void checkNames(const Node& document, const Description& description, Report& report)
{
    for (const ParamDesc& each : description.params) blameBound(document, each, report);
    checkTakers(document, description, report);
    checkSizeCycles(description, report);
    checkCollisions(description, report);
}

}  // namespace crevice::table
