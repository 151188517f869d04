// SPDX-License-Identifier: MIT
// Finding a value by pointer, path or bare name, and telling who set it.

#include "core/base/text.h"
#include "core/json/merge.h"
#include "tests/support/need.h"
#include "tools/show/plan/print.h"

using namespace crevice;

namespace {

Node parsed(const char* name, const char* text)
{
    return need(parseDocument(std::make_shared<SourceText>(SourceText{name, text})));
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
        const auto value = need(findValue(document, path));
        CHECK(value.pointer == "/params/radius/default");
        CHECK(value.node->number == 0.25);
    }
    CHECK(need(findValue(document, "fade")).pointer == "/features/fade/default");
    CHECK(need(findValue(document, "/extends/1")).node->text == "b");
    CHECK(need(findValue(document, "/a~1b/~0")).pointer == "/a~1b/~0");
}

TEST_CASE("the bare name of what a level sets is its value at the initial level, else the default")
{
    const Node document = parsed(
        "levels.json",
        R"({"params": {"steps": {"default": 8}, "radius": {"default": 1}}, "features": {"quality":
            {"values": ["low", "high"], "sets": {"low": {"steps": 4}, "high": {"steps": 16}}}}})");
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
    const Node document = parsed("levels.json",
                                 "{\"features\": {\"quality\": {\"values\": [\"low\"],\n"
                                 "\"sets\": {\"low\": {\"steps\": 4}}}}}");
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
    CHECK(explainJson(need(findValue(mine, "steps"))).find("overruled") != std::string::npos);
    const Node same = withDefault(R"({"params": {"steps": {"default": 4}}})");
    for (const FoundValue& value :
         {need(findValue(same, "steps")), need(findValue(mine, "params.steps.default"))}) {
        CHECK(explainText(value).find("and not") == std::string::npos);
        CHECK(explainJson(value).find("overruled") == std::string::npos);
    }
}

TEST_CASE("what is not there is reported with the keys that are")
{
    const Node document = mergedDocument();
    for (const char* path : {"/extends/2", "/extends/-1", "/params/radius/default/x", "", "/"}) {
        INFO(path);
        CHECK_FALSE(findValue(document, path));
    }
    const Diagnostic wrong =
        onlyError(findValue(document, "params.radus"), Code::reference_missing);
    CHECK(wrong.pointer == "/params");
    CHECK(wrong.help.find("did you mean 'radius'") != std::string::npos);
}

TEST_CASE("the places that set a value, or one in an object, come newest first with their texts")
{
    const Node document = mergedDocument();
    for (const char* path : {"radius", "params"})
        CHECK(explainText(need(findValue(document, path))) ==
              "/params/radius/default is 0.25\n"
              "  set by patch.json:2:26: 0.25\n"
              "  before that by base.json:2:38: 1.5\n");
    CHECK(has(explainJson(*findValue(document, "params")), "\"members\""));
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
    const auto blur = findValue(document, "passes.blur");
    REQUIRE_FALSE(blur);
    REQUIRE(blur.diagnostics().front().notes.size() == 1);
    CHECK(blur.diagnostics().front().notes.front().place.line == 2);
}
