// SPDX-License-Identifier: MIT
// What must hold for every filter over the occlusion, drawn for real.
#include "tests/support/modules.h"
#include "tests/support/picture.h"

#include <crevice/compile.h>
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/shipped.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace crevice;

namespace {

// A plane that fills the picture, at a slant.
const char* const kSlant = "eye=0,2,1;at=0,0,0;fov=30";

// A value for each pixel of a tile of 4x4; their mean is a half.
const char* const kTile =
    "(mod(floor(gl_FragCoord.x), 4.0) + 4.0 * mod(floor(gl_FragCoord.y), 4.0)) / 15.0";

const char* const kGiven = R"({
    "format": 1,
    "params": {"radius": {"default": 0.5}},
    "targets": {"ao": {"format": ["r8"]}},
    "shaders": {"ssao": {"vertex": "common/fullscreen.vert", "fragment": "ssao/given.frag"}},
    "passes": {"ssao": {"type": "fullscreen", "shader": "ssao", "color": ["ao"]}}})";

std::string givenShader(const std::string& ao)
{
    return R"(#version 300 es
precision highp float;
#include <surface>
uniform float radius;
in vec2 uv;
layout(location = 0) out float ao;
void main() { vec3 point; ao = viewPosition(uv, point) && radius > 0.0 ? )" +
           ao + " : 1.0; }\n";
}

struct Given {
    std::string ao;  ///< GLSL: what an estimator writes at a pixel that sees a surface.
    std::string filter;
    std::string scene = "plane";
    std::string camera = kSlant;
    std::vector<std::string> overrides = {};
    std::string geometry = "depth_normal";
    Extent extent = {128, 72};
};

MemorySources sourcesOf(const Given& given)
{
    MemorySources mine;
    mine.add("ssao/given.frag", givenShader(given.ao));
    mine.add("ssao/given.json", kGiven);
    mine.add("configs/given.json", R"({"format": 1, "extends": ["geometry/)" + given.geometry +
                                       R"(", "ssao/given", "filter/)" + given.filter + "\"]}");
    return mine;
}

Image filtered(const Given& given)
{
    const MemorySources mine = sourcesOf(given);
    const LayeredSources sources({&mine, &shippedSources()});
    PictureRequest request;
    request.config = "given";
    request.scene = given.scene;
    request.camera = given.camera;
    request.overrides = given.overrides;
    request.sources = &sources;
    request.extent = given.extent;
    return picture(request);
}

/// The passes that the output `ao` needs.
std::size_t passCount(const Given& given)
{
    const MemorySources mine = sourcesOf(given);
    const LayeredSources sources({&mine, &shippedSources()});
    const Node document = need(loadConfig(sources, {"given", {}, given.overrides}));
    const Description description = need(decode(document, sources));
    return need(compile(description, {}, RecordingDevice().caps(), {given.extent, {"ao"}, {}}))
        .passes.size();
}

/// Those over the occlusion of one frame and nothing else.
std::vector<std::string> filters()
{
    std::vector<std::string> names;
    for (const Module& filter : shippedFilters())
        if (!filter.remembers && filter.needs.size() == filter.needs.count("ao"))
            names.push_back(filter.name.substr(sizeof("filter")));
    return names;
}

/// Least and greatest at least 16 pixels from the border, where no window is cut off.
std::pair<float, float> rangeInside(const Image& image)
{
    std::pair<float, float> range(1e9f, -1e9f);
    for (int y = 16; y < image.extent.height - 16; ++y)
        for (int x = 16; x < image.extent.width - 16; ++x) {
            range.first = std::min(range.first, image.at(x, y));
            range.second = std::max(range.second, image.at(x, y));
        }
    return range;
}

/// The share of pixels that are neither near 0.2 nor above 0.78.
double shareBetween(const Image& image)
{
    return shareBelow(image, 0.78f) - shareBelow(image, 0.22f);
}

}  // namespace

TEST_CASE("Filters keep a constant picture constant")
{
    for (const std::string& filter : filters()) {
        const Image image = filtered({"0.6", filter});
        INFO(filter);
        for (float value : image.pixels) REQUIRE(value == image.pixels.front());
        CHECK(image.pixels.front() == Approx(0.6f).margin(1.01f / 255));
    }
}

TEST_CASE("Filters keep 1 exactly, whatever the size and the projection")
{
    for (const std::string& filter : filters())
        for (const char* camera : {kSlant, "eye=0,2,1;at=0,0,0;ortho=1"})
            for (const Extent extent : {Extent{97, 51}, Extent{1, 1}, Extent{1, 37}}) {
                INFO(filter << " " << camera << " " << extent.width << "x" << extent.height);
                Given given = {"1.0", filter};
                given.camera = camera;
                given.extent = extent;
                CHECK(mean(filtered(given)) == 1.0);
            }
}

TEST_CASE("Filters keep 1 exactly at any radius")
{
    for (const std::string& filter : filters())
        for (const char* radius : {"radius=1e-9", "radius=1e9"}) {
            INFO(filter << " " << radius);
            Given given = {"1.0", filter, "spheres", ""};
            given.overrides = {radius};
            CHECK(mean(filtered(given)) == 1.0);
        }
}

TEST_CASE("Noise that repeats every four pixels leaves no trace on a plane")
{
    for (const char* filter :
         {"box", "bilateral_normal", "edges3x3", "atrous", "kuwahara", "upsample"}) {
        const auto range = rangeInside(filtered({kTile, filter}));
        INFO(filter << " " << range.first << " to " << range.second);
        CHECK(range.first > 0.5f - 3.01f / 255);
        CHECK(range.second < 0.5f + 3.01f / 255);
    }
}

TEST_CASE("Steps of a coarse depth keep no filter from a plane that they are stored of")
{
    for (const char* filter : {"bilateral_normal", "atrous", "upsample"}) {
        Given given = {kTile, filter};
        given.camera = "eye=0,8,4;at=0,0,0;fov=7.5";
        given.overrides = {"/targets/depth/format=[\"depth16\"]", "radius=50"};
        const auto range = rangeInside(filtered(given));
        INFO(filter << " " << range.first << " to " << range.second);
        CHECK(range.first > 0.5f - 5.01f / 255);
        CHECK(range.second < 0.5f + 5.01f / 255);
    }
}

TEST_CASE("Gaussian weights leave a hundredth of noise that repeats every four pixels")
{
    for (const char* filter : {"bilateral", "gaussian"}) {
        const auto range = rangeInside(filtered({kTile, filter}));
        INFO(filter << " " << range.first << " to " << range.second);
        CHECK(range.second - range.first < 0.03f);
    }
}

TEST_CASE("Filters that weigh by place keep the mean of any noise on a plane")
{
    const std::string noise =
        "fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453)";
    const double before = mean(filtered({noise, "none"}));
    for (const std::string& filter : filters()) {
        if (filter == "median" || filter == "upsample") continue;
        INFO(filter);
        CHECK(mean(filtered({noise, filter})) == Approx(before).margin(0.005));
    }
}

TEST_CASE("Light from occluders is filtered as the occlusion is")
{
    MemorySources mine;
    std::string shader = givenShader("fract(dot(floor(gl_FragCoord.xy), vec2(0.3, 0.21)))");
    shader.insert(shader.find("void main"), "layout(location = 1) out vec4 indirect;\n");
    shader.insert(shader.rfind('}'), "indirect = vec4(vec3(ao), 1.0); ");
    mine.add("ssao/given.frag", shader);
    std::string module = kGiven;
    module.replace(module.find(R"("targets": {)"), 12, R"("targets": {
        "indirect": {"format": ["rgba16f"]},)");
    module.replace(module.find(R"("color": ["ao"])"), 15, R"("color": ["ao", "indirect"])");
    mine.add("ssao/given.json", module);
    mine.add("configs/given.json", R"({"format": 1,
        "extends": ["geometry/depth_normal", "ssao/given", "filter/indirect"]})");
    const LayeredSources sources({&mine, &shippedSources()});
    PictureRequest request;
    request.config = "given";
    request.scene = "corner";
    request.sources = &sources;
    const Image ao = picture(request);
    request.output = "indirect";
    const Image light = picture(request);
    float farthest = 0;
    for (int y = 0; y < ao.extent.height; ++y)
        for (int x = 0; x < ao.extent.width; ++x)
            farthest = std::max(farthest, std::abs(light.at(x, y, 1) - ao.at(x, y)));
    CHECK(farthest < 2.0f / 255);
    CHECK(meanChange(ao, Image(ao.extent, 1, float(mean(ao)))) > 0.005);
}

TEST_CASE("A box of any size is the mean of its pixels, half of those at the ends where it is even")
{
    const std::string noise =
        "fract(sin(dot(floor(gl_FragCoord.xy), vec2(12.9898, 78.233))) * 43.5453)";
    const auto boxOf = [&](int size) {
        return filtered({noise, "box", "plane", kSlant, {"blur_size=" + std::to_string(size)}});
    };
    const Image raw = boxOf(1);
    for (int size = 2; size <= 9; ++size) {
        INFO(size);
        const int reach = size / 2;
        const auto share = [&](int off) { return std::abs(2 * off) == size ? 0.5 : 1.0; };
        const Image box = boxOf(size);
        for (const auto& [x, y] : {std::pair(40, 30), {41, 30}, {64, 36}, {87, 45}}) {
            double sum = 0;
            for (int v = -reach; v <= reach; ++v)
                for (int u = -reach; u <= reach; ++u)
                    sum += share(u) * share(v) * raw.at(x + u, y + v);
            CHECK(box.at(x, y) == Approx(sum / (size * size)).margin(1.5 / 255));
        }
    }
}

TEST_CASE("The median is the fifth of nine sorted values")
{
    const char* const noise =
        "floor(fract(sin(dot(floor(gl_FragCoord.xy), vec2(12.99, 78.23))) * 4375.8) * 255.0) / "
        "255.0";
    const Image given = filtered({noise, "none"});
    const Image median = filtered({noise, "median"});
    for (int y = 1; y < given.extent.height - 1; ++y)
        for (int x = 1; x < given.extent.width - 1; ++x) {
            std::array<float, 9> nine;
            for (int i = 0; i < 9; ++i) nine[i] = given.at(x + i % 3 - 1, y + i / 3 - 1);
            std::sort(nine.begin(), nine.end());
            INFO(x << ' ' << y);
            REQUIRE(median.at(x, y) == nine[4]);
        }
}

TEST_CASE("The median takes out single outliers and keeps a straight step")
{
    const std::string step = "(gl_FragCoord.x < 64.0 ? 0.2 : 0.8)";
    const Image kept = filtered({step, "median"});
    CHECK(meanChange(kept, filtered({step, "none"})) == 0.0);
    const std::string dot =
        "(mod(floor(gl_FragCoord.x), 5.0) + mod(floor(gl_FragCoord.y), 5.0) == 0.0 ? 0.0 : 0.8)";
    const auto range = rangeInside(filtered({dot, "median"}));
    CHECK(range.first == range.second);
    CHECK(range.first == Approx(0.8f).margin(1.01f / 255));
}

TEST_CASE("Kuwahara's filter keeps a straight step")
{
    const std::string step = "(gl_FragCoord.x < 64.0 ? 0.2 : 0.8)";
    CHECK(meanChange(filtered({step, "kuwahara"}), filtered({step, "none"})) < 1e-6);
}

TEST_CASE("Filters that know depth do not leak across silhouettes and others do")
{
    // Surfaces are dark and the background is bright: nothing but these two values may remain.
    const auto leaked = [](const char* filter) {
        Given given = {"0.2", filter, "spheres"};
        given.camera = "";
        return shareBetween(filtered(given));
    };
    for (const char* filter : {"bilateral", "bilateral_normal", "edges3x3", "atrous"}) {
        INFO(filter);
        CHECK(leaked(filter) == 0.0);
    }
    CHECK(leaked("upsample") < 0.002);
    for (const char* filter : {"box", "gaussian"}) {
        INFO(filter);
        CHECK(leaked(filter) > 0.01);
    }
}

TEST_CASE(
    "Filters that know the tangent plane do not leak across a hollow edge, and less over a sharp "
    "one by its slope")
{
    const auto leaked = [](const char* filter, const char* scene, const char* camera,
                           const char* slope_cut) {
        Given given = {"normalAt(uv).y > 0.5 ? 0.2 : 0.8", "none", scene, camera};
        const Image raw = filtered(given);
        given.filter = filter;
        if (*slope_cut) given.overrides = {std::string("slope_cut=") + slope_cut};
        return meanChange(filtered(given), raw);
    };
    const char* const corner = "eye=0,1.5,4;at=0,0,0;fov=40";
    const char* const cube = "eye=0.5,0.8,1.2;at=-0.1,0.25,0.05;fov=22";
    CHECK(leaked("box", "corner", corner, "") > 0.005);
    for (const char* filter : {"bilateral_normal", "atrous"}) {
        INFO(filter);
        CHECK(leaked(filter, "corner", corner, "0.4") == 0.0);
        CHECK(leaked(filter, "room", cube, "0.4") < 0.65 * leaked(filter, "room", cube, "1000"));
    }
}

TEST_CASE("A filter that a param switches off is left out")
{
    const std::vector<std::pair<const char*, const char*>> offs = {
        {"box", "blur_size=1"},        {"bilateral", "blur_radius=0"},
        {"gaussian", "sigma=0"},       {"gaussian", "blur_radius=0"},
        {"atrous", "depth_cut=0"},     {"bilateral_normal", "depth_cut=0"},
        {"edges3x3", "depth_cut=0"},   {"edges3x3", "blur_passes=none"},
        {"kuwahara", "blur_radius=0"}, {"median", "median_strength=0"}};
    const Image raw = filtered({kTile, "none"});
    for (const auto& [filter, off] : offs) {
        Given given = {kTile, filter};
        given.overrides = {off};
        INFO(filter << " " << off);
        CHECK(passCount(given) == 2);  // geometry and estimator
        CHECK(meanChange(filtered(given), raw) == 0.0);
    }
    Given upsample = {kTile, "upsample"};
    upsample.overrides = {"ao_scale=1", "depth_cut=0"};
    CHECK(meanChange(filtered(upsample), raw) == 0.0);  // it packs depth, and so is drawn
}

TEST_CASE("Every filter runs over every geometry and every projection")
{
    const std::string steps = "(fract(point.x * 4.0) < 0.5 ? 0.2 : 0.8)";
    for (const Module& input : shippedInputs())
        for (const char* camera : {"", "eye=0,2,4;at=0,0,0;ortho=4"}) {
            if (input.host_textures) continue;
            Given raw = {steps, "none", "spheres", camera};
            raw.geometry = input.name.substr(sizeof("geometry"));
            const double before = mean(filtered(raw));
            for (const std::string& filter : filters()) {
                Given given = raw;
                given.filter = filter;
                const Image image = filtered(given);
                INFO(filter << " over " << input.name << " " << camera);
                CHECK(allVisibility(image));
                CHECK(mean(image) == Approx(before).margin(0.1));
            }
        }
}

TEST_CASE("Occlusion at half and at a quarter of the size resembles that of full size")
{
    // Half of 127 x 71 is no whole number.
    for (const Extent extent : {Extent{128, 72}, Extent{127, 71}}) {
        PictureRequest request;
        request.config = "gtao_half";
        request.scene = "room";
        request.extent = extent;
        request.overrides = {"radius=1", "ao_scale=1"};
        const Image full = picture(request);
        request.overrides[1] = "ao_scale=0.5";
        const Image half = picture(request);
        request.overrides[1] = "ao_scale=0.25";
        const Image quarter = picture(request);
        CHECK((allVisibility(half) && allVisibility(quarter)));
        CHECK(mean(half) == Approx(mean(full)).margin(0.01));
        CHECK(mean(quarter) == Approx(mean(full)).margin(0.02));
        CHECK(meanChange(half, full) < 0.04);
        CHECK(meanChange(quarter, full) < 0.08);
    }
}
