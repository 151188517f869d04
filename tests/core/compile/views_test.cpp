// SPDX-License-Identifier: MIT
// Frames of several views: how they are planned, and what each of them is given.
#include "tests/support/plan_rig.h"
#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

const char* const kKept = R"({"format": ["r8"], "history": true})";

Camera eye(float x, float left = -1.0f)
{
    Camera camera;
    camera.view_from_world = glm::translate(glm::mat4(1.0f), glm::vec3(-x, 0, -3));
    camera.clip_from_view = glm::frustum(left, 1.0f, -1.0f, 1.0f, 1.0f, 10.0f);
    return camera;
}

/// A rig whose frames have a left and a right eye with projections of their own.
struct StereoRig : Rig {
    explicit StereoRig(bool remembering = false) : Rig(remembering)
    {
        frame.camera = eye(-0.5f, -1.5f);
        frame.other_views = {{eye(0.5f, -0.5f), {}}};
    }
};

std::string without(std::string text, const std::string& part)
{
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at))
        text.erase(at, part.size());
    return text;
}

/// What a renderer for this one camera does from one frame's first pass to its last.
std::string passesOf(const std::string& log)
{
    const auto begin = log.find("beginPass");
    return log.substr(begin, log.find("endFrame") - begin);
}

std::string passesAlone(const Camera& camera)
{
    Rig rig;
    rig.frame.camera = camera;
    return passesOf(rig.draw());
}

/// The lines of a log that set a uniform, in their order.
std::vector<std::string> sent(const std::string& log, const std::string& name)
{
    std::vector<std::string> lines;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);)
        if (line.rfind("setUniform " + name + ' ', 0) == 0) lines.push_back(line);
    return lines;
}

SceneTraits twoViews()
{
    SceneTraits traits;
    traits.views = 2;
    return traits;
}

const PlanTexture& textureOf(const Plan& plan, const std::string& target)
{
    return plan.textures[findNamed(plan.targets, target)->texture];
}

// A chain of passes with an output in its middle and its end, and one that remembers.
Plan chain(const SceneTraits& traits)
{
    return planOf(describe(Sketch{{"a: -> x", "b: x -> y", "c: y -> z", "d: z kept_history -> kept",
                                   "e: kept -> w"},
                                  {{"first", "y"}, {"last", "w"}},
                                  {{"kept", kKept}, {"w", R"({"format": ["rgba8"]})"}}}),
                  traits);
}

}  // namespace

TEST_CASE("Two views are drawn one after the other, each as a frame of its camera would be")
{
    StereoRig rig;
    const std::string log = rig.draw();
    CHECK(without(passesOf(log), " of view 1") ==
          passesAlone(rig.frame.camera) + passesAlone(rig.frame.other_views[0].camera));
    CHECK(passesAlone(rig.frame.camera) != passesAlone(rig.frame.other_views[0].camera));
    CHECK(occurrences(log, "beginFrame") == 1);
}

TEST_CASE("Each view remembers its own last frame")
{
    StereoRig rig(true);
    rig.draw();
    const auto first = rig.renderer->output("ao").value;
    const auto first_right = rig.renderer->output("ao", 1).value;
    const Camera before = rig.frame.other_views[0].camera;
    rig.frame.camera = eye(3.0f);
    rig.frame.other_views[0].camera = eye(4.0f);
    const std::string log = rig.draw();

    const std::set<std::uint32_t> all = {first, first_right, rig.renderer->output("ao").value,
                                         rig.renderer->output("ao", 1).value};
    CHECK(all.size() == 4);
    const auto previous = sent(log, "previous_clip_from_view");
    REQUIRE(previous.size() == 2);
    CHECK(previous[0] != previous[1]);
    const std::vector<float> right = rig.device.lastUniform("previous_clip_from_view");
    const glm::mat4 wanted = glm::dmat4(before.clip_from_view) * before.view_from_world *
                             glm::inverse(rig.frame.other_views[0].camera.view_from_world);
    for (int i = 0; i < 16; ++i) CHECK(right.at(i) == Approx(wanted[i / 4][i % 4]).margin(1e-5));
    CHECK(occurrences(log, "smooth_ao_history unit 1 <- texture 'smooth_ao_history'") +
              occurrences(log, "smooth_ao_history unit 1 <- texture 'smooth_ao'") ==
          1);
    CHECK(
        occurrences(log, "smooth_ao_history unit 1 <- texture 'smooth_ao of view 1'") +
            occurrences(log, "smooth_ao_history unit 1 <- texture 'smooth_ao_history of view 1'") ==
        1);

    rig.draw();
    CHECK(rig.renderer->output("ao").value == first);
    CHECK(rig.renderer->output("ao", 1).value == first_right);
}

TEST_CASE("A view has its own textures for imports, and the frame's for the others")
{
    StereoRig rig;
    const auto texture = [&](const char* name) {
        return rig.device.adoptTexture({3, name, Format::rgba8, {4, 4}}).value();
    };
    const TextureId left = texture("left"), right = texture("right");
    rig.frame.textures = {{"decal", left}};
    CHECK(occurrences(rig.draw(), "setTexture decal unit 2 <- texture 'left'") == 2);
    rig.frame.other_views[0].textures = {{"decal", right}};
    const std::string log = rig.draw();
    CHECK(occurrences(log, "setTexture decal unit 2 <- texture 'left'") == 1);
    CHECK(log.find("texture 'left'") < log.find("texture 'right'"));
    rig.frame.textures.clear();
    CHECK(occurrences(rig.draw(), "setTexture decal unit 2 <- texture 'black'") == 1);
}

TEST_CASE("A frame with a view that no shader could draw is refused")
{
    const std::pair<void (*)(Camera & camera, Camera & view), const char*> rows[] = {
        {[](Camera&, Camera& view) { view.view_from_world[3][0] = INFINITY; },
         "view 1's view_from_world is not finite"},
        {[](Camera&, Camera& view) { view.clip_from_view = glm::mat4(0.0f); },
         "view 1's clip_from_view has no inverse"},
        {[](Camera&, Camera& view) { view.clip_from_view = glm::mat4(1.0f); },
         "view 1 is orthographic, and the camera is not"},
        {[](Camera& camera, Camera&) { camera.clip_from_view = glm::mat4(1.0f); },
         "view 1 is not orthographic, and the camera is"}};
    for (const auto& [change, what] : rows) {
        StereoRig rig;
        rig.draw();
        change(rig.frame.camera, rig.frame.other_views[0].camera);
        const Diagnostic error = onlyError(rig.renderer->render(rig.frame), Code::bad_input);
        CHECK(error.message == what);
        CHECK_FALSE(error.help.empty());
    }
}

TEST_CASE("Views share what ends with them, and each keeps its outputs and histories")
{
    const Plan one = chain({});
    const Plan two = chain(twoViews());
    REQUIRE(one.textures.size() == two.textures.size());
    for (std::size_t i = 0; i < one.textures.size(); ++i) {
        CHECK(one.textures[i].copies == 1);
        CHECK(one.textures[i].targets == two.textures[i].targets);
    }
    CHECK(textureOf(two, "x").copies == 1);
    CHECK(textureOf(two, "z").copies == 1);
    for (const char* name : {"y", "kept", "w"}) CHECK(textureOf(two, name).copies == 2);
    CHECK(two.textures[findNamed(two.targets, "kept")->history_texture].copies == 2);
    CHECK(two.texture_bytes == one.texture_bytes + 64 * 32 * (1 + 2 + 4));  // y, kept twice, w
    CHECK(movedBytes(two).read == 2 * movedBytes(one).read);
    CHECK(movedBytes(two).written == 2 * movedBytes(one).written);
}
