// SPDX-License-Identifier: MIT
// Real GL that runs out of memory or loses its context: nothing stays behind, and what is drawn
// after is bit for bit what it would have been.
#include "tests/support/failing_changes.h"
#include "tests/support/failing_device.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shipped_subjects.h"
#include "tests/support/watched_gl.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {32, 18};

using Pixels = std::vector<std::vector<float>>;

/// A scene on a device.
struct Stage {
    explicit Stage(Device& on) : device(on), uploaded(need(UploadedScene::upload(on, scene)))
    {
        const double aspect = double(kExtent.width) / kExtent.height;
        frame =
            makeFrame(uploaded, need(chooseCamera(scene, uploaded.bounds(), "", aspect)), kExtent);
    }

    std::unique_ptr<Renderer> make(const Description& description)
    {
        return need(Renderer::create(device, description, {kExtent}, traitsOf(frame)));
    }

    /// What the outputs hold.
    Pixels shown(const Renderer& renderer)
    {
        Pixels all;
        for (const PlanOutput& output : renderer.plan().outputs)
            all.push_back(need(device.readTexture(renderer.output(output.name))).pixels);
        return all;
    }

    Pixels draw(Renderer& renderer, const Frame& drawn)
    {
        need(renderer.render(drawn));
        return shown(renderer);
    }

    Device& device;
    Scene scene = need(loadScene("spheres"));
    UploadedScene uploaded;
    Frame frame;
};

}  // namespace

TEST_CASE(
    "Shipped configs on GL that fails any object keep their pictures, and draw the same bits after")
{
    GlFixture gl;
    FailingDevice device(*gl.device);
    Stage stage(device);
    const std::vector<std::string> names = configNames(shippedSources());
    const int live = device.live();
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(names[i]);
        const Description description = descriptionOf({names[i], ""});
        std::unique_ptr<Renderer> renderer;
        const auto create = [&]() -> Status {
            auto made = Renderer::create(device, description, {kExtent}, traitsOf(stage.frame));
            if (made) renderer = std::move(*made);
            return made.diagnostics();
        };
        CHECK(failEachObject(device, create, [] {}) > 5);
        checkFailingChanges(
            device, *renderer, stage.frame,
            {resizing(), reloading(descriptionOf({names[(i + 1) % names.size()], ""}))},
            [&](Renderer& drawn, const Frame& frame) { return stage.draw(drawn, frame); },
            [&](const Renderer& drawn) { return stage.shown(drawn); });
        renderer.reset();
        CHECK(device.live() == live);
    }
}

TEST_CASE(
    "A driver without memory for one call leaves no name, and then the picture that is wanted")
{
    GlFixture fixture;
    WatchedGl gl(testContext().loader());
    {
        auto device = need(makeGlDevice(gl.loader()));
        Stage stage(*device);
        auto renderer = stage.make(descriptionOf({"balanced", ""}));
        const Pixels before = stage.draw(*renderer, stage.frame);
        const Description other = descriptionOf({"learnopengl", ""});
        const Pixels wanted = stage.draw(*stage.make(other), stage.frame);
        const int names = gl.names();
        int n = 1;
        for (;; ++n) {
            INFO("attempt " << n);
            const int attempts = gl.attempts();
            gl.failAt(n);
            const Status status = renderer->reload(other, {kExtent});
            gl.failAt(0);
            if (gl.attempts() - attempts < n) break;
            REQUIRE_FALSE(status.ok());
            const Code code = status.diagnostics()[0].code;
            CHECK((code == Code::out_of_memory || code == Code::gl_error));
            CHECK_FALSE(gl.errorPends());
            CHECK(gl.names() == names);
            CHECK((stage.shown(*renderer) == before));
        }
        CHECK(n > 20);
        CHECK((stage.draw(*renderer, stage.frame) == wanted));
    }
    CHECK(gl.names() == 0);
}

TEST_CASE("A context that is lost in a frame ends in CV6016, and a new one draws the same bits")
{
    Pixels before;
    Description description;
    auto context = need(makeContext(testBackend()));
    {
        WatchedGl gl(context->loader());
        auto device = need(makeGlDevice(gl.loader()));
        Stage stage(*device);
        auto renderer = stage.make(descriptionOf({"balanced", ""}));
        need(renderer->setParam("radius", 0.3f));
        before = stage.draw(*renderer, stage.frame);
        ++stage.frame.revision;
        gl.loseAt(200, Loss::for_ever);
        const Status status = renderer->render(stage.frame);
        REQUIRE(status.diagnostics().size() == 1);
        CHECK(status.diagnostics()[0].code == Code::context_lost);
        description = renderer->description();
        context.reset();  // ... before what was made in it
    }
    context = need(makeContext(testBackend()));
    auto device = need(makeGlDevice(context->loader()));
    Stage stage(*device);
    CHECK((stage.draw(*stage.make(description), stage.frame) == before));
}

TEST_CASE("Hundreds of resizes, reloads and settings leave no GL name and no id behind")
{
    constexpr int kChanges = 240, kWarmUp = 48;
    GlFixture fixture;
    WatchedGl gl(testContext().loader());
    {
        auto device = need(makeGlDevice(gl.loader()));
        Stage stage(*device);
        const Description plain = descriptionOf({"learnopengl", ""}),
                          other = descriptionOf({"mobile", ""});
        auto renderer = stage.make(plain);
        int names = 0;
        for (int n = 0; n <= kChanges; ++n) {
            INFO("change " << n);
            if (n == kWarmUp) names = gl.names();
            const int turn = n / 4;
            if (n % 4 == 0) need(renderer->resize({16 + turn % 4, 16}));
            if (n % 4 == 1) need(renderer->reload(turn % 2 ? plain : other, {kExtent}));
            if (n % 4 == 2) need(renderer->setParam("power", 1.0f + turn % 3));
            if (n % 4 == 3) stage.frame.lights.resize(turn % 2);
            need(renderer->render(stage.frame));
        }
        CHECK(gl.names() == names);
        const TextureId next = need(device->createTexture({"next", Format::r8, {1, 1}}));
        CHECK(next.value < 100);
    }
    CHECK(gl.names() == 0);
}
