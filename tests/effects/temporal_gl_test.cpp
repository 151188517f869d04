// SPDX-License-Identifier: MIT
// The mean over frames, drawn for real: what it gathers, what it forgets, and what it never shows.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kExtent = {128, 72};

// Another number in 0..1 for each pixel and frame of a cycle of eight.
const char* const kNoise =
    "fract(sin(dot(gl_FragCoord.xy + float(frame_index % 8) * 7.31, "
    "vec2(12.9898, 78.233))) * 43758.5)";
// Leaves the filter out.
const char* const kRaw = "/outputs/ao=ao";
// Stripes that stand still in the world.
const char* const kStripes = "(fract(world.x * 2.0) < 0.5 ? 0.2 : 0.8)";

/// A filter over an occlusion that a line of GLSL gives: of uv, the point in the world and the
/// frame.
struct Film : SceneRig {
    explicit Film(const std::string& ao, const std::string& scene_name = "plane",
                  const std::vector<std::string>& overrides = {})
        : SceneRig(scene_name, kExtent),
          film(renderer(filterOver(ao, "temporal", "r16f", overrides, "0.25"), now, {"ao"}))
    {
    }

    void look(const std::string& camera) { now = frame(camera); }

    Image draw(int frames = 1)
    {
        for (int i = 0; i < frames; ++i) need(film->render(now));
        return read(film->output("ao"));
    }

    Frame now = frame("eye=0,2,1;at=0,0,0;fov=30");
    std::unique_ptr<Renderer> film;
};

/// How far pixels lie from their mean.
double spread(const Image& image)
{
    const double middle = mean(image);
    double sum = 0;
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x)
            sum += (image.at(x, y) - middle) * (image.at(x, y) - middle);
    return std::sqrt(sum / (double(image.extent.width) * image.extent.height));
}

/// Draws while the camera goes sideways along a wall or past a scene, a frame a step.
Image travel(Film& film, double height, double distance)
{
    Image last;
    for (int step = 0; step <= 8; ++step) {
        const std::string x = std::to_string(step * 0.03);
        film.look("eye=" + x + "," + std::to_string(height) + "," + std::to_string(distance) +
                  ";at=" + x + ",0,0;fov=30");
        last = film.draw();
    }
    return last;
}

}  // namespace

TEST_CASE("The first frame is the picture without a history, and so is the one after a cut")
{
    Film film(kNoise);
    Film raw(kNoise, "plane", {kRaw});
    CHECK(meanChange(film.draw(), raw.draw()) == 0.0);
    film.draw(3);
    raw.draw(3);
    film.now.camera_cut = true;
    CHECK(meanChange(film.draw(), raw.draw()) == 0.0);
    film.now.camera_cut = false;
    CHECK(meanChange(film.draw(), raw.draw()) > 0.05);
}

TEST_CASE("Under a still camera noise falls and the mean stays")
{
    for (const char* clamp : {"history_clamp=true", "history_clamp=false"}) {
        Film film(kNoise, "plane", {clamp});
        const Image first = film.draw();
        const Image fourth = film.draw(3);
        const Image late = film.draw(28);
        INFO(clamp);
        CHECK(spread(fourth) < 0.6 * spread(first));
        CHECK(spread(late) < 0.4 * spread(first));
        CHECK(mean(late) == Approx(mean(first)).margin(0.01));
        CHECK(meanChange(late, film.draw(1)) == 0.0);
        CHECK(meanChange(late, film.draw(8)) == 0.0);
    }
}

TEST_CASE("A mean that stands still notices within a cycle that something changed")
{
    // By less than the clamp finds, in noise.
    const std::string changes =
        std::string("0.4 + 0.2 * ") + kNoise + " + (frame_index < 48 ? 0.0 : 0.1)";
    Film film(changes);
    film.draw(40);
    const double before = mean(film.draw(8));
    const double after = mean(film.draw(16));  // the change comes in its first frame
    CHECK(after == Approx(before + 0.1).margin(0.01));
    const Image rest = film.draw(8);
    CHECK(meanChange(rest, film.draw(1)) == 0.0);
}

TEST_CASE("What changes comes in by the history's frames, and at first each frame counts alike")
{
    const std::vector<std::string> half = {"history_frames=2", "history_clamp=false"};
    Film late("float(frame_index < 30 ? 0.2 : 0.8)", "plane", half);
    late.draw(30);
    CHECK(mean(late.draw(1)) == Approx(0.5).margin(0.01));
    CHECK(mean(late.draw(2)) == Approx(0.8 - 0.6 / 8).margin(0.01));
    Film early("float(frame_index < 1 ? 0.2 : 0.8)", "plane", {"history_clamp=false"});
    CHECK(mean(early.draw(3)) == Approx((0.2 + 0.8 + 0.8) / 3).margin(0.01));
}

TEST_CASE("A constant stays that constant, and 1 stays 1")
{
    for (const char* ao : {"1.0", "0.5"}) {
        Film film(ao);
        const float value = film.draw().pixels.front();
        const Image late = film.draw(20);
        for (const float each : late.pixels) REQUIRE(each == value);
    }
}

TEST_CASE("What the camera moves past comes along and leaves no ghost on a wall")
{
    for (const char* clamp : {"history_clamp=true", "history_clamp=false"}) {
        Film film(kStripes, "plane", {clamp});
        Film still(kStripes, "plane", {kRaw});
        const Image moved = travel(film, 2, 1);
        const Image now = travel(still, 2, 1);
        INFO(clamp);
        CHECK(allVisibility(moved));
        CHECK(meanChange(moved, now) < 0.03);
    }
}

TEST_CASE("What moves by itself keeps its history where the host gives velocities")
{
    // Noise on stripes that go to the right by 3 pixels a frame, under a still camera.
    const std::string stripes =
        "(fract((gl_FragCoord.x - 3.0 * float(frame_index)) / 32.0) < 0.5 ? 0.2 : 0.6)";
    const std::string noisy = stripes + " + 0.4 * " + kNoise;
    const auto error = [&](float pixels, const char* told) {
        Film film(noisy, "plane", {"history_clamp=false", told});
        Film exact(stripes + " + 0.2", "plane", {kRaw});
        const TextureId velocity = film.texture(Format::rg16f, kExtent);
        Image moved(kExtent, 2);
        for (std::size_t i = 0; i < moved.pixels.size(); i += 2)
            moved.pixels[i] = pixels / float(kExtent.width);
        need(film.device->writeTexture(velocity, moved));
        film.now.textures = {{"velocity", velocity}};
        exact.draw(23);
        return meanChange(film.draw(24), exact.draw());
    };
    const double raw = 0.1;  // of noise over 0..0.4, from its middle
    CHECK(error(3, "host_velocity=true") < 0.6 * raw);
    CHECK(error(-3, "host_velocity=true") > raw);
    CHECK(error(3, "host_velocity=false") > raw);
}

TEST_CASE("A surface that comes into view has no history of the one before it")
{
    // Spheres are dark, what they stand before is bright.
    const char* const ao = "(world.y > 0.01 ? 0.2 : 0.8)";
    const auto ghost = [&](const char* cut) {
        Film film(ao, "spheres", {"history_clamp=false", cut});
        Film still(ao, "spheres", {kRaw});
        return meanChange(travel(film, 1, 6), travel(still, 1, 6));
    };
    const double without = ghost("history_cut=1000");
    CHECK(ghost("history_cut=0.5") < 0.5 * without);
}
