// SPDX-License-Identifier: MIT
// Merge patches: the cases of RFC 7396 that we keep, those that we refuse, and origins.
// Variants and overrides: what is laid over a loaded config.
#include "core/json/merge.h"

#include "tests/core/config/load_fixture.h"

using namespace crevice;

namespace {

Node valueOf(const std::string& text, const std::string& name = "text.json")
{
    return need(parseValue(std::make_shared<SourceText>(SourceText{name, text})));
}

struct Case {
    const char* base;
    const char* patch;
    const char* result;
};

struct Merged {
    Node node;
    Diagnostics errors;
};

Merged merged(const std::string& base, const std::string& patch)
{
    Merged result{valueOf(base, "base.json"), {}};
    mergePatch(result.node, valueOf(patch, "patch.json"), result.errors);
    return result;
}

Node overridden(const std::string& text) { return loaded(smallCatalog(), {"base", {}, {text}}); }

}  // namespace

TEST_CASE("merging follows RFC 7396 where a patch makes sense")
{
    const Case kCases[] = {
        {R"({"a": "b"})", R"({"a": "c"})", R"({"a": "c"})"},
        {R"({"a": "b"})", R"({"b": "c"})", R"({"a": "b", "b": "c"})"},
        {R"({"a": "b"})", R"({"a": null})", R"({})"},
        {R"({"a": "b", "b": "c"})", R"({"a": null})", R"({"b": "c"})"},
        {R"({"a": ["b"]})", R"({"a": "c"})", R"({"a": "c"})"},
        {R"({"a": "c"})", R"({"a": ["b"]})", R"({"a": ["b"]})"},
        {R"({"a": {"b": "c"}})", R"({"a": {"b": "d"}})", R"({"a": {"b": "d"}})"},
        {R"({"a": [1, 2, 3]})", R"({"a": [4]})", R"({"a": [4]})"},
        {R"({"a": null})", R"({"b": 1})", R"({"a": null, "b": 1})"},
        {R"({"a": 1})", R"({"a": true})", R"({"a": true})"},
        {R"({})", R"({"a": {"b": {"c": [null]}}})", R"({"a": {"b": {"c": [null]}}})"},
        {R"({"a": 1})", R"({})", R"({"a": 1})"},
        {R"({"x-a": {"b": 1}})", R"({"x-a": {"c": 2}})", R"({"x-a": {"b": 1, "c": 2}})"},
    };
    for (const Case& one : kCases) {
        INFO(one.base << " with " << one.patch);
        const Merged result = merged(one.base, one.patch);
        CHECK(result.errors.empty());
        CHECK(brief(result.node) == one.result);
    }
}

TEST_CASE("a replaced value remembers each place that set it, oldest first")
{
    Node base = valueOf(R"({"a": {"b": 1}})", "one.json");
    Diagnostics errors;
    mergePatch(base, valueOf(R"({"a": {"b": 2}})", "two.json"), errors);
    mergePatch(base, valueOf("{\"a\":\n{\"b\": 3}}", "three.json"), errors);
    CHECK(errors.empty());
    const Node& value = *base.find("a")->find("b");
    CHECK(value.number == 3);
    CHECK(placeName(value.place) == "three.json:2:7");
    REQUIRE(value.origins.size() == 2);
    CHECK(placeName(value.origins[0]) == "one.json:1:13");
    CHECK(placeName(value.origins[1]) == "two.json:1:13");
    CHECK(placeName(base.find("a")->place) == "one.json:1:7");
    CHECK(base.find("a")->origins.empty());
}

TEST_CASE("an object has at most 1024 members, also when files are merged")
{
    const auto text = [](std::size_t count, const char* prefix) {
        std::string members = "\"k\": 0";
        for (std::size_t i = 1; i < count; ++i)
            members += std::string(",\"") + prefix + std::to_string(i) + "\":0";
        return "{" + members + "}";
    };
    CHECK(merged("{}", text(kMaxMembers, "a")).node.members.size() == kMaxMembers);
    CHECK(merged(text(kMaxMembers, "a"), text(2, "b")).errors.at(0).code == Code::too_many_members);
    const auto source = std::make_shared<SourceText>(SourceText{"m.json", text(1025, "a")});
    onlyError(parseDocument(source), Code::too_many_members);
}

TEST_CASE("the patch between two documents is the smallest that makes one of the other")
{
    const Case kCases[] = {
        {R"({"a": 1, "b": {"c": 2}})", "{}", R"({"b": {"c": 2.0}, "a": 1})"},
        {R"({"a": 1, "b": {"c": 2, "d": 3}})", R"({"b":{"d":4}})",
         R"({"a": 1, "b": {"c": 2, "d": 4}})"},
        {R"({"a": {"b": 1}, "c": 1})", R"({"a":{"b":null},"c":null})", R"({"a": {}})"},
        {R"({"a": [1, 2]})", R"({"a":[1,3],"b":{"c":true}})", R"({"a": [1, 3], "b": {"c": true}})"},
        {R"({"a": "x"})", R"({"a":"y"})", R"({"a": "y"})"},
        {R"({"a": true})", R"({"a":false})", R"({"a": false})"},
    };
    for (const Case& one : kCases) {
        INFO(one.base << " to " << one.result);
        const Node patch = patchBetween(valueOf(one.base), valueOf(one.result));
        CHECK(toJson(patch) == toJson(valueOf(one.patch)));
        Node again = valueOf(one.base);
        Diagnostics errors;
        mergePatch(again, patch, errors);
        CHECK(errors.empty());
        CHECK(patchBetween(again, valueOf(one.result)).members.empty());
    }
}

TEST_CASE("a variant of an extended config may be chosen, and is extended by one of the same name")
{
    const Node base = loaded(smallCatalog(), {"base", "fast"});
    CHECK(at(base, "params/samples/default")->number == 8);
    CHECK(at(base, "params/radius/default")->number == 0.5);
    const Node fine = loaded(smallCatalog(), {"fine", "fast"});
    CHECK(at(fine, "params/samples/default")->number == 8);
    CHECK(at(fine, "params/radius/default")->number == 0.1);
    CHECK(at(fine, "params/samples/default")->origins.size() == 2);
}

TEST_CASE("an override by name sets the default of a param or feature")
{
    const Node document = overridden("radius=0.8");
    const Node* radius = at(document, "params/radius/default");
    CHECK(radius->number == 0.8);
    CHECK(placeName(radius->place) == "--set radius=0.8:1:8");
    CHECK(radius->place.length == 3);
    CHECK(radius->place.source->text == "radius=0.8");
    CHECK(radius->origins.size() == 1);
    CHECK(at(document, "params/radius/min")->number == 0);
    CHECK(at(overridden("half=true"), "features/half/default")->boolean);
    CHECK(at(overridden("half=soft"), "features/half/default")->text == "soft");
    CHECK(at(overridden("radius= [1, 2]"), "params/radius/default")->items.size() == 2);
    CHECK(at(overridden("half=a=b"), "features/half/default")->text == "a=b");
}

TEST_CASE("an override by pointer sets, makes and deletes")
{
    CHECK_FALSE(at(overridden("/passes/ssao/when=null"), "passes/ssao/when"));
    CHECK(at(overridden("/passes/ssao/x-a/x-b={\"c\": 1}"), "passes/ssao/x-a/x-b/c")->number == 1);
    CHECK(overridden("/x-a~1b~0c=1").find("x-a/b~c"));
    CHECK(overridden("/=1").find(""));
    CHECK(overridden("/x~=1").find("x~"));
}
