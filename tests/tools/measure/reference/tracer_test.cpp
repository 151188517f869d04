// SPDX-License-Identifier: MIT
// The ray tracer against itself: lenses, threads, radii, noise, and what it refuses.
// Pictures in passes: the whole one at the end, and a picture after each.
#include "tests/tools/measure/reference/tracer_shot.h"

#include "tools/measure/reference/pixel_tracer.h"
#include "tools/measure/reference/ray_scene.h"

#include <limits>
#include <thread>

using namespace crevice;

namespace {

// Looks straight down: the picture's right is +x, its top is -z; `half` to each side.
Camera fromAbove(float half)
{
    return {glm::lookAt(glm::vec3(0, 20, 0), glm::vec3(0), glm::vec3(0, 0, -1)),
            glm::ortho(-half, half, -half, half, 1.0f, 30.0f)};
}

Camera perspective(const glm::mat4& clip_from_view)
{
    const glm::vec3 eye = {1, 2, 3}, at = {0, 0.3f, 0}, up = {0, 1, 0};
    return {glm::lookAt(eye, at, up), clip_from_view};
}

const Camera kAhead = perspective(glm::perspective(0.9f, 1.0f, 0.1f, 100.0f));

Scene cornerWithSphere()
{
    Scene scene = sceneOf({kFloor, kWall, makeSphere(0.5f, 24)});
    scene.instances[2].world_from_model = glm::translate(glm::mat4(1), {0.2f, 0.5f, 0.8f});
    return scene;
}

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
        return need(ProgressiveTrace::begin(*tree, shot.camera, kExtent, {radius, rays}));
    }

    Image whole(int rays) const { return trace(*tree, shot.camera, kExtent, 1.0, rays); }
};

void traceAll(ProgressiveTrace& trace, int pass)
{
    for (int y = 0; y < kExtent.height; ++y) trace.traceRow(pass, y);
}

}  // namespace

TEST_CASE("the picture does not depend on the number of threads, and progress ends at one")
{
    const Scene scene = cornerWithSphere();
    TraceOptions options = {0.5, 16};
    options.threads = 1;
    double last = 0;
    options.progress = [&](double done) {
        CHECK(done > last);
        last = done;
    };
    const Image alone = need(traceAmbientOcclusion(scene, kAhead, {32, 32}, options));
    CHECK(last == 1.0);
    options.threads = 3;
    options.progress = {};
    CHECK(sameBits(need(traceAmbientOcclusion(scene, kAhead, {32, 32}, options)), alone));
}

TEST_CASE("reversed depth, an infinite far plane and a shifted lens see the same")
{
    const Scene scene = cornerWithSphere();
    const Image image = trace(scene, kAhead, {32, 32}, 1, 64);
    const auto difference = [&](const glm::mat4& lens, int width) {
        const Image seen = trace(scene, perspective(lens), {width, 32}, 1, 64);
        double sum = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < width; ++x) sum += std::abs(seen.at(x, y) - image.at(x, y));
        return sum / (32.0 * width);
    };
    const glm::mat4 infinite = glm::infinitePerspective(0.9f, 1.0f, 0.1f);
    const glm::mat4 reversed = glm::scale(glm::mat4(1), {1, 1, -1});
    CHECK(difference(reversed * kAhead.clip_from_view, 32) < 0.002);
    CHECK(difference(infinite, 32) < 0.002);
    CHECK(difference(reversed * infinite, 32) < 0.002);
    const float top = 0.1f * std::tan(0.45f);  // the left half of the view, alone
    CHECK(difference(glm::frustum(-top, 0.0f, -top, top, 0.1f, 100.0f), 16) < 0.002);
}

TEST_CASE("rays pass through the holes of an alpha-tested material")
{
    Scene scene = sceneOf({kFloor, makeQuad({-1, 1, 1}, {2, 0, 0}, {0, 0, -2})});
    scene.materials.emplace_back();
    scene.instances[1].material = 1;
    const auto shade = [&] { return trace(scene, fromAbove(2), {4, 4}, 10, 256).at(0, 1); };
    const float shaded = shade();
    CHECK(shaded < 0.97f);
    scene.materials[1].base_color.a = 0.3f;
    CHECK(shade() == shaded);
    scene.materials[1].alpha_cutoff = 0.5f;
    CHECK(shade() == 1.0f);
    scene.materials[1].base_color.a = 1.0f;
    CHECK(shade() == shaded);

    // The left half of a texture is a hole, so the left of the floor is lighter.
    scene.textures.push_back({"holes", Image({2, 1}, 4, 1.0f)});
    scene.textures[0].image.at(0, 0, 3) = 0.0f;
    scene.materials[1].base_color_texture = 0;
    const Image image = trace(scene, fromAbove(2), {4, 4}, 10, 256);
    CHECK(image.at(0, 1) > image.at(3, 1) + 0.02f);
}

TEST_CASE("noise is about what docs/reference/bench.md says of each number of rays")
{
    const Scene scene = cornerWithSphere();
    const Image exact = trace(scene, kAhead, {24, 24}, 1, 8192);
    const std::pair<int, double> rows[] = {
        {64, 0.014}, {128, 0.008}, {256, 0.005}, {512, 0.003}, {1024, 0.002}};
    for (const auto& [rays, limit] : rows) {
        const double noise = rmsDifference(trace(scene, kAhead, {24, 24}, 1, rays), exact);
        CHECK(noise <= limit * 1.25);
        CHECK(noise >= limit / 2);
    }
}

TEST_CASE("options and cameras that cannot be traced are refused, in passes too")
{
    struct Row {
        Code code;
        double radius;
        int rays;
        Extent extent = {4, 4};
        Camera camera = fromAbove(1);
    };
    const Row rows[] = {{Code::out_of_range, -1, 4},
                        {Code::out_of_range, std::numeric_limits<double>::quiet_NaN(), 4},
                        {Code::out_of_range, 1, 0},
                        {Code::out_of_range, 1, kMaxTraceRays + 1},
                        {Code::bad_size, 1, 4, {0, 4}},
                        {Code::bad_input, 1, 4, {4, 4}, {glm::mat4(1), glm::mat4(0)}}};
    const Scene scene = sceneOf({kFloor});
    const auto tree = makeBvhScene(scene, {0, 20, 0});
    for (const Row& row : rows) {
        const TraceOptions options = {row.radius, row.rays};
        onlyError(traceAmbientOcclusion(scene, row.camera, row.extent, options), row.code);
        CHECK_FALSE(ProgressiveTrace::begin(*tree, row.camera, row.extent, options).ok());
    }
}

TEST_CASE("after all passes the picture is the whole one, bit by bit, with either search")
{
    const Subject subject;
    const auto chosen = need(makeRayScene(subject.shot.scene, {1, 2, 5}));
    for (const RayScene* scene : {static_cast<const RayScene*>(chosen.get()),
                                  static_cast<const RayScene*>(subject.tree.get())}) {
        for (const int rays : {1, 9, 64, 100, 256}) {
            const Camera& camera = subject.shot.camera;
            ProgressiveTrace passes =
                need(ProgressiveTrace::begin(*scene, camera, kExtent, {1.0, rays}));
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
