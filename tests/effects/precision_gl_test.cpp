// SPDX-License-Identifier: MIT
// What core/compile/depth_precision.h foretells, against what a device stores and draws.
#include "tests/support/gl_fixture.h"

#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "core/compile/depth_precision.h"
#include "tests/support/picture.h"
#include "tools/cli/config_options.h"
#include "tools/render/scene_upload.h"
#include "tools/stress/case.h"
#include "tools/stress/scenes.h"

#include <cmath>

using namespace crevice;

namespace {

// A config whose target has one format alone.
struct Stored {
    const char* config;
    const char* target;
    Format format;
    bool reversed = false;
    const char* variant = "";

    Description description() const
    {
        ConfigOptions options;
        options.config = config;
        options.variant = variant;
        Description description = need(loadDescription(options, shippedSources()));
        for (TargetDesc& each : description.targets)
            if (each.name == target) each.formats = {format};
        return description;
    }
    StoredSurface surface() const { return {Semantic::view_position, format}; }
};

struct Drawn {
    Image image;
    SceneTraits traits;
    bool warned;
};

// The occlusion, or where `target` is named what that holds.
Drawn draw(GlFixture& gl, const Stored& stored, const Scene& scene, const Camera& camera,
           Extent extent, const std::string& target = {})
{
    Description description = stored.description();
    OutputDesc output;
    output.name = "shown";
    output.target.name =
        target.empty() ? findNamed(description.outputs, "ao")->target.name : target;
    description.outputs = {output};
    const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    Frame frame = makeFrame(uploaded, SceneCamera(), extent);
    frame.camera = camera;
    auto made =
        Renderer::create(*gl.device, std::move(description), {extent, {}, {}}, traitsOf(frame));
    bool warned = false;
    for (const Diagnostic& each : made.diagnostics()) warned |= each.code == Code::too_coarse;
    const auto renderer = need(std::move(made));
    need(renderer->render(frame));
    return {gl.read(renderer->output("shown")), traitsOf(frame), warned};
}

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
    const Extent extent = {8, 8};
    for (const Stored& stored :
         {Stored{"hemisphere_box", "depth", Format::depth16},
          Stored{"hemisphere_box", "depth", Format::depth24},
          Stored{"hemisphere_box", "depth", Format::depth32f},
          Stored{"hemisphere_box", "depth", Format::depth16, true},
          Stored{"hemisphere_box", "depth", Format::depth24, true},
          Stored{"hemisphere_box", "depth", Format::depth32f, true},
          Stored{"learnopengl", "position", Format::rgba16f, false, "sound"}}) {
        GlFixture gl;
        CAPTURE(formatInfo(stored.format).name, stored.reversed);
        StressView view;
        view.near_distance = 0.01;
        view.far_distance = 1e4;
        view.reversed = stored.reversed;
        const Camera camera = cameraOf(view, extent);
        double largest = 0;  // error, in steps
        for (double distance = 0.021; distance < 100; distance *= 1.61) {
            const Scene scene = planeView(view, extent, distance, 0).scene;
            const Drawn drawn = draw(gl, stored, scene, camera, extent, stored.target);
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
    const Extent extent = {96, 54};
    for (const StressCase& stress : stressCases()) {
        if (stress.name != "plane_distance" && stress.name != "plane_near_far") continue;
        for (const Stored& stored :
             {Stored{"hemisphere_box", "depth", Format::depth16},
              Stored{"hemisphere_box", "depth", Format::depth24},
              Stored{"sao", "depth", Format::depth16}, Stored{"sao", "depth", Format::depth24},
              Stored{"learnopengl", "position", Format::rgba16f, false, "sound"}}) {
            GlFixture gl;
            for (const StressStep& step : stress.steps) {
                CAPTURE(stress.name, step.label, stored.config, formatInfo(stored.format).name);
                const StressShot shot = stress.shot(step.value, extent);
                const Drawn drawn = draw(gl, stored, shot.scene, shot.camera, extent);
                const PrecisionNeed asked = precisionNeed(drawn.traits, shot.radius, extent.height);
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
    GlFixture gl;
    const Extent extent = {96, 54};
    const auto corner = [&](double near_distance, Format format) {
        StressView view;
        view.eye = {0, 1, 4};
        view.near_distance = near_distance;
        return draw(gl, {"hemisphere_box", "depth", format}, cornerScene(), cameraOf(view, extent),
                    extent);
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
