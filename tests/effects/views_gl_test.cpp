// SPDX-License-Identifier: MIT
// Frames of two views, drawn for real: each view's picture is that of its camera alone.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

using namespace crevice;

namespace {

/// The spheres, seen from places that move with time, each off-centre by `shift` pictures.
struct Eyes : SceneRig {
    Eyes() : SceneRig("spheres", {96, 54}) {}

    Frame seen(double right, double shift, int time) const
    {
        const std::string x = std::to_string(1.0 + right + 0.05 * time);
        return frame("eye=" + x + ",1.5,4;at=" + std::to_string(right) +
                     ",0.5,0;fov=45;shift=" + std::to_string(shift) + ",0.05");
    }
};

Frame together(const Frame& left, const Frame& right)
{
    Frame both = left;
    both.other_views = {{right.camera, {}}};
    return both;
}

}  // namespace

TEST_CASE("Each view of a frame is the picture of its camera alone, bit for bit")
{
    const std::string config = GENERATE("learnopengl", "gtao", "gtao_temporal");
    INFO(config);
    Eyes eyes;
    const Description description = descriptionOf({config});
    const auto left = [&](int time) { return eyes.seen(-0.1, 0.08, time); };
    const auto right = [&](int time) { return eyes.seen(0.1, -0.08, time); };
    auto left_alone = eyes.renderer(description, left(0));
    auto right_alone = eyes.renderer(description, right(0));
    auto both = eyes.renderer(description, together(left(0), right(0)));
    for (int time = 0; time < 4; ++time) {
        need(left_alone->render(left(time)));
        need(right_alone->render(right(time)));
        need(both->render(together(left(time), right(time))));
        for (const PlanOutput& output : both->plan().outputs) {
            INFO(output.name << " of frame " << time);
            const Image alone = eyes.read(left_alone->output(output.name));
            const Image right_eye = eyes.read(both->output(output.name, 1));
            CHECK(eyes.read(both->output(output.name, 0)).pixels == alone.pixels);
            CHECK(right_eye.pixels == eyes.read(right_alone->output(output.name)).pixels);
            CHECK(meanChange(alone, right_eye) > 0.001);
        }
    }
}

TEST_CASE("A host's depth texture for each view is seen by that view")
{
    Eyes eyes;
    const Frame left = eyes.seen(-0.2, 0.0, 0), right = eyes.seen(0.2, 0.0, 0);
    const GivenConfig drawn({"geometry/depth_normal"}, R"(, "outputs": {"depth": "depth"})");
    auto host = eyes.renderer(drawn.description(), together(left, right));
    need(host->render(together(left, right)));

    const Description hosted =
        GivenConfig({"geometry/host_depth", "ssao/hemisphere", "filter/none"}).description();
    const auto with = [&](Frame frame, int view) {
        frame.textures = {{"depth", host->output("depth", view)}};
        return frame;
    };
    Frame both = together(with(left, 0), right);
    both.other_views[0].textures = with(right, 1).textures;
    auto stereo = eyes.renderer(hosted, both);
    need(stereo->render(both));
    const Image wanted = eyes.draw(hosted, with(right, 1));
    CHECK(mean(wanted) < 0.99);
    CHECK(eyes.read(stereo->output("ao", 1)).pixels == wanted.pixels);
}
