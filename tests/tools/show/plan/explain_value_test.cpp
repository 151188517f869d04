// SPDX-License-Identifier: MIT
// Finding a value by pointer, path or bare name, and telling who set it.
#include "tests/support/catch.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

#include "core/json/merge.h"
#include "core/json/override.h"
#include "tests/support/need.h"
#include "tools/show/plan/explain_value.h"
#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

Node parsed(const char* name, const char* text)
{
    auto node = parseDocument(std::make_shared<SourceText>(SourceText{name, text}));
    REQUIRE(node);
    return *node;
}

/// base.json with patch.json over it: the radius was set in both.
Node mergedDocument()
{
    Node document = parsed("base.json", R"({
  "params": { "radius": { "default": 1.5 } },
  "features": { "fade": { "default": "hard" } },
  "extends": ["a", "b"],
  "a/b": { "~": 7 }
})");
    Diagnostics diagnostics;
    mergePatch(document,
               parsed("patch.json", "{ \"params\":\n{ \"radius\": { \"default\": 0.25 } } }"),
               diagnostics);
    REQUIRE(diagnostics.empty());
    return document;
}

}  // namespace

TEST_CASE("a value is found by its pointer, by a dotted path and, for a default, by its bare name")
{
    const Node document = mergedDocument();
    for (const char* path : {"/params/radius/default", "params.radius.default", "radius"}) {
        INFO(path);
        const auto value = findValue(document, path);
        REQUIRE(value);
        CHECK(value->pointer == "/params/radius/default");
        CHECK(value->node->number == 0.25);
    }
    const auto feature = findValue(document, "fade");
    REQUIRE(feature);
    CHECK(feature->pointer == "/features/fade/default");
}

TEST_CASE("the bare name of what a level sets is its value at the initial level, else the default")
{
    const Node document = need(parseDocument(std::make_shared<const SourceText>(SourceText{
        "levels.json",
        R"({"params": {"steps": {"default": 8}, "radius": {"default": 1}}, "features": {"quality":
            {"values": ["low", "high"], "sets": {"low": {"steps": 4}, "high": {"steps": 16}}}}})"})));
    CHECK(need(findValue(document, "steps")).node->number == 4);
    CHECK(need(findValue(document, "radius")).node->number == 1);
    Node high = document;
    REQUIRE(applyOverride(high, "quality=high").ok());
    CHECK(need(findValue(high, "steps")).pointer == "/features/quality/sets/high/steps");
    REQUIRE(applyOverride(high, "steps=9").ok());  // stands over all levels
    CHECK(need(findValue(high, "steps")).node->number == 9);
    const auto misspelt = findValue(document, "stepz");
    CHECK(misspelt.diagnostics().at(0).help.find("'steps'") != std::string::npos);
}

TEST_CASE("a default that the initial level overrules is told with the places that set it")
{
    Node document = need(parseDocument(std::make_shared<const SourceText>(
        SourceText{"levels.json",
                   "{\"features\": {\"quality\": {\"values\": [\"low\"],\n"
                   "\"sets\": {\"low\": {\"steps\": 4}}}}}"})));
    const auto withDefault = [&](const char* text) {
        Node own = document;
        Diagnostics diagnostics;
        mergePatch(own, parsed("mine.json", text), diagnostics);
        return own;
    };
    const Node mine = withDefault(R"({"params": {"steps": {"default": 8}}})");
    CHECK(explainText(need(findValue(mine, "steps"))) ==
          "/features/quality/sets/low/steps is 4\n"
          "  set by levels.json:2:27: 4\n"
          "and not /params/steps/default is 8\n"
          "  set by mine.json:1:34: 8\n");
    const std::string json = explainJson(need(findValue(mine, "steps")));
    CHECK(json.find("\"overruled\"") != std::string::npos);
    const Node same = withDefault(R"({"params": {"steps": {"default": 4}}})");
    for (const FoundValue& value :
         {need(findValue(same, "steps")), need(findValue(mine, "params.steps.default"))}) {
        CHECK(explainText(value).find("and not") == std::string::npos);
        CHECK(explainJson(value).find("overruled") == std::string::npos);
    }
}

TEST_CASE("pointers reach into arrays and escape slashes and tildes")
{
    const Node document = mergedDocument();
    const auto entry = findValue(document, "/extends/1");
    REQUIRE(entry);
    CHECK(entry->node->text == "b");
    const auto escaped = findValue(document, "/a~1b/~0");
    REQUIRE(escaped);
    CHECK(escaped->node->number == 7.0);
    CHECK(escaped->pointer == "/a~1b/~0");
}

TEST_CASE("what is not there is reported with the keys that are")
{
    const Node document = mergedDocument();
    for (const char* path : {"/extends/2", "/extends/-1", "/params/radius/default/x", "", "/"}) {
        INFO(path);
        CHECK_FALSE(findValue(document, path));
    }
    const auto wrong = findValue(document, "params.radus");
    REQUIRE_FALSE(wrong);
    CHECK(wrong.diagnostics().front().code == Code::reference_missing);
    CHECK(wrong.diagnostics().front().pointer == "/params");
    CHECK(wrong.diagnostics().front().help.find("did you mean 'radius'") != std::string::npos);
}

TEST_CASE("a bare name of neither a param nor a feature leads to what has that name")
{
    const Node document = parsed("base.json", R"({
  "imports": { "velocity": { "type": "texture" } },
  "passes": { "ssao": {} }, "shaders": { "ssao": {} } })");
    const auto helpFor = [&](const char* name) {
        return findValue(document, name).diagnostics().at(0).help;
    };
    CHECK(helpFor("velocity") == "did you mean 'imports.velocity'?");
    CHECK(helpFor("ssao") == "did you mean 'passes.ssao' or 'shaders.ssao'?");
    CHECK(helpFor("passes.velocity").find("imports") == std::string::npos);
}

TEST_CASE("the places that set a value come newest first, each with its text")
{
    const Node document = mergedDocument();
    const auto value = findValue(document, "radius");
    REQUIRE(value);
    CHECK(explainText(*value) ==
          "/params/radius/default is 0.25\n"
          "  set by patch.json:2:26: 0.25\n"
          "  before that by base.json:2:38: 1.5\n");
    const std::string json = explainJson(*value);
    CHECK(json.find("\"patch.json\"") < json.find("\"base.json\""));
}

TEST_CASE("an unmatched key explains to the one place that set it")
{
    const Node document = mergedDocument();
    const auto value = findValue(document, "fade");
    REQUIRE(value);
    CHECK(explainText(*value).find("before that") == std::string::npos);
}

TEST_CASE("an object explains to every value in it, each with its places")
{
    const Node document = mergedDocument();
    const auto value = findValue(document, "params");
    REQUIRE(value);
    CHECK(explainText(*value) == explainText(*findValue(document, "radius")));
    CHECK(explainJson(*value).find("\"members\"") != std::string::npos);
}

TEST_CASE("a key that no file sets has the format's default, where there is something to have it")
{
    const Node document = parsed("base.json", R"({
  "params": { "radius": { "default": 1.5 } },
  "passes": { "ssao": { "shader": "ssao", "inputs": { "depth": "far" } } } })");
    const auto cull = findUnset(document, "passes.ssao.state.cull", nullptr);
    REQUIRE(cull);
    CHECK(cull->pointer == "/passes/ssao/state/cull");
    CHECK(cull->value == "\"none\"");
    CHECK(explainText(*cull) ==
          "/passes/ssao/state/cull is \"none\"\n"
          "  by default, since no file sets it: Which faces of triangles are culled.\n");
    CHECK(findUnset(document, "/passes/ssao/inputs/depth/filter", nullptr)->value == "\"nearest\"");
    CHECK(findUnset(document, "params.radius.bind", nullptr)->value == "\"uniform\"");
    const auto label = findUnset(document, "params.radius.label", nullptr);
    REQUIRE(label);
    CHECK(label->value.empty());
    CHECK(explainText(*label).find("has no value") != std::string::npos);
    for (const char* path : {"passes.blur.state.cull", "passes.ssao.state.cul", "params.bias",
                             "passes.ssao.inputs.normal", "colour", "params.radius.default.x"}) {
        INFO(path);
        CHECK_FALSE(findUnset(document, path, nullptr));
    }
}

TEST_CASE("what a patch deleted is reported with the place that deleted it")
{
    Node document = parsed("base.json", R"({
  "passes": { "ssao": { "state": { "cull": "back" } }, "blur": {} } })");
    Diagnostics diagnostics;
    mergePatch(document, parsed("patch.json", R"({
  "passes": { "ssao": { "state": { "cull": null } }, "blur": null } })"),
               diagnostics);
    REQUIRE(diagnostics.empty());
    CHECK(findUnset(document, "passes.ssao.state.cull", nullptr)->reason ==
          "by default, since patch.json:2:36 deletes it: Which faces of triangles are culled.");
    const auto blur = findValue(document, "passes.blur");
    REQUIRE_FALSE(blur);
    REQUIRE(blur.diagnostics().front().notes.size() == 1);
    CHECK(blur.diagnostics().front().notes.front().place.line == 2);
    CHECK_FALSE(findUnset(document, "passes.blur", nullptr));
}

TEST_CASE("a sampler or uniform that no file mentions binds by its name")
{
    const LoadRequest request = {"sao"};
    const Result<Node> document = loadConfig(shippedSources(), request);
    REQUIRE(document);
    ConfigOptions options;
    options.config = request.config;
    const Result<Plan> plan = planWithoutDevice(options, shippedSources());
    REQUIRE(plan);
    const auto depth = findUnset(*document, "passes.ssao.inputs.depth", &*plan);
    REQUIRE(depth);
    CHECK(depth->pointer == "/passes/ssao/inputs/depth");
    CHECK(depth->value == "target depth");
    CHECK(depth->reason.find("by name") == 0);
    CHECK(depth->reason.find(".glsl:") != std::string::npos);
    CHECK(findUnset(*document, "passes.ssao.inputs.depth.wrap", &*plan)->value == "clamp");
    const auto radius = findUnset(*document, "passes.ssao.uniforms.radius", &*plan);
    REQUIRE(radius);
    CHECK(radius->value == "param radius");
    CHECK(findUnset(*document, "passes.geometry.state.depth_test", &*plan)->value == "less");
    CHECK(findUnset(*document, "passes.ssao.state.depth_test", &*plan)->value == "always");
    CHECK_FALSE(findUnset(*document, "passes.ssao.state.depth", &*plan));
    CHECK_FALSE(findUnset(*document, "passes.ssao.inputs.radius", &*plan));
    CHECK_FALSE(findUnset(*document, "passes.ssao.inputs.nothing", &*plan));
}
