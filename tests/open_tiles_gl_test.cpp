// SPDX-License-Identifier: MIT
// Open tiles: what is left undrawn since nothing can occlude it is what would have been drawn, and on an even
// floor that is most of it.
#include "tests/picture.h"

#include "effects/catalog.h"

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

struct Estimator {
    const char* config;
    const char* tiles;
};

const Estimator kEstimators[] = {
    {"gtao", "ssao/open_tiles_cosine"},  {"bitmask", "ssao/open_tiles_cosine"},
    {"learnopengl", "ssao/open_tiles"},  {"sao", "ssao/open_tiles"},
};

/// The config with open tiles, or with the rule's feature off.
Image drawn(const Estimator& estimator, PictureRequest request, bool open)
{
    MemorySources mine;
    mine.add("configs/tiled.json", std::string(R"({"format": 1, "extends": [")") + estimator.config +
                                       R"(", ")" + estimator.tiles + R"("]})");
    const LayeredSources sources({&mine, &shippedSources()});
    request.config = "tiled";
    request.sources = &sources;
    request.overrides.push_back(open ? "open_tiles=true" : "open_tiles=false");
    return picture(request);
}

float mostApart(const Image& a, const Image& b)
{
    REQUIRE(a.pixels.size() == b.pixels.size());
    float most = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
    return most;
}

/// The share of pixels that the mask calls open.
double openShare(const Estimator& estimator, PictureRequest request)
{
    request.target = "receivers";
    const Image mask = drawn(estimator, request, true);
    const auto open = std::count_if(mask.pixels.begin(), mask.pixels.end(),
                                    [](float value) { return value > 0.1f && value < 0.5f; });
    return double(open) / double(mask.pixels.size());
}

constexpr float kStep = 1.01f / 255;  // of the target's format

}  // namespace

TEST_CASE("Open tiles leave out no occlusion that could be told, from wherever a scene is seen")
{
    const struct {
        const char* scene;
        const char* camera;
    } views[] = {{"room", ""},
                 {"spheres", "eye=0,1.5,4;at=0,2.3,0"},
                 {"spheres", "eye=9,7,9;at=0,0,0"},
                 {"spheres", "eye=6,5,6;at=0,1,0;ortho=12;shift=0.2,0.1"},
                 {"corner", "eye=6,3,9;at=0,1,0"},
                 {"plane", "eye=0,0.3,3;at=0,0.2,0"}};
    for (const Estimator& estimator : kEstimators) {
        for (const auto& view : views) {
            for (const char* radius : {"radius=0.1", "radius=0.5"}) {
                INFO(estimator.config << ' ' << view.scene << ' ' << view.camera << ' ' << radius);
                PictureRequest request;
                request.scene = view.scene;
                request.camera = view.camera;
                request.extent = {192, 108};
                request.overrides = {radius};
                CHECK(mostApart(drawn(estimator, request, true), drawn(estimator, request, false)) <= kStep);
                request.target = "ao";
                CHECK(mostApart(drawn(estimator, request, true), drawn(estimator, request, false)) <= kStep);
            }
        }
    }
}

TEST_CASE("Open tiles draw views of a few pixels, where a cell is one texel and no plane fits it")
{
    for (const Extent extent : {Extent{1, 1}, Extent{2, 1}, Extent{1, 40}, Extent{5, 3}}) {
        INFO(extent.width << 'x' << extent.height);
        PictureRequest request;
        request.scene = "corner";
        request.extent = extent;
        request.target = "cells";
        const Image cells = drawn(kEstimators[0], request, true);
        for (const float value : cells.pixels) CHECK(std::isfinite(value));
        request.target = "ao";
        CHECK(mostApart(drawn(kEstimators[0], request, true), drawn(kEstimators[0], request, false)) <= kStep);
    }
}

TEST_CASE("Most of an even floor is open, and nothing is where the rule is off")
{
    for (const Estimator& estimator : kEstimators) {
        INFO(estimator.config);
        PictureRequest request;
        request.scene = "plane";
        request.extent = {192, 108};
        request.overrides = {"radius=0.2"};
        CHECK(openShare(estimator, request) > 0.8);
        request.target = "receivers";
        CHECK(mean(drawn(estimator, request, false)) == 1.0);
    }
}

TEST_CASE("A floor about a thing is open, and where it occludes it is not")
{
    PictureRequest request;
    request.camera = "eye=9,7,9;at=0,0,0";
    request.extent = {384, 216};
    request.overrides = {"radius=0.1"};
    const double share = openShare(kEstimators[0], request);
    CHECK(share > 0.2);
    CHECK(share < 0.95);
}
