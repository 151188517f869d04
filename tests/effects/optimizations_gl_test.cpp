// SPDX-License-Identifier: MIT
// Plans and frames that leave work out show, bit for bit, what those that run everything show.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <functional>
#include <map>

using namespace crevice;

namespace {

using Names = std::vector<std::string>;

constexpr Extent kExtent = {64, 36};

/// What a host may change from one frame to the next.
const std::function<void(Frame&, Renderer&)> kChanges[] = {
    [](Frame&, Renderer&) {},
    [](Frame& frame, Renderer&) { frame.lights[0].position += glm::dvec3(0.5, 0, 0.25); },
    [](Frame&, Renderer&) {},
    [](Frame& frame, Renderer&) { frame.camera.view_from_world[3][0] += 0.05; },
    [](Frame&, Renderer& renderer) { need(renderer.setParam("radius", 0.4f)); },
    [](Frame& frame, Renderer&) { frame.draws[0].world_from_model[3][1] += 0.1; },
    [](Frame& frame, Renderer&) { frame.materials[0].base_color.x = 0.25f; },
    [](Frame& frame, Renderer&) {
        frame.ambient_light = {0.5f, 1, 1};
    },
    [](Frame& frame, Renderer&) {
        frame.camera.view_from_world[3][0] -= 2;
    },  // draws leave the view
};

/// A scene with a renderer that leaves out what it can, and one that runs everything.
struct Both : SceneRig {
    explicit Both(const char* name) : SceneRig(name, kExtent) {}

    Renderer& lean(const Description& description, const Frame& seen, const Names& kept = {},
                   Names outputs = {})
    {
        return reloaded(description, seen, {kExtent, std::move(outputs), kept}, 0);
    }
    Renderer& full(const Description& description, const Frame& seen)
    {
        return reloaded(description, seen, {kExtent, {}, {"all"}}, 1);
    }
};

/// With those outputs too that are drawn on request.
Description asked(Description description)
{
    for (OutputDesc& output : description.outputs) output.on_request = false;
    return description;
}

/// An output that a plan knows unrun is one texel, which stands for all.
bool isConstant(const Renderer& renderer, const std::string& output)
{
    return findNamed(renderer.plan().outputs, output)->constant >= 0;
}

/// The params of passes' no-ops, each with the value at which one holds.
std::map<std::string, float> noOpsOf(const Description& description)
{
    std::map<std::string, float> found;
    for (const PassDesc& pass : description.passes)
        for (const NoOpDesc& no_op : pass.no_op) found[no_op.name] = no_op.at;
    return found;
}

/// Without alpha, which says nothing in a picture of colours: a no-op gives one number for all
/// channels.
Image opaque(Image image)
{
    if (image.channels < 4) return image;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 1.0f;
    return image;
}

void checkSame(GlFixture& gl, const Renderer& lean, const Renderer& full, const Names& outputs)
{
    for (const std::string& output : outputs) {
        INFO(output);
        Image picture = gl.read(lean.output(output));
        const Image whole = gl.read(full.output(output));
        if (isConstant(lean, output)) picture.pixels.assign(whole.pixels.size(), picture.pixels[0]);
        CHECK(opaque(std::move(picture)).pixels == opaque(whole).pixels);
    }
}

}  // namespace

TEST_CASE(
    "With all optimizations and with none the pictures of shipped configs are the same, whatever "
    "changes")
{
    Both rig("spheres");
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = asked(descriptionOf(subject));
        Frame frame = rig.frame(), same = frame;
        Renderer& lean = rig.lean(description, frame);
        Renderer& full = rig.full(description, frame);
        for (std::size_t i = 0; i < std::size(kChanges); ++i) {
            INFO("change " << i);
            kChanges[i](frame, lean);
            kChanges[i](same, full);
            need(lean.render(frame));
            need(full.render(same));
            checkSame(rig, lean, full, namesOf(description.outputs));
        }
    }
}

TEST_CASE("The occlusion is the same where it is the one output")
{
    Both rig("room");
    const Frame frame = rig.frame();
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << ' ' << subject.variant);
        const Description description = descriptionOf(subject);
        Renderer& lean = rig.lean(description, frame, {}, {"ao"});
        Renderer& full = rig.full(description, frame);
        need(lean.render(frame));
        need(full.render(frame));
        checkSame(rig, lean, full, {"ao"});
    }
}

TEST_CASE("What a no-op gives is what its pass would have drawn, and so on down the filters")
{
    Both rig("spheres");
    const Frame frame = rig.frame();
    for (const Subject& subject : sampledSubjects()) {
        for (const auto& [param, at] : noOpsOf(descriptionOf(subject))) {
            INFO(subject.config << ", " << param << ' ' << at);
            Description description = descriptionOf(subject);
            for (ParamDesc& each : description.params)
                if (each.name == param) each.value.fill(at);
            Renderer& lean = rig.lean(description, frame);
            Renderer& full = rig.full(description, frame);
            need(lean.render(frame));
            need(full.render(frame));
            checkSame(rig, lean, full, namesOf(lean.plan().outputs));
            CHECK(lean.plan().passes.size() < full.plan().passes.size());
            if (param == "intensity") CHECK(lean.plan().passes.size() <= 2);  // geometry, lighting
        }
    }
}

TEST_CASE("Masks and bounds change no pixel: half a background, draws off the middle, none at all")
{
    Both rig("spheres");
    for (const Subject& subject : sampledSubjects()) {
        const Description description = asked(descriptionOf(subject));
        for (const char* camera :
             {"eye=0,1.5,4;at=0,2.3,0", "eye=0,40,90;at=20,0,0",
              "eye=4,3,4;at=0,1,0;ortho=7;shift=0.2,0.1", "eye=0,2,9;at=0,4,20"}) {
            INFO(camera << ' ' << subject.config);
            const Frame frame = rig.frame(camera);
            Renderer& full = rig.full(description, frame);
            need(full.render(frame));
            for (const char* kept : {"depth_mask", "scissor"}) {
                Renderer& lean = rig.lean(description, frame, {kept});
                need(lean.render(frame));
                checkSame(rig, lean, full, namesOf(description.outputs));
            }
        }
    }
}
