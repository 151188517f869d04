// SPDX-License-Identifier: MIT
// Figures with params off their defaults, for which tools/scripts/guard_bench.sh has none: how far
// occlusion is from the ray-traced ground truth, and light from light without occlusion, at two
// radii and two shapes of picture.
//
// Both bounds count: a fault in a shader may well bring its picture nearer to the ground truth.
// Where a change of a shader is meant, take the figures that the failing test prints.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_metrics.h"

#include <map>

using namespace crevice;

namespace {

/// How far a figure may be off: another driver's last bits move it by a tenth of this.
constexpr double kMargin = 0.001;

constexpr int kRays = 64;

/// A part of the scene of spheres, of which the edges of the picture cut some.
struct View {
    const char* camera;
    Extent extent;
    double radius;
};

const View kClose = {"close", {96, 96}, 0.4};
const View kWide = {"eye=0.3,0.9,2.4;at=0.15,0.3,0;fov=34", {161, 65}, 1.5};  // and odd

using Overrides = std::vector<std::string>;

struct Row {
    const char* config;
    const View& view;
    Overrides overrides;
    double rmse;
    double bias;
};

const Row kOcclusion[] = {
    {"mobile", kClose, {"intensity=1.6", "power=1.7"}, 0.1766, -0.1052},
    {"high", kWide, {"intensity=0.6", "power=2.5"}, 0.0741, -0.0484},
    {"hbao", kClose, {"intensity=0.7", "power=1.5"}, 0.2107, 0.1485},
    {"ssdo", kWide, {"intensity=1.5", "power=0.6"}, 0.2290, -0.0327},
    {"sao", kClose, {"intensity=0.5", "power=4"}, 0.2015, 0.1170},
    {"gtao", kClose, {"bias=0.1"}, 0.1031, 0.0537},
    {"gtao", kWide, {"guard_band=1"}, 0.0922, 0.0127},
    {"gtao", kClose, {"max_gap=0.5"}, 0.1610, 0.0912},
    {"bitmask", kWide, {"thickness=0.1"}, 0.0644, 0.0296},
    {"bitmask", kClose, {"thickness=2", "bias=0.05"}, 0.1286, -0.0445},
    {"balanced", kWide, {"guard_band=1.5", "max_gap=0.4"}, 0.0636, 0.0208},
    {"hbao", kWide, {"bias=0.08", "angle_bias=30"}, 0.1230, 0.0802},
    {"hbao", kClose, {"light=cosine", "falloff=0.3", "thin_occluders=count"}, 0.2589, -0.1690},
    {"sao", kWide, {"bias=0.15"}, 0.2150, 0.1153},
    {"sao", kWide, {"curve=steep"}, 0.3035, -0.1733},
    {"levels", kWide, {"power=1"}, 0.2409, 0.1595},
    {"ssdo", kClose, {"bias=0.2"}, 0.1578, 0.0574},
    {"ssdo", kClose, {"bias_length=0.05", "bias_along=normal"}, 0.1224, 0.0006},
    {"gtao", kWide, {"rotation=gradient", "slices=1", "steps=5"}, 0.0765, 0.0057},
    {"gtao_temporal", kWide, {"intensity=1.5", "bias=0.05"}, 0.0877, -0.0495},
    {"balanced_temporal", kClose, {"guard_band=1"}, 0.0561, 0.0097},
    {"bitmask_layers", kClose, {"thickness=1"}, 0.0543, 0.0205},
};

const Row kLight[] = {
    {"bent", kClose, {"specular_occlusion=bent", "ambient=0", "specular_power=2"}, 0.0391, -0.0256},
    {"bent", kWide, {"specular_occlusion=bent", "ambient=0", "specular_power=9"}, 0.0144, -0.0042},
    {"gtao", kClose, {"specular_occlusion=ao", "ambient=0", "specular_power=20"}, 0.0030, -0.0007},
    {"gtao", kWide, {"specular_occlusion=ao", "ambient=0", "specular_power=4"}, 0.0198, -0.0094},
    {"gtao", kWide, {"ambient=1", "multi_bounce=true"}, 0.0658, -0.0254},
    {"balanced", kClose, {"ambient=0.7", "ao_on=everything"}, 0.1314, -0.0727},
    {"ssdo", kWide, {"bounce=3"}, 0.0386, -0.0125},
    {"ssdo", kClose, {}, 0.0348, -0.0172},
    {"mobile", kWide, {"ambient=1"}, 0.1045, -0.0510},
};

/// The shipped configs, and two with what ships beside them.
const SourceSet& configs()
{
    static const GivenConfig config(
        {}, "",
        {{"configs/bent.json", R"({"format": 1, "extends": ["gtao", "ssao/bent_normals"]})"},
         {"configs/levels.json", R"({"format": 1, "extends": ["sao", "geometry/depth_levels"]})"}});
    return config.sources();
}

/// The spheres, all glossy, and a light that is low enough to shine under them.
Scene glossySpheres()
{
    Scene scene = need(loadScene("spheres"));
    for (SceneMaterial& material : scene.materials) material.specular = glm::vec3(0.5f);
    scene.lights[0].light.position = {1.5, 0.6, 1.6};
    scene.lights[0].light.color = glm::vec3(1);
    return scene;
}

/// The scene, and what was traced of it.
struct Spheres : SceneRig {
    Spheres() : SceneRig(glossySpheres()) {}

    Image drawn(const Row& row, const char* output, const Overrides& more = {})
    {
        Overrides overrides = {"radius=" + std::to_string(row.view.radius)};
        for (const Overrides* each : {&row.overrides, &more})
            overrides.insert(overrides.end(), each->begin(), each->end());
        extent = row.view.extent;
        return draw(descriptionOf({row.config}, overrides, configs()), frame(row.view.camera),
                    output, 0);
    }

    const Image& groundTruth(const View& view)
    {
        const auto known = traced.find(&view);
        if (known != traced.end()) return known->second;
        extent = view.extent;
        return traced[&view] = need(traceAmbientOcclusion(scene, frame(view.camera).camera, extent,
                                                          {view.radius, kRays}));
    }

    std::map<const View*, Image> traced;
};

void checkFigures(const Row& row, const Image& drawn, const Image& expected)
{
    const ImageDifference figures = need(compareImages(drawn, expected));
    INFO(row.config << (&row.view == &kWide ? " wide " : " close ")
                    << Catch::Detail::stringify(row.overrides) << ": " << figures.rmse << ", "
                    << figures.bias);
    CHECK(figures.rmse == Approx(row.rmse).epsilon(0).margin(kMargin));
    CHECK(figures.bias == Approx(row.bias).epsilon(0).margin(kMargin));
}

}  // namespace

TEST_CASE("Occlusion by params off their defaults is as far from the ground truth as it was")
{
    Spheres spheres;
    for (const Row& row : kOcclusion)
        checkFigures(row, spheres.drawn(row, "ao"), spheres.groundTruth(row.view));
}

TEST_CASE("Occlusion takes as much of the light of lit pictures as it did")
{
    Spheres spheres;
    for (const Row& row : kLight)
        checkFigures(row, spheres.drawn(row, "color"),
                     spheres.drawn(row, "color", {"display=no_ao"}));
}
