// SPDX-License-Identifier: MIT
// Pictures in passes: the whole one at the end, and a picture after each.
#include "tools/measure/reference/progressive_trace.h"
#include "tools/measure/reference/bvh_scene.h"

#include "tests/tools/measure/reference/tracer_shot.h"

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

// The sphere in a tree, seen by a camera of its own.
struct Subject {
    Shot shot = sphereInRoom();
    std::unique_ptr<RayScene> tree = makeBvhScene(shot.scene, {1, 2, 5});

    ProgressiveTrace begin(int rays, double radius = 1.0) const
    {
        return need(
            ProgressiveTrace::begin(*tree, shot.camera, kExtent, traceOptions(radius, rays)));
    }

    Image whole(int rays) const { return trace(*tree, shot.camera, kExtent, 1.0, rays); }
};

void traceAll(ProgressiveTrace& trace, int pass)
{
    for (int y = 0; y < kExtent.height; ++y) trace.traceRow(pass, y);
}

}  // namespace

TEST_CASE("after all passes the picture is the whole one, bit by bit, with either search")
{
    const Subject subject;
    const auto chosen = need(makeRayScene(subject.shot.scene, {1, 2, 5}));
    for (const RayScene* scene : {static_cast<const RayScene*>(chosen.get()),
                                  static_cast<const RayScene*>(subject.tree.get())}) {
        for (const int rays : {1, 9, 64, 100, 256}) {
            const Camera& camera = subject.shot.camera;
            ProgressiveTrace passes =
                need(ProgressiveTrace::begin(*scene, camera, kExtent, traceOptions(1.0, rays)));
            for (int pass = 0; pass < passes.passes(); ++pass) traceAll(passes, pass);
            CHECK(sameBits(passes.image(), trace(*scene, camera, kExtent, 1.0, rays)));
        }
    }
}

TEST_CASE("passes and rows may come in any order and on any thread")
{
    const Subject subject;
    ProgressiveTrace trace = subject.begin(64);
    REQUIRE(trace.passes() == 8);
    const auto half = [&trace](int begin) {
        for (int y = kExtent.height - 1 - begin; y >= 0; y -= 2)
            for (const int pass : {3, 0, 7, 5, 1, 2, 6, 4}) trace.traceRow(pass, y);
    };
    std::thread other(half, 1);
    half(0);
    other.join();
    CHECK(sameBits(trace.image(), subject.whole(64)));
}

TEST_CASE("each pass brings the picture closer, and rows that wait for one are not numbers")
{
    const Subject subject;
    const Image exact = subject.whole(8192);
    ProgressiveTrace trace = subject.begin(256);
    CHECK(std::isnan(trace.image().at(kExtent.width / 2, kExtent.height / 2)));
    double before = 0.1;  // of the first 8 rays
    for (int pass = 0; pass < trace.passes(); ++pass) {
        traceAll(trace, pass);
        if ((pass & (pass + 1)) != 0) continue;  // 1, 2, 4, 8 ... passes
        const double error = rmsDifference(trace.image(), exact);
        CHECK(error < 0.85 * before);
        before = error;
    }
    CHECK(before < 0.006);
}
