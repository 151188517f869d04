// SPDX-License-Identifier: MIT
// Every target of every shipped config in 32-bit floats: nothing that 8 bits would hide.
#include "tests/support/need.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/device/float_device.h"
#include "tools/render/output_source.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/target_diagnosis.h"

using namespace crevice;

namespace {

constexpr Extent kSize = {96, 54};

/// What is wrong with the targets of two frames of a config, each "pass target", in floats.
std::vector<std::string> faults(Device& device, Description description, const Frame& frame)
{
    CompileOptions options;
    options.extent = kSize;
    options.disable = {"aliasing"};
    const Plan plan = need(compile(description, traitsOf(frame), device.caps(), options));
    const std::vector<WatchedTarget> watched = watchAll(plan, description);
    FloatDevice floats(device);
    const auto renderer = need(Renderer::create(floats, description, options, traitsOf(frame)));
    for (int i = 0; i < 2; ++i) REQUIRE(renderer->render(frame).ok());
    std::vector<std::string> found;
    for (const WatchedTarget& each : watched) {
        const Image image = need(readOutput(floats, *renderer, each.output));
        TargetHealth health = examine(image, image);
        examineFloats(image, formatOf(plan, each.target), health);
        if (health.bad()) found.push_back(each.pass + " " + each.target);
    }
    CHECK(watched.size() > 2);
    return found;
}

}  // namespace

TEST_CASE("No pass of a shipped config writes what its target's format hides")
{
    GlFixture gl;
    for (const char* name : {"room", "spheres"}) {
        const Scene scene = need(loadScene(name));
        const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
        const double aspect = double(kSize.width) / kSize.height;
        const SceneCamera camera = need(chooseCamera(scene, uploaded.bounds(), "", aspect));
        const Frame frame = makeFrame(uploaded, camera, kSize);
        for (const Subject& subject : subjects()) {
            INFO(name << " " << subject.config << " " << subject.variant);
            CHECK(faults(*gl.device, descriptionOf(subject), frame) == std::vector<std::string>());
        }
    }
}
