// SPDX-License-Identifier: MIT
// Merge patches: the cases of RFC 7396 that we keep, those that we refuse, and origins.
#include "core/json/merge.h"

#include "tests/support/catch.h"

using namespace crevice;

namespace {

Node valueOf(const std::string& text, const std::string& name = "text.json")
{
    Result<Node> value = parseValue(std::make_shared<SourceText>(SourceText{name, text}));
    REQUIRE(value);
    return std::move(*value);
}

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

std::string codesOf(const Diagnostics& diagnostics)
{
    std::string codes;
    for (const Diagnostic& d : diagnostics) codes += codeName(d.code) + " " + d.pointer + ";";
    return codes;
}

}  // namespace

TEST_CASE("merging follows RFC 7396 where a patch makes sense")
{
    struct Case {
        const char* base;
        const char* patch;
        const char* result;
    };
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

TEST_CASE("deleting what is not there is an error that lists what is")
{
    const Merged result =
        merged(R"({"passes": {"blur": {}, "light": {}}})", R"({"passes": {"blurr": null}})");
    REQUIRE(codesOf(result.errors) == "CV1101 /passes/blurr;");
    const Diagnostic& error = result.errors.front();
    CHECK(placeName(error.place) == "patch.json:1:13");
    CHECK(error.help == "did you mean 'blur'? keys: blur, light");
    REQUIRE(error.notes.size() == 1);
    CHECK(placeName(error.notes[0].place) == "base.json:1:12");
    CHECK(brief(result.node) == R"({"passes": {"blur": {}, "light": {}}})");
}

TEST_CASE("a null in what is new deletes nothing and is an error")
{
    const Merged result =
        merged(R"({"a": 1})", R"({"b": {"c": null, "d/e": {"f": null}, "g": 2}})");
    CHECK(codesOf(result.errors) == "CV1101 /b/c;CV1101 /b/d~1e/f;");
    CHECK(brief(result.node) == R"({"a": 1, "b": {"d/e": {}, "g": 2}})");
}

TEST_CASE("an object and anything else do not replace each other")
{
    for (const char* other : {"1", "\"x\"", "true", "[1]"}) {
        const std::string text = std::string("{\"k\": ") + other + "}";
        const Merged flat = merged(R"({"k": {"b": 1}})", text);
        CHECK(codesOf(flat.errors) == "CV1102 /k;");
        CHECK(placeName(flat.errors.at(0).place) == "patch.json:1:7");
        CHECK(placeName(flat.errors.at(0).notes.at(0).place) == "base.json:1:7");
        CHECK(brief(flat.node) == R"({"k": {"b": 1}})");
        CHECK(codesOf(merged(text, R"({"k": {"b": 1}})").errors) == "CV1102 /k;");
    }
    CHECK(codesOf(merged("{}", "[]").errors) == "CV1102 ;");
}

TEST_CASE("all errors of a patch are found and its good parts are applied")
{
    const Merged result =
        merged(R"({"a": {"b": 1}, "c": 2})", R"({"a": 5, "x": null, "c": 3, "d": {"y": null}})");
    CHECK(codesOf(result.errors) == "CV1102 /a;CV1101 /x;CV1101 /d/y;");
    CHECK(result.node.find("c")->number == 3);
}

TEST_CASE("a patch of very many keys merges into nothing in little time")
{
    std::string text = "{\"k\": 0";
    for (int i = 0; i < 80000; ++i) text += ",\"" + std::to_string(i) + "\":0";
    CHECK(merged("{}", text + "}").node.members.size() == 80001);
}

TEST_CASE("a copy of a document changes alone")
{
    const Node original = valueOf(R"({"a": {"b": 1}})");
    Node copy = original;
    Diagnostics errors;
    mergePatch(copy, valueOf(R"({"a": {"b": 2, "c": 3}})"), errors);
    CHECK(errors.empty());
    CHECK(toJson(copy) == R"({"a": {"b": 2, "c": 3}})");
    CHECK(toJson(original) == R"({"a": {"b": 1}})");
    CHECK(original.find("a")->find("b")->origins.empty());
}

TEST_CASE("the patch between two documents is the smallest that makes one of the other")
{
    struct Case {
        const char* base;
        const char* now;
        const char* patch;
    };
    const Case kCases[] = {
        {R"({"a": 1, "b": {"c": 2}})", R"({"b": {"c": 2.0}, "a": 1})", "{}"},
        {R"({"a": 1, "b": {"c": 2, "d": 3}})", R"({"a": 1, "b": {"c": 2, "d": 4}})",
         R"({"b":{"d":4}})"},
        {R"({"a": {"b": 1}, "c": 1})", R"({"a": {}})", R"({"a":{"b":null},"c":null})"},
        {R"({"a": [1, 2]})", R"({"a": [1, 3], "b": {"c": true}})", R"({"a":[1,3],"b":{"c":true}})"},
        {R"({"a": "x"})", R"({"a": "y"})", R"({"a":"y"})"},
        {R"({"a": true})", R"({"a": false})", R"({"a":false})"},
    };
    for (const Case& one : kCases) {
        INFO(one.base << " to " << one.now);
        const Node patch = patchBetween(valueOf(one.base), valueOf(one.now));
        CHECK(toJson(patch) == toJson(valueOf(one.patch)));
        Node again = valueOf(one.base);
        Diagnostics errors;
        mergePatch(again, patch, errors);
        CHECK(errors.empty());
        CHECK(patchBetween(again, valueOf(one.now)).members.empty());
    }
}
