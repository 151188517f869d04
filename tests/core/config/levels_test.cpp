// SPDX-License-Identifier: MIT
// Features whose words set params and other features: levels of quality.
// "radius": 0.8 for {"radius": {"default": 0.8}}: what it sets, where errors point, and when it may
// not stand.
#include "core/config/values.h"
#include "tests/core/config/decode_fixture.h"
#include "tests/core/config/load_fixture.h"
#include "tests/support/need.h"

#include <cmath>

using namespace crevice;

namespace {

const char* const kBase = R"({"format": 1,
    "params": {"taps": {"type": "int", "default": 4, "min": 1, "max": 64},
               "scale": {"default": 1, "min": 0.25, "max": 1},
               "tint": {"type": "vec2", "default": [1, 2]}},
    "features": {"layers": {"default": true}, "look": {"type": "enum", "values": ["flat", "lit"]}}})";

std::string quality(const std::string& sets, const std::string& initial = "low")
{
    return R"("features": {"quality": {"type": "enum", "values": ["low", "mid", "high"],
        "default": ")" +
           initial + "\", \"sets\": " + sets + "}}";
}

const std::string kLevels =
    quality(R"({"low": {"taps": 2, "layers": false}, "high": {"taps": 16, "look": "lit"}})");

Result<Description> extended(const std::string& members,
                             const std::vector<std::string>& overrides = {})
{
    MemorySources sources;
    sources.add("base.json", kBase);
    sources.add("levels.json", file("\"extends\": [\"base\"], " + kLevels));
    sources.add("configs/mine.json", file(members));
    const Result<Node> document = loadConfig(sources, {"mine", "", overrides});
    if (!document) return document.diagnostics();
    return decode(*document, sources);
}

Result<Description> withLevels(const std::string& sets)
{
    return extended("\"extends\": [\"base\"], " + quality(sets));
}

float paramOf(const Description& d, const char* name)
{
    return findNamed(d.params, name)->value[0];
}
int featureOf(const Description& d, const char* name) { return findNamed(d.features, name)->value; }

/// "CV4003 /features/..." of all.
std::string found(const Result<Description>& result)
{
    const Diagnostics& all = result ? result->unused : result.diagnostics();
    std::string text;
    for (const Diagnostic& each : all)
        text += (text.empty() ? "" : ", ") + codeName(each.code) + " " + each.pointer;
    return text;
}

const std::string kSets = "/features/quality/sets/";

const char* const kLongForm = R"({"format": 1,
    "params": {"radius": {"default": 0.5, "min": 0, "max": 10, "unit": "scene units"},
               "tint": {"type": "vec2", "default": [1, 2]}},
    "features": {"fast": {}, "look": {"type": "enum", "values": ["flat", "lit"]}},
    "passes": {"blur": {"inputs": {"ao": {"filter": "linear"}}}}})";

/// A config that extends kLongForm, with its own members and an override.
Result<Description> shortened(const std::string& members,
                              const std::vector<std::string>& overrides = {},
                              const std::string& variant = "")
{
    MemorySources sources;
    sources.add("base.json", kLongForm);
    sources.add("configs/mine.json", "{\"format\": 1, \"extends\": [\"base\"],\n" + members + "}");
    const Result<Node> document = loadConfig(sources, {"mine", variant, overrides});
    if (!document) return document.diagnostics();
    Node tunables;  // decoded without the pass, which has no shader
    tunables.kind = Node::Kind::object;
    tunables.place = document->place;
    tunables.origins = document->origins;
    for (const Member& member : document->members)
        if (member.key != "passes") tunables.members.push_back(member);
    return decode(tunables, sources);
}

}  // namespace

TEST_CASE("The initial word of a feature sets params and features", "[decode]")
{
    const Description low = need(extended(R"("extends": ["levels"])"));
    CHECK(paramOf(low, "taps") == 2);
    CHECK(featureOf(low, "layers") == 0);
    CHECK(featureOf(low, "look") == 0);
    const Description high =
        need(extended(R"("extends": ["levels"], "features": {"quality": "high"})"));
    CHECK(paramOf(high, "taps") == 16);
    CHECK(featureOf(high, "look") == 1);
    CHECK(paramOf(need(extended(R"("extends": ["levels"])", {"quality=high"})), "taps") == 16);
}

TEST_CASE("What one word sets has its default at the others, also at those that set nothing",
          "[decode]")
{
    const Description mid = need(extended(R"("extends": ["levels"])", {"quality=mid"}));
    CHECK(paramOf(mid, "taps") == 4);
    CHECK(featureOf(mid, "layers") == 1);
    const FeatureDesc& feature = *findNamed(mid.features, "quality");
    REQUIRE(feature.sets.size() == 3);
    for (const FeatureDesc::Level& level : feature.sets) CHECK(level.settings.size() == 3);
}

TEST_CASE("A later file changes a level value by value, and a vector is set as a list", "[decode]")
{
    const Description d = need(extended(R"("extends": ["levels"], "features": {"quality": {
        "sets": {"low": {"scale": 0.5, "tint": [3, 4]}}}})"));
    CHECK(paramOf(d, "taps") == 2);
    CHECK(paramOf(d, "scale") == 0.5f);
    CHECK(findNamed(d.params, "tint")->value[1] == 4);
}

TEST_CASE("An override of a param or feature stands over all levels", "[decode]")
{
    Description d = need(extended(R"("extends": ["levels"])", {"taps=7", "layers=true"}));
    CHECK(paramOf(d, "taps") == 7);
    CHECK(featureOf(d, "layers") == 1);
    for (const FeatureDesc::Level& level : findNamed(d.features, "quality")->sets)
        CHECK(findNamed(level.settings, "taps")->value[0] == 7);
    d = need(extended(R"("extends": ["levels"])", {"taps=7", kSets + "low/taps=9"}));
    CHECK(paramOf(d, "taps") == 9);
}

TEST_CASE("A level's names and values are checked as those of params and features are", "[decode]")
{
    CHECK(found(withLevels(R"({"lov": {"taps": 2}})")) == "CV2106 " + kSets + "lov");
    CHECK(found(withLevels(R"({"low": {"tabs": 2}})")) == "CV4004 " + kSets + "low/tabs");
    CHECK(found(withLevels(R"({"low": {"taps": 65}})")) == "CV4001 " + kSets + "low/taps");
    CHECK(found(withLevels(R"({"low": {"taps": 2.5}})")) == "CV3002 " + kSets + "low/taps");
    CHECK(found(withLevels(R"({"low": {"taps": true}})")) == "CV3002 " + kSets + "low/taps");
    CHECK(found(withLevels(R"({"low": {"tint": 1}})")) == "CV3002 " + kSets + "low/tint");
    CHECK(found(withLevels(R"({"low": {"layers": 1}})")) == "CV3002 " + kSets + "low/layers");
    CHECK(found(withLevels(R"({"low": {"look": "lid"}})")) == "CV3005 " + kSets + "low/look");
    CHECK(found(withLevels(R"({"low": {"quality": "mid"}})")) == "CV2204 " + kSets + "low/quality");
    CHECK(found(withLevels(R"({"low": 3})")) == "CV3002 " + kSets + "low");
    const Diagnostic near = withLevels(R"({"low": {"tabs": 2}})").diagnostics().front();
    CHECK(near.help.find("did you mean 'taps'?") != std::string::npos);
}

TEST_CASE("Two features may not set the same value", "[decode]")
{
    const Result<Description> both = extended(R"("extends": ["levels"], "features": {
        "speed": {"sets": {"true": {"taps": 1}}}})");
    CHECK(found(both) == "CV2107 /features/speed/sets/true/taps");
}

TEST_CASE("A bare value sets the default of what a module declares and leaves the rest", "[decode]")
{
    const Description d = need(shortened(
        R"("params": {"radius": 0.8, "tint": [3, 4]}, "features": {"fast": true, "look": "lit"})"));
    CHECK(d.params.at(0).value[0] == 0.8f);
    CHECK(d.params.at(0).max == 10);
    CHECK(d.params.at(0).unit == "scene units");
    CHECK(d.params.at(1).value[1] == 4.0f);
    CHECK(d.features.at(0).value == 1);
    CHECK(d.features.at(1).value == 1);
}

TEST_CASE("Variants, overrides and long forms go over a bare value, and it over them", "[decode]")
{
    const std::string mine = R"("params": {"radius": 0.8},
        "variants": {"wide": {"params": {"radius": 5}},
                     "long": {"params": {"radius": {"default": 6, "max": 7}}}})";
    const auto radius = [&](const std::vector<std::string>& overrides, const std::string& variant) {
        return need(shortened(mine, overrides, variant)).params.at(0).value[0];
    };
    CHECK(radius({}, "") == 0.8f);
    CHECK(radius({}, "wide") == 5.0f);
    CHECK(radius({}, "long") == 6.0f);
    CHECK(radius({"radius=2"}, "wide") == 2.0f);
    CHECK(radius({"/params/radius=3"}, "") == 3.0f);
    CHECK(radius({"/params/radius/default=4"}, "") == 4.0f);
}

TEST_CASE("An error in a bare value points at it", "[decode]")
{
    const Diagnostic range =
        onlyError(shortened(R"("params": {"radius": 11})"), Code::out_of_range);
    CHECK(range.pointer == "/params/radius/default");
    CHECK((range.place.line == 2 && range.place.column == 22));
    REQUIRE(range.notes.size() == 1);  // where the base sets it
    for (const char* text : {R"("params": {"radius": "wide"})", R"("params": {"tint": 1})",
                             R"("features": {"fast": 1})"})
        onlyError(shortened(text), Code::wrong_type);
    onlyError(shortened(R"("features": {"look": "lid"})"), Code::bad_enum);
}

TEST_CASE("A param takes its own bounds, though no float is 0.01")
{
    ParamDesc power;
    power.name = "power";
    power.min = 0.01;
    power.max = 0.7;
    REQUIRE(double{0.01f} < power.min);
    const auto takes = [&power](float value) { return checkValue(power, &value, 1).ok(); };
    CHECK(takes(0.01f));
    CHECK(takes(0.7f));
    CHECK_FALSE(takes(std::nextafter(0.01f, 0.0f)));
    CHECK_FALSE(takes(std::nextafter(0.7f, 1.0f)));
}

TEST_CASE("A length is in scene units, a share of the scene or pixels of the view, as they are")
{
    ParamDesc radius;
    radius.name = "radius";
    radius.max = 100;
    radius.semantic = ParamSemantic::length;
    SceneTraits traits;
    traits.scale = {20, 8};
    traits.camera.zoom = 2;
    const auto length = [&](const char* text) {
        return takeLength(text, radius.value) ? sceneUnits(radius, traits, 400)[0] : -1;
    };
    CHECK(length("5%") == 1);
    CHECK(length("40px") == 40 * 8 / 400.0f);
    CHECK(length("0%") == 0);
    CHECK(length("1000%") == 100);  // as far as it may be
    radius.value = {0, 5, 0, 8};    // at most 8 % of the view's height, which is 8 there
    CHECK(sceneUnits(radius, traits, 400)[0] == 0.64f);
    traits.orthographic = true;
    CHECK(length("40px") == 40 / 400.0f);
    for (const char* wrong : {"", "%", "abc%", "-5%", "nan%", "5em", "5 %", "5", "1e99px"})
        CHECK(length(wrong) == -1);
    traits = SceneTraits();
    CHECK(std::isnan(length("5%")));
    CHECK(std::isnan(length("40px")));
}
