// SPDX-License-Identifier: MIT
// The doctor: what is wrong with targets, which pass is to blame, and why.
#include "tools/render/target_diagnosis.h"
#include "tests/support/plan_rig.h"

#include <limits>

using namespace crevice;

namespace {

constexpr Extent kSize = {4, 3};

Image ramp()
{
    Image image(kSize, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = 0.1f * float(i);
    return image;
}

/// What an examination finds in a target that a pass of `chain` wrote.
TargetHealth examined(const Image& image, const std::string& target, const std::string& pass)
{
    TargetHealth health = examine(image, image);
    health.target = target;
    health.pass = pass;
    return health;
}

TargetHealth healthy(const std::string& target, const std::string& pass)
{
    return examined(ramp(), target, pass);
}

// Three passes in a row.
Description chain()
{
    return describe(Sketch{{"first: -> x", "second: x -> y", "third: y -> z"}, {{"out", "z"}}});
}

/// The one thing that is said of those targets.
Diagnostic saidOf(const std::vector<TargetHealth>& targets)
{
    const Diagnostics found = diagnose(chain(), planOf(chain()), targets);
    REQUIRE(found.size() == 1);
    return found[0];
}

}  // namespace

TEST_CASE("An examination counts what is not finite, and finds the first one")
{
    Image image = ramp();
    image.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
    image.at(3, 0) = std::numeric_limits<float>::infinity();
    const TargetHealth health = examine(image, image);
    CHECK(health.pixels == 12);
    CHECK(health.not_numbers == 1);
    CHECK(health.infinite == 1);
    CHECK(health.undefined == 0);
    CHECK(health.first_bad.x == 2);
    CHECK(health.first_bad.y == 1);  // from the upper row
    CHECK(health.maximum[0] == Approx(1.1f));

    Image both(kSize, 2);  // one pixel that is wrong in two ways counts once
    both.at(1, 1, 0) = std::numeric_limits<float>::infinity();
    both.at(1, 1, 1) = std::numeric_limits<float>::quiet_NaN();
    CHECK(examine(both, both).not_numbers == 1);
    CHECK(examine(both, both).infinite == 0);
}

TEST_CASE("Floats show what a format of 8 or 16 bits hides, and rounding is no fault")
{
    Image floats = ramp();
    floats.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
    floats.at(3, 0) = 1.7f;
    floats.at(1, 2) = 1.1f;
    floats.at(0, 2) = 1.001f;
    floats.at(2, 0) = -0.5f;
    TargetHealth health = examine(Image(kSize, 1), Image(kSize, 1));
    examineFloats(floats, Format::r8, health);
    CHECK(health.not_numbers == 1);
    CHECK(health.out_of_range == 4);  // with the 1.1 at the end of the ramp
    CHECK((health.first_bad.x == 1 && health.first_bad.y == 0));  // the uppermost
    CHECK(health.first_value == 1.1f);

    TargetHealth half = examine(Image(kSize, 1), Image(kSize, 1));
    floats.at(2, 1) = 7e4f;
    examineFloats(floats, Format::r16f, half);
    CHECK(half.not_numbers == 0);
    CHECK(half.out_of_range == 1);
    TargetHealth full = examine(Image(kSize, 1), Image(kSize, 1));
    examineFloats(floats, Format::r32f, full);
    CHECK_FALSE(full.bad());
}

TEST_CASE("A value that its format clamps is an error with the value and the pass")
{
    TargetHealth second = healthy("y", "second");
    second.out_of_range = 4;
    second.first_value = 1.7f;
    const Diagnostic said = saidOf({healthy("x", "first"), second});
    CHECK(said.code == Code::target_out_of_range);
    CHECK(said.pointer == "/passes/second");
    CHECK(said.message.find("pass 'second' writes 4 of 12 pixels out of range") == 0);
    CHECK(said.message.find("1.7") != std::string::npos);
}

TEST_CASE("A pixel that differs with the poison in memory is undefined")
{
    Image other = ramp();
    other.at(1, 2) += 0.5f;
    const TargetHealth health = examine(ramp(), other);
    CHECK(health.undefined == 1);
    CHECK(health.first_bad.x == 1);
    CHECK(health.first_bad.y == 0);
    CHECK(health.bad());
}

TEST_CASE("An image of one value in each channel is constant")
{
    Image image(kSize, 2, 0.5f);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) image.at(x, y, 1) = 0.25f;
    CHECK(examine(image, image).constant);
    image.at(3, 2, 1) = 0.26f;
    CHECK_FALSE(examine(image, image).constant);
}

TEST_CASE("The first pass that is wrong is named, and those behind it are notes")
{
    TargetHealth second = healthy("y", "second"), third = healthy("z", "third");
    second.not_numbers = 3;
    third.not_numbers = 7;
    const Diagnostic said = saidOf({healthy("x", "first"), second, third});
    CHECK(said.code == Code::target_not_finite);
    CHECK(said.pointer == "/passes/second");
    CHECK(said.message.find("pass 'second' writes 3 of 12 pixels") == 0);
    REQUIRE(said.notes.size() == 1);
    CHECK(said.notes[0].text.find("'third'") != std::string::npos);
}

TEST_CASE("What depends on poison is an error of the pass that left it, what is healthy none")
{
    TargetHealth first = healthy("x", "first");
    CHECK(diagnose(chain(), planOf(chain()), {first, healthy("z", "third")}).empty());
    first.undefined = 12;
    const Diagnostic said = saidOf({first});
    CHECK(said.code == Code::target_undefined);
    CHECK_FALSE(said.help.empty());
}

TEST_CASE("An output that is the same everywhere is traced to the pass where that began")
{
    const Image white(kSize, 1, 1.0f);
    const Diagnostic said = saidOf(
        {healthy("x", "first"), examined(white, "y", "second"), examined(white, "z", "third")});
    CHECK(said.code == Code::output_constant);
    CHECK(said.severity == Severity::warning);
    CHECK(said.pointer == "/passes/second");
}

TEST_CASE("Occlusion that is the same everywhere is found beside the depth that a texel has too")
{
    Image packed(kSize, 2, 1.0f);
    for (std::size_t i = 1; i < packed.pixels.size(); i += 2) packed.pixels[i] = 0.01f * float(i);
    const Image white(kSize, 1, 1.0f);
    CHECK(saidOf({healthy("x", "first"), examined(packed, "y", "second"),
                  examined(white, "z", "third")})
              .pointer == "/passes/second");
    const Image grey(kSize, 1, 0.5f);  // which does not come of the 1
    CHECK(saidOf({healthy("x", "first"), examined(packed, "y", "second"),
                  examined(grey, "z", "third")})
              .pointer == "/passes/third");
}
