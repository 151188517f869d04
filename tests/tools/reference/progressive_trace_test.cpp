// SPDX-License-Identifier: MIT
// Pictures in passes: the whole one at the end, and a picture after each.
#include "tools/reference/progressive_trace.h"
#include "tools/reference/bvh_scene.h"

#include "tests/tools/reference/tracer_shot.h"

#include <algorithm>
#include <cstring>
#include <thread>

using namespace crevice;

namespace {

constexpr Extent kExtent = {24, 20};

// The sphere does not fill the picture.
Shot sphereInRoom()
{
    Scene scene = sceneOf({makeSphere(1, 16), makeQuad({-2, -1, 2}, {4, 0, 0}, {0, 0, -4})});
    return {std::move(scene),
            {glm::lookAt(glm::vec3(1, 2, 5), glm::vec3(0), glm::vec3(0, 1, 0)),
             glm::perspective(0.9f, 1.2f, 0.1f, 50.0f)}};
}

TraceOptions options(int rays, double radius = 1.0)
{
    TraceOptions made;
    made.radius = radius;
    made.rays = rays;
    return made;
}

ProgressiveTrace begin(const RayScene& scene, const Camera& camera, const TraceOptions& options)
{
    Result<ProgressiveTrace> begun = ProgressiveTrace::begin(scene, camera, kExtent, options);
    REQUIRE(begun.ok());
    return *begun;
}

bool sameBits(const Image& a, const Image& b)
{
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

// Over the pixels that see a surface in both.
double rootMeanSquare(const Image& a, const Image& b)
{
    double sum = 0;
    int seen = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        if (std::isnan(a.pixels[k]) || std::isnan(b.pixels[k])) continue;
        sum += std::pow(a.pixels[k] - b.pixels[k], 2.0);
        ++seen;
    }
    REQUIRE(seen > 0);
    return std::sqrt(sum / seen);
}

}  // namespace

TEST_CASE("after all passes the picture is the whole one, bit by bit, with either search")
{
    const Shot shot = sphereInRoom();
    const auto chosen = makeRayScene(shot.scene, {1, 2, 5});
    const auto tree = makeBvhScene(shot.scene, {1, 2, 5});
    REQUIRE(chosen.ok());
    for (const RayScene* scene :
         {static_cast<const RayScene*>(chosen->get()), static_cast<const RayScene*>(tree.get())}) {
        for (const int rays : {1, 9, 64, 100, 256}) {
            ProgressiveTrace trace = begin(*scene, shot.camera, options(rays));
            for (int pass = 0; pass < trace.passes(); ++pass)
                for (int y = 0; y < kExtent.height; ++y) trace.traceRow(pass, y);
            const auto whole = traceAmbientOcclusion(*scene, shot.camera, kExtent, options(rays));
            REQUIRE(whole.ok());
            CHECK(sameBits(trace.image(), *whole));
        }
    }
}

TEST_CASE("passes and rows may come in any order and on any thread")
{
    const Shot shot = sphereInRoom();
    const auto scene = makeBvhScene(shot.scene, {1, 2, 5});
    ProgressiveTrace trace = begin(*scene, shot.camera, options(64));
    REQUIRE(trace.passes() == 8);
    const auto half = [&trace](int begin) {
        for (int y = kExtent.height - 1 - begin; y >= 0; y -= 2)
            for (const int pass : {3, 0, 7, 5, 1, 2, 6, 4}) trace.traceRow(pass, y);
    };
    std::thread other(half, 1);
    half(0);
    other.join();
    const auto whole = traceAmbientOcclusion(*scene, shot.camera, kExtent, options(64));
    REQUIRE(whole.ok());
    CHECK(sameBits(trace.image(), *whole));
}

TEST_CASE("each pass brings the picture closer, and rows that wait for one are not numbers")
{
    const Shot shot = sphereInRoom();
    const auto scene = makeBvhScene(shot.scene, {1, 2, 5});
    const auto exact = traceAmbientOcclusion(*scene, shot.camera, kExtent, options(8192));
    REQUIRE(exact.ok());
    ProgressiveTrace trace = begin(*scene, shot.camera, options(256));
    CHECK(std::isnan(trace.image().at(kExtent.width / 2, kExtent.height / 2)));
    double before = 0.1;  // of the first 8 rays
    for (int pass = 0; pass < trace.passes(); ++pass) {
        for (int y = 0; y < kExtent.height; ++y) trace.traceRow(pass, y);
        if ((pass & (pass + 1)) != 0) continue;  // 1, 2, 4, 8 ... passes
        const double error = rootMeanSquare(trace.image(), *exact);
        CHECK(error < 0.85 * before);
        before = error;
    }
    CHECK(before < 0.006);
}

TEST_CASE("passes are powers of two with a batch of rays each")
{
    const Shot shot = sphereInRoom();
    const auto scene = makeBvhScene(shot.scene, {1, 2, 5});
    const auto passes = [&](int rays) {
        return begin(*scene, shot.camera, options(rays)).passes();
    };
    CHECK(passes(1) == 1);
    CHECK(passes(15) == 1);
    CHECK(passes(16) == 2);
    CHECK(passes(256) == 32);
    CHECK(passes(300) == 32);
    CHECK(passes(4096) == kMaxTracePasses);
}

TEST_CASE("a radius of zero is open in every pass")
{
    const Shot shot = sphereInRoom();
    const auto scene = makeBvhScene(shot.scene, {1, 2, 5});
    ProgressiveTrace trace = begin(*scene, shot.camera, options(64, 0.0));
    for (int y = 0; y < kExtent.height; ++y) trace.traceRow(0, y);
    const Image image = trace.image();
    CHECK(std::count(image.pixels.begin(), image.pixels.end(), 1.0f) > 100);
    CHECK(std::all_of(image.pixels.begin(), image.pixels.end(),
                      [](float value) { return std::isnan(value) || value == 1.0f; }));
}

TEST_CASE("what cannot be traced whole cannot be begun")
{
    const Shot shot = sphereInRoom();
    const auto scene = makeBvhScene(shot.scene, {1, 2, 5});
    CHECK_FALSE(ProgressiveTrace::begin(*scene, shot.camera, {0, 4}, options(4)).ok());
    CHECK_FALSE(ProgressiveTrace::begin(*scene, shot.camera, kExtent, options(0)).ok());
    CHECK_FALSE(ProgressiveTrace::begin(*scene, shot.camera, kExtent, options(4, -1)).ok());
}
