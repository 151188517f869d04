// SPDX-License-Identifier: MIT
// How finely formats distinguish surfaces, against the projections themselves in double.
#include "core/plan/depth_precision.h"

#include "tests/support/catch.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

struct Lens {
    const char* name;
    glm::dmat4 clip_from_view;
    double nearest, farthest;  // of the distances to look at
};

glm::dmat4 reversed(glm::dmat4 clip_from_view)
{
    for (int column = 0; column < 4; ++column) clip_from_view[column].z *= -1;
    return clip_from_view;
}

std::vector<Lens> lenses()
{
    const glm::dmat4 endless = glm::infinitePerspective(0.9, 1.7, 0.02);
    const glm::dmat4 common = glm::perspective(1.0, 1.5, 0.1, 1000.0);
    return {
        {"common", common, 0.11, 990},
        {"reversed", reversed(common), 0.11, 990},
        {"off-centre", glm::frustum(-0.01, 0.09, -0.05, 0.02, 0.1, 50.0), 0.11, 49},
        {"near", glm::perspective(1.5, 1.0, 0.001, 1e4), 0.0011, 9e3},
        {"narrow", glm::perspective(0.02, 1.0, 100.0, 1e4), 101, 9900},
        {"endless", endless, 0.021, 1e5},
        {"endless, reversed", reversed(endless), 0.021, 1e5},
        {"of millimetres", glm::perspective(1.0, 1.0, 1e-7, 1e-4), 1.1e-7, 9.9e-5},
        {"of kilometres", glm::perspective(1.0, 1.0, 1e5, 1e8), 1.1e5, 9.9e7},
    };
}

SceneTraits through(const glm::dmat4& clip_from_view)
{
    Frame frame;
    frame.camera.clip_from_view = glm::mat4(clip_from_view);
    return traitsOf(frame);
}

SceneTraits common(double near_distance, double far_distance)
{
    return through(glm::perspective(1.0, 1.5, near_distance, far_distance));
}

// How far view depth changes with window depth.
double slopeOf(const glm::dmat4& m, double distance)
{
    const double w = m[3][3] - m[2][3] * distance;
    return 2 * w * w / std::abs(m[2][2] * m[3][3] - m[3][2] * m[2][3]);
}

double windowOf(const glm::dmat4& m, double distance)
{
    const glm::dvec4 clip = m * glm::dvec4(0, 0, -distance, 1);
    return clip.z / clip.w * 0.5 + 0.5;
}

StoredSurface drawn(Format format) { return {Semantic::other, format}; }
StoredSurface ofHost(Format format) { return {Semantic::other, format, false}; }
StoredSurface position(Format format) { return {Semantic::view_position, format}; }

const auto about = [](double value) { return Approx(value).epsilon(0.01); };

}  // namespace

TEST_CASE("A step of window depth is as long in view depth as the projection makes it")
{
    for (const Lens& lens : lenses()) {
        CAPTURE(lens.name);
        const SceneTraits traits = through(lens.clip_from_view);
        for (double distance = lens.nearest; distance < lens.farthest; distance *= 1.7) {
            CAPTURE(distance);
            const double slope = slopeOf(lens.clip_from_view, distance);
            CHECK(viewStep(traits, drawn(Format::depth16), distance) == about(slope / 65535));
            CHECK(viewStep(traits, drawn(Format::depth24), distance) == about(slope / 16777215));
            const double window = windowOf(lens.clip_from_view, distance);
            if (window < 1e-12) continue;  // double runs out here
            const double ulp = std::exp2(std::floor(std::log2(window)) - 23);
            const double step = viewStep(traits, ofHost(Format::depth32f), distance);
            CHECK(step <= 2.02 * slope * ulp);  // at powers of two the least rounding doubles it
            CHECK(step >= 0.49 * slope * ulp);
        }
    }
}

TEST_CASE("An orthographic view has one step at every distance")
{
    const SceneTraits traits = through(glm::ortho(-2.0, 3.0, -1.0, 1.0, -5.0, 45.0));
    CHECK(viewStep(traits, drawn(Format::depth16), 1) == about(50.0 / 65535));
    CHECK(viewStep(traits, drawn(Format::depth16), 49) == about(50.0 / 65535));
}

TEST_CASE("The known steps of depth and half floats come out")
{
    CHECK(viewStep(common(0.1, 1e5), drawn(Format::depth24), 100) == about(0.00596));
    CHECK(viewStep(common(0.001, 1e3), drawn(Format::depth24), 100) == about(0.596).epsilon(0.12));
    CHECK(viewStep(common(0.1, 1e4), drawn(Format::depth16), 10) == about(0.01524));
    CHECK(viewStep(common(0.001, 1e3), drawn(Format::depth16), 20) == about(6.1));
    const SceneTraits traits = common(0.1, 1e6);
    CHECK(viewStep(traits, position(Format::rgba16f), 100) == 0.0625);
    CHECK(viewStep(traits, position(Format::rgba16f), 1000) == 0.5);
    CHECK(std::isinf(viewStep(traits, position(Format::rgba16f), 65505)));
    CHECK(viewStep(traits, position(Format::rgba16f), 1e-6) == std::exp2(-14));
    CHECK(formatStep(Format::rgba16f, 1e-6) == std::exp2(-24));
    CHECK(formatStep(Format::rgba32f, 1e-6) == std::exp2(-43));
    CHECK(viewStep(traits, {Semantic::other, Format::rgba8}, 100) == 0);
}

TEST_CASE("A radius asks for a tenth of it as far as it covers two pixels")
{
    SceneTraits traits = common(0.1, 1000);
    const PrecisionNeed need = precisionNeed(traits, 0.5, 540);
    CHECK(need.step == Approx(0.05));
    const double pixels = 0.5 * traits.camera.zoom * 540 / 2 / need.distance;
    CHECK(pixels == Approx(2));
    CHECK(precisionNeed(traits, 50, 540).distance == about(1000));
    CHECK(precisionNeed(traits, 0, 540).distance == 0);
    CHECK(precisionNeed(traits, 1e-6, 540).distance == 0);  // below two pixels everywhere
    CHECK(precisionNeed(SceneTraits{}, 0.5, 540).distance == 0);
}

TEST_CASE("What is resolved ends where a step is a tenth of the radius")
{
    for (const Lens& lens : lenses()) {
        CAPTURE(lens.name);
        const SceneTraits traits = through(lens.clip_from_view);
        for (const double share : {1e-5, 1e-3, 0.1}) {
            const PrecisionNeed need = {lens.farthest * share, lens.farthest};
            const double end = resolvedDistance(traits, drawn(Format::depth16), need);
            CAPTURE(share, end);
            const double limit = need.step * 65535;
            if (end == need.distance)
                CHECK(slopeOf(lens.clip_from_view, end) < 1.01 * limit);
            else if (end > 0)
                CHECK(slopeOf(lens.clip_from_view, end) == about(limit));
            else
                CHECK(slopeOf(lens.clip_from_view, traits.camera.near_distance) > 0.99 * limit);
        }
    }
    const PrecisionNeed need = {0.05, 1000};
    CHECK(resolvedDistance(common(0.1, 1000), position(Format::rgba16f), need) == about(64));
    CHECK(resolvedDistance(common(0.1, 1000), position(Format::rgba32f), need) == 1000);
    CHECK(resolvedDistance(common(0.1, 1000), position(Format::rgba16f), {1e-9, 1}) == 0);
}

TEST_CASE("A camera's range is that of its planes, whatever the projection")
{
    for (const Lens& lens : lenses()) {
        CAPTURE(lens.name);
        const CameraRange range = through(lens.clip_from_view).camera;
        CHECK(range.near_distance < lens.nearest);
        CHECK(range.near_distance > 0.9 * lens.nearest);
        CHECK(range.far_distance > 0.9 * lens.farthest);  // a float matrix rounds it
        CHECK(range.zoom == Approx(lens.clip_from_view[1][1]));
    }
    CHECK(std::isinf(through(glm::infinitePerspective(1.0, 1.0, 0.1)).camera.far_distance));
}

TEST_CASE("Ranges are equal while planes and zoom move by less than a factor of two")
{
    const CameraRange range = common(0.1, 100).camera;
    CHECK(range == common(0.15, 100).camera);
    CHECK(range == common(0.06, 180).camera);
    CHECK_FALSE(range == common(0.3, 100).camera);
    CHECK_FALSE(range == common(0.1, 300).camera);
    CHECK_FALSE(range == through(glm::perspective(0.2, 1.5, 0.1, 100.0)).camera);
    CHECK_FALSE(range == through(glm::infinitePerspective(1.0, 1.5, 0.1)).camera);
    CHECK(CameraRange{} == CameraRange{});
    CHECK_FALSE(through(glm::infinitePerspective(1.0, 1.5, 0.1)).camera == range);

    // Where the far plane is lost in the rounding of the matrix, that plans nothing again.
    const CameraRange endless = common(1e-3, 1e7).camera;
    for (double near_distance = 0.6e-3; near_distance < 1.9e-3; near_distance *= 1.01)
        CHECK(endless == common(near_distance, 1e7).camera);
}
