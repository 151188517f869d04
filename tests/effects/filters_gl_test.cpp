// SPDX-License-Identifier: MIT
// What must hold for every filter over the occlusion, drawn for real.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/scene/mesh_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace crevice;

namespace {

// A plane that fills the picture, at a slant.
const char* const kSlant = "eye=0,2,1;at=0,0,0;fov=30";

// A value for each pixel of a tile of 4x4; their mean is a half.
const char* const kTile =
    "(mod(floor(gl_FragCoord.x), 4.0) + 4.0 * mod(floor(gl_FragCoord.y), 4.0)) / 15.0";

struct Given {
    std::string ao;  ///< GLSL: what an estimator writes at a pixel that sees a surface.
    std::string filter;
    std::string scene = "plane";
    std::string camera = kSlant;
    std::vector<std::string> overrides = {};
    Extent extent = {128, 72};

    Description description() const { return filterOver(ao, filter, "r8", overrides); }
};

struct Filters : SceneRig {
    Filters() : SceneRig("plane") {}

    Image filtered(const Given& given)
    {
        show(given.scene);
        extent = given.extent;
        return draw(given.description(), frame(given.camera));
    }

    /// The least and the greatest value at least 16 pixels from the border, where no window is cut
    /// off.
    std::pair<float, float> rangeInside(const Given& given)
    {
        const Image image = filtered(given);
        std::pair<float, float> range(1e9f, -1e9f);
        for (int y = 16; y < image.extent.height - 16; ++y)
            for (int x = 16; x < image.extent.width - 16; ++x) {
                range.first = std::min(range.first, image.at(x, y));
                range.second = std::max(range.second, image.at(x, y));
            }
        return range;
    }
};

/// Those over the occlusion of one frame and nothing else.
std::vector<std::string> filters()
{
    std::vector<std::string> names;
    for (const Module& filter : shippedFilters())
        if (!filter.remembers && filter.name != "filter/indirect")
            names.push_back(filter.name.substr(sizeof("filter")));
    return names;
}

}  // namespace

TEST_CASE_METHOD(Filters, "Filters keep a constant picture constant")
{
    for (const std::string& filter : filters()) {
        const Image image = filtered({"0.6", filter});
        INFO(filter);
        for (float value : image.pixels) REQUIRE(value == image.pixels.front());
        CHECK(image.pixels.front() == Approx(0.6f).margin(1.01f / 255));
    }
}

TEST_CASE_METHOD(Filters, "Filters keep 1 exactly, whatever the size")
{
    for (const std::string& filter : filters())
        for (const Extent size : {Extent{97, 51}, Extent{1, 1}, Extent{1, 37}}) {
            INFO(filter << " " << size.width << "x" << size.height);
            Given given = {"1.0", filter};
            given.extent = size;
            CHECK(mean(filtered(given)) == 1.0);
        }
}

TEST_CASE_METHOD(Filters, "Noise that repeats every four pixels leaves no trace on a plane")
{
    const auto check = [&](const Given& given, float margin) {
        const auto range = rangeInside(given);
        INFO(given.filter << " " << range.first << " to " << range.second);
        CHECK(range.first > 0.5f - margin / 255);
        CHECK(range.second < 0.5f + margin / 255);
    };
    for (const char* filter : {"box", "bilateral_normal", "edges3x3", "upsample"})
        check({kTile, filter}, 3.01f);
    // Nor do the steps of a coarse depth keep a filter from a plane that they are stored of.
    for (const char* filter : {"bilateral_normal", "upsample"})
        check({kTile,
               filter,
               "plane",
               "eye=0,8,4;at=0,0,0;fov=7.5",
               {"/targets/depth/format=[\"depth16\"]", "radius=50"}},
              5.01f);
    // Gaussian weights leave a hundredth.
    for (const char* filter : {"bilateral", "gaussian"}) {
        const auto range = rangeInside({kTile, filter});
        INFO(filter << " " << range.first << " to " << range.second);
        CHECK(range.second - range.first < 0.03f);
    }
}

TEST_CASE_METHOD(
    Filters,
    "A box of any size is the mean of its pixels, half of those at the ends where it is even")
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

TEST_CASE_METHOD(Filters, "The median is the fifth of nine sorted values")
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

TEST_CASE_METHOD(Filters, "Filters that know depth do not leak across silhouettes and others do")
{
    // Surfaces are dark and the background is bright: nothing but these two values may remain.
    const auto leaked = [&](const char* filter) {
        const Image image = filtered({"0.2", filter, "spheres", ""});
        return shareBelow(image, 0.78f) - shareBelow(image, 0.22f);
    };
    for (const char* filter : {"bilateral", "bilateral_normal", "edges3x3"})
        CHECK(leaked(filter) == 0.0);
    CHECK(leaked("upsample") < 0.002);
    for (const char* filter : {"box", "gaussian"}) CHECK(leaked(filter) > 0.01);
}

TEST_CASE("Wires that all texels of low resolution miss are open, before a dark slot")
{
    const auto drawn = [](const char* config, bool wires) {
        Scene scene;
        scene.materials.emplace_back();
        scene.instances.emplace_back();
        MeshDesc slot = makeQuad({-3, 0, -0.6f}, {6, 0, 0}, {0, 0.4f, 0});
        append(slot, makeBox({-3, -2, -0.6f}, {3, 0, 0}));
        append(slot, makeBox({-3, 0.4f, -0.6f}, {3, 2, 0}));
        for (float x = -0.6f; x < 0.6f && wires; x += 0.123f)
            append(slot, makeBox({x, -2, 1}, {x + 0.012f, 2, 1.012f}));
        scene.meshes = {slot};
        SceneRig rig(std::move(scene), {240, 135});
        return rig.draw(descriptionOf({config}, {"radius=0.7"}),
                        rig.frame("eye=0,0.2,4;at=0,0.2,0;fov=30"), "ao");
    };
    const Image full = drawn("gtao", true), slot = drawn("gtao", false),
                low = drawn("mobile", true);
    int wires = 0, wrong = 0;
    for (std::size_t i = 0; i < full.pixels.size(); ++i)
        if (full.pixels[i] > slot.pixels[i] + 0.2f) {
            ++wires;
            wrong += low.pixels[i] < 0.5f * (full.pixels[i] + slot.pixels[i]);
        }
    CHECK(wires > 100);
    CHECK(wrong < 0.05 * wires);
}

TEST_CASE_METHOD(
    Filters,
    "Filters that know the tangent plane do not leak across a hollow edge, and less over a sharp "
    "one by its slope")
{
    const auto leaked = [&](const char* filter, const char* place, const char* camera,
                            const char* slope_cut) {
        Given given = {"normalAt(uv).y > 0.5 ? 0.2 : 0.8", "none", place, camera};
        const Image raw = filtered(given);
        given.filter = filter;
        if (*slope_cut) given.overrides = {std::string("slope_cut=") + slope_cut};
        return meanChange(filtered(given), raw);
    };
    const char* const corner = "eye=0,1.5,4;at=0,0,0;fov=40";
    const char* const cube = "eye=0.5,0.8,1.2;at=-0.1,0.25,0.05;fov=22";
    CHECK(leaked("box", "corner", corner, "") > 0.005);
    CHECK(leaked("bilateral_normal", "corner", corner, "0.4") == 0.0);
    CHECK(leaked("bilateral_normal", "room", cube, "0.4") <
          0.65 * leaked("bilateral_normal", "room", cube, "1000"));
}

TEST_CASE_METHOD(Filters, "A filter that a param switches off is left out")
{
    const std::vector<std::pair<const char*, const char*>> offs = {
        {"box", "blur_size=1"},
        {"bilateral", "blur_radius=0"},
        {"gaussian", "sigma=0"},
        {"gaussian", "blur_radius=0"},
        {"bilateral_normal", "depth_cut=0"},
        {"edges3x3", "depth_cut=0"},
        {"edges3x3", "blur_passes=none"},
        {"median", "median_strength=0"}};
    const Image raw = filtered({kTile, "none"});
    for (const auto& [filter, off] : offs) {
        Given given = {kTile, filter};
        given.overrides = {off};
        INFO(filter << " " << off);
        CHECK(meanChange(filtered(given), raw) == 0.0);
        const CompileOptions options = {extent, {"ao"}, {}};
        const Plan plan = need(compile(given.description(), {}, device->caps(), options));
        CHECK(plan.passes.size() == 2);  // geometry and estimator
    }
    Given upsample = {kTile, "upsample"};
    upsample.overrides = {"ao_scale=1", "depth_cut=0"};
    CHECK(meanChange(filtered(upsample), raw) == 0.0);  // it packs depth, and so is drawn
}
