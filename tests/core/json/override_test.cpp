// SPDX-License-Identifier: MIT
// Variants and overrides: what is laid over a loaded config.
#include "tests/core/config/load_fixture.h"

using namespace crevice;

namespace {

Node overridden(const std::string& text) { return loaded(smallCatalog(), {"base", {}, {text}}); }

Diagnostic overrideFailure(const std::string& text)
{
    return failure(smallCatalog(), {"base", {}, {text}});
}

}  // namespace

TEST_CASE("a variant is laid over its file, and may delete")
{
    const Node document = loaded(smallCatalog(), {"fine", "bare"});
    CHECK_FALSE(at(document, "passes/box"));
    CHECK(at(document, "passes/ssao"));
    CHECK_FALSE(at(document, "variants"));
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

TEST_CASE("a variant that does not exist is an error with the nearest names")
{
    const Diagnostic error = failure(smallCatalog(), {"fine", "fsat"});
    CHECK(error.code == Code::variant_missing);
    CHECK(error.help == "did you mean 'fast'? variants: bare, fast");
    MemorySources sources;
    sources.add("configs/a.json", file(""));
    CHECK(failure(sources, {"a", "fast"}).help == "there are no variants");
    CHECK(failureOf(file(R"("variants": {"a/b": null})")).pointer == "/variants/a~1b");
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

TEST_CASE("overrides come last and in order")
{
    const Node document = loaded(smallCatalog(), {"fine", "fast", {"radius=3", "radius=4"}});
    CHECK(at(document, "params/radius/default")->number == 4);
    CHECK(at(document, "params/radius/default")->origins.size() == 3);
}

TEST_CASE("an override of nothing is an error with the nearest names")
{
    const Diagnostic error = overrideFailure("radios=0.8");
    CHECK(error.code == Code::unknown_param);
    CHECK(error.help == "did you mean 'radius'? params and features: half, radius, samples");
    CHECK(placeName(error.place) == "--set radios=0.8:1:1");
    CHECK(error.place.length == 6);
    CHECK(overrideFailure("/passes/none=null").code == Code::merge_missing);
    CHECK(overrideFailure("/passes/ssao=1").code == Code::merge_kind);
    CHECK(overrideFailure("/name/first=1").code == Code::merge_kind);
}

TEST_CASE("an override without a name or a value is an error")
{
    for (const char* text : {"radius", "=0.8", "radius=", "", "/passes/box"}) {
        INFO(text);
        CHECK(overrideFailure(text).code == Code::override_syntax);
    }
}

TEST_CASE("a fault in an override's value is placed in the override")
{
    const Diagnostic error = overrideFailure("radius=0.8m");
    CHECK(error.code == Code::syntax);
    CHECK(toText(error) == "--set radius=0.8m:1:8: error CV1001: " + error.message +
                               "\n    1 | radius=0.8m\n      |        ^~~~\n  help: " + error.help +
                               "\n");
}

TEST_CASE("all bad overrides are reported together")
{
    const LoadRequest request = {"base", {}, {"x=1", "radius", "half=1"}};
    CHECK(loadConfig(smallCatalog(), request).diagnostics().size() == 2);
}

TEST_CASE("a relative file in an override stands in the current folder")
{
    const Node document = overridden("/shaders/mine/fragment=./mine.frag");
    const Node* fragment = at(document, "shaders/mine/fragment");
    REQUIRE(fragment);
    CHECK(fragment->text == "./mine.frag");
    CHECK(resolvePath(fragment->place.source->path, fragment->text) == "./mine.frag");
}

TEST_CASE("a variant or an override cannot change what a file extends, nor its variants")
{
    MemorySources sources = smallCatalog();
    sources.add("configs/bad.json", file(R"("extends": ["base"],
        "variants": {"other": {"extends": ["filter/box"]},
                     "nested": {"variants": {"more": {}}}})"));
    for (const char* variant : {"other", "nested"})
        CHECK(failure(sources, {"bad", variant}).code == Code::unknown_key);
    for (const char* text : {"/extends=[\"filter/box\"]", "/extends/2=filter/box",
                             "/variants/fast=5", "/variants/fast/params/radius/default=5"}) {
        const Diagnostic error = failure(sources, {"base", "", {text}});
        CHECK(error.code == Code::unknown_key);
        REQUIRE(error.place.source);
        CHECK(error.place.source->name == std::string("--set ") + text);
        CHECK_FALSE(error.help.empty());
    }
}

TEST_CASE("an override by pointer sets a list as a whole")
{
    MemorySources sources = smallCatalog();
    sources.add("configs/listed.json", file(R"("targets": {"ao": {"format": ["r8", "rg8"]}})"));
    const Node document = loaded(sources, {"listed", "", {R"(/targets/ao/format=["r16f"])"}});
    CHECK(toJson(*at(document, "targets/ao/format")) == R"(["r16f"])");
    CHECK(failure(sources, {"listed", "", {"/targets/ao/format/0=r16f"}}).code == Code::merge_kind);
}
