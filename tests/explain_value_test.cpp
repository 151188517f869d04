// SPDX-License-Identifier: MIT
// Finding a value by pointer, path or bare name, and telling who set it.
#include "tests/catch.h"

#include "core/merge.h"
#include "tools/explain_value.h"

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
    mergePatch(document, parsed("patch.json", "{ \"params\":\n{ \"radius\": { \"default\": 0.25 } } }"),
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

TEST_CASE("what is not there is told with the keys that are")
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
