// SPDX-License-Identifier: MIT
// Every shipped config through the public API, from cameras of every kind: the picture is the same,
// turned with the camera. Drawn from meshes, and on what a host draws itself.
//
// CREVICE_ORIENTATIONS=all draws the whole matrix and prints it, in some minutes; without it each
// config meets a part, so that each kind of camera meets some config.
#include <crevice/config.h>
#include <crevice/effect.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tests/effects/geometry/host_scene.h"
#include "tests/support/gl_fixture.h"
#include "tools/render/scene_upload.h"
#include "tools/stress/limits.h"
#include "tools/stress/scenes.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iterator>
#include <sstream>

using namespace crevice;

namespace {

constexpr int kBlock = 8;  // pixels a side of the means that are compared

bool isWhole() { return std::getenv("CREVICE_ORIENTATIONS") != nullptr; }

const Extent kExtent = isWhole() ? Extent{128, 128} : Extent{64, 64};

/// How a host's camera differs from the plain one.
struct Orientation {
    const char* name;
    glm::dmat2 turned = glm::dmat2(1.0);  ///< The picture, about its middle.
    bool left_handed = false;
    bool half_depth = false;  ///< Clip z from 0 to 1 that the viewport halves again.
    ClipControl control = {};
    bool set = false;  ///< As the context's clip control, else told.
    bool oblique = false;
};

const Orientation kOrientations[] = {
    {"flipped in x", {-1, 0, 0, 1}},
    {"flipped in y", {1, 0, 0, -1}},
    {"turned by 90", {0, 1, -1, 0}},
    {"turned by 180", {-1, 0, 0, -1}},
    {"turned by 270", {0, -1, 1, 0}},
    {"left-handed", glm::dmat2(1.0), true},
    {"halved depth", glm::dmat2(1.0), false, true},
    {"0 to 1 told", glm::dmat2(1.0), false, false, {true, false}},
    {"0 to 1 set", glm::dmat2(1.0), false, false, {true, false}, true},
    {"upper left told", {1, 0, 0, -1}, false, false, {false, true}},
    {"both set", {1, 0, 0, -1}, false, false, {true, true}, true},
    {"oblique", glm::dmat2(1.0), false, false, {}, false, true},
    {"oblique, turned by 90", {0, 1, -1, 0}, false, false, {}, false, true},
};

struct Lens {
    const char* name;
    StressView view;
    glm::dvec2 off_centre = glm::dvec2(0.0);
};

StressView roomView()
{
    StressView view;
    view.eye = {0, 1, 5};
    return view;
}

std::vector<Lens> lenses()
{
    std::vector<Lens> all = {{"perspective", roomView()},
                             {"orthographic", roomView()},
                             {"off-centre", roomView(), {0.3, -0.2}},
                             {"infinite", roomView()},
                             {"reversed infinite", roomView()}};
    all[1].view.half_height = 2;
    all[1].view.eye.z = 10;  // before all of the scene: nothing is cut away
    all[3].view.infinite = all[4].view.infinite = all[4].view.reversed = true;
    return all;
}

/// The near plane of rows, before all of the scene and at an angle. `sign` is -1 of reversed depth.
/// [Lengyel 2005, "Oblique View Frustum Depth Projection and Clipping"]
void makeOblique(glm::dmat4& rows, double sign)
{
    const glm::dvec4 plane(0.3, 0.2, -1.0, -0.2);
    rows[2] *= sign;
    const glm::dvec4 corner = glm::inverse(glm::transpose(rows)) * glm::dvec4(1, 1, 1, 1);
    const double scale = 2 * glm::dot(rows[3], corner) / glm::dot(plane, corner);
    rows[2] = sign * (scale * plane - rows[3]);
}

/// A host's matrices, and the projection by which GL's own clip control draws the same.
struct HostCamera {
    glm::dmat4 view_from_world;
    glm::mat4 clip_from_view, plain_clip;
};

HostCamera cameraOf(const Lens& lens, const Orientation& kind)
{
    const Camera plain = cameraOf(lens.view, kExtent);
    glm::dmat4 rows = glm::transpose(glm::dmat4(plain.clip_from_view));
    for (int i = 0; i < 2; ++i) rows[i] += lens.off_centre[i] * rows[3];
    if (kind.oblique) makeOblique(rows, lens.view.reversed ? -1 : 1);
    if (kind.half_depth) rows[2] = (rows[2] + rows[3]) * 0.5;
    glm::dmat4 mirror(1.0), turn(kind.turned);
    if (kind.left_handed) mirror[2][2] = -1;
    const glm::dmat4 drawn = turn * glm::transpose(rows) * mirror;
    glm::dmat4 given = glm::transpose(drawn);
    if (kind.control.upper_left) given[1] = -given[1];  // GL turns the picture
    if (kind.control.zero_to_one) given[2] = (given[2] + given[3]) * 0.5;
    return {mirror * plain.view_from_world, glm::mat4(glm::transpose(given)), glm::mat4(drawn)};
}

/// What a block of `plain` has more than the same of `image`, turned back.
double differenceOf(const Image& plain, const Image& image, const glm::dmat2& turned, int left,
                    int low)
{
    double sum = 0;
    for (int y = low; y < low + kBlock; ++y)
        for (int x = left; x < left + kBlock; ++x) {
            const glm::dvec2 middle(kExtent.width * 0.5);
            const glm::ivec2 at(glm::floor(turned * (glm::dvec2(x, y) + 0.5 - middle) + middle));
            sum += plain.at(x, y) - image.at(at.x, at.y);
        }
    return sum / (kBlock * kBlock);
}

struct Difference {
    double mean = 0, most = 0;
};

Difference differenceOf(const Image& plain, const Image& image, const glm::dmat2& turned)
{
    REQUIRE(plain.extent == kExtent);
    REQUIRE(image.extent == kExtent);
    Difference found;
    for (int low = 0; low < kExtent.height; low += kBlock)
        for (int left = 0; left < kExtent.width; left += kBlock) {
            const double change = std::abs(differenceOf(plain, image, turned, left, low));
            found.mean += change * kBlock * kBlock / (kExtent.width * kExtent.height);
            found.most = std::max(found.most, change);
        }
    return found;
}

using SetClipControl = void(GL_APIENTRY*)(GLenum origin, GLenum depth);

/// A host with the test scene, in draws of its own and as meshes for configs.
struct Host : GlFixture {
    HostScene own{gl, testScene(), kExtent};
    UploadedScene uploaded = need(UploadedScene::upload(*device, testScene()));
    SetClipControl set_clip_control = reinterpret_cast<SetClipControl>(
        testContext().loader()(testBackend() == "osmesa" ? "glClipControl" : "glClipControlEXT"));

    Host()
    {
        constexpr ClipControl kBoth = {true, true};
        setControl(kBoth);
        if (!(device->clipControl() == kBoth)) set_clip_control = nullptr;
        setControl({});
    }

    void setControl(const ClipControl& control)
    {
        constexpr GLenum kZeroToOne = 0x935F, kUpperLeft = 0x8CA2;
        if (set_clip_control)
            set_clip_control(control.upper_left ? kUpperLeft : GL_LOWER_LEFT_EXT,
                             control.zero_to_one ? kZeroToOne : GL_NEGATIVE_ONE_TO_ONE_EXT);
    }

    /// A config on a module that takes the host's pictures, or, without one, on its meshes.
    Result<Effect> effectOf(const std::string& config, const std::string& module)
    {
        const std::string on = module.empty() ? "" : "\", \"" + module;
        Result<Effect> made = Effect::create(
            *device, R"({"format": 1, "name": "ao", "extends": [")" + config + on + "\"]}", kExtent,
            {"ao"});
        if (!made) return made;
        if (module.empty()) made->frame() = makeFrame(uploaded, SceneCamera(), kExtent);
        for (const ImportDesc& import : made->renderer().description().imports) {
            if (import.name == "depth")
                need(made->setTexture("depth", own.depth(), Format::depth32f, kExtent));
            if (import.name == "normal")
                need(made->setTexture("normal", own.normal(), Format::rgba16f, kExtent));
        }
        need(made->setParam("radius", 1));
        return made;
    }

    /// AO as the host gets it through such a camera.
    Image occlusion(Effect& effect, const Lens& lens, const Orientation& kind)
    {
        const HostCamera camera = cameraOf(lens, kind);
        setControl(kind.set ? kind.control : ClipControl());
        own.draw(camera.view_from_world, kind.set ? camera.clip_from_view : camera.plain_clip,
                 lens.view.reversed);
        Frame& frame = effect.frame();
        effect.setProjection(glm::value_ptr(camera.clip_from_view));
        frame.camera.clip_control.reset();
        if (!kind.set && !(kind.control == ClipControl())) effect.setClipControl(kind.control);
        if (frame.textures.empty()) effect.setView(glm::value_ptr(camera.view_from_world));
        const std::vector<TargetDesc>& targets = effect.renderer().description().targets;
        const bool remembers = std::any_of(targets.begin(), targets.end(),
                                           [](const TargetDesc& each) { return each.history; });
        frame.camera_cut = true;
        for (int i = 0; i < (remembers ? 16 : 1); ++i) {  // two cycles of noise
            need(effect.render());
            frame.camera_cut = false;
        }
        setControl({});
        return read(effect.output("ao"));
    }
};

/// All pictures of one effect, or those that the test takes of its number `index`.
void checkOrientations(Host& host, Effect& effect, const std::string& title, std::size_t index)
{
    const std::vector<Lens> all = lenses();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!isWhole() && index % all.size() != i) continue;
        const Image plain = host.occlusion(effect, all[i], {"plain"});
        std::ostringstream table;
        table << title << ", " << all[i].name << std::fixed << std::setprecision(4);
        for (std::size_t kind = 0; kind < std::size(kOrientations); ++kind) {
            const Orientation& orientation = kOrientations[kind];
            if (!isWhole() && (kind + index) % 7 > 0) continue;
            if (orientation.set && !host.set_clip_control) continue;
            INFO(all[i].name << ", " << orientation.name);
            const Image image = host.occlusion(effect, all[i], orientation);
            const Difference found = differenceOf(plain, image, orientation.turned);
            CHECK(found.mean < kSameChange);
            table << '\n' << found.mean << ' ' << found.most << ' ' << orientation.name;
        }
        if (isWhole()) WARN(table.str());
    }
}

}  // namespace

TEST_CASE("The picture of every shipped config turns with the host's projection, and only so")
{
    Host host;
    std::size_t index = 0;
    const char* const modules[] = {"", "geometry/host_depth", "geometry/host_depth_normal"};
    for (const std::string& config : configNames(shippedSources())) {
        for (const char* module : modules) {
            if (!isWhole() && module != modules[index % std::size(modules)]) continue;
            const std::string title = config + ' ' + module;
            INFO(title);
            Result<Effect> effect = host.effectOf(config, module);
            CHECK(effect.ok() == (config != "ssdo" || !*module));  // which gathers albedo
            INFO(toText(effect.diagnostics()));
            if (effect) checkOrientations(host, *effect, title, index);
        }
        ++index;
    }
}
