// SPDX-License-Identifier: MIT
// Draws outside the view: never one of which a part could show, and most that are far from it.
#include <crevice/renderer.h>

#include "core/run/view_draws.h"

#include "tests/support/renderer_rig.h"
#include "tests/support/shipped_subjects.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>
#include <sstream>

using namespace crevice;

namespace {

const glm::mat4 kReversed = glm::scale(glm::mat4(1), glm::vec3(1, 1, -1));

struct View {
    const char* name;
    glm::mat4 clip_from_view;
};

const View kViews[] = {
    {"perspective", glm::perspective(0.8f, 1.7f, 0.1f, 50.0f)},
    {"wide", glm::perspective(2.6f, 1.0f, 0.1f, 50.0f)},
    {"off-centre", glm::frustum(-0.01f, 0.2f, 0.0f, 0.1f, 0.1f, 50.0f)},
    {"infinite", glm::infinitePerspective(0.8f, 1.7f, 0.1f)},
    {"reversed, infinite", kReversed* glm::infinitePerspective(0.8f, 1.7f, 0.1f)},
    {"orthographic", glm::ortho(-3.0f, 4.0f, -1.0f, 2.0f, 0.1f, 50.0f)},
};

/// The part of the volume's half spaces that holds a point, as shaders place it.
bool shows(const glm::mat4& clip_from_model, const glm::vec3& point, float wider)
{
    const glm::vec4 clip = clip_from_model * glm::vec4(point, 1);
    return std::abs(clip.x) <= wider * clip.w && std::abs(clip.y) <= wider * clip.w &&
           std::abs(clip.z) <= clip.w;
}

bool isOutside(const DrawItem& item, const CameraMatrices& camera, double wider)
{
    const glm::dmat4 view_from_model = camera.view_from_world * item.world_from_model;
    return isOutside(boundsInView(item, view_from_model), viewVolume(camera, wider));
}

PixelArea pixelsOf(const std::vector<DrawItem>& draws, const CameraMatrices& camera,
                   const Extent& extent, double length)
{
    const DrawnList drawn = {draws, {}, {Material()}};
    ViewDraws view(drawn);
    view.begin(camera);
    return pixelsOf(view.area(extent, length), extent);
}

}  // namespace

TEST_CASE("Nothing that has a point in the view is outside, however it is placed and stretched")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> around(-1.0f, 1.0f);
    const auto vector = [&] { return glm::vec3(around(random), around(random), around(random)); };
    int elided = 0;
    int shown = 0;
    for (const View& view : kViews) {
        INFO(view.name);
        for (int i = 0; i < 2000; ++i) {
            Camera camera;
            camera.clip_from_view = view.clip_from_view;
            camera.view_from_world = glm::rotate(glm::dmat4(1), 3.0 * around(random),
                                                 glm::dvec3(glm::normalize(vector() + 1e-3f)));
            DrawItem item;
            item.bounds_center = vector();
            item.bounds_radius = std::abs(around(random));
            glm::mat4 placed = glm::translate(glm::mat4(1), 20.0f * vector());
            placed[0] += glm::vec4(2.0f * vector(), 0);  // shears and mirrors, too
            placed[1] *= 3.0f * around(random);
            item.world_from_model = placed;
            const CameraMatrices matrices = cameraMatrices(camera);
            const glm::mat4 clip_from_model(matrices.clip_from_view * matrices.view_from_world *
                                            item.world_from_model);
            const float wider = i % 2 == 0 ? 1.0f : 1.4f;
            bool visible = false;
            for (int k = 0; k < 60 && !visible; ++k) {
                const glm::vec3 on = glm::normalize(vector() + 1e-4f) * item.bounds_radius;
                visible = shows(clip_from_model, item.bounds_center + on * float(k % 2), wider);
            }
            const bool outside = isOutside(item, matrices, wider);
            CHECK_FALSE((visible && outside));
            elided += outside;
            shown += visible;
        }
    }
    CHECK(elided > 3000);
    CHECK(shown > 500);
}

TEST_CASE("What shows of a draw lies in the area of draws, and the area of what is far is small")
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> around(-1.0f, 1.0f);
    const auto vector = [&] { return glm::vec3(around(random), around(random), around(random)); };
    const Extent extent = {160, 90};
    int shown = 0;
    int small = 0;
    for (const View& view : kViews) {
        INFO(view.name);
        Camera camera;
        camera.clip_from_view = view.clip_from_view;
        const CameraMatrices matrices = cameraMatrices(camera);
        const glm::mat4 clip_from_world(matrices.clip_from_view * matrices.view_from_world);
        for (int i = 0; i < 500; ++i) {
            DrawItem item;
            item.count = 3;
            item.bounds_radius = 0.5f * std::abs(around(random));
            item.world_from_model = glm::translate(glm::dmat4(1), glm::dvec3(12.0f * vector()));
            const PixelArea area =
                pixelsOf({item}, matrices, extent, std::numeric_limits<double>::infinity());
            const Extent all = area.extent;
            small += all.width > 0 && all.width * all.height < extent.width * extent.height / 20;
            for (int k = 0; k < 40; ++k) {
                const glm::vec3 on = glm::normalize(vector() + 1e-4f) * item.bounds_radius;
                const glm::vec3 point = glm::vec3(item.world_from_model[3]) + on;
                if (!shows(clip_from_world, point, 1.0f)) continue;
                ++shown;
                const glm::vec4 clip = clip_from_world * glm::vec4(point, 1);
                const float x = (clip.x / clip.w * 0.5f + 0.5f) * extent.width;
                const float y = (clip.y / clip.w * 0.5f + 0.5f) * extent.height;
                CHECK((x >= area.x && x <= area.x + all.width));
                CHECK((y >= area.y && y <= area.y + all.height));
            }
        }
    }
    CHECK(shown > 3000);
    CHECK(small > 200);
}

TEST_CASE(
    "An item without bounds is never outside, and one that wider views show is not outside of "
    "those")
{
    Camera camera;
    camera.clip_from_view = glm::perspective(0.8f, 1.0f, 0.1f, 50.0f);
    const CameraMatrices matrices = cameraMatrices(camera);
    DrawItem item;
    item.world_from_model = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 10));
    CHECK_FALSE(isOutside(item, matrices, 1));
    item.bounds_radius = 1;
    CHECK(isOutside(item, matrices, 1));
    for (const glm::dvec2 off : {glm::dvec2(6, 0), {-6, 0}, {0, 6}, {0, -6}}) {
        INFO(off.x << ' ' << off.y);
        item.world_from_model = glm::translate(glm::dmat4(1), glm::dvec3(off, -10));
        CHECK(isOutside(item, matrices, 1));
        CHECK_FALSE(isOutside(item, matrices, 1.4));
        CHECK(isOutside(item, matrices, 1.1));
    }
}

namespace {

/// Cubes of which each lies at some x, drawn through gtao on a recording device.
struct Cubes {
    explicit Cubes(const std::vector<double>& places)
    {
        const MeshId mesh =
            device.createMesh({"cube", std::vector<Vertex>(3), {0, 1, 2, 2, 1, 0}}).value();
        frame.camera.clip_from_view = glm::perspective(0.8f, 2.0f, 0.1f, 50.0f);
        frame.materials.resize(1);
        for (const double x : places) {
            DrawItem item = {mesh, 0, 6, glm::translate(glm::dmat4(1), glm::dvec3(x, 0, -5)), 0};
            item.bounds_radius = 1;
            frame.draws.push_back(item);
        }
    }

    /// The calls of a frame, with these optimizations off.
    std::vector<std::string> calls(const std::vector<std::string>& keep)
    {
        CompileOptions options;
        options.extent = {64, 32};
        options.disable = keep;
        const auto renderer =
            need(Renderer::create(device, descriptionOf({"gtao"}), options, traitsOf(frame)));
        device.clearLog();
        need(renderer->render(frame));
        std::vector<std::string> lines;
        std::istringstream log(device.log());
        for (std::string line; std::getline(log, line);) lines.push_back(line);
        return lines;
    }

    /// How many of them are drawn.
    std::ptrdiff_t drawn(const std::vector<std::string>& keep = {})
    {
        const std::vector<std::string> all = calls(keep);
        return std::count(all.begin(), all.end(), "draw mesh 'cube' 0..6");
    }

    RecordingDevice device;
    Frame frame;
};

}  // namespace

TEST_CASE("A frame draws what lies in the view, and all of it with the optimization off")
{
    Cubes cubes({0, 100});
    CHECK(cubes.drawn() == 1);
    CHECK(cubes.drawn({"frustum_culling"}) == 2);
}

TEST_CASE("A param that says how far beyond the view draws count does so at once")
{
    Description description = describe(kRigConfig, rigSources(""));
    for (PassDesc& pass : description.passes)
        if (pass.name == "geometry") pass.frustum_scale_param.name = "radius";
    RecordingDevice device;
    const auto renderer = need(Renderer::create(device, description, {{64, 32}}, {}));
    CHECK(renderer->plan().passes[0].frustum_scale == 0.5f);
    REQUIRE(renderer->setParam("radius", 2.0f).ok());
    CHECK(renderer->plan().passes[0].frustum_scale == 2);
}

TEST_CASE("What the guard band shows by being whole pixels is drawn as well")
{
    const auto scales = [](const char* config, const char* band, const Extent& extent) {
        RecordingDevice device;
        const LoadRequest request = {config, {}, {std::string("guard_band=") + band}};
        const Description description =
            need(decode(need(loadConfig(shippedSources(), request)), shippedSources()));
        const auto renderer = need(Renderer::create(device, description, {extent}, {}));
        std::vector<float> all;
        for (const PlanPass& pass : renderer->plan().passes)
            if (pass.frustum_scale > 0) all.push_back(pass.frustum_scale);
        return all;
    };
    CHECK(scales("gtao", "1.4", {640, 320}) == std::vector<float>{1.4f});
    CHECK(scales("gtao", "1.4", {64, 32}) == std::vector<float>{46.0f / 32.0f});
    CHECK(scales("bitmask_layers", "2", {64, 33}) == std::vector<float>(4, 67.0f / 33.0f));
}

TEST_CASE("With nothing in view occlusion and its filters are cleared and not drawn")
{
    const auto drawn = [](double x, const std::vector<std::string>& keep) {
        Cubes cubes({x});
        std::vector<std::string> passes;
        std::string pass;
        for (const std::string& call : cubes.calls(keep)) {
            if (startsWith(call, "beginPass ")) pass = call.substr(10, call.find(' ', 10) - 10);
            if (startsWith(call, "drawFullscreen")) passes.push_back(pass);
        }
        CHECK(cubes.device.misuse().empty());
        return joined(passes, " ");
    };
    const std::string all = "source ssao filter_x filter_y lighting";
    CHECK(drawn(0, {}) == all);
    CHECK(drawn(100, {}) == "source lighting");  // which has a guard band: no bounds of the view
    CHECK(drawn(100, {"scissor"}) == all);
}
