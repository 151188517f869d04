// SPDX-License-Identifier: MIT
// Variants and overrides: what is laid over a loaded config.
#include "tests/core/config/load_fixture.h"

using namespace crevice;

namespace {

Node overridden(const std::string& text) { return loaded(smallCatalog(), {"base", {}, {text}}); }

}  // namespace

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
