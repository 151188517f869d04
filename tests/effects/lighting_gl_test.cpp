// SPDX-License-Identifier: MIT
// What must hold for the lighting modules, drawn for real with an occlusion that each test gives.
#include "tests/support/picture.h"

#include <crevice/shipped.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

const char* const kGivenModule = R"({
    "format": 1,
    "targets": {"ao_filtered": {"format": ["r8"]}, "bent_normal": {"format": ["rgba16f", "rgba8"]}},
    "shaders": {"ssao": {"vertex": "common/fullscreen.vert", "fragment": "mine/given.frag"}},
    "passes": {"ssao": {"type": "fullscreen", "shader": "ssao",
                        "color": ["ao_filtered", "bent_normal"]}},
    "outputs": {"ao": "ao_filtered"}})";

std::string givenShader(const std::string& ao)
{
    return R"(#version 300 es
precision highp float;
#include <surface>
in vec2 uv;
layout(location = 0) out float ao_filtered;
layout(location = 1) out vec4 bent_normal;
void main()
{
    vec3 point;
    bool seen = viewPosition(uv, point);
    bent_normal = vec4(seen ? normalAt(uv) * 0.5 + 0.5 : vec3(0.5, 0.5, 1.0), 1.0);
    ao_filtered = seen ? )" +
           ao + " : 1.0; }\n";
}

Scene glossySpheres()
{
    Scene scene = need(loadScene("spheres"));
    for (SceneMaterial& material : scene.materials) material.specular = glm::vec3(0.5f);
    return scene;
}

/// The lit picture where an estimator says `ao` of every surface and bends no normal.
Image lit(const std::string& ao, std::vector<std::string> overrides, const Scene& scene,
          const std::string& lighting = "deferred", const std::string& geometry = "depth_normal",
          const std::function<void(Frame&)>& change = {})
{
    MemorySources mine;
    mine.add("mine/given.frag", givenShader(ao));
    mine.add("mine/given.json", kGivenModule);
    mine.add("configs/given.json", R"({"format": 1, "extends": ["geometry/)" + geometry +
                                       R"(", "mine/given", "lighting/)" + lighting + "\"]}");
    const LayeredSources sources({&mine, &shippedSources()});
    PictureRequest request;
    request.config = "given";
    request.overrides = std::move(overrides);
    request.output = "color";
    request.sources = &sources;
    request.change = change;
    return picture(request, scene);
}

const SourceSet& forwardSources()
{
    static const MemorySources sources = [] {
        MemorySources mine;
        mine.add("configs/forward.json", R"({"format": 1, "extends": ["geometry/depth_normal",
            "ssao/sphere", "filter/box", "lighting/forward"]})");
        return mine;
    }();
    return sources;
}

const std::string kReflections[] = {"lambert", "phong", "blinn_phong"};

}  // namespace

TEST_CASE("Full occlusion of the ambient light alone leaves what lights bring")
{
    const Scene scene = glossySpheres();
    for (const std::string& reflection : kReflections) {
        INFO(reflection);
        const std::string chosen = "reflection=" + reflection;
        const Image lights = lit("1.0", {chosen, "ambient=0"}, scene);
        CHECK(mean(lights) > 0.1);
        CHECK(meanChange(lit("0.0", {chosen}, scene), lights) == 0.0);
        const Image dark =
            lit("0.0", {chosen, "ao_on=everything", "background_color=[0,0,0]"}, scene);
        CHECK(mean(dark) == 0.0);
    }
}

TEST_CASE("Full openness lights as without occlusion, whatever occlusion would do")
{
    const Scene scene = glossySpheres();
    const Image without = lit("0.0", {"display=no_ao", "reflection=phong"}, scene);
    for (const char* choice : {"ao_on=everything", "specular_occlusion=ao",
                               "specular_occlusion=bent", "multi_bounce=true"}) {
        INFO(choice);
        CHECK(meanChange(lit("1.0", {choice, "reflection=phong"}, scene), without) < 0.0005);
    }
}

TEST_CASE("The three reflections differ in their highlights alone")
{
    const Scene matte = need(loadScene("spheres"));
    const Scene glossy = glossySpheres();
    const Image lambert = lit("1.0", {"reflection=lambert"}, glossy);
    for (const char* shiny : {"reflection=phong", "reflection=blinn_phong"}) {
        INFO(shiny);
        CHECK(mean(lit("1.0", {shiny, "specular_power=4"}, glossy)) > mean(lambert) + 0.0005);
        Scene dull = matte;
        for (SceneMaterial& material : dull.materials) material.specular = glm::vec3(0.0f);
        CHECK(meanChange(lit("1.0", {shiny}, dull), lambert) == 0.0);
    }
    CHECK(meanChange(lit("1.0", {}, glossy, "blinn_phong"),
                     lit("1.0", {"reflection=blinn_phong"}, glossy)) == 0.0);
}

TEST_CASE("Bounces lighten corners, bright ones by more, and never darken")
{
    Scene scene = need(loadScene("spheres"));
    const auto gain = [&](float albedo, const char* ao) {
        for (SceneMaterial& material : scene.materials) {
            material.base_color = glm::vec4(glm::vec3(albedo), 1.0f);
            material.base_color_texture = -1;
        }
        const Image once = lit(ao, {"ambient=1"}, scene);
        const Image often = lit(ao, {"ambient=1", "multi_bounce=true"}, scene);
        for (std::size_t i = 0; i < once.pixels.size(); ++i)
            REQUIRE(often.pixels[i] >= once.pixels[i]);
        return mean(often) / mean(once);
    };
    CHECK(gain(0.9f, "0.5") > 1.05);
    CHECK(gain(0.9f, "0.5") > gain(0.3f, "0.5"));
    CHECK(gain(0.9f, "0.0") == 1.0);
}

TEST_CASE("A material's ambient scales its ambient light alone, and no other material's")
{
    const Scene scene = glossySpheres();
    const auto half_light = [](Frame& frame) { frame.ambient_light *= 0.5f; };
    const auto half_material = [](Frame& frame) { frame.materials[0].ambient = 0.5f; };
    const auto check = [&](const char* geometry, const std::string& lighting, const char* ao) {
        INFO(geometry << " " << lighting << " " << ao);
        const std::vector<std::string> chosen = {"ambient=1", "multi_bounce=true"};
        const Image full = lit(ao, chosen, scene, lighting, geometry);
        const Image half = lit(ao, chosen, scene, lighting, geometry, half_light);
        const Image mixed = lit(ao, chosen, scene, lighting, geometry, half_material);
        int dimmed = 0, same = 0, wrong = 0;
        for (std::size_t i = 0; i < mixed.pixels.size(); ++i) {
            if (std::abs(full.pixels[i] - half.pixels[i]) < 0.02f) continue;
            const bool as_half = std::abs(mixed.pixels[i] - half.pixels[i]) < 1.5f / 255;
            ++(mixed.pixels[i] == full.pixels[i] ? same : as_half ? dimmed : wrong);
        }
        CHECK(dimmed > 1000);
        CHECK(same > 1000);
        CHECK(wrong == 0);
    };
    for (const char* ao : {"1.0", "0.5"}) {
        check("depth_normal", "forward", ao);
        check("depth_normal", "deferred", ao);
    }
    check("depth_normal", "blinn_phong", "0.5");
    check("depth_normal", "deferred\", \"lighting/baked", "0.5");
    check("depth_only", "deferred", "0.5");
    check("linear_depth_normal", "deferred", "0.5");
    check("position_normal", "blinn_phong", "0.5");
}

TEST_CASE("A material's ambient counts from 0 to 1, and full occlusion leaves nothing of it")
{
    const Scene scene = glossySpheres();
    for (const char* lighting : {"blinn_phong", "forward"}) {
        INFO(lighting);
        const auto with = [&](float ambient, const char* ao = "0.5") {
            return lit(ao, {}, scene, lighting, "depth_normal", [ambient](Frame& frame) {
                for (Material& material : frame.materials) material.ambient = ambient;
            });
        };
        const Image full = lit("0.5", {}, scene, lighting);
        CHECK(meanChange(with(1), full) == 0.0);
        CHECK(meanChange(with(2), full) == 0.0);
        CHECK(meanChange(with(-1), with(0)) == 0.0);
        CHECK(meanChange(with(0), lit("0.0", {}, scene, lighting)) == 0.0);
        CHECK(meanChange(with(0.5f, "0.0"), with(0)) == 0.0);
    }
}

TEST_CASE("Occlusion of highlights takes them away where all is blocked, and less where less is")
{
    const Scene scene = glossySpheres();
    const Image none = lit("0.0", {"reflection=lambert"}, scene);
    for (const char* how : {"specular_occlusion=ao", "specular_occlusion=bent"}) {
        INFO(how);
        const auto highlights = [&](const char* ao) {
            return mean(lit(ao, {how, "reflection=phong", "ambient=0"}, scene)) - mean(none);
        };
        CHECK(highlights("0.0") == 0.0);
        CHECK(highlights("0.5") > highlights("0.1"));
        CHECK(highlights("1.0") > highlights("0.5") - 0.0001);
    }
}

TEST_CASE("Occluded highlights keep the share that the papers give, by how sharp they are")
{
    Scene scene = need(loadScene("plane"));
    scene.materials[0].base_color = {0, 0, 0, 1};
    scene.materials[0].specular = glm::vec3(0.5f);
    Light light;
    light.position = {0, 3, 0};
    light.color = glm::vec3(1.8f);
    scene.lights = {{"light", light}};
    scene.cameras[0].view_from_world =
        glm::lookAt(glm::dvec3(0, 3, 0), glm::dvec3(0), glm::dvec3(0, 0, -1));
    const double open = std::round(0.5 * 255) / 255;
    for (const double exponent : {1.0, 4.0, 64.0, 4000.0}) {
        INFO("exponent " << exponent);
        const auto highlight = [&](const std::string& how) {
            const std::string power = "specular_power=" + std::to_string(exponent);
            const double shown =
                lit("0.5", {"specular_occlusion=" + how, power, "reflection=phong", "ambient=0"},
                    scene)
                    .at(64, 36);
            return std::pow((shown + 0.055) / 1.055, 2.4);
        };
        const double whole = highlight("none");
        CHECK(whole > 0.2);
        // Lagarde, de Rousiers 2014, seen at a right angle.
        const double roughness = std::sqrt(2 / (exponent + 2));
        const double by_ao = std::pow(1 + open, std::exp2(-16 * roughness - 1)) - 1 + open;
        CHECK(highlight("ao") / whole == Approx(by_ao).margin(0.015));
        // Jimenez et al. 2016: the cap of open directions over the lobe's, which it lies within.
        const double lobe = std::pow(0.01, 1 / exponent);
        const double by_cones = std::min((1 - std::sqrt(1 - open)) / (1 - lobe), 1.0);
        CHECK(highlight("bent") / whole == Approx(by_cones).margin(0.015));
    }
}

TEST_CASE("A transparent background has alpha 0 there and 1 on every surface")
{
    const Scene scene = glossySpheres();
    PictureRequest request;
    request.camera = "eye=0,1,9;at=0,2,0;fov=40";
    request.output = "color";
    request.config = "hemisphere_box";
    request.overrides = {"background=transparent"};
    const Image image = picture(request, scene);
    request.overrides = {};
    const Image opaque = picture(request, scene);
    int holes = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x) {
            CHECK(opaque.at(x, y, 3) == 1.0f);
            if (image.at(x, y, 3) == 1.0f) {
                CHECK(image.at(x, y, 0) == opaque.at(x, y, 0));
                continue;
            }
            ++holes;
            for (int channel = 0; channel < 4; ++channel) CHECK(image.at(x, y, channel) == 0.0f);
        }
    CHECK(holes > 100);
    CHECK(holes < image.extent.width * image.extent.height - 100);
}

TEST_CASE("A spot lights its cone like a point light, and nothing outside")
{
    Scene scene = need(loadScene("plane"));
    Light light;
    light.position = {0, 3, 0};
    light.direction = {0, -1, 0};
    scene.lights = {{"light", light}};
    const auto drawn = [&] {
        PictureRequest request;
        request.camera = "eye=0,6,0.01;at=0,0,0;fov=60";
        request.output = "color";
        request.overrides = {"ambient=0", "reflection=lambert"};
        return picture(request, scene);
    };
    const Image point = drawn();
    scene.lights[0].light.spot = true;
    scene.lights[0].light.inner_angle_rad = 0.2f;
    scene.lights[0].light.outer_angle_rad = 0.4f;
    const Image spot = drawn();
    CHECK(point.at(2, 36) > 0.3f);
    CHECK(spot.at(2, 36) == 0.0f);
    CHECK(spot.at(64, 36) == point.at(64, 36));
    CHECK(mean(spot) < mean(point) / 4);
    // Between the angles the square of a ramp of the cosine: pixel 73 is seen 0.296 rad off.
    const double off = std::atan(9.5 / 36 * std::tan(0.5236) * 6 / 3);
    const double ramp = (std::cos(off) - std::cos(0.4)) / (std::cos(0.2) - std::cos(0.4));
    const double seen = std::pow(spot.at(73, 36) / point.at(73, 36), 2.2);  // of encoded values
    CHECK(seen == Approx(ramp * ramp).margin(0.03));
    scene.lights[0].light.outer_angle_rad = scene.lights[0].light.inner_angle_rad = 3.1415927f;
    CHECK(meanChange(drawn(), point) < 0.001);
}

TEST_CASE("A directional light does not fade with distance")
{
    Scene scene = need(loadScene("plane"));
    Light light;
    light.directional = true;
    light.direction = {0, -1, 0};
    light.color = glm::vec3(0.5f);
    const auto drawn = [&](const glm::vec3& attenuation) {
        light.attenuation = attenuation;
        scene.lights = {{"light", light}};
        PictureRequest request;
        request.camera = "eye=0,6,0.01;at=0,0,0;fov=60";
        request.output = "color";
        request.overrides = {"ambient=0", "reflection=lambert"};
        return picture(request, scene);
    };
    const Image lit = drawn({1, 0, 0});
    CHECK(lit.at(64, 36) > 0.3f);
    CHECK(meanChange(drawn({1, 2, 3}), lit) == 0);
}

TEST_CASE("Forward lighting draws what deferred lighting draws")
{
    const Scene scene = glossySpheres();
    PictureRequest request;
    request.output = "color";
    request.camera = "eye=0,2,4;at=0,0.3,0;fov=40";
    for (const char* display : {"lit", "no_ao", "ao_only"}) {
        INFO(display);
        request.overrides = {std::string("display=") + display, "reflection=phong"};
        request.config = "sphere_box";
        const Image deferred = picture(request, scene);
        const LayeredSources sources({&forwardSources(), &shippedSources()});
        request.sources = &sources;
        request.config = "forward";
        if (request.overrides[0] == "display=ao_only")
            request.overrides.push_back("/passes/lighting/clear/color=[1, 1, 1, 1]");
        CHECK(meanChange(picture(request, scene), deferred) < 0.004);
        request.sources = nullptr;
    }
}
