// SPDX-License-Identifier: MIT
// Every estimator with every filter on every input, by pairs, drawn for real: whatever makes sense
// runs and has the properties of visibility, and the rest is refused with a reason.
#include "tests/support/modules.h"
#include "tests/support/nightly.h"
#include "tests/support/picture.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene/mesh_shapes.h"

#include <algorithm>

using namespace crevice;

namespace {

constexpr Extent kExtent = {256, 144};

struct Cell {
    const Module* input = nullptr;
    const Module* estimator = nullptr;
    const Module* filter = nullptr;
    std::vector<std::string> add_ons = {};    ///< Modules between estimator and filter.
    std::vector<std::string> overrides = {};  ///< As `--set`.
};

std::string textOf(const Cell& cell)
{
    std::string text = cell.input->name + " " + cell.estimator->name + " " + cell.filter->name;
    for (const std::string& name : cell.add_ons) text += " " + name;
    for (const std::string& setting : cell.overrides) text += " " + setting;
    return text;
}

/// Options that the modules of a cell have, another choice for each `index`.
void addOptions(Cell& cell, std::size_t index)
{
    const auto has = [](const Module& module, const char* option) {
        return module.options.count(option) > 0;
    };
    const char* const layers[] = {"", "geometry/back_faces", "geometry/second_layer"};
    const bool drawn = !cell.input->host_textures;
    if (drawn && has(*cell.estimator, "second_layer") && index % 3 > 0)
        cell.add_ons.push_back(layers[index % 3]);
    if (cell.input->targets.count("depth") && index % 5 == 2)
        cell.add_ons.push_back("geometry/depth_levels");
    const char* const rotations[] = {"rotation=tile", "rotation=gradient", "rotation=none"};
    if (has(*cell.estimator, "rotation")) cell.overrides.push_back(rotations[index / 2 % 3]);
    if (has(*cell.input, "guard_band") && index % 4 == 0)
        cell.overrides.push_back("guard_band=1.2");
    // Tiles of every fourth pixel: at a quarter of the size none is as near as the radius.
    const bool tiles = std::string_view(cell.estimator->name) == "ssao/hbao_plus";
    if (has(*cell.filter, "ao_scale") && index % 2)
        cell.overrides.push_back(tiles ? "ao_scale=0.5" : "ao_scale=0.25");
}

/// All pairs of estimator and filter, each on two inputs three apart, so that every estimator and
/// every filter meets every input.
std::vector<Cell> cells()
{
    std::vector<Cell> all;
    const std::vector<Module>& inputs = shippedInputs();
    std::size_t row = 0;
    for (const Module& estimator : shippedEstimators()) {
        std::size_t input = row++;
        for (const Module& filter : shippedFilters()) {
            for (std::size_t i = 0; i < 2; ++i) {
                all.push_back({&inputs[(input + 3 * i) % inputs.size()], &estimator, &filter});
                addOptions(all.back(), all.size() + row);
            }
            ++input;
        }
    }
    return all;
}

/// A floor and a wall, closed and finite: an edge, two open faces, background all round.
Scene edgeScene()
{
    Scene scene;
    scene.meshes = {makeBox({-2, -0.2f, -2}, {2, 0, 2}), makeBox({-2, 0, -2.2f}, {2, 2.2f, -2})};
    for (MeshDesc& mesh : scene.meshes) mesh.label = "box";
    scene.instances.resize(2);
    scene.instances[1].mesh = 1;
    scene.materials.resize(1);
    Light light;
    light.position = {1, 2, 2};
    scene.lights = {{"light", light}};
    return scene;
}

/// What all cells share: the scene, and what a host would have drawn of it.
struct Stage : SceneRig {
    Frame drawn = frame("eye=0,2.4,5.5;at=0,0.6,-0.8;fov=45"), host_frame, host_and_draws;
    std::vector<HostTextures> hosts;

    Stage() : SceneRig(edgeScene(), kExtent)
    {
        for (const Module& input : shippedInputs()) {
            if (!input.host_textures) continue;
            const Description description =
                GivenConfig({input.name, "ssao/hemisphere"}).description();
            hosts.push_back(need(HostTextures::make(*device, description, kExtent, drawn)));
            const Frame given = need(hosts.back().frameOf(drawn));
            host_frame.camera = given.camera;
            host_frame.lights = given.lights;
            for (const ImportedTexture& each : given.textures)
                if (!findNamed(host_frame.textures, each.name)) host_frame.textures.push_back(each);
        }
        host_and_draws = host_frame;
        host_and_draws.draws = drawn.draws;
        host_and_draws.materials = drawn.materials;
    }

    const Frame& frameFor(const Cell& cell) const
    {
        if (!cell.input->host_textures) return drawn;
        // Voxels are of a scene, whoever draws what is seen of it.
        return std::string_view(cell.estimator->name) == "ssao/vxao" ? host_and_draws : host_frame;
    }

    Result<std::unique_ptr<Renderer>> make(const Cell& cell)
    {
        std::vector<std::string> modules = {cell.input->name, cell.estimator->name};
        modules.insert(modules.end(), cell.add_ons.begin(), cell.add_ons.end());
        modules.push_back(cell.filter->name);
        const GivenConfig config(modules, R"(, "params": {"radius": {"default": 0.6}})");
        const Result<Node> document = loadConfig(config.sources(), {"given", {}, cell.overrides});
        if (!document) return document.diagnostics();
        const Result<Description> description = decode(*document, config.sources());
        if (!description) return description.diagnostics();
        return Renderer::create(*device, *description, {kExtent, {}, {}}, traitsOf(frameFor(cell)));
    }

    Image drawCell(Renderer& of, const Cell& cell)
    {
        for (int i = 0; i < (cell.filter->remembers ? 2 : 1); ++i) need(of.render(frameFor(cell)));
        return read(of.output("ao"));
    }

    /// Least and mean visibility on the rectangle between two points of the world.
    std::pair<float, double> seen(const Image& ao, const glm::vec3& from, const glm::vec3& to) const
    {
        constexpr int kSteps = 12;
        float least = 1.0f;
        double sum = 0;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const glm::vec3 share = {i % kSteps / (kSteps - 1.0f), i / kSteps / (kSteps - 1.0f),
                                     i / kSteps / (kSteps - 1.0f)};
            const glm::vec4 clip = drawn.camera.clip_from_view *
                                   glm::mat4(drawn.camera.view_from_world) *
                                   glm::vec4(glm::mix(from, to, share), 1.0f);
            const float value = ao.at(int((clip.x / clip.w * 0.5f + 0.5f) * kExtent.width),
                                      int((clip.y / clip.w * 0.5f + 0.5f) * kExtent.height));
            least = std::min(least, value);
            sum += value;
        }
        return {least, sum / (kSteps * kSteps)};
    }
};

void checkRefusal(const Diagnostics& diagnostics)
{
    REQUIRE(diagnostics.size() == 1);
    const Diagnostic& error = diagnostics.front();
    INFO(toText(diagnostics));
    CHECK((error.code == Code::uniform_unbound || error.code == Code::target_missing));
    CHECK(error.place.line > 0);
    CHECK(!error.help.empty());
}

void checkVisibility(const Stage& stage, const Cell& cell, const Image& ao)
{
    CHECK(allVisibility(ao));
    const auto floor = stage.seen(ao, {-1, 0, -0.4f}, {1, 0, 0.8f});
    const auto wall = stage.seen(ao, {-1, 1.2f, -2}, {1, 1.6f, -2});
    const auto edge = stage.seen(ao, {-1, 0, -1.9f}, {1, 0, -1.8f});
    if (cell.estimator->reads_normals) {
        CHECK(edge.second < floor.second - 0.03);
        CHECK(std::min(floor.first, wall.first) >= 0.95f);
    } else {  // half of what such a kernel probes about a wall lies inside it
        CHECK((wall.first > 0.35f && wall.second < 0.75));
    }
    for (const int x : {4, kExtent.width - 5})
        for (const int y : {4, kExtent.height - 5}) CHECK(ao.at(x, y) == 1.0f);
}

}  // namespace

TEST_CASE("Estimators, filters and inputs run together by pairs, or are refused with a reason")
{
    Stage stage;
    std::set<std::string> drawn, all;
    std::size_t turn = 0, refused = 0;
    for (const Cell& cell : cells()) {
        const std::set<std::string> names = {cell.input->name, cell.estimator->name,
                                             cell.filter->name};
        all.insert(names.begin(), names.end());
        const bool known = std::includes(drawn.begin(), drawn.end(), names.begin(), names.end());
        if (known && !nightly() && turn++ % 10 > 0) continue;
        INFO(textOf(cell));
        auto renderer = stage.make(cell);
        if (!renderer) {
            ++refused;
            checkRefusal(renderer.diagnostics());
            continue;
        }
        checkVisibility(stage, cell, stage.drawCell(**renderer, cell));
        need((*renderer)->setParam("intensity", 0.0f));
        CHECK(mean(stage.drawCell(**renderer, cell)) == 1.0);
        drawn.insert(names.begin(), names.end());
    }
    all.erase("filter/indirect");  // no cell has its light with its depth; figures_gl_test draws it
    CHECK(drawn == all);
    CHECK(refused < cells().size() / 3);  // which read what no other module of the cell writes
}
