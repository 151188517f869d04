// SPDX-License-Identifier: MIT
// Decoding: the GLSL files that a config names and what they include.
#include <crevice/glsl_stage.h>

#include "tests/core/config/decode_fixture.h"

using namespace crevice;

namespace {

std::vector<std::string> keysOf(const Description& description)
{
    std::vector<std::string> keys;
    for (const auto& file : description.files) keys.push_back(file.first);
    return keys;
}

}  // namespace

TEST_CASE("a description carries each GLSL file that it names or includes", "[decode]")
{
    const auto result = decodeWith({});
    REQUIRE(result.ok());
    CHECK(keysOf(*result) == std::vector<std::string>{"common/fullscreen.vert", "common/view.glsl",
                                                      "geometry/a.surface.glsl",
                                                      "geometry/normal.glsl", "ssao/ao.frag"});
    for (const auto& [key, file] : result->files) CHECK(file->name == key);
    const auto stage =  // which they are enough for
        assembleStage(result->files, {{"surface", result->interfaces.at(0).file.name}},
                      result->shaders.at(0).fragment.name, {});
    INFO(toText(stage.diagnostics()));
    CHECK(stage.ok());
}

TEST_CASE("files that include each other are read once", "[decode]")
{
    MemorySources sources = glslSources();
    sources.add("ssao/ao.frag", "#include \"ssao/ao.frag\"\n#include \"./b.glsl\"\n");
    sources.add("ssao/b.glsl", "#include \"./ao.frag\"\n");
    const auto result = decodeWith({}, sources);
    REQUIRE(result.ok());
    CHECK(result->files.count("ssao/b.glsl") == 1);
}
