// SPDX-License-Identifier: MIT
// Error budgets against what edits of the config do.
#include "tools/measure/bench/errors.h"

#include <crevice/shipped.h>

#include "tests/support/gl_fixture.h"
#include "tools/measure/bench/bench.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/scene_upload.h"

#include <cmath>

using namespace crevice;

namespace {

/// A part that is off by more of the error misleads: configs beside each other in a table differ by
/// as much.
constexpr double kBar = 0.1;

/// Where the edit does nothing but what the part makes ideal.
constexpr double kSame = 0.01;

struct Place {
    const char* scene;
    const char* camera = "";

    bool operator==(const Place& other) const
    {
        return std::string(scene) == other.scene && std::string(camera) == other.camera;
    }
};

const Place kRoom = {"room"};
const Place kSpheres = {"spheres"};
const Place kWalkedUpTo = {"room", "eye=-0.9,0.6,-0.3;at=-1.1,0.4,-1.25"};
const Place kNearPlane = {"room", "eye=4,2,6;at=0,1,0;near=0.0005"};  // stiff for depth16

struct Edit {
    const char* config;
    std::vector<std::string> overrides = {};
};

/// What a part of the budget of `from` says that `to` does.
struct Prediction {
    const char* part;
    unsigned ideal;
    Place place;
    Edit from, to;
    double off = kSame;  ///< By how much of the error it may be off.
};

const Prediction kPredictions[] = {
    {"taps",
     kIdealTaps,
     kRoom,
     {"gtao", {"slices=1", "steps=1"}},
     {"gtao", {"slices=16", "steps=32"}}},
    {"taps", kIdealTaps, kRoom, {"lettier", {"samples=4"}}, {"lettier", {"samples=128"}}, kBar},
    {"filter", kIdealFilter, kRoom, {"gtao"}, {"gtao", {"filter/bilateral_normal=filter/none"}}},
    {"filter",
     kIdealFilter,
     kRoom,
     {"gtao_half", {"slices=1"}},
     {"gtao_half", {"slices=1", "depth_cut=0"}}},
    {"half size",
     kIdealSize,
     kRoom,
     {"balanced"},
     {"balanced", {"filter/upsample=filter/bilateral_normal"}}},
    {"off screen",
     kIdealScreen,
     kWalkedUpTo,
     {"gtao", {"guard_band=1"}},
     {"gtao", {"guard_band=2"}}},
    {"off screen", kIdealScreen, kWalkedUpTo, {"no_band"}, {"gtao", {"guard_band=2"}}, kBar},
    {"hidden layers",
     kIdealLayers,
     kRoom,
     {"bitmask", {"thickness=0.2"}},
     {"bitmask_layers", {"slices=2", "steps=4", "thickness=0.2"}}},
    {"precision",
     kIdealFormats,
     kNearPlane,
     {"gtao", {R"(/targets/depth/format=["depth16"])"}},
     {"gtao", {R"(/targets/depth/format=["depth32f"])"}},
     kBar},
};

BenchPlan planned(const Place& place, const Edit& edit)
{
    MemorySources mine;
    mine.add("configs/no_band.json",
             R"({"format": 1, "extends": ["geometry/position_normal", "ssao/gtao",
                                          "filter/bilateral_normal", "lighting/blinn_phong"]})");
    BenchOptions options;
    options.scenes = {place.scene};
    options.camera = place.camera;
    options.sizes = {"96x54"};
    options.radii = {1.0};
    options.overrides = edit.overrides;
    if (edit.config) options.configs = {edit.config};
    BenchPlan plan = need(planBench(options, LayeredSources({&mine, &shippedSources()})));
    for (const BenchTask& task : plan.tasks) {
        INFO(task.sample.failure);
        REQUIRE(task.sample.failure.empty());
    }
    return plan;
}

/// A small view of a scene, and what configs draw of it.
class TestView {
public:
    explicit TestView(const Place& place)
        : place_(place),
          view_(planned(place, {"gtao"}).views.at(0)),
          uploaded_(need(UploadedScene::upload(*gl_.device, *view_.scene))),
          frame_(makeFrame(uploaded_, view_.camera, view_.extent))
    {
    }

    const Place& place() const { return place_; }

    Image draw(const Description& description, unsigned ideal, bool interrupted = false)
    {
        const Stage stage = {*gl_.device, frame_, view_.extent, shippedSources()};
        Image ao =
            need(idealOcclusion(stage, description, ideal, [interrupted] { return interrupted; }));
        CHECK(ao.extent == view_.extent);
        return ao;
    }

    double error(const Edit& edit, unsigned ideal)
    {
        if (ground_truth_.pixels.empty()) {
            TraceOptions trace;
            trace.radius = 1.0;
            trace.rays = 64;
            ground_truth_ =
                need(traceAmbientOcclusion(*view_.scene, view_.matrices(), view_.extent, trace));
        }
        const Image ao = draw(planned(place_, edit).tasks.at(0).description, ideal);
        return need(compareImages(ao, ground_truth_)).rmse;
    }

private:
    GlFixture gl_;
    Place place_;
    BenchView view_;
    UploadedScene uploaded_;
    Frame frame_;
    Image ground_truth_;
};

}  // namespace

TEST_CASE("Each part of a budget is what an edit of the config does to its error")
{
    std::unique_ptr<TestView> view;
    for (const Prediction& each : kPredictions) {
        INFO(each.part << " of " << each.from.config << ", " << each.place.scene);
        if (!view || !(view->place() == each.place)) view = std::make_unique<TestView>(each.place);
        const double error = view->error(each.from, 0);
        const double predicted = view->error(each.from, each.ideal) - error;
        const double real = view->error(each.to, 0) - error;
        INFO("error " << error << ", predicted " << predicted << ", real " << real);
        CHECK(std::abs(predicted - real) <= each.off * error);
        CHECK(std::abs(real) > kBar * error);  // or a part that is always 0 would pass
    }
}

TEST_CASE("A part that a config does not have is exactly 0")
{
    TestView view(kSpheres);
    const auto changed = [&view](const Edit& edit, unsigned ideal) {
        const Description description = planned(kSpheres, edit).tasks.at(0).description;
        return view.draw(description, 0).pixels != view.draw(description, ideal).pixels;
    };
    CHECK_FALSE(changed({"reference", {"slices=1", "steps=1"}}, kIdealFilter));
    CHECK_FALSE(changed({"gtao"}, kIdealSize));
    CHECK_FALSE(changed({"gtao"}, kIdealLayers));  // although it has a param `max_gap`
    CHECK_FALSE(changed({"gtao", {"guard_band=2"}}, kIdealScreen));
}

TEST_CASE("What a config converges to does not depend on its samples or seeds")
{
    TestView view(kSpheres);
    const auto converged = [&view](const Edit& edit, bool interrupted = false) {
        const Description description = planned(kSpheres, edit).tasks.at(0).description;
        return view.draw(description, kIdealTaps, interrupted).pixels;
    };
    const Edit few = {"hemisphere_box", {"samples=2", "/generated/kernel/seed=7"}};
    CHECK(converged(few) == converged({"hemisphere_box", {"samples=32"}}));
    CHECK(converged(few) != converged(few, true));  // of one seed
}

TEST_CASE("Every shipped config can be drawn with everything ideal")
{
    TestView view(kSpheres);
    for (const BenchTask& task : planned(kSpheres, {nullptr}).tasks) {
        CAPTURE(task.sample.config);
        view.draw(task.description, kIdealEverything, true);
    }
}
