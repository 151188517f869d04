// SPDX-License-Identifier: MIT
// Decoding, the names that nothing uses: a typo makes one, and it must not pass in silence.
// Malformed configs: one mistake gives one error, at its place, with a way out.
// Modules that take the place of others, and what is left out with those.
#include <crevice/config.h>
#include <crevice/shipped.h>

#include "tests/core/config/decode_fixture.h"
#include "tests/core/config/load_fixture.h"
#include "tests/support/bad_corpus.h"
#include "tests/support/need.h"
#include "tests/support/plan_rig.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace {

// The fixture's sources, and a config that uses all it declares.
MemorySources sources()
{
    MemorySources all = glslSources();
    all.add("configs/base.json", configText({{"name", "\"base\""}}));
    return all;
}

Diagnostics unusedIn(const std::string& members, const LoadRequest& extra = {})
{
    MemorySources all = sources();
    all.add("configs/mine.json",
            R"({"format": 1, "name": "mine", "extends": ["base"], )" + members + "}");
    LoadRequest request = extra;
    request.config = "mine";
    return need(decode(need(loadConfig(all, request)), all)).unused;
}

/// What they are about.
std::string namesIn(const Diagnostics& all)
{
    std::string names;
    for (const Diagnostic& each : all)
        names += (names.empty() ? "" : " ") + each.pointer.substr(each.pointer.rfind('/') + 1);
    return names;
}

/// A drawn and a host's geometry, a filter, what needs the scene, and a config of them.
MemorySources sceneCatalog()
{
    MemorySources sources;
    sources.add("geometry/drawn.json", file(R"("needs": ["scene"],
                        "imports": {"camera": {"type": "camera"}, "scene": {"type": "draw_list"}},
                        "params": {"band": {"default": 1, "min": 1, "max": 2}},
                        "targets": {"depth": {"format": ["depth24"]}, "albedo": {"format": ["rgba8"]}},
                        "interfaces": {"surface": "drawn.glsl"},
                        "passes": {"geometry": {"type": "draw", "shader": "geometry"}})"));
    sources.add("geometry/host.json", file(R"("needs": ["host"], "replaces": ["scene", "host"],
                        "imports": {"camera": {"type": "camera"}, "depth": {"type": "texture"}},
                        "interfaces": {"surface": "host.glsl"})"));
    sources.add("geometry/host_normal.json", file(R"("extends": ["geometry/host"],
                        "needs": ["host"], "replaces": ["scene", "host"],
                        "imports": {"normal": {"type": "texture"}})"));
    sources.add("light.json", file(R"("needs": ["scene"], "params": {"ambient": {"default": 1}},
                        "features": {"lit": {"default": true}}, "outputs": {"color": "color"})"));
    sources.add("ssao.json", file(R"("params": {"radius": {"default": 1}, "steps": {"default": 4}},
                        "passes": {"ssao": {"shader": "ssao"}}, "outputs": {"ao": "ao"})"));
    sources.add("configs/plain.json",
                file(R"("extends": ["geometry/drawn", "ssao", "light"], "name": "plain",
                        "params": {"band": 1.2, "steps": 8, "ambient": 0.5},
                        "features": {"level": {"type": "enum", "values": ["low", "high"],
                            "sets": {"low": {"band": 1, "steps": 2, "lit": false}}}},
                        "passes": {"geometry": {"frustum_scale": "band"}},
                        "variants": {"bare": {"params": {"band": 1, "radius": 2}}})"));
    return sources;
}

MemorySources with(const std::string& members)
{
    MemorySources sources = sceneCatalog();
    sources.add("configs/mine.json", file(members));
    return sources;
}

Node mine(const std::string& members, const std::string& variant = "",
          const std::vector<std::string>& overrides = {})
{
    return loaded(with(members), {"mine", variant, overrides});
}

const char* const kOnHost = R"("extends": ["plain", "geometry/host"])";

}  // namespace

TEST_CASE("A param that only a target is made by is used")
{
    const auto with = [](const std::string& target) {
        return namesIn(
            unusedIn(R"("params": {"msaa": {"type": "int", "default": 1, "min": 1, "max": 4},
                                   "share": {"default": 0.5, "min": 0.1, "max": 1}},
                        "targets": {"ao": {)" +
                     target + "}}"));
    };
    CHECK(with(R"("samples": "msaa", "size": {"scale": "share"})").empty());
    CHECK(with(R"("samples": "msaa")") == "share");
    CHECK(with(R"("size": {"scale": "share"})") == "msaa");
}

TEST_CASE("What a deleted pass of another file leaves behind is no mistake")
{
    const Diagnostics unused = unusedIn(
        R"("passes": {"blur": null}, "outputs": {"ao": "ao"}, "params": {"radius": {"default": 1}})");
    INFO(toText(unused));
    CHECK(unused.empty());
}

TEST_CASE("Under a variant an unused name is a warning")
{
    LoadRequest request;
    request.variant = "plain";
    const Diagnostics unused = unusedIn(
        R"("targets": {"more": {"format": "r8"}},
           "passes": {"more": {"shader": "ao", "color": "more"}},
           "variants": {"plain": {"passes": {"more": null}}})",
        request);
    CHECK(onlyWarning(unused, Code::unused_name).message.find("target 'more'") == 0);
}

TEST_CASE("What a module on disk declares and this config does not use is a warning")
{
    const TemporaryFolder folder("unused_of_module");
    folder.write("mine.json", R"({"format": 1, "params": {"spare": {"default": 1}},
                                  "targets": {"more": {"format": "r8"}}})");
    const LoadRequest request{
        folder.write("config.json", R"({"format": 1, "extends": ["base", "./mine.json"]})")};
    const MemorySources all = sources();
    const Diagnostics unused = need(decode(need(loadConfig(all, request)), all)).unused;
    CHECK(namesIn(unused) == "spare more");
    CHECK_FALSE(hasErrors(unused));
}

TEST_CASE("An unused name is reported where nothing else is wrong, since that might be why")
{
    Description description = describe(
        R"({"format": 1, "targets": {"x": {"format": "r8"}},
        "shaders": {"a": {"vertex": "full.vert", "fragment": "a.frag"}},
        "passes": {"a": {"shader": "a", "color": "x"}}, "outputs": {"out": "x"}})",
        {{"full.vert", kFullVertex},
         {"a.frag", "#version 300 es\nlayout(location = 0) out highp float x;\nvoid main() {}\n"}});
    description.unused = {{Code::unused_name, "param 'radius' is used by nothing"}};
    onlyError(tryCompile(description), Code::unused_name);
    description.outputs.clear();
    onlyError(tryCompile(description), Code::no_outputs);
}

TEST_CASE("Every config of the corpus gets one error, with its place and the way out")
{
    for (const CorpusCase& config : corpus().cases()) {
        if (config.options.find("driver")) continue;  // no text shows it: context_gl_test.cpp
        RecordingDevice device(capsOf(config));
        Diagnostics reported = diagnosticsOf(config, device);
        const auto warning = [](const Diagnostic& each) {
            return each.severity != Severity::error;
        };
        eraseIf(reported, warning);
        INFO(config.name);
        checkReported(config, reported);
        CHECK_FALSE(reported[0].help.empty());
        const bool needs_device = config.name.rfind("run_time/", 0) == 0;
        CHECK((needs_device || device.log().empty()));
    }
}

TEST_CASE("A module that replaces a word takes the place of what was named before and needs it")
{
    const Node document = mine(kOnHost);
    CHECK(at(document, "interfaces/surface")->text == "host.glsl");
    CHECK(at(document, "imports/depth"));
    CHECK(at(document, "imports/camera"));
    for (const char* gone :
         {"imports/scene", "targets/albedo", "passes/geometry", "outputs/color"}) {
        INFO(gone);
        CHECK_FALSE(at(document, gone));
    }
    CHECK(at(document, "outputs/ao"));
    for (const char* key : {"needs", "replaces"}) CHECK_FALSE(at(document, key));
}

TEST_CASE("Values for what is left out go with it, in levels and variants too, and others stay")
{
    const Node document = mine(kOnHost, "bare");
    CHECK_FALSE(at(document, "params/band"));
    CHECK_FALSE(at(document, "params/ambient"));
    CHECK(at(document, "params/steps/default")->number == 8);
    CHECK(at(document, "params/radius/default")->number == 2);
    const Node* low = at(document, "features/level/sets/low");
    REQUIRE(low->members.size() == 1);
    CHECK(low->find("steps"));
}

TEST_CASE("A module that extends what replaces its own words takes its place whole")
{
    const Node both = mine(R"("extends": ["plain", "geometry/host_normal"])");
    CHECK(at(both, "imports/normal"));
    CHECK(at(both, "imports/depth"));
    const Node again = mine(R"("extends": ["plain", "geometry/host_normal", "geometry/host"])");
    CHECK(at(again, "imports/depth"));
    REQUIRE(again.deleted.size() == 2);
}

TEST_CASE("An override with a plus adds a module at the end of what the config extends")
{
    const Node document = loaded(sceneCatalog(), {"plain", "", {"+geometry/host", "radius=3"}});
    CHECK(at(document, "name")->text == "plain");
    CHECK(document.place.source->name == "configs/plain.json");
    CHECK_FALSE(at(document, "passes/geometry"));
    CHECK(at(document, "params/radius/default")->number == 3);

    const Diagnostic missing = failure(sceneCatalog(), {"plain", "", {"+geometry/hots"}});
    CHECK(missing.code == Code::module_missing);
    CHECK_THAT(missing.help, Catch::Contains("did you mean 'geometry/host'"));
    CHECK(missing.place.source->name == "--set +geometry/hots");
    CHECK(failure(sceneCatalog(), {"plain", "", {"+"}}).code == Code::override_syntax);
    const Diagnostic gone = failure(sceneCatalog(), {"plain", "", {"+geometry/host", "band=1.5"}});
    CHECK(gone.code == Code::unknown_param);
}

TEST_CASE("A module named behind the config is laid over it, as if by an override")
{
    const MemorySources sources = sceneCatalog();
    const Node named = loaded(sources, {"plain+geometry/host_normal+ssao"});
    const Node laid = loaded(sources, {"plain", "", {"+geometry/host_normal", "+ssao"}});
    CHECK(toJson(named) == toJson(laid));
    CHECK(at(named, "imports/normal"));
    CHECK(at(named, "name")->text == "plain");

    TemporaryFolder folder("a+b");
    const std::string file_name = folder.write("mine.json", file(R"("extends": ["plain"])"));
    CHECK(at(loaded(sources, {file_name}), "imports/scene"));
    CHECK(at(loaded(sources, {file_name + "+geometry/host"}), "imports/depth"));
    CHECK(variantNames(sources, {"plain+geometry/host"}) == std::vector<std::string>{"bare"});
}

TEST_CASE("A swap changes the module and leaves out with a warning what was set for the old one")
{
    const Node document =
        need(loadConfig(shippedSources(), {"thesis", "", {"ssao/hemisphere=ssao/gtao"}}));
    CHECK(at(document, "shaders/ssao/fragment")->text == "ssao/shaders/march.frag");
    const Description description = need(decode(document, shippedSources()));
    std::vector<std::string> elided;
    for (const Diagnostic& each : description.unused) {
        CHECK(each.severity == Severity::warning);
        // thesis sets which generator makes rotation_noise, which gtao does not read
        const bool unused = each.pointer == "/generated/rotation_noise";
        CHECK(each.code == (unused ? Code::unused_name : Code::unknown_param));
        elided.push_back(each.pointer);
    }
    CHECK(elided == std::vector<std::string>{"/features/guards", "/features/basis",
                                             "/features/range_check", "/params/bias_length",
                                             "/params/samples", "/generated/kernel",
                                             "/generated/rotation_noise"});
    CHECK_FALSE(findNamed(description.params, "samples"));
}
