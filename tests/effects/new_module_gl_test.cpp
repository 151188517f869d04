// SPDX-License-Identifier: MIT
// A user's own filter, parameter and estimator, written as files in a folder of theirs: no C++ is
// needed.
#include "tests/support/picture.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>

using namespace crevice;

namespace {

const char* const kDarkenShader = R"(#version 300 es
// Multiplies the occlusion picture by a parameter that no C++ knows.
precision highp float;
uniform mediump sampler2D ao;
uniform float darken;
in vec2 uv;
layout(location = 0) out float ao_filtered;
void main() { ao_filtered = texture(ao, uv).r * darken; }
)";

const char* const kDarkenModule = R"({
  "format": 1,
  "params": { "darken": { "default": 0.5, "min": 0, "max": 1, "unit": "1" } },
  "targets": { "ao_filtered": { "format": ["r8"] } },
  "shaders": { "darken": { "vertex": "common/fullscreen.vert", "fragment": "./darken.frag" } },
  "passes": { "darken": { "type": "fullscreen", "shader": "darken", "color": ["ao_filtered"] } },
  "outputs": { "ao": "ao_filtered" }
})";

const char* const kConfig = R"({
  "format": 1,
  "name": "mine",
  "extends": ["geometry/depth_normal", "ssao/hemisphere", "./filter/darken.json"]
})";

}  // namespace

TEST_CASE("A filter module with its own parameter runs from a folder without any C++")
{
    const TemporaryFolder folder("new_module");
    folder.write("filter/darken.frag", kDarkenShader);
    folder.write("filter/darken.json", kDarkenModule);

    PictureRequest request;
    request.config = folder.write("mine.json", kConfig);
    request.scene = "plane";
    const Image half = picture(request);
    CHECK(half.at(64, 20) == Approx(0.5f).margin(1.0f / 255));

    request.overrides = {"darken=0.25"};
    CHECK(picture(request).at(64, 20) == Approx(0.25f).margin(1.0f / 255));
}

TEST_CASE("An estimator is two files: a module that extends ssao/estimator, and its shader")
{
    PictureRequest request;
    request.config = CREVICE_SOURCE_DIR "/tests/data/new_estimator/mine.json";
    request.camera = "eye=0,1.5,4;at=0,0,0;fov=40";

    const auto least = [&](const char* scene) {
        request.scene = scene;
        const Image ao = picture(request);
        return *std::min_element(ao.pixels.begin(), ao.pixels.end());
    };
    CHECK(least("plane") == 1.0f);
    CHECK(least("corner") < 0.9f);
    request.overrides = {"samples=4", "power=4"};
    CHECK(least("corner") < 0.8f);
    for (const char* off : {"intensity=0", "radius=0"}) {
        INFO(off);
        request.overrides = {off};
        CHECK(least("corner") == 1.0f);
    }
}
