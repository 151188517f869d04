// SPDX-License-Identifier: MIT
// Frames that change little: which passes the renderer runs again, on the recording device.
// What a frame runs again: by the plan alone, without a device.
#include "core/run/dirty_passes.h"
#include "tests/support/need.h"
#include "tests/support/plan_rig.h"
#include "tests/support/renderer_rig.h"
#include "tools/render/device/forwarding_device.h"

#include <functional>

using namespace crevice;

namespace {

std::string passesOf(Rig& rig)
{
    rig.draw();
    std::string passes;
    for (const char* name : {"geometry", "occlusion", "filter", "lighting"})
        if (rig.ranPass(name)) passes += std::string(passes.empty() ? "" : " ") + name;
    return passes;
}

const char* const kAll = "geometry occlusion filter lighting";

struct Cached {
    explicit Cached(const Sketch& sketch, int views = 1)
        : plan(planOf(describe(sketch), traitsFor(views))),
          cache(plan)
    {
    }

    static SceneTraits traitsFor(int views)
    {
        SceneTraits traits;
        traits.views = views;
        return traits;
    }

    /// The passes that run where those named have changed, of further views with their number.
    std::string run(const std::vector<std::string>& changed)
    {
        std::vector<char> flags;
        std::vector<std::string> names;
        for (int view = 0; view < plan.views; ++view)
            for (const PlanPass& pass : plan.passes) {
                names.push_back(pass.name + (view > 0 ? std::to_string(view) : ""));
                flags.push_back(std::count(changed.begin(), changed.end(), names.back()) > 0);
            }
        const std::vector<char>& runs = cache.choose(flags);
        std::vector<std::string> chosen;
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (runs[i]) chosen.push_back(names[i]);
        return joined(chosen);
    }

    Plan plan;
    PassCache cache;
};

/// Counts what it is asked of meshes and textures.
struct AskedDevice : ForwardingDevice {
    using ForwardingDevice::ForwardingDevice;
    ObjectInfo info(ObjectId id) const override { return ++asked, ForwardingDevice::info(id); }
    mutable int asked = 0;
};

/// Of a target that shares its texture with none of format r8.
const char* const kOwn = R"({"format": ["rgba8"]})";

/// The third pass draws into the first one's texture.
const Sketch kChain = {{"a: -> x", "b: x -> y", "c: y -> z", "d: z -> w"}, {{"out", "w"}}};

}  // namespace

TEST_CASE("A moving light runs the lighting alone")
{
    Rig rig;
    rig.draw();
    for (int i = 0; i < 3; ++i) {
        rig.frame.lights[0].position.x += 1;
        CHECK(passesOf(rig) == "lighting");
    }
    rig.frame.ambient_light.x = 0.5f;
    CHECK(passesOf(rig) == "lighting");
}

TEST_CASE("Another camera, draw or material, or other contents of them, runs all")
{
    Rig rig;
    const auto after = [&rig](const std::function<void(Frame&)>& change) {
        rig.draw();
        change(rig.frame);
        return passesOf(rig);
    };
    CHECK(after([](Frame& frame) { frame.camera.view_from_world[3][0] = 1; }) == kAll);
    CHECK(after([](Frame& frame) { frame.camera.clip_from_view[0][0] = 2; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws[0].world_from_model[3][1] = 1; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws[0].count = 3; }) == kAll);
    CHECK(after([](Frame& frame) { frame.draws.push_back(frame.draws[0]); }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].base_color.y = 0.5f; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].shininess = 3; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].ambient = 0.5f; }) == kAll);
    CHECK(after([](Frame& frame) { frame.materials[0].ambient = 0.25f; }) == kAll);
    CHECK(after([](Frame& frame) { ++frame.revision; }) == kAll);
    CHECK(after([](Frame&) {}).empty());
}

TEST_CASE("Draws of a frame that is like the last one are not asked for")
{
    Rig rig;
    AskedDevice device(rig.device);
    rig.frame.draws.resize(100, rig.frame.draws[0]);
    rig.renderer = rig.make(device);
    rig.frame.draws_revision = GENERATE(0u, 1u);
    rig.draw();
    CHECK(device.asked >= 100);
    for (int i = 0; i < 3; ++i) {
        device.asked = 0;
        CHECK(passesOf(rig).empty());
        CHECK(device.asked < 10);
    }
    rig.frame.draws[7].count = 0;
    CHECK(passesOf(rig) == (rig.frame.draws_revision == 0 ? kAll : ""));
    rig.renderer.reset();  // before its device
}

TEST_CASE("Draws and materials are taken again when their revision, or that of what they name, is")
{
    Rig rig;
    rig.frame.draws_revision = 1;
    rig.draw();
    rig.frame.materials[0].base_color.y = 0.5f;
    CHECK(passesOf(rig).empty());
    rig.frame.draws_revision = 2;
    CHECK(passesOf(rig) == kAll);
    CHECK(passesOf(rig).empty());
    rig.frame.draws_revision = 0;
    CHECK(passesOf(rig).empty());
    rig.frame.draws_revision = 2;
    CHECK(passesOf(rig).empty());
    ++rig.frame.revision;
    CHECK(passesOf(rig) == kAll);
    rig.frame.materials.resize(2);
    CHECK(passesOf(rig) == kAll);
    rig.frame.draws[0].callback = [](const DrawCall&, void*) {};
    rig.frame.draws_revision = 3;
    for (int i = 0; i < 3; ++i) CHECK(passesOf(rig) == kAll);
}

TEST_CASE("A mesh that is gone is not drawn under the same revision of the draws")
{
    Rig rig;
    rig.frame.draws_revision = 1;
    rig.draw();
    rig.device.destroy(rig.mesh);
    CHECK(passesOf(rig).empty());
    rig.frame.camera.view_from_world[3][0] = 1;
    CHECK(passesOf(rig) == kAll);
    CHECK_FALSE(rig.logged("draw cube"));
}

TEST_CASE(
    "A host's texture runs its readers when it or its revision is another, and without one always")
{
    Rig rig;
    const TextureId decal = rig.device.createTexture({"decal", Format::rgba8, {4, 4}}).value();
    REQUIRE(rig.device.writeTexture(decal, Image({4, 4}, 4, 1.0f)));
    rig.draw();
    rig.frame.textures = {{"decal", decal, 7}};
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
    rig.frame.textures[0].revision = 8;
    CHECK(passesOf(rig) == "lighting");
    const TextureId other = rig.device.createTexture({"decal", Format::rgba8, {4, 4}}).value();
    REQUIRE(rig.device.writeTexture(other, Image({4, 4}, 4, 0.5f)));
    rig.frame.textures[0].texture = other;
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
    rig.frame.textures[0].revision = 0;
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig) == "lighting");
    rig.frame.textures.clear();
    CHECK(passesOf(rig) == "lighting");
    CHECK(passesOf(rig).empty());
}

TEST_CASE("A new size, a new plan and a frame that failed run all")
{
    Rig rig;
    rig.draw();
    REQUIRE(rig.renderer->resize({32, 32}));
    CHECK(passesOf(rig) == kAll);
    rig.frame.lights[0].position.x += 1;
    rig.device.failFrame();
    CHECK_FALSE(rig.renderer->render(rig.frame));
    CHECK(passesOf(rig) == kAll);
    REQUIRE(rig.renderer->setParam("samples", 9));
    CHECK(passesOf(rig) == kAll);
}

TEST_CASE("Timed frames and those of a plan that keeps the optimization off run every pass")
{
    Rig rig;
    rig.draw();
    rig.device.clearLog();
    REQUIRE(rig.renderer->renderTimed(rig.frame));
    CHECK(rig.ranPass("geometry"));
    CHECK(passesOf(rig).empty());
    CompileOptions options{{64, 32}};
    options.disable = {"cached"};
    auto kept = need(Renderer::create(rig.device, rigDescription(), options, traitsOf(rig.frame)));
    rig.renderer = std::move(kept);
    CHECK(passesOf(rig) == kAll);
    CHECK(passesOf(rig) == kAll);
}

TEST_CASE("What has changed runs, and all that reads it")
{
    Cached cached({{"a: -> x", "b: x -> y", "side: -> s", "last: s y -> z"},
                   {{"out", "z"}},
                   {{"s", kOwn}, {"z", R"({"format": ["rg8"]})"}}});
    cached.run({});
    CHECK(cached.run({"last"}) == "last");
    CHECK(cached.run({"side"}) == "side, last");
    CHECK(cached.run({"a"}) == "a, b, last");
}

TEST_CASE("What another pass has overwritten is drawn again for whoever reads it")
{
    Cached cached(kChain);
    REQUIRE(cached.plan.targets[0].texture == cached.plan.targets[2].texture);
    CHECK(cached.run({}) == "a, b, c, d");  // the first frame
    CHECK(cached.run({}).empty());
    CHECK(cached.run({"b"}) == "a, b, c, d");
    CHECK(cached.run({"d"}) == "d");
}

TEST_CASE("A pass and what draws over it run both or neither")
{
    Cached cached({{"a: -> x", "b: x -> y", R"(c: s -> y | "over": "b")", "side: -> s", "d: y -> z",
                    "e: z -> v"},
                   {{"out", "v"}},
                   {{"s", kOwn}}});
    cached.run({});
    CHECK(cached.run({"side"}) == "a, b, side, c, d, e");
    CHECK(cached.run({"b"}) == "a, b, c, d, e");
    CHECK(cached.run({"e"}) == "e");
    CHECK(cached.run({"d"}) == "a, b, c, d, e");  // "e" has overwritten what they drew
}

TEST_CASE("What remembers runs in every frame")
{
    Cached cached({{"a: -> now", "mean: now mean_history -> mean", "show: mean -> color"},
                   {{"out", "color"}},
                   {{"mean", R"({"format": ["r8"], "history": true})"}, {"color", kOwn}}});
    cached.run({});
    CHECK(cached.run({}) == "mean, show");
}

TEST_CASE("Views that share a texture draw into it in turn")
{
    Cached cached({{"a: -> x", "b: x -> y"}, {{"out", "y"}}}, 2);
    CHECK(cached.run({}) == "a, b, a1, b1");
    CHECK(cached.run({}).empty());
    CHECK(cached.run({"b1"}) == "b1");
    CHECK(cached.run({"b"}) == "a, b");
    CHECK(cached.run({"b", "b1"}) == "b, a1, b1");
}
