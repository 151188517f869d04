// SPDX-License-Identifier: MIT
// The figures between two images, on images whose figures are known.
#include "tools/render/image/image_metrics.h"

#include "tests/support/need.h"

#include <cmath>
#include <limits>

using namespace crevice;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Values spread over (0, 1].
Image ramp(int count, double power = 1.0)
{
    Image image({count, 1}, 1);
    for (int x = 0; x < count; ++x)
        image.at(x, 0) = static_cast<float>(std::pow((x + 1.0) / count, power));
    return image;
}

ImageDifference compare(const Image& test, const Image& ground_truth, const Image* mask = nullptr)
{
    return need(compareImages(test, ground_truth, mask));
}

}  // namespace

TEST_CASE("a constant error is rmse and bias alike")
{
    const ImageDifference figures = compare(Image({8, 8}, 1, 0.7f), Image({8, 8}, 1, 0.8f));
    CHECK(figures.rmse == Approx(0.1));
    CHECK(figures.bias == Approx(-0.1));
    CHECK(figures.p99 == Approx(0.1));
    CHECK(figures.max == Approx(0.1));
    CHECK(figures.psnr_db == Approx(20));
    CHECK(figures.bad_fraction == 1);
}

TEST_CASE("the 99th percentile passes over one pixel in a hundred")
{
    Image test = ramp(200);
    test.at(17, 0) += 0.5f;
    const ImageDifference figures = compare(test, ramp(200));
    CHECK(figures.p99 == 0);
    CHECK(figures.max == Approx(0.5));
    CHECK(figures.rmse == Approx(0.5 / std::sqrt(200.0)));
    CHECK(figures.bad_fraction == Approx(0.005));

    test = ramp(100);
    test.at(17, 0) += 0.5f;
    CHECK(compare(test, ramp(100)).p99 == 0);
    test.at(80, 0) += 0.25f;
    CHECK(compare(test, ramp(100)).p99 == Approx(0.25));
}

TEST_CASE("the pattern is what of an error repeats every few pixels, and no other")
{
    const auto patternOf = [](auto error) {
        Image test({64, 48}, 1, 0.5f);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) test.at(x, y) += 0.1f * error(x, y);
        return compare(test, Image({64, 48}, 1, 0.5f)).pattern;
    };
    CHECK(patternOf([](int, int) { return 1; }) < 1e-6);
    CHECK(patternOf([](int x, int y) { return (x + y) % 2 ? 1 : -1; }) < 0.02);
    CHECK(patternOf([](int x, int) { return x / 64.0; }) < 0.01);
    CHECK(patternOf([](int x, int) { return x % 6 < 3 ? 1 : -1; }) > 0.06);
    CHECK(patternOf([](int x, int y) { return (x / 4 + y / 4) % 2 ? 1 : -1; }) > 0.05);
}

TEST_CASE("the fit finds the power that was applied, and is never worse than none")
{
    for (const double power : {0.2, 0.5, 1.8, 5.0}) {
        const ImageDifference figures = compare(ramp(500), ramp(500, power));
        CHECK(figures.power_fit == Approx(power).epsilon(1e-3));
        CHECK(figures.rmse_fit < 1e-4);
        CHECK(figures.rmse > 0.05);
    }
    const Image one({4, 4}, 1, 1.0f);  // to any power
    const ImageDifference figures = compare(one, Image({4, 4}, 1, 0.25f));
    CHECK(figures.rmse_fit == Approx(figures.rmse));
    CHECK(figures.power_fit == 1);
}

TEST_CASE("only pixels with a ground truth, a finite value and no mask of zero count")
{
    Image ground_truth = ramp(10), test = ramp(10), mask({10, 1}, 1, 1.0f);
    ground_truth.at(0, 0) = test.at(0, 0) = kNan;
    mask.at(1, 0) = 0;
    test.at(1, 0) = 99;
    const ImageDifference masked = compare(test, ground_truth, &mask);
    CHECK(masked.rmse == 0);
    CHECK(masked.pixels == 8);
    CHECK(masked.masked == 2);
    CHECK(masked.non_finite == 0);
    test = ramp(10);
    test.at(3, 0) = kNan;
    test.at(4, 0) = std::numeric_limits<float>::infinity();
    const ImageDifference broken = compare(test, ramp(10));
    CHECK(broken.non_finite == 2);
    CHECK(broken.pixels == 8);
    CHECK(broken.rmse == 0);
    const ImageDifference nothing = compare(ramp(3), Image({3, 1}, 1, kNan));
    CHECK(nothing.rmse == 0);
    CHECK(nothing.pixels == 0);
    CHECK(nothing.masked == 3);
}

TEST_CASE("the difference picture is blue where darker, red where brighter, white where equal")
{
    Image ground_truth({5, 1}, 1, 0.5f), test = ground_truth;
    test.at(1, 0) = 0.0f;
    test.at(2, 0) = 1.0f;
    test.at(3, 0) = kNan;
    ground_truth.at(4, 0) = kNan;
    const Image picture = need(differencePicture(test, ground_truth));
    REQUIRE(picture.channels == 3);
    CHECK(picture.pixels ==
          std::vector<float>{1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0.5f, 0.5f, 0.5f});
}
