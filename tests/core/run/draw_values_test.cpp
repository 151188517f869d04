// SPDX-License-Identifier: MIT
// What a draw reads: in every pass, view and frame the values of its own place and material, bit
// for bit, though they are computed once a view and sent only where they differ.
#include <crevice/recording_device.h>

#include "core/run/view_draws.h"

#include "tests/core/run/allocations.h"
#include "tests/core/run/reading_device.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/shipped_subjects.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>

using namespace crevice;

namespace {

template <class T>
Words wordsOf(const T& value)
{
    Words words(sizeof(T) / sizeof(std::uint32_t));
    std::memcpy(words.data(), &value, sizeof value);
    return words;
}

using Given = std::map<std::string, Words>;

/// A host's draw, which keeps the matrices that it was given by name.
struct Host {
    std::vector<Given> given;

    static void draw(const DrawCall& call, void* host)
    {
        Given& given = static_cast<Host*>(host)->given.emplace_back();
        for (const char* name : {"clip_from_model", "view_from_model", "view_normal_from_model"}) {
            const auto* words = reinterpret_cast<const std::uint32_t*>(call.matrix(name));
            given[name].assign(words, words + (name[5] == 'n' ? 9 : 16));
        }
    }
};

/// A mesh of one triangle for each draw, so that a draw is known by its mesh. That of every third
/// lies far from its model's origin, and is kept about its middle.
struct Scene {
    explicit Scene(Device& device)
    {
        frame.camera.clip_from_view = glm::perspective(0.9f, 1.6f, 0.1f, 80.0f);
        frame.materials.resize(3);
        frame.materials[1].base_color = {0.5f, 0.25f, 1, 1};
        frame.materials[2].specular = glm::vec3(0.5f);
        frame.materials[2].alpha_cutoff = 0.5f;
        for (int i = 0; i < 3; i += 2)
            frame.materials[i].base_color_map =
                need(device.createTexture({"map " + std::to_string(i), Format::rgba8, {1, 1}}));
        for (int i = 0; i < 3; i += 2)
            need(device.writeTexture(frame.materials[i].base_color_map, Image({1, 1}, 4, 1.0f)));
        for (int i = 0; i < 12; ++i) {
            MeshDesc mesh = {"mesh", std::vector<Vertex>(3), {0, 1, 2}};
            for (Vertex& vertex : mesh.vertices) vertex.position[0] = i % 3 == 0 ? 1000.0f : 0.0f;
            mesh.vertices[1].position[1] = 1;
            origins.push_back(originOf(mesh));
            DrawItem item = {need(device.createMesh(mesh)), 0, 3, glm::dmat4(1), i / 2 % 3};
            if (i == 5) item = {{}, 0, 0, glm::dmat4(1), item.material};
            item.callback = i == 5 ? Host::draw : nullptr;
            item.host = &host;
            item.sheet = i == 7;
            frame.draws.push_back(item);
        }
        move();
    }

    /// Puts everything elsewhere; some of it is then mirrored, and some off the view.
    void move()
    {
        for (DrawItem& item : frame.draws) {
            const auto at = [this] { return around_(random_); };
            item.world_from_model =
                glm::translate(glm::dmat4(1), {6 * at(), 3 * at(), -9 + 6 * at()});
            item.world_from_model[0] *= at() < -0.5 ? -2.0 : 1.0;
            item.world_from_model[1].z = at();
            item.bounds_radius = at() < 0 ? -1.0f : 1200.0f;
        }
    }

    /// The draw of a mesh; that of none is the host's.
    std::size_t drawOf(std::uint32_t mesh) const
    {
        std::size_t i = 0;
        while (frame.draws[i].mesh.value != mesh) ++i;
        return i;
    }

    /// What a draw must read in a view, by the uniforms' names.
    std::map<std::string, Words> wanted(std::size_t draw, const CameraMatrices& camera) const
    {
        const DrawItem& item = frame.draws[draw];
        const Material& material = frame.materials[item.material];
        const MeshOrigin origin = item.callback ? MeshOrigin() : origins[draw];
        const glm::dmat4 view_from_mesh =
            glm::translate(camera.view_from_world * item.world_from_model,
                           glm::dvec3(origin.x, origin.y, origin.z));
        return {{"clip_from_model", wordsOf(glm::mat4(camera.clip_from_view * view_from_mesh))},
                {"view_from_model", wordsOf(glm::mat4(view_from_mesh))},
                {"view_normal_from_model", wordsOf(normalMatrix(view_from_mesh))},
                {"base_color", wordsOf(material.base_color)},
                {"alpha_cutoff", wordsOf(material.alpha_cutoff)},
                {"specular", wordsOf(material.specular)},
                {"shininess", wordsOf(material.shininess)}};
    }

    Frame frame;
    std::vector<MeshOrigin> origins;
    Host host;

private:
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> around_{-1.0, 1.0};
};

/// How many values were looked at: those that the pass reads, and those that a host was given.
int checkValues(const Scene& scene, const Drawn& drawn, const Given& given)
{
    const std::size_t draw = scene.drawOf(drawn.mesh);
    const auto wanted = scene.wanted(draw, cameraMatrices(cameraOf(scene.frame, drawn.view)));
    int compared = 0;
    for (const auto& [name, words] : wanted) {
        INFO(name << " of draw " << draw);
        const auto found = drawn.bound.uniforms.find(name);
        if (found == drawn.bound.uniforms.end()) continue;
        ++compared;
        CHECK(found->second == words);
    }
    for (const auto& [name, words] : given) CHECK(wanted.at(name) == words);
    return compared;
}

void checkTexture(const Scene& scene, const Drawn& drawn)
{
    const DrawItem& item = scene.frame.draws[scene.drawOf(drawn.mesh)];
    const TextureId map = scene.frame.materials[item.material].base_color_map;
    const auto found = drawn.bound.textures.find("base_color_map");
    if (found == drawn.bound.textures.end()) return;
    for (const Material& material : scene.frame.materials)
        if (material.base_color_map)
            CHECK((found->second == material.base_color_map.value) ==
                  (map.value == material.base_color_map.value));
}

void checkCull(const Scene& scene, const PlanPass& pass, const Drawn& drawn)
{
    const DrawItem& item = scene.frame.draws[scene.drawOf(drawn.mesh)];
    const Camera& camera = cameraOf(scene.frame, drawn.view);
    const bool mirrored =
        mirrors(item.world_from_model) != mirrors(cameraMatrices(camera).view_from_world);
    if (pass.state.cull == Cull::none || isSheet(item, scene.frame.materials[item.material]))
        CHECK(drawn.cull == Cull::none);
    else
        CHECK((drawn.cull == pass.state.cull) == !mirrored);
}

}  // namespace

TEST_CASE("A draw reads the values of its place and material, in each pass, view and frame")
{
    const std::string config = GENERATE("high", "balanced", "bitmask_layers");
    INFO(config);
    RecordingDevice recording;
    ReadingDevice device(recording);
    Scene scene(device);
    scene.frame.other_views.resize(GENERATE(0, 1));
    const auto renderer = need(
        Renderer::create(device, descriptionOf({config, ""}), {{64, 40}}, traitsOf(scene.frame)));
    int compared = 0;
    std::set<Cull> culls;
    for (int frame = 0; frame < 3; ++frame) {
        scene.move();
        scene.host.given.clear();
        scene.frame.camera.view_from_world[3][0] += 0.25;
        for (FrameView& view : scene.frame.other_views) {
            view.camera = scene.frame.camera;
            view.camera.view_from_world[0] *= -1.0;  // mirrored
        }
        need(renderer->render(scene.frame));
        std::size_t by_host = 0;
        for (const Drawn& drawn : device.drawn) {
            INFO(frame << ' ' << drawn.pass << " of view " << drawn.view);
            const bool host = drawn.mesh == 0;
            compared += checkValues(scene, drawn, host ? scene.host.given.at(by_host++) : Given());
            checkTexture(scene, drawn);
            checkCull(scene, *findNamed(renderer->plan().passes, drawn.pass), drawn);
            culls.insert(drawn.cull);
        }
        CHECK(by_host == scene.host.given.size());
        CHECK(by_host > 0);
    }
    CHECK(compared > 400);
    CHECK(culls.size() == 3);
    CHECK(recording.misuse() == std::vector<std::string>());
}

TEST_CASE("Values and areas of draws are computed once a view, whatever passes ask")
{
    const Plan plan;
    ValueTable table(plan);
    DrawnList drawn = {{{MeshId{1}, 0, 3}}, {{}}, {{}}};
    DrawItem& item = drawn.draws[0];
    item.bounds_radius = 0.125f;
    ViewDraws view(drawn);
    const CameraMatrices camera = cameraMatrices(Camera());
    const auto x = [&] {
        (void)view.placed();
        float value = 0;
        std::memcpy(&value, view.values(0, table) + 12, sizeof value);  // of clip_from_model[3]
        return value;
    };
    const double any = std::numeric_limits<double>::infinity();
    view.begin(camera);
    CHECK(x() == 0);
    const double left = view.area({10, 10}, any).left;
    item.world_from_model[3].x = 0.5;  // nobody looks again ...
    const Words before(view.values(0, table), view.values(0, table) + table.drawWords());
    drawn.materials[0].base_color.x = 0.5f;
    CHECK(x() == 0);
    CHECK(Words(view.values(0, table), view.values(0, table) + table.drawWords()) == before);
    CHECK(view.area({10, 10}, any).left == left);
    CHECK(view.area({20, 10}, any).left == left);
    view.begin(camera);  // ... before the next view or frame
    CHECK(x() == 0.5f);
    CHECK(view.area({10, 10}, any).left > left);
}

TEST_CASE("A pass sends a value of the material, and binds its textures, once for draws in a row")
{
    Rig rig;
    ReadingDevice device(rig.device);
    const auto renderer = rig.make(device);
    rig.frame.draws.resize(5, rig.frame.draws[0]);
    for (int i = 0; i < 5; ++i) rig.frame.draws[i].world_from_model[3].x = i;
    need(renderer->render(rig.frame));
    CHECK(device.sent["clip_from_model"] == 5);
    CHECK(device.sent["base_color"] == 1);
    const std::string log = rig.device.log();
    const std::string bound = "setTexture base_color_map";
    CHECK(log.find(bound) != std::string::npos);
    CHECK(log.find(bound) == log.rfind(bound));
}
