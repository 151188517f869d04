// SPDX-License-Identifier: MIT
// The truth at some pixels: that of the whole picture, and what margins it leaves.
#include "tools/measure/reference/sparse_truth.h"

#include "tests/tools/measure/reference/tracer_shot.h"

#include "tools/render/image/image_metrics.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {96, 64};

struct Subject {
    Shot shot = {sceneOf({kFloor, kWall, makeSphere(2, 16)}),
                 {glm::lookAt(glm::vec3(3, 6, 9), glm::vec3(0), glm::vec3(0, 1, 0)),
                  glm::perspective(0.9f, 1.5f, 0.1f, 500.0f)}};
    std::unique_ptr<RayScene> tree = makeBvhScene(shot.scene, {3, 6, 9});
    Image whole = trace(*tree, shot.camera, kExtent, 4.0, 32);

    SparseTruth begin() const
    {
        return need(SparseTruth::begin(*tree, shot.camera, kExtent, {4.0, 32}));
    }
};

/// Some smooth picture that is wrong here and there.
Image wrongPicture()
{
    Image picture(kExtent, 1);
    for (int y = 0; y < kExtent.height; ++y)
        for (int x = 0; x < kExtent.width; ++x)
            picture.at(x, y) = 0.8f + 0.2f * std::sin(0.3f * float(x)) * std::cos(0.2f * float(y));
    return picture;
}

}  // namespace

TEST_CASE("the truth at some pixels is that of the whole picture, and what is known stays")
{
    const Subject subject;
    SparseTruth truth = subject.begin();
    need(truth.grow(100));
    const std::vector<TruePixel> first = truth.pixels();
    REQUIRE(first.size() >= 100);
    need(truth.grow(4000));
    REQUIRE(truth.pixels().size() >= 4000);
    for (const TruePixel& pixel : truth.pixels())
        CHECK(pixel.visibility == subject.whole.at(pixel.x, pixel.y));
    for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].x == truth.pixels()[i].x);
}

TEST_CASE("an error over some pixels is that of all within its margin, which shrinks")
{
    const Subject subject;
    const Image picture = wrongPicture();
    const ImageDifference all = need(compareImages(picture, subject.whole));
    SparseTruth truth = subject.begin();
    double before = 1;
    for (const std::size_t pixels : {500, 1500, 5000}) {
        need(truth.grow(pixels));
        const SparseError some = need(sparseError(picture, truth));
        INFO(truth.pixels().size());
        CHECK(std::abs(some.rmse - all.rmse) < some.margin);
        CHECK(some.margin < before);
        CHECK(some.bias == Approx(all.bias).margin(some.margin));
        CHECK(some.p99 <= all.max);
        before = some.margin;
    }
    CHECK(before < 0.05 * all.rmse);
    const SparseError none = need(sparseError(Image(kExtent, 1, 1.0f), truth));
    CHECK(none.rmse == Approx(none.without_ao));
    CHECK(none.dark == 0.0);
    CHECK(need(sparseError(Image(kExtent, 1, 0.0f), truth)).dark == 1.0);
}

TEST_CASE("two pictures are told apart by the pixels that both have")
{
    const Subject subject;
    SparseTruth truth = subject.begin();
    need(truth.grow(400));
    Image picture = wrongPicture(), better = picture;
    for (std::size_t i = 0; i < better.pixels.size(); ++i)
        better.pixels[i] += 0.01f * (subject.whole.pixels[i] - better.pixels[i]);
    for (float& value : better.pixels)
        if (std::isnan(value)) value = 1.0f;
    const SparseError more = need(sparseError(picture, truth)),
                      less = need(sparseError(better, truth));
    CHECK(more.rmse - less.rmse < more.margin);  // which by themselves could be equal
    CHECK(deviationsBelow(less, more) > 3.0);
    CHECK(deviationsBelow(more, less) < -3.0);
    CHECK(deviationsBelow(less, more, 0.9) < -3.0);  // not by a tenth
    picture.pixels.assign(picture.pixels.size(), std::nanf(""));
    CHECK(sparseError(picture, truth).diagnostics().front().code == Code::not_finite);
}

TEST_CASE("a truth of a view that sees nothing says so")
{
    Subject subject;
    subject.shot.camera.view_from_world =
        glm::lookAt(glm::vec3(3, 6, 9), glm::vec3(6, 12, 18), glm::vec3(0, 1, 0));
    SparseTruth truth = subject.begin();
    CHECK(truth.grow(10).diagnostics().front().code == Code::nothing_seen);
}
