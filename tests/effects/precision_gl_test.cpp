// SPDX-License-Identifier: MIT
// What core/compile/depth_precision.h foretells, against what a device stores and draws.
#include "core/compile/depth_precision.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/stress/case.h"
#include "tools/measure/stress/scenes.h"

#include <cmath>

using namespace crevice;

namespace {

// A config whose target has one format alone.
struct Stored {
    Subject subject;
    const char* target;
    Format format;
    bool reversed = false;

    StoredSurface surface() const { return {Semantic::view_position, format}; }
};

struct Drawn {
    Image image;
    SceneTraits traits;
    bool warned;
};

struct Rig : DrawRig {
    // The occlusion, or where `shown` is named what that target holds.
    Drawn drawn(const Stored& stored, const Scene& scene, const Camera& camera,
                const std::string& shown = {})
    {
        Description description = descriptionOf(stored.subject);
        for (TargetDesc& each : description.targets)
            if (each.name == stored.target) each.formats = {stored.format};
        OutputDesc output;
        output.name = "shown";
        output.target.name =
            shown.empty() ? findNamed(description.outputs, "ao")->target.name : shown;
        description.outputs = {output};
        const UploadedScene uploaded = need(UploadedScene::upload(*device, scene));
        Frame frame = makeFrame(uploaded, SceneCamera(), extent);
        frame.camera = camera;
        const Result<Plan> plan =
            compile(description, traitsOf(frame), device->caps(), {extent, {}, {}});
        bool warned = false;
        for (const Diagnostic& each : plan.diagnostics()) warned |= each.code == Code::too_coarse;
        return {draw(description, frame, "shown"), traitsOf(frame), warned};
    }
};

double distanceOf(const Image& image, const Camera& camera, Format format)
{
    const int x = image.extent.width / 2, y = image.extent.height / 2;
    if (formatInfo(format).format_class != FormatClass::depth) return -image.at(x, y, 2);
    const glm::dmat4 m = camera.clip_from_view;
    const double clip = image.at(x, y) * 2.0 - 1.0;
    return -(m[3][2] - clip * m[3][3]) / (clip * m[2][3] - m[2][2]);
}

}  // namespace

TEST_CASE("What is stored of a plane is as far off as foretold, and no farther")
{
    std::vector<Stored> all = {{{"learnopengl", "sound"}, "position", Format::rgba16f}};
    for (const bool reversed : {false, true})
        for (const Format format : {Format::depth16, Format::depth24, Format::depth32f})
            all.push_back({{"hemisphere_box"}, "depth", format, reversed});
    Rig rig;
    rig.extent = {8, 8};
    for (const Stored& stored : all) {
        CAPTURE(formatInfo(stored.format).name, stored.reversed);
        StressView view;
        view.near_distance = 0.01;
        view.far_distance = 1e4;
        view.reversed = stored.reversed;
        const Camera camera = cameraOf(view, rig.extent);
        double largest = 0;  // error, in steps
        for (double distance = 0.021; distance < 100; distance *= 1.61) {
            const Scene scene = planeView(view, rig.extent, distance, 0).scene;
            const Drawn drawn = rig.drawn(stored, scene, camera, stored.target);
            const double step = viewStep(drawn.traits, stored.surface(), distance);
            if (step > 0.2 * distance) break;  // steps are not even any more
            const double off = distanceOf(drawn.image, camera, stored.format) - distance;
            CAPTURE(distance, off, step);
            CHECK(std::abs(off) < 3 * step);  // of rounding, and of the arithmetic before it
            largest = std::max(largest, std::abs(off) / step);
        }
        CHECK(largest > 0.2);
    }
}

TEST_CASE("A flat plane is open as far as foretold, and where it is not a plan warned")
{
    Rig rig;
    rig.extent = {96, 54};
    for (const StressCase& stress : stressCases()) {
        if (stress.name != "plane_distance" && stress.name != "plane_near_far") continue;
        for (const Stored& stored :
             {Stored{{"hemisphere_box"}, "depth", Format::depth16},
              Stored{{"hemisphere_box"}, "depth", Format::depth24},
              Stored{{"sao"}, "depth", Format::depth16}, Stored{{"sao"}, "depth", Format::depth24},
              Stored{{"learnopengl", "sound"}, "position", Format::rgba16f}}) {
            for (const StressStep& step : stress.steps) {
                CAPTURE(stress.name, step.label, stored.subject.config,
                        formatInfo(stored.format).name);
                const StressShot shot = stress.shot(step.value, rig.extent);
                const Drawn drawn = rig.drawn(stored, shot.scene, shot.camera);
                const PrecisionNeed asked =
                    precisionNeed(drawn.traits, shot.radius, rig.extent.height);
                const double foretold = resolvedDistance(drawn.traits, stored.surface(),
                                                         {asked.step, shot.far_distance});
                double sum = 0;
                int open = 0, dark = 0, unforetold = 0;
                for (int y = 6; y < 48; ++y)
                    for (int x = 10; x < 86; ++x) {
                        const double distance = shot.distances.at(x, y), ao = drawn.image.at(x, y);
                        if (distance <= 0) continue;
                        const bool resolved = distance * 1.02 < foretold;
                        open += resolved;
                        sum += resolved ? ao : 0;
                        dark += resolved && ao < 0.95;
                        unforetold += ao < 0.95 && distance < asked.distance && !drawn.warned;
                    }
                CHECK(dark == 0);
                if (open > 0) CHECK(sum / open >= 0.999);
                CHECK(unforetold == 0);
            }
        }
    }
}

TEST_CASE("A corner loses its occlusion to coarse depth only where a plan warned")
{
    Rig rig;
    rig.extent = {96, 54};
    const auto corner = [&](double near_distance, Format format) {
        StressView view;
        view.eye = {0, 1, 4};
        view.near_distance = near_distance;
        return rig.drawn({{"hemisphere_box"}, "depth", format}, cornerScene(),
                         cameraOf(view, rig.extent));
    };
    const Drawn fine = corner(0.1, Format::depth24);
    CHECK_FALSE(fine.warned);
    double change = 0;
    for (const double near_distance : {0.5, 0.1, 0.03, 0.01, 0.003, 0.001, 1e-4}) {
        const Drawn drawn = corner(near_distance, Format::depth16);
        change = meanChange(fine.image, drawn.image);
        CAPTURE(near_distance, change, drawn.warned);
        if (!drawn.warned) CHECK(change < 0.002);
    }
    CHECK(change > 0.02);
}
