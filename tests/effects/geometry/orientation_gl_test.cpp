// SPDX-License-Identifier: MIT
// What a host draws through cameras and under clip controls of every kind: the occlusion is the
// same, turned with the picture. Cameras over a config's own meshes are a case of `crevice stress`,
// which shipped_properties_gl_test.cpp asks of all configs.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/stress/figures.h"
#include "tools/measure/stress/scenes.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 64};
constexpr int kBlock = 8;  // pixels a side of the means that are compared

/// How a host's camera differs from the plain one.
struct Orientation {
    const char* name;
    glm::dmat2 turned = glm::dmat2(1.0);  ///< The picture, about its middle.
    bool left_handed = false;
    bool half_depth = false;  ///< Clip z from 0 to 1 that the viewport halves again.
    ClipControl control = {};
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
    {"0 to 1", glm::dmat2(1.0), false, false, {true, false}},
    {"upper left", {1, 0, 0, -1}, false, false, {false, true}},
    {"both", {1, 0, 0, -1}, false, false, {true, true}},
    {"oblique", glm::dmat2(1.0), false, false, {}, true},
    {"oblique, turned by 90", {0, 1, -1, 0}, false, false, {}, true},
};

struct Lens {
    const char* name;
    StressView view;
    glm::dvec2 off_centre = glm::dvec2(0.0);
};

std::vector<Lens> lenses()
{
    StressView room;
    room.eye = {0, 1, 5};
    std::vector<Lens> all = {{"perspective", room},
                             {"orthographic", room},
                             {"off-centre", room, {0.3, -0.2}},
                             {"infinite", room},
                             {"reversed infinite", room}};
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

/// A host's camera, and from the plain view to where GL draws what it shows.
struct HostCamera {
    Camera given;
    glm::dmat4 mirror, clip_from_view;
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
    Camera camera;
    camera.view_from_world = mirror * plain.view_from_world;
    camera.clip_from_view = glm::mat4(glm::transpose(given));
    camera.clip_control = kind.control;
    return {camera, mirror, drawn * mirror};
}

/// A host that has drawn the test scene: what a plain camera sees, stored as another one would.
struct Host : SceneRig {
    Host() : SceneRig(testScene(), kExtent) {}

    /// The plain picture through a lens.
    void look(const Lens& through)
    {
        lens = through;
        Frame plain = frame();
        plain.camera = cameraOf(lens, {"plain"}).given;
        const GivenConfig surface({"geometry/depth_normal"},
                                  R"(, "outputs": {"depth": "depth", "normal": "normal"})");
        Renderer& drawn = reloaded(surface.description(), plain, {kExtent, {}, {}}, 1);
        need(drawn.render(plain));
        depth = read(drawn.output("depth"));
        normal = read(drawn.output("normal"));
        view_from_clip = glm::inverse(glm::dmat4(plain.camera.clip_from_view));
    }

    /// AO as the host gets it through such a camera. A history has two cycles of its noise.
    Image occlusion(const Description& hosted, const Orientation& kind)
    {
        const HostCamera camera = cameraOf(lens, kind);
        const float background = lens.view.reversed ? 0 : 1;
        Image depths(kExtent, 1, background), normals(kExtent, 4, 0);
        for (int y = 0; y < kExtent.height; ++y)
            for (int x = 0; x < kExtent.width; ++x) {
                const glm::dvec2 here = (glm::dvec2(x, y) + 0.5) * (2.0 / kExtent.width) - 1.0;
                const glm::dvec2 plain = glm::inverse(kind.turned) * here;
                const glm::ivec2 at(glm::floor((plain + 1.0) * (kExtent.width / 2.0)));
                if (depth.at(at.x, at.y) == background) continue;
                const double plain_z = depth.at(at.x, at.y) * 2.0 - 1.0;
                const glm::dvec4 view = view_from_clip * glm::dvec4(plain, plain_z, 1);
                const glm::dvec4 clip = camera.clip_from_view * view;
                depths.at(x, y) = static_cast<float>(clip.z / clip.w * 0.5 + 0.5);
                for (int i = 0; i < 3; ++i)
                    normals.at(x, y, i) = static_cast<float>(
                        camera.mirror[i][i] * (normal.at(at.x, at.y, i) - 0.5) + 0.5);
            }
        need(device->writeTexture(stored_depth, depths));
        need(device->writeTexture(stored_normal, normals));
        Frame given;
        given.camera = camera.given;
        given.textures = {{"depth", stored_depth}, {"normal", stored_normal}};
        const bool remembers = findNamed(hosted.params, "history_frames") != nullptr;
        return draw(hosted, given, "ao", remembers ? 16 : 1);
    }

    Lens lens = {};
    Image depth, normal;
    glm::dmat4 view_from_clip = glm::dmat4(1.0);
    TextureId stored_depth = texture(Format::r32f, kExtent);
    TextureId stored_normal = texture(Format::rgba16f, kExtent);
};

}  // namespace

TEST_CASE("The occlusion of what a host draws turns with the host's projection, and only so")
{
    std::vector<std::pair<std::string, std::string>> configs = {
        {"mobile_temporal", "+geometry/host_depth"},
        {"gtao", "+geometry/host_depth_normal"},
        {"learnopengl", "+geometry/host_depth_normal"}};
    if (nightly())
        for (const std::string& config : configNames(shippedSources()))
            if (config != "ssdo")  // which gathers albedo
                for (const char* module : {"+geometry/host_depth", "+geometry/host_depth_normal"})
                    configs.emplace_back(config, module);
    Host host;
    std::size_t turn = 0;
    for (const auto& [config, module] : configs) {
        const Description hosted = descriptionOf({config}, {module, "radius=1"});
        for (const Lens& lens : lenses()) {
            host.look(lens);
            const Image plain = host.occlusion(hosted, {"plain"});
            CHECK(mean(plain) < 0.98);
            for (const Orientation& kind : kOrientations) {
                if (!nightly() && turn++ % 4 > 0) continue;
                StressShot shot;
                shot.turned = kind.turned;
                shot.block_px = kBlock;
                const Image image = host.occlusion(hosted, kind);
                INFO(config << ' ' << module << ", " << lens.name << ", " << kind.name);
                CHECK(changeBetween(plain, image, shot).change < kSameChange);
            }
        }
    }
}
