// SPDX-License-Identifier: MIT
// FLIP against what its paper's own program gives, and against what any difference must be.
#include "tools/render/image/image_metrics.h"

#include "tests/support/catch.h"

using namespace crevice;

namespace {

constexpr Extent kSize = {48, 32};

/// Stripes of eight pixels, of that contrast about a middle grey.
Image stripes(float contrast, int shift = 0)
{
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x)
            image.at(x, y) = (x + shift) / 8 % 2 ? 0.5f + contrast / 2 : 0.5f - contrast / 2;
    return image;
}

Image filled(float red, float green, float blue)
{
    Image image(kSize, 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        image.pixels[i] = red;
        image.pixels[i + 1] = green;
        image.pixels[i + 2] = blue;
    }
    return image;
}

}  // namespace

TEST_CASE("FLIP of pictures without an edge is that of their colours alone, as published")
{
    // |L| of 100 to the power of 0.7 is 25.12; green and blue are 41.28 apart; 40 % of that take 95
    // % of the range [Andersson et al. 2020, section 4.1].
    CHECK(meanFlip(filled(1, 1, 1), filled(0, 0, 0)) == Approx(0.9674).margin(5e-4));
    CHECK(meanFlip(filled(0, 1, 0), filled(0, 0, 1)) == Approx(1.0).margin(1e-6));
    CHECK(meanFlip(Image(kSize, 1, 0.5f), filled(0.5f, 0.5f, 0.5f)) == Approx(0.0).margin(1e-9));
}

TEST_CASE("FLIP is 0 for equal pictures, symmetric, and grows with contrast")
{
    const Image grey(kSize, 1, 0.5f);
    CHECK(meanFlip(stripes(0.4f), stripes(0.4f)) == 0.0);
    CHECK(meanFlip(stripes(0.4f), grey) == Approx(meanFlip(grey, stripes(0.4f))));
    double last = 0;
    for (const float contrast : {0.05f, 0.1f, 0.2f, 0.4f, 0.8f}) {
        const double flip = meanFlip(stripes(contrast), grey);
        CHECK(flip > last);
        CHECK(flip < 1.0);
        last = flip;
    }
}

TEST_CASE(
    "FLIP sees an edge that moves more than the same change of an even area, and less from afar")
{
    const double moved = meanFlip(stripes(0.4f, 1), stripes(0.4f));
    CHECK(moved > meanFlip(Image(kSize, 1, 0.55f), Image(kSize, 1, 0.5f)));  // the same mean change
    CHECK(meanFlip(stripes(0.4f, 1), stripes(0.4f), 200) < moved);
}
