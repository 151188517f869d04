// SPDX-License-Identifier: MIT
// Properties of the shipped effects, drawn for real: what must hold whatever the pixels are.
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

using namespace crevice;

namespace {

const char* const kHemispheres[] = {"learnopengl", "thesis", "hemisphere_box",
                                    "hemisphere_bilateral"};

double meanOfRows(const Image& image, int first, int last)
{
    double sum = 0;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < image.extent.width; ++x) sum += image.at(x, y);
    return sum / ((last - first) * double(image.extent.width));
}

}  // namespace

TEST_CASE("Every shipped config draws visibility and a picture that is not black")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        PictureRequest request;
        request.config = name;
        const Image ao = picture(request);
        CHECK(allVisibility(ao));
        CHECK(mean(ao) > 0.2);
        CHECK(mean(ao) < 1.0);

        request.output = "color";
        const Image color = picture(request);
        CHECK(allVisibility(color));
        CHECK(shareBelow(color, 0.02f, 1.0) < 0.01);
    }
}

TEST_CASE("A flat plane is open under the hemisphere kernel with guards")
{
    for (const char* config : kHemispheres) {
        INFO(config);
        PictureRequest request;
        request.config = config;
        request.overrides = {"guards=true", "bias=0.025"};
        request.scene = "plane";
        const Image ao = picture(request);
        CHECK(mean(ao) >= 0.999);
        CHECK(shareBelow(ao, 0.95f) == 0.0);
    }
}

TEST_CASE("A flat plane is grey under the sphere kernel, its authors' look")
{
    PictureRequest request;
    request.config = "sphere_box";
    request.scene = "plane";
    const Image ao = picture(request);
    CHECK(ao.at(64, 20) > 0.35f);
    CHECK(ao.at(64, 20) < 0.7f);
}

TEST_CASE("An inner corner is darker than the wall away from it")
{
    // The edge runs across the middle of the picture; rows far above and below see flat walls.
    for (const std::string& config : configNames(shippedSources())) {
        INFO(config);
        PictureRequest request;
        request.config = config;
        request.scene = "corner";
        request.camera = "eye=0,1.5,4;at=0,0,0;fov=40";
        const Image ao = picture(request);
        const int middle = ao.extent.height / 2;
        CHECK(meanOfRows(ao, middle - 3, middle + 3) < meanOfRows(ao, 4, 12) - 0.05);
    }
}

TEST_CASE("More radius never lightens the corner")
{
    PictureRequest request;
    request.scene = "corner";
    request.camera = "eye=0,1.5,4;at=0,0,0;fov=40";
    double last = 1.0;
    for (const char* radius : {"radius=0.05", "radius=0.2", "radius=0.5"}) {
        request.overrides = {radius};
        const Image ao = picture(request);
        const double now = mean(ao);
        INFO(radius);
        CHECK(now <= last + 0.002);
        last = now;
    }
}

TEST_CASE("Intensity 0 and radius 0 are the no-op")
{
    for (const char* off : {"intensity=0", "radius=0"}) {
        PictureRequest request;
        request.overrides = {off};
        CHECK(mean(picture(request)) == 1.0);

        request.output = "color";
        const Image without_work = picture(request);
        request.overrides = {"display=no_ao"};
        INFO(off);
        CHECK(meanChange(without_work, picture(request)) == 0.0);
    }
}

TEST_CASE("Occlusion does not depend on whether positions are stored or rebuilt from depth")
{
    PictureRequest request;
    request.config = "hemisphere_box";
    const Image from_depth = picture(request);
    request.config = "learnopengl";
    request.overrides = {"samples=32",
                         "guards=true",
                         "bias=0.025",
                         "bias_length=0",
                         "basis=rotated",
                         "/generated/kernel/shape=ball",
                         "/generated/kernel/lengths=even",
                         "/generated/rotation_noise/generator=rotation_noise"};
    CHECK(meanChange(from_depth, picture(request)) < 0.004);
}

TEST_CASE("250 offsets without rotation draw what 16 with rotation and a filter do")
{
    PictureRequest request;
    request.overrides = {"samples=16"};
    const Image filtered = picture(request);
    request.overrides = {"samples=250", "/generated/rotation_noise/count=1", "blur_size=1"};
    const Image many = picture(request);
    CHECK(mean(many) < 0.99);
    CHECK(meanChange(filtered, many) < 0.01);
}

TEST_CASE("An orthographic view is occluded like the narrow perspective that tends to it")
{
    PictureRequest request;
    request.scene = "corner";
    request.camera = "eye=0,200,200;at=0,0,0;fov=0.81";
    const Image narrow = picture(request);
    request.camera = "eye=0,200,200;at=0,0,0;ortho=4";
    const Image orthographic = picture(request);
    CHECK(mean(orthographic) < 0.99);
    CHECK(meanChange(narrow, orthographic) < 0.01);
}

TEST_CASE("The three display modes agree with each other")
{
    PictureRequest request;
    request.config = "learnopengl";
    const Image ao = picture(request);
    request.output = "color";
    request.overrides = {"display=ao_only"};
    const Image shown = picture(request);
    for (int x = 0; x < ao.extent.width; ++x) CHECK(shown.at(x, 30) == ao.at(x, 30));

    request.overrides = {"display=no_ao"};
    const double without = mean(picture(request));
    request.overrides = {};
    const double with = mean(picture(request));
    request.overrides = {"ao_on=everything"};
    const double everything = mean(picture(request));
    CHECK(with < without);
    CHECK(everything < with);
}

TEST_CASE("Bare OpenGL ES 3.0 draws the same occlusion where no float target is needed")
{
    PictureRequest request;
    const Image full = picture(request);
    request.ignore_extensions = true;
    CHECK(meanChange(full, picture(request)) == 0.0);
}

TEST_CASE("Odd and tiny sizes draw finite visibility")
{
    for (const Extent extent : {Extent{1, 1}, Extent{1, 37}, Extent{3, 2}, Extent{127, 5}}) {
        for (const char* config : {"learnopengl", "hemisphere_bilateral", "ogldev45"}) {
            PictureRequest request;
            request.config = config;
            request.extent = extent;
            INFO(config << " " << extent.width << "x" << extent.height);
            CHECK(allVisibility(picture(request)));
        }
    }
}
