// SPDX-License-Identifier: MIT
// Boxes and volumes, on the recording device: what is drawn by a box's view, when, in which layers,
// and where readers are told that it lies.
#include "tests/support/plan_rig.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

/// A box of 16 around the camera, in steps of 2; slices of it, four voxel layers of them, a reader.
Description boxed(const std::string& edge = "[\"reach\", 4]", int cells = 4)
{
    const std::string config = R"({
      "format": 1, "name": "boxed",
      "imports": {"camera": {"type": "camera"}, "scene": {"type": "draw_list"}},
      "params": {"reach": {"default": 4, "max": 100},
                 "cells": {"type": "int", "default": )" +
                               std::to_string(cells) +
                               R"(, "min": 2, "max": 4096, "bind": "define"}},
      "boxes": {"room": {"edge": )" +
                               edge + R"(}},
      "targets": {
        "slices": {"format": ["rgba8"], "size": {"width": "cells", "height": "cells", "depth": ["cells", 0.5]}},
        "voxels": {"format": ["r8"], "mips": true, "size": {"width": "cells", "height": "cells", "depth": "cells"}},
        "ao": {"format": ["r8"]}},
      "shaders": {"slices": {"vertex": "mesh.vert", "fragment": "slices.frag"},
                  "voxels": {"vertex": "full.vert", "fragment": "voxels.frag"},
                  "ao": {"vertex": "full.vert", "fragment": "ao.frag"}},
      "passes": {
        "slices": {"type": "draw", "shader": "slices", "box": "room", "color": ["slices", "slices"],
                   "state": {"blend": "max"}, "frustum_scale": 1},
        "voxels": {"type": "fullscreen", "shader": "voxels", "box": "room", "color": ["voxels"]},
        "ao": {"type": "fullscreen", "shader": "ao", "color": ["ao"]}},
      "outputs": {"ao": "ao"}
    })";
    const std::string head = "#version 300 es\nprecision highp float;\n";
    return describe(
        config,
        {{"mesh.vert", head + "uniform mat4 clip_from_model;\nuniform highp int first_layer;\n"},
         {"full.vert", head},
         {"slices.frag", head + "layout(location = 0) out vec4 first;\n"
                                "layout(location = 1) out vec4 second;\n"},
         {"voxels.frag", head + "uniform highp sampler3D slices;\nuniform highp int first_layer;\n"
                                "layout(location = 0) out float filled;\n"},
         {"ao.frag", head +
                         "uniform mediump sampler3D voxels;\nuniform mat4 room;\n"
                         "uniform mat4 view_from_window;\nlayout(location = 0) out float ao;\n"}});
}

bool isNear(double a, double b) { return std::abs(a - b) < 1e-6; }

struct Boxes : Rig {
    explicit Boxes(const Description& description = boxed()) { use(description); }

    /// The passes that a frame draws.
    std::string passes()
    {
        draw();
        std::string all;
        for (const char* name : {"slices", "voxels", "ao"})
            if (ranPass(name)) all += std::string(all.empty() ? "" : " ") + name;
        return all;
    }

    void moveTo(double x) { frame.camera.view_from_world[3][0] = -x; }

    /// Where the reader is told that the camera is in the box, along x.
    float seenAt() { return (sentMatrix(*this, "room") * glm::vec4(0, 0, 0, 1)).x; }
};

}  // namespace

TEST_CASE("A volume is drawn layer by layer, as many at once as `color` names it, then its mips")
{
    Boxes rig;
    const std::string log = rig.draw();
    const auto count = [&log](const std::string& part) { return occurrences(log, part); };
    CHECK(count("beginPass slices ") == 1);  // two layers at once
    CHECK(count("beginPass voxels ") == 4);
    CHECK(count("setUniform first_layer 3") == 1);
    CHECK(count("from layer 3 makes mips") == 1);
    CHECK(count("makes mips") == 1);
    CHECK(count("blend max") == 1);
    const Plan& plan = rig.renderer->plan();
    CHECK(plan.textures[plan.targets[1].texture].mips);
    CHECK(findNamed(plan.passes[2].inputs, "voxels")->sampling.filter == Filter::trilinear);
    CHECK(textureBytes(plan.textures[plan.targets[1].texture]) == 64 + 8 + 1);
}

TEST_CASE("What a box shows is drawn again when it moves or its draws do, one pass a frame in turn")
{
    Boxes rig;
    CHECK(rig.passes() == "slices voxels ao");
    CHECK(rig.passes().empty());
    rig.moveTo(0.9);  // less than half a step of 2
    CHECK(rig.passes() == "ao");
    rig.moveTo(1.1);
    CHECK(rig.passes() == "slices ao");  // the box is on its way
    CHECK(rig.passes() == "voxels ao");
    CHECK(rig.passes().empty());
    rig.frame.draws[0].world_from_model[3][1] = 1;
    CHECK(rig.passes() == "slices");
    rig.frame.draws[0].world_from_model[3][1] = 2;  // and on, while the next pass has its turn
    CHECK(rig.passes() == "voxels ao");
    CHECK(rig.passes() == "slices");
    CHECK(rig.passes() == "voxels ao");
    CHECK(rig.passes().empty());
    need(rig.renderer->setParam("reach", 5));
    CHECK(rig.passes() == "slices");
}

TEST_CASE("Readers are told where a box was drawn, once all its passes have drawn it there")
{
    Boxes rig;
    rig.moveTo(0.5);
    rig.draw();
    CHECK(isNear(rig.seenAt(), 0.5 + 0.5 / 16));
    rig.moveTo(1.5);
    rig.draw();  // the slices of the box at 2
    CHECK(isNear(rig.seenAt(), 0.5 + 1.5 / 16));
    rig.draw();  // and its voxels
    CHECK(isNear(rig.seenAt(), 0.5 - 0.5 / 16));
    rig.frame.origin_shift = {2, 0, 0};
    rig.moveTo(-0.25);
    rig.frame.draws[0].world_from_model[3][0] = -2;
    rig.draw();  // where the world's origin is another, the box is where it was
    CHECK(isNear(rig.seenAt(), 0.5 - 0.25 / 16));
}

TEST_CASE("A box draws by its own view: the world's axes, -1 to 1 along an edge")
{
    Boxes rig;
    rig.frame.camera.view_from_world = glm::mat4(0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1);
    rig.frame.draws[0].world_from_model[3] = {4, -2, 1, 1};
    rig.draw();
    const glm::vec4 at = sentMatrix(rig, "clip_from_model") * glm::vec4(0, 0, 0, 1);
    CHECK(glm::length(at - glm::vec4(0.5, -0.25, 0.125, 1)) < 1e-6);
    rig.frame.draws[0].bounds_radius = 1;
    rig.frame.draws[0].world_from_model[3] = {40, 0, 0, 1};
    rig.frame.draws.push_back(rig.frame.draws[0]);
    rig.frame.draws[1].world_from_model[3] = {-40, 0, 0, 1};
    CHECK(!has(rig.draw(), "draw 'cube'"));  // outside of it
}

TEST_CASE("Where all that is drawn fits into a smaller box, that is it, wherever the camera is")
{
    Boxes rig;
    rig.frame.draws[0].bounds_radius = 1;
    rig.frame.draws[0].world_from_model[3] = {100, 0, 0, 1};
    CHECK(rig.passes() == "slices voxels ao");
    const glm::mat4 room = sentMatrix(rig, "room");
    const glm::vec3 low = glm::vec3(room * glm::vec4(99, -1, -1, 1));
    const glm::vec3 high = glm::vec3(room * glm::vec4(101, 1, 1, 1));
    CHECK(std::min({low.x, low.y, low.z}) >= 0);
    CHECK(std::max({high.x, high.y, high.z}) <= 1);
    CHECK(room[0][0] > 1.0f / 4);
    rig.moveTo(50);
    CHECK(rig.passes() == "ao");
    rig.frame.draws[0].bounds_radius = -1;  // no longer known
    CHECK(rig.passes() == "slices");
    CHECK(rig.passes() == "voxels ao");
}

TEST_CASE("What draws the scene more than 20 times takes as many frames to do it again")
{
    Boxes rig;
    rig.use(boxed("[\"reach\", 4]", 96));
    const auto slices = [&rig] { return occurrences(rig.draw(), "beginPass slices "); };
    CHECK(slices() == 24);  // the first frame has all
    rig.moveTo(1.5);
    CHECK(slices() == 12);
    rig.moveTo(3.5);  // on its way to the first place it stays on it
    const std::string log = rig.draw();
    CHECK(occurrences(log, "beginPass slices ") == 12);
    CHECK(has(log, "from layer 46"));
    CHECK(isNear(rig.seenAt(), 0.5 + 3.5 / 16));
    CHECK(rig.passes() == "voxels ao");
    CHECK(isNear(rig.seenAt(), 0.5 + 1.5 / 16));
    CHECK(slices() + slices() == 24);
    CHECK(rig.passes() == "voxels ao");
    CHECK(isNear(rig.seenAt(), 0.5 - 0.5 / 16));
    CHECK(rig.passes().empty());
    CHECK(has(toText(rig.renderer->plan()), "drawn 24 times for 48 layers, over 2 frames"));
}

TEST_CASE("What the view reads of a box is drawn again in one frame, however often that takes")
{
    for (const bool read : {true, false}) {
        Description description = boxed("[\"reach\", 4]", 96);
        TargetDesc other = *findNamed(description.targets, "slices");
        other.name = "other";
        description.targets.push_back(other);
        std::vector<Reference>& color = description.passes[0].color;
        color[read ? 1 : 0].name = "other";
        InputDesc input;
        input.name = "voxels";
        input.from.name = "other";
        if (read) description.passes[2].inputs.push_back(input);
        const Plan plan = planOf(description, {}, sized(64, 32));
        CHECK(findNamed(plan.passes, "slices")->frames == (read ? 1 : 3));
    }
}

TEST_CASE("Two views share what a box shows")
{
    Boxes rig;
    rig.frame.other_views.resize(1);
    rig.frame.other_views[0].camera = rig.frame.camera;
    rig.use(boxed());
    const std::string log = rig.draw();
    CHECK(log.find("beginPass slices ") == log.rfind("beginPass slices "));
    CHECK(rig.renderer->plan().textures[0].copies == 1);
    rig.frame.other_views[0].camera.view_from_world[3][0] = 30;
    CHECK(rig.passes() == "ao");
}

TEST_CASE("With the optimization 'cached' off all of a box is drawn in each frame")
{
    Boxes rig;
    rig.use(boxed(), {{64, 32}, {}, {"cached"}});
    for (int i = 0; i < 3; ++i) CHECK(rig.passes() == "slices voxels ao");
}

TEST_CASE("What is drawn of a box outlives the frame, and what only its passes read is shared")
{
    Description description = boxed();
    const Plan plan = planOf(description, {}, sized(64, 32));
    const PlanTarget& voxels = *findNamed(plan.targets, "voxels");
    CHECK(voxels.last_pass == static_cast<int>(plan.passes.size()));
    CHECK(findNamed(plan.targets, "slices")->last_pass == 1);
    CHECK(has(toText(plan),
              "cached  until what lies in the box room (edge 16, "
              "or that of all draws if less) changes or it moves"));
    CHECK(has(toText(plan), "drawn 4 times for 4 layers"));
}
