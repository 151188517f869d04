// SPDX-License-Identifier: MIT
// The smallest patch between two configs.
#include "tests/support/catch.h"

#include "core/json/merge.h"
#include "tests/support/need.h"
#include "tools/cli/save_patch.h"

using namespace crevice;

namespace {

Node documentOf(const std::string& text)
{
    return need(parseDocument(std::make_shared<const SourceText>(SourceText{"a.json", text})));
}

}  // namespace

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
        const std::string patch = patchBetween(documentOf(one.base), documentOf(one.now));
        CHECK(patch == one.patch);
        Node again = documentOf(one.base);
        Diagnostics errors;
        mergePatch(again, documentOf(patch), errors);
        CHECK(errors.empty());
        CHECK(patchBetween(again, documentOf(one.now)) == "{}");
    }
}
