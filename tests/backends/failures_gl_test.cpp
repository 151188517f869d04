// SPDX-License-Identifier: MIT
// Real GL that runs out of memory or loses its context: nothing stays behind, and what is drawn
// after is bit for bit what it would have been.
#include "tests/backends/stage.h"
#include "tests/support/failing_changes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/watched_gl.h"

#include <algorithm>

using namespace crevice;

TEST_CASE(
    "A driver without memory for one call leaves no name, and then the picture that is wanted")
{
    // Presets with all kinds of passes; at night each config gives way to the next one, but for
    // that with levels, of which one that lacks memory is a warning.
    std::vector<std::string> configs = {"balanced", "learnopengl"};
    if (nightly()) {
        configs = configNames(shippedSources());
        configs.erase(std::find(configs.begin(), configs.end(), "quality"));
    }
    GlFixture fixture;
    WatchedGl gl(testContext().loader());
    {
        auto device = need(makeGlDevice(gl.loader()));
        Stage stage(*device);
        for (std::size_t i = 0; i + 1 < configs.size(); ++i) {
            INFO(configs[i] << ", then " << configs[i + 1]);
            auto renderer = stage.make(configs[i]);
            const Pixels before = stage.draw(*renderer);
            const Description other = descriptionOf({configs[i + 1]});
            const Pixels wanted = stage.draw(*stage.make(other));
            const int names = gl.names();
            const auto reload = [&] { return renderer->reload(other, {stage.extent}); };
            const int failures = failEachAttempt(gl, reload, [&](const Status& status) {
                REQUIRE_FALSE(status.ok());
                const Code code = status.diagnostics()[0].code;
                CHECK((code == Code::out_of_memory || code == Code::gl_error));
                CHECK_FALSE(gl.errorPends());
                CHECK(gl.names() == names);
                CHECK((stage.shown(*renderer) == before));
            });
            CHECK(failures > (nightly() ? 10 : 20));
            CHECK((stage.draw(*renderer) == wanted));
        }
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
        auto renderer = stage.make("balanced");
        need(renderer->setParam("radius", 0.3f));
        before = stage.draw(*renderer);
        ++stage.frame.revision;
        gl.loseAt(200, Loss::for_ever);
        CHECK(onlyCode(renderer->render(stage.frame)) == Code::context_lost);
        description = renderer->description();
        context.reset();  // ... before what was made in it
    }
    context = need(makeContext(testBackend()));
    auto device = need(makeGlDevice(context->loader()));
    Stage stage(*device);
    CHECK((stage.draw(*stage.make(description)) == before));
}

TEST_CASE("Many resizes, reloads and settings leave no GL name and no id behind")
{
    constexpr int kPeriod = 48;  // of what is changed
    const int changes = kPeriod * (nightly() ? 5 : 2);
    GlFixture fixture;
    WatchedGl gl(testContext().loader());
    {
        auto device = need(makeGlDevice(gl.loader()));
        Stage stage(*device);
        const Description plain = descriptionOf({"learnopengl"}), other = descriptionOf({"mobile"});
        auto renderer = stage.make(plain);
        int names = 0;
        for (int n = 0; n <= changes; ++n) {
            INFO("change " << n);
            if (n == kPeriod) names = gl.names();
            const int turn = n / 4;
            if (n % 4 == 0) need(renderer->resize({16 + turn % 4, 16}));
            if (n % 4 == 1) need(renderer->reload(turn % 2 ? plain : other, {stage.extent}));
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
