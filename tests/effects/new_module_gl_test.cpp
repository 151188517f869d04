// SPDX-License-Identifier: MIT
// A user's own filter and parameter, written as files in a folder of theirs: no C++ is needed.
#include "tests/support/picture.h"
#include "tests/support/temporary_folder.h"

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
