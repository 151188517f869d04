// SPDX-License-Identifier: MIT
// Baked effects drawn for real: each picture is the config's to the last bit.
#include "tests/support/baked.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include "core/config/values.h"

#include <cstring>

using namespace crevice;

namespace {

/// The same frames by a config and by what was baked of it.
struct Twins : SceneRig {
    Twins() : SceneRig("room", {96, 54}) {}

    void make(const Description& config, const Frame& frame, const BakeOptions& options = {})
    {
        BakeOptions usual = options;
        usual.scene = traitsOf(frame);
        const std::vector<std::string> outputs = namesOf(throughBytes(config, usual).outputs);
        own = renderer(config, frame, outputs);
        baked = renderer(throughBytes(config, usual), frame, outputs);
        names = outputs;
    }

    /// Both do it, or both refuse it; then both draw the same.
    template <class Change>
    void change(const char* what, const Change& change, const Frame& frame)
    {
        INFO(what);
        CHECK(bool(change(*own)) == bool(change(*baked)));
        draw(frame);
    }

    void draw(const Frame& frame)
    {
        need(own->render(frame));
        need(baked->render(frame));
        for (const std::string& name : names)
            for (int view = 0; view <= static_cast<int>(frame.other_views.size()); ++view) {
                INFO(name << " of view " << view);
                const Image a = read(own->output(name, view)), b = read(baked->output(name, view));
                CHECK(a.extent == b.extent);
                CHECK(std::memcmp(a.pixels.data(), b.pixels.data(),
                                  a.pixels.size() * sizeof(float)) == 0);
            }
    }

    std::unique_ptr<Renderer> own, baked;
    std::vector<std::string> names;
};

}  // namespace

TEST_CASE("A baked effect draws its config's pictures: sizes, params, views, histories")
{
    Twins twins;
    const Frame frame = twins.frame(), moved = twins.frame("eye=1,1.6,2;at=-1,0.5,-1;fov=60");
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << ' ' << subject.variant);
        twins.make(descriptionOf(subject), frame);
        twins.draw(frame);
        twins.draw(moved);
        const auto param = [](const char* name, float value) {
            return [=](Renderer& renderer) { return renderer.setParam(name, value); };
        };
        twins.change("radius", param("radius", 1.25f), moved);
        twins.change("steps", param("steps", 7), moved);
        twins.change("ao_scale", param("ao_scale", 1), moved);
        twins.change("intensity", param("intensity", 0), moved);
        twins.change("intensity", param("intensity", 1.5f), frame);
        twins.change("depth_cut", param("depth_cut", 0), frame);
        twins.change(
            "size",
            [](Renderer& each) {
                return each.resize({77, 101});
            },
            frame);
        Frame both = frame;
        both.other_views = {{moved.camera, {}}};
        const auto none = [](Renderer&) { return Status(); };
        twins.change("two views", none, both);
        twins.change("again", none, both);
    }
}

TEST_CASE("What is listed of features and traits is drawn as by the config")
{
    Twins twins;
    const Frame frame = twins.frame();
    BakeOptions options;
    options.values = {{"quality", {"low", "medium", "high"}}, {"display", {"lit", "ao_only"}}};
    options.traits = {{"scene.lights", {"2", "0"}}, {"camera.reversed_depth", {"false", "true"}}};
    twins.make(descriptionOf({"quality"}), frame, options);
    for (const char* word : {"low", "high", "medium"})
        twins.change(
            word, [&](Renderer& each) { return each.setFeature("quality", word); }, frame);
    twins.change(
        "display", [](Renderer& each) { return each.setFeature("display", "ao_only"); }, frame);
    Frame dark = frame;
    dark.lights.clear();
    for (int column = 0; column < 4; ++column)  // depth from 1 to 0 in place of 0 to 1
        dark.camera.clip_from_view[column][2] *= -1;
    twins.change(
        "no lights, reversed depth", [](Renderer&) { return Status(); }, dark);
}
