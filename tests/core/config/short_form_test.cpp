// SPDX-License-Identifier: MIT
// "radius": 0.8 for {"radius": {"default": 0.8}}: what it sets, where errors point, and when it may
// not stand.
#include "tests/core/config/decode_fixture.h"
#include "tests/core/config/load_fixture.h"
#include "tests/support/need.h"

using namespace crevice;

namespace {

const char* const kBase = R"({"format": 1,
    "params": {"radius": {"default": 0.5, "min": 0, "max": 10, "unit": "scene units"},
               "tint": {"type": "vec2", "default": [1, 2]}},
    "features": {"fast": {}, "look": {"type": "enum", "values": ["flat", "lit"]}},
    "passes": {"blur": {"inputs": {"ao": {"filter": "linear"}}}}})";

/// A config that extends kBase, with its own members and an override.
Result<Description> extended(const std::string& members,
                             const std::vector<std::string>& overrides = {},
                             const std::string& variant = "")
{
    MemorySources sources;
    sources.add("base.json", kBase);
    sources.add("configs/mine.json", "{\"format\": 1, \"extends\": [\"base\"],\n" + members + "}");
    const Result<Node> document = loadConfig(sources, {"mine", variant, overrides});
    if (!document) return document.diagnostics();
    Node tunables;  // decoded without the pass, which has no shader
    tunables.kind = Node::Kind::object;
    tunables.place = document->place;
    tunables.origins = document->origins;
    for (const Member& member : document->members)
        if (member.key != "passes") tunables.members.push_back(member);
    return decode(tunables, sources);
}

/// The only diagnostic.
Diagnostic only(const Result<Description>& result)
{
    INFO(toText(result.diagnostics()));
    REQUIRE(result.diagnostics().size() == 1);
    return result.diagnostics().front();
}

}  // namespace

TEST_CASE("A bare value sets the default of what a module declares and leaves the rest", "[decode]")
{
    const Description d = need(extended(
        R"("params": {"radius": 0.8, "tint": [3, 4]}, "features": {"fast": true, "look": "lit"})"));
    CHECK(d.params.at(0).value[0] == 0.8f);
    CHECK(d.params.at(0).max == 10);
    CHECK(d.params.at(0).unit == "scene units");
    CHECK(d.params.at(1).value[1] == 4.0f);
    CHECK(d.features.at(0).value == 1);
    CHECK(d.features.at(1).value == 1);
}

TEST_CASE("Variants, overrides and long forms go over a bare value, and it over them", "[decode]")
{
    const std::string mine = R"("params": {"radius": 0.8},
        "variants": {"wide": {"params": {"radius": 5}},
                     "long": {"params": {"radius": {"default": 6, "max": 7}}}})";
    const auto radius = [&](const std::vector<std::string>& overrides, const std::string& variant) {
        return need(extended(mine, overrides, variant)).params.at(0).value[0];
    };
    CHECK(radius({}, "") == 0.8f);
    CHECK(radius({}, "wide") == 5.0f);
    CHECK(radius({}, "long") == 6.0f);
    CHECK(radius({"radius=2"}, "wide") == 2.0f);
    CHECK(radius({"/params/radius=3"}, "") == 3.0f);
    CHECK(radius({"/params/radius/default=4"}, "") == 4.0f);
}

TEST_CASE("An error in a bare value points at it", "[decode]")
{
    const Diagnostic range = only(extended(R"("params": {"radius": 11})"));
    CHECK(range.code == Code::out_of_range);
    CHECK(range.pointer == "/params/radius/default");
    CHECK((range.place.line == 2 && range.place.column == 22));
    REQUIRE(range.notes.size() == 1);  // where the base sets it
    CHECK(only(extended(R"("params": {"radius": "wide"})")).code == Code::wrong_type);
    CHECK(only(extended(R"("params": {"tint": 1})")).code == Code::wrong_type);
    CHECK(only(extended(R"("features": {"fast": 1})")).code == Code::wrong_type);
    CHECK(only(extended(R"("features": {"look": "lid"})")).code == Code::bad_enum);
}
