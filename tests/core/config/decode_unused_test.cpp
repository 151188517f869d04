// SPDX-License-Identifier: MIT
// Decoding, the names that nothing uses: a typo makes one, and it must not pass in silence.
#include <crevice/config.h>

#include "tests/core/config/decode_fixture.h"
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
    const Result<Node> document = loadConfig(all, request);
    INFO(toText(document.diagnostics()));
    REQUIRE(document.ok());
    const Result<Description> description = decode(*document, all);
    INFO(toText(description.diagnostics()));
    REQUIRE(description.ok());
    return description->unused;
}

/// What they are about.
std::string namesIn(const Diagnostics& all)
{
    std::string names;
    for (const Diagnostic& each : all)
        names += (names.empty() ? "" : " ") + each.pointer.substr(each.pointer.rfind('/') + 1);
    return names;
}

}  // namespace

TEST_CASE("A param that only a target is made by is used")
{
    const auto with = [](const std::string& target) {
        const Diagnostics unused =
            unusedIn(R"("params": {"msaa": {"type": "int", "default": 1, "min": 1, "max": 4},
                                   "share": {"default": 0.5, "min": 0.1, "max": 1}},
                        "targets": {"ao": {)" +
                     target + "}}");
        return namesIn(unused);
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
    INFO(toText(unused));
    REQUIRE(unused.size() == 1);
    CHECK(unused[0].severity == Severity::warning);
    CHECK(unused[0].message.find("target 'more'") == 0);
}

TEST_CASE("What a module on disk declares and this config does not use is a warning")
{
    const TemporaryFolder folder("unused_of_module");
    folder.write("mine.json", R"({"format": 1, "params": {"spare": {"default": 1}},
                                  "targets": {"more": {"format": "r8"}}})");
    const LoadRequest request{
        folder.write("config.json", R"({"format": 1, "extends": ["base", "./mine.json"]})")};
    const MemorySources all = sources();
    const Result<Node> document = loadConfig(all, request);
    REQUIRE(document.ok());
    const Result<Description> description = decode(*document, all);
    INFO(toText(description.diagnostics()));
    REQUIRE(description.ok());
    CHECK(namesIn(description->unused) == "spare more");
    CHECK_FALSE(hasErrors(description->unused));
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
    CHECK(onlyError(description).code == Code::unused_name);
    description.outputs.clear();
    CHECK(onlyError(description).code == Code::no_outputs);
}
