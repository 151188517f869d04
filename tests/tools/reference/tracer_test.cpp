// SPDX-License-Identifier: MIT
// The ray tracer, against closed forms and against itself.
#include "tests/tools/reference/tracer_shot.h"

#include <cstring>
#include <limits>

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Looks straight down: the picture's right is +x, its top is -z; `half` to each side.
Camera fromAbove(float half, const glm::vec3& center = glm::vec3(0.0f))
{
    return {glm::lookAt(center + glm::vec3(0, 20, 0), center, glm::vec3(0, 0, -1)),
            glm::ortho(-half, half, -half, half, 1.0f, 30.0f)};
}

Camera perspective(const glm::mat4& clip_from_view)
{
    const glm::vec3 eye = {1, 2, 3}, at = {0, 0.3f, 0}, up = {0, 1, 0};
    return {glm::lookAt(eye, at, up), clip_from_view};
}

const glm::mat4 kLens = glm::perspective(0.9f, 1.0f, 0.1f, 100.0f);

Image trace(const Scene& scene, const Camera& camera, Extent extent, double radius, int rays)
{
    TraceOptions options;
    options.radius = radius;
    options.rays = rays;
    const auto image = traceAmbientOcclusion(scene, camera, extent, options);
    INFO(toText(image.diagnostics()));
    REQUIRE(image.ok());
    return *image;
}

bool sameBits(const Image& a, const Image& b)
{
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

double meanDifference(const Image& a, const Image& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) sum += std::abs(a.pixels[k] - b.pixels[k]);
    return sum / static_cast<double>(a.pixels.size());
}

Scene cornerWithSphere()
{
    Scene scene = sceneOf({kFloor, kWall, makeSphere(0.5f, 24)});
    scene.instances[2].world_from_model = glm::translate(glm::mat4(1), {0.2f, 0.5f, 0.8f});
    return scene;
}

}  // namespace

TEST_CASE("an open plane is open, seen from any side and under any slope")
{
    Scene scene = sceneOf({kFloor});
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(1, 0.3f, 0.2f)}) {
        const glm::mat4 turn = glm::rotate(glm::mat4(1), 0.4f, glm::normalize(axis));
        for (const float height : {1.0f, -1.0f}) {
            scene.instances[0].world_from_model = turn * glm::scale(glm::mat4(1), {1, height, 1});
            const Image image = trace(scene, fromAbove(5), {16, 16}, 10, 64);
            for (const float value : image.pixels) CHECK(value == 1.0f);
        }
    }
}

TEST_CASE("an inner corner darkens by the closed form")
{
    // Cosine-weighted directions are even on the unit disc; those that reach the wall within the
    // radius are the segment beyond distance / radius.
    constexpr double kRadius = 2.0;
    const Scene scene = sceneOf({kFloor, kWall});
    const Image image = trace(scene, fromAbove(2, {0, 0, 2}), {4, 32}, kRadius, 4096);
    for (int y = 0; y < 32; ++y) {
        const double distance = 2.0 - (2.0 * (y + 0.5) / 32 - 1.0) * 2.0;
        const double part = std::min(distance / kRadius, 1.0);
        const double expected = 1.0 - (std::acos(part) - part * std::sqrt(1 - part * part)) / kPi;
        for (int x = 0; x < 4; ++x) CHECK(image.at(x, y) == Approx(expected).margin(0.003));
    }
}

TEST_CASE("a sphere shades the floor by the closed form")
{
    Scene scene = sceneOf({kFloor, makeSphere(0.5f, 128)});
    scene.instances[1].world_from_model = glm::translate(glm::mat4(1), {0, 1.0f, 0});
    const Image image = trace(scene, fromAbove(3), {33, 33}, 20, 4096);
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
            const double across = (2.0 * (x + 0.5) / 33 - 1.0) * 3;
            const double along = (2.0 * (y + 0.5) / 33 - 1.0) * 3;
            const double squared = across * across + along * along + 1.0;
            if (squared < 1.0 + 0.6 * 0.6) continue;  // the sphere itself
            const double expected = 1.0 - 0.25 / squared / std::sqrt(squared);
            CHECK(image.at(x, y) == Approx(expected).margin(0.004));
        }
    }
}

TEST_CASE("what sees no surface is not a number")
{
    const Image image = trace(sceneOf({makeSphere(1, 16)}), fromAbove(2), {16, 16}, 1, 4);
    CHECK(std::isnan(image.at(0, 0)));
    CHECK(image.at(8, 8) == 1.0f);
}

TEST_CASE("the picture does not depend on the number of threads or on the run")
{
    TraceOptions options;
    options.rays = 16;
    options.threads = 1;
    const Scene scene = cornerWithSphere();
    const auto alone = traceAmbientOcclusion(scene, perspective(kLens), {32, 32}, options);
    options.threads = 3;
    const auto shared = traceAmbientOcclusion(scene, perspective(kLens), {32, 32}, options);
    REQUIRE(alone.ok());
    REQUIRE(shared.ok());
    CHECK(sameBits(*alone, *shared));
}

TEST_CASE("a radius of zero leaves every surface open, and more radius never opens it")
{
    const Scene scene = cornerWithSphere();
    Image last = trace(scene, perspective(kLens), {24, 24}, 0, 64);
    for (const float value : last.pixels) CHECK(value == 1.0f);
    for (const double radius : {0.1, 0.5, 2.0, 8.0}) {
        const Image image = trace(scene, perspective(kLens), {24, 24}, radius, 64);
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
            CHECK(image.pixels[k] <= last.pixels[k] + 1.5f / 64);
        last = image;
    }
}

TEST_CASE("reversed depth, an infinite far plane and a shifted lens see the same")
{
    const Scene scene = cornerWithSphere();
    const Image image = trace(scene, perspective(kLens), {32, 32}, 1, 64);
    glm::mat4 reversed = glm::scale(glm::mat4(1), {1, 1, -1}) * kLens;
    CHECK(meanDifference(trace(scene, perspective(reversed), {32, 32}, 1, 64), image) < 0.002);
    const glm::mat4 infinite = glm::infinitePerspective(0.9f, 1.0f, 0.1f);
    CHECK(meanDifference(trace(scene, perspective(infinite), {32, 32}, 1, 64), image) < 0.002);
    reversed = glm::scale(glm::mat4(1), {1, 1, -1}) * infinite;
    CHECK(meanDifference(trace(scene, perspective(reversed), {32, 32}, 1, 64), image) < 0.002);

    // The left half of the view, alone.
    const float top = 0.1f * std::tan(0.45f);
    const glm::mat4 left = glm::frustum(-top, 0.0f, -top, top, 0.1f, 100.0f);
    const Image half = trace(scene, perspective(left), {16, 32}, 1, 64);
    double difference = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 16; ++x) difference += std::abs(half.at(x, y) - image.at(x, y));
    CHECK(difference / (16 * 32) < 0.002);
}

TEST_CASE("the unit of length does not matter, nor the distance from the origin")
{
    const Image image = trace(cornerWithSphere(), fromAbove(1.5f, {0, 0, 1.5f}), {24, 24}, 1, 256);
    for (const float scale : {1e-6f, 1e6f}) {
        Scene scaled = cornerWithSphere();
        for (SceneInstance& instance : scaled.instances)
            instance.world_from_model =
                glm::scale(glm::dmat4(1), glm::dvec3(scale)) * instance.world_from_model;
        Camera camera = fromAbove(1.5f, {0, 0, 1.5f});
        camera.view_from_world =
            camera.view_from_world * glm::scale(glm::dmat4(1), glm::dvec3(1 / scale));
        CHECK(meanDifference(trace(scaled, camera, {24, 24}, scale, 256), image) < 0.002);
    }
    Scene moved = cornerWithSphere();
    const glm::dvec3 far_away = {1e7, 0, 1e7};
    for (SceneInstance& instance : moved.instances)
        instance.world_from_model[3] += glm::dvec4(far_away, 0);
    Camera camera = fromAbove(1.5f, {0, 0, 1.5f});
    camera.view_from_world = camera.view_from_world * glm::translate(glm::dmat4(1), -far_away);
    CHECK(meanDifference(trace(moved, camera, {24, 24}, 1, 256), image) < 0.002);
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
    const Image exact = trace(scene, perspective(kLens), {24, 24}, 1, 8192);
    const std::pair<int, double> rows[] = {
        {64, 0.014}, {128, 0.008}, {256, 0.005}, {512, 0.003}, {1024, 0.002}};
    for (const auto& [rays, limit] : rows) {
        const Image image = trace(scene, perspective(kLens), {24, 24}, 1, rays);
        double sum = 0;
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
            sum += std::pow(image.pixels[k] - exact.pixels[k], 2.0);
        const double noise = std::sqrt(sum / static_cast<double>(image.pixels.size()));
        CHECK(noise <= limit * 1.25);
        CHECK(noise >= limit / 2);
    }
}

TEST_CASE("options and cameras that cannot be traced are refused")
{
    const auto codeOf = [](const Camera& camera, Extent extent, double radius, int rays) {
        TraceOptions options;
        options.radius = radius;
        options.rays = rays;
        const auto image = traceAmbientOcclusion(sceneOf({kFloor}), camera, extent, options);
        return image.ok() ? Code::internal : image.diagnostics()[0].code;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(codeOf(fromAbove(1), {4, 4}, -1, 4) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, nan, 4) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, 1, 0) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {4, 4}, 1, kMaxTraceRays + 1) == Code::out_of_range);
    CHECK(codeOf(fromAbove(1), {0, 4}, 1, 4) == Code::bad_size);
    CHECK(codeOf({glm::mat4(1), glm::mat4(0)}, {4, 4}, 1, 4) == Code::bad_input);
}

TEST_CASE("progress ends at one")
{
    TraceOptions options;
    options.rays = 1;
    options.threads = 1;
    double last = 0;
    options.progress = [&](double done) {
        CHECK(done > last);
        last = done;
    };
    REQUIRE(traceAmbientOcclusion(sceneOf({kFloor}), fromAbove(1), {4, 9}, options).ok());
    CHECK(last == 1.0);
}
