// SPDX-License-Identifier: MIT
// What must hold for the lighting modules, drawn for real with an occlusion that each test gives.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

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

using Change = std::function<void(Frame&)>;

struct Lighting : SceneRig {
    Lighting() : SceneRig(glossySpheres()) {}

    /// The lit picture where an estimator says `ao` of every surface and bends no normal.
    Image lit(const std::string& ao, const std::vector<std::string>& overrides,
              const std::string& lighting = "deferred",
              const std::string& geometry = "depth_normal", const Change& change = {})
    {
        const GivenConfig config(
            {"geometry/" + geometry, "mine/given", "lighting/" + lighting}, "",
            {{"mine/given.frag", givenShader(ao)}, {"mine/given.json", kGivenModule}});
        Frame seen = frame();
        if (change) change(seen);
        return draw(config.description(overrides), seen, "color");
    }

    /// A shipped config's.
    Image color(const std::vector<std::string>& overrides, const char* camera)
    {
        return draw(descriptionOf({"hemisphere_box"}, overrides), frame(camera), "color");
    }

    /// A plane from above, under one light alone.
    Image underLight(const Light& light)
    {
        Scene plane = need(loadScene("plane"));
        plane.lights = {{"light", light}};
        show(plane);
        return color({"ambient=0", "reflection=lambert"}, "eye=0,6,0.01;at=0,0,0;fov=60");
    }
};

}  // namespace

TEST_CASE_METHOD(Lighting, "Full occlusion of the ambient light alone leaves what lights bring")
{
    for (const std::string reflection : {"lambert", "phong", "blinn_phong"}) {
        INFO(reflection);
        const std::string chosen = "reflection=" + reflection;
        const Image lights = lit("1.0", {chosen, "ambient=0"});
        CHECK(mean(lights) > 0.1);
        CHECK(meanChange(lit("0.0", {chosen}), lights) == 0.0);
        const Image dark = lit("0.0", {chosen, "ao_on=everything", "background_color=[0,0,0]"});
        CHECK(mean(dark) == 0.0);
    }
}

TEST_CASE_METHOD(Lighting,
                 "A material's ambient scales its ambient light alone, and no other material's")
{
    const auto half_light = [](Frame& frame) { frame.ambient_light *= 0.5f; };
    const auto half_material = [](Frame& frame) { frame.materials[0].ambient = 0.5f; };
    const auto check = [&](const char* geometry, const std::string& lighting, const char* ao) {
        INFO(geometry << " " << lighting << " " << ao);
        const std::vector<std::string> chosen = {"ambient=1", "multi_bounce=true"};
        const Image full = lit(ao, chosen, lighting, geometry);
        const Image half = lit(ao, chosen, lighting, geometry, half_light);
        const Image mixed = lit(ao, chosen, lighting, geometry, half_material);
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
    check("depth_normal", "forward", "1.0");
    check("depth_normal", "deferred", "0.5");
    check("linear_depth_normal", "deferred", "0.5");
    check("position_normal", "blinn_phong", "0.5");
}

TEST_CASE_METHOD(Lighting,
                 "Occluded highlights keep the share that the papers give, by how sharp they are")
{
    Scene plane = need(loadScene("plane"));
    plane.materials[0].base_color = {0, 0, 0, 1};
    plane.materials[0].specular = glm::vec3(0.5f);
    Light light;
    light.position = {0, 3, 0};
    light.color = glm::vec3(1.8f);
    plane.lights = {{"light", light}};
    plane.cameras[0].view_from_world =
        glm::lookAt(glm::dvec3(0, 3, 0), glm::dvec3(0), glm::dvec3(0, 0, -1));
    show(plane);
    const double open = std::round(0.5 * 255) / 255;
    for (const double exponent : {1.0, 4.0, 64.0, 4000.0}) {
        INFO("exponent " << exponent);
        const auto highlight = [&](const std::string& how) {
            const std::string power = "specular_power=" + std::to_string(exponent);
            const double shown =
                lit("0.5", {"specular_occlusion=" + how, power, "reflection=phong", "ambient=0"})
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

TEST_CASE_METHOD(Lighting, "A transparent background has alpha 0 there and 1 on every surface")
{
    const char* const camera = "eye=0,1,9;at=0,2,0;fov=40";
    const Image image = color({"background=transparent"}, camera), opaque = color({}, camera);
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

TEST_CASE_METHOD(Lighting, "A spot lights its cone like a point light, and nothing outside")
{
    Light light;
    light.position = {0, 3, 0};
    light.direction = {0, -1, 0};
    const Image point = underLight(light);
    light.spot = true;
    light.inner_angle_rad = 0.2f;
    light.outer_angle_rad = 0.4f;
    const Image spot = underLight(light);
    CHECK(point.at(2, 36) > 0.3f);
    CHECK(spot.at(2, 36) == 0.0f);
    CHECK(spot.at(64, 36) == point.at(64, 36));
    CHECK(mean(spot) < mean(point) / 4);
    // Between the angles the square of a ramp of the cosine: pixel 73 is seen 0.296 rad off.
    const double off = std::atan(9.5 / 36 * std::tan(0.5236) * 6 / 3);
    const double ramp = (std::cos(off) - std::cos(0.4)) / (std::cos(0.2) - std::cos(0.4));
    const double seen = std::pow(spot.at(73, 36) / point.at(73, 36), 2.2);  // of encoded values
    CHECK(seen == Approx(ramp * ramp).margin(0.03));
    light.outer_angle_rad = light.inner_angle_rad = 3.1415927f;
    CHECK(meanChange(underLight(light), point) < 0.001);
}

TEST_CASE_METHOD(Lighting, "A directional light does not fade with distance")
{
    Light light;
    light.directional = true;
    light.direction = {0, -1, 0};
    light.color = glm::vec3(0.5f);
    light.attenuation = {1, 0, 0};
    const Image near = underLight(light);
    CHECK(near.at(64, 36) > 0.3f);
    light.attenuation = {1, 2, 3};
    CHECK(meanChange(underLight(light), near) == 0);
}

TEST_CASE_METHOD(Lighting, "Forward lighting draws what deferred lighting draws")
{
    const GivenConfig forward(
        {"geometry/depth_normal", "ssao/sphere", "filter/box", "lighting/forward"});
    const Frame seen = frame("eye=0,2,4;at=0,0.3,0;fov=40");
    for (const std::string display : {"lit", "no_ao", "ao_only"}) {
        INFO(display);
        std::vector<std::string> overrides = {"display=" + display, "reflection=phong"};
        const Image deferred = draw(descriptionOf({"sphere_box"}, overrides), seen, "color");
        if (display == "ao_only") overrides.push_back("/passes/lighting/clear/color=[1, 1, 1, 1]");
        CHECK(meanChange(draw(forward.description(overrides), seen, "color"), deferred) < 0.004);
    }
}

TEST_CASE_METHOD(Lighting,
                 "What is blended takes and casts no AO and covers by its alpha, far first")
{
    const auto encoded = [](float linear) { return 1.055 * std::pow(linear, 1 / 2.4) - 0.055; };
    Frame clear = frame("eye=0,2,4;at=0,0.3,0;fov=40");
    clear.lights.clear();
    clear.ambient_light = glm::vec3(1.0f);
    // Spheres about the eye's axis: green before red, and one behind the ground.
    Frame panes = clear;
    const auto add = [&](const glm::vec4& color, const glm::dvec3& at) {
        DrawItem item = clear.draws.back();
        item.world_from_model = glm::scale(glm::translate(glm::dmat4(1), at), glm::dvec3(0.3));
        item.material = static_cast<int>(panes.materials.size());
        panes.draws.push_back(item);
        panes.materials.emplace_back().base_color = color;
        panes.materials.back().blended = true;
    };
    add({0.2f, 0.6f, 0.1f, 0.5f}, {0, 1.575, 3});
    add({0.7f, 0.1f, 0.1f, 0.25f}, {0, 1.15, 2});
    add({1, 1, 1, 1}, {0, -0.55, -2});
    const std::size_t count = panes.draws.size();
    Frame turned = panes;
    std::swap(turned.draws[count - 3], turned.draws[count - 2]);
    for (const std::string config : {"sphere_box", "mobile_low", "mobile_low, four samples"}) {
        INFO(config);
        const bool samples = config.size() > 12;
        const auto drawn = [&](const Frame& seen, const char* output) {
            std::vector<std::string> overrides = {"ambient=1"};
            if (samples) overrides.emplace_back("msaa=4");
            return draw(descriptionOf({samples ? "mobile_low" : config}, overrides), seen, output);
        };
        CHECK(meanChange(drawn(panes, "ao"), drawn(clear, "ao")) == 0);
        const Image under = drawn(clear, "color"), over = drawn(panes, "color");
        CHECK(meanChange(drawn(turned, "color"), over) == 0);
        CHECK(over.at(2, 70) == under.at(2, 70));
        for (int channel = 0; channel < 3; ++channel) {
            const double red = channel == 0 ? 0.7 : 0.1, green[] = {0.2, 0.6, 0.1};
            const double behind = 0.75 * under.at(64, 36, channel) + 0.25 * encoded(float(red));
            const double seen = 0.5 * behind + 0.5 * encoded(float(green[channel]));
            CHECK(over.at(64, 36, channel) == Approx(seen).margin(2.0 / 255));
        }
    }
}

TEST_CASE_METHOD(Lighting,
                 "Metallic-roughness keeps the light of a furnace, and adds a surface's own")
{
    const auto shown = [&](const std::string& ao, const auto& change,
                           std::vector<std::string> overrides = {}) {
        overrides.insert(overrides.end(), {"tone_mapping=none", "sky_color=[0.5,0.5,0.5]",
                                           "ground_color=[0.5,0.5,0.5]", "ambient=1"});
        const auto changed = [&](Frame& frame) {
            frame.lights.clear();
            frame.ambient_light = glm::vec3(1.0f);
            for (Material& material : frame.materials) {
                material.base_color = {1, 1, 1, 1};
                change(material);
            }
        };
        const double seen =
            lit(ao, overrides, "metallic_roughness", "depth_normal", changed).at(64, 30);
        return std::pow((seen + 0.055) / 1.055, 2.4);
    };
    for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f}) {
        INFO("roughness " << roughness);
        const auto surface = [roughness](float metallic) {
            return [=](Material& material) {
                material.metallic = metallic;
                material.roughness = roughness;
            };
        };
        CHECK(shown("1.0", surface(0)) == Approx(0.5).margin(0.01));
        CHECK(shown("1.0", surface(1)) == Approx(0.5).margin(0.01));
        CHECK(shown("0.0", surface(0)) < 0.02);
    }
    const auto glows = [](Material& material) { material.emission = glm::vec3(0.25f); };
    CHECK(shown("0.0", glows, {"ambient=0"}) == Approx(0.25).margin(0.01));
    const auto unlit = [](Material& material) {
        material.unlit = true;
        material.base_color = {0.3f, 0.3f, 0.3f, 1};
    };
    CHECK(shown("0.0", unlit) == Approx(0.3).margin(0.01));
}

TEST_CASE_METHOD(Lighting,
                 "AO of no strength, of floor 1, white or faded out is none in the lit picture")
{
    for (const std::string lighting : {"deferred", "forward"}) {
        INFO(lighting);
        const Image none = lit("0.25", {"display=no_ao"}, lighting);
        CHECK(meanChange(lit("0.25", {}, lighting), none) > 0.02);
        for (const char* param :
             {"ao_strength=0", "ao_floor=1", "ao_color=[1,1,1]", "ao_fade=1e-3"})
            CHECK(meanChange(lit("0.25", {param}, lighting), none) == 0);
        CHECK(meanChange(lit("0.25", {"ao_floor=0.5"}, lighting), lit("0.5", {}, lighting)) <
              0.002);
        CHECK(meanChange(lit("0.25", {"ao_fade=1e3"}, lighting), lit("0.25", {}, lighting)) == 0);
    }
}
