// SPDX-License-Identifier: MIT
// A host's scene by the C API, on a device that draws nothing: what becomes of each member, when
// something is drawn again, and who keeps what alive.
#include "tests/c_api/c_scene.h"
#include "tests/core/run/allocations.h"

#include <glm/gtc/type_ptr.hpp>

#include <numeric>

using namespace crevice;

namespace {

/// Counts its calls.
void count(const crevice_draw_call*, void* calls) { ++*static_cast<int*>(calls); }

}  // namespace

TEST_CASE_METHOD(CScene, "C API: each member of a draw becomes that of a frame's draw")
{
    draw.first = 1;
    draw.count = 2;
    std::iota(draw.world_from_model, draw.world_from_model + 16, 1.5);
    draw.material = 7;
    const float center[] = {2, 3, 4};
    std::copy_n(center, 3, draw.bounds_center);
    draw.bounds_radius = 5;
    draw.sheet = true;
    draw.revision = (1ull << 40) + 1;
    setDraw();
    DrawItem wanted;
    wanted.mesh = mesh->shared->id.id();
    wanted.first = 1;
    wanted.count = 2;
    wanted.world_from_model = glm::make_mat4(draw.world_from_model);
    wanted.material = 7;
    wanted.bounds_center = {2, 3, 4};
    wanted.bounds_radius = 5;
    wanted.sheet = true;
    wanted.revision = (1ull << 40) + 1;
    REQUIRE(frame().draws.size() == 1);
    CHECK(frame().draws[0] == wanted);
}

TEST_CASE_METHOD(CScene, "C API: each member of a material becomes that of a frame's material")
{
    const float color[] = {0.1f, 0.2f, 0.3f, 0.4f};
    std::copy_n(color, 4, material.base_color);
    std::copy_n(color, 3, material.specular);
    material.shininess = 3;
    material.ambient_dimming = 0.25f;
    material.alpha_cutoff = 0.5f;
    material.normal_scale = 0.6f;
    material.occlusion_strength = 0.7f;
    crevice_texture normals = texture, open = texture;
    normals.name = 6;
    open.name = 7;
    material.base_color_map = &texture;
    material.normal_map = &normals;
    material.occlusion_map = &open;
    setMaterial();
    REQUIRE(frame().materials.size() == 1);
    Material made = frame().materials[0];
    CHECK(recording->info(made.base_color_map).native_name == 5);
    CHECK(recording->info(made.normal_map).native_name == 6);
    CHECK(recording->info(made.occlusion_map).native_name == 7);
    Material wanted = made;  // with its maps
    wanted.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
    wanted.specular = {0.1f, 0.2f, 0.3f};
    wanted.shininess = 3;
    wanted.ambient = 0.75f;
    wanted.alpha_cutoff = 0.5f;
    wanted.normal_scale = 0.6f;
    wanted.occlusion_strength = 0.7f;
    CHECK(made == wanted);
}

TEST_CASE_METHOD(CScene, "C API: each member of a light becomes that of a frame's light")
{
    crevice_light lights[3];
    for (crevice_light& each : lights) each = sized<crevice_light>();
    lights[1].kind = CREVICE_DIRECTIONAL;
    crevice_light& spot = lights[2];
    spot.kind = CREVICE_SPOT;
    std::iota(spot.position, spot.position + 3, 1.0);
    std::iota(spot.direction, spot.direction + 3, 4.0f);
    std::iota(spot.color, spot.color + 3, 7.0f);
    std::iota(spot.attenuation, spot.attenuation + 3, 10.0f);
    spot.inner_angle_rad = 0.25f;
    spot.outer_angle_rad = 0.5f;
    const float ambient[] = {0.5f, 0.6f, 0.7f};
    need(crevice_effect_set_lights(effect, lights, 3));
    need(crevice_effect_set_ambient_light(effect, ambient));
    const std::vector<Light>& made = frame().lights;
    REQUIRE(made.size() == 3);
    CHECK_FALSE((made[0].directional || made[0].spot));
    CHECK((made[1].directional && !made[1].spot));
    CHECK((made[2].spot && !made[2].directional));
    CHECK(made[2].position == glm::dvec3(1, 2, 3));
    CHECK(made[2].direction == glm::vec3(4, 5, 6));
    CHECK(made[2].color == glm::vec3(7, 8, 9));
    CHECK(made[2].attenuation == glm::vec3(10, 11, 12));
    CHECK(made[2].inner_angle_rad == 0.25f);
    CHECK(made[2].outer_angle_rad == 0.5f);
    CHECK(frame().ambient_light == glm::vec3(0.5f, 0.6f, 0.7f));
}

TEST_CASE_METHOD(CScene, "C API: what is zero in a scene is the default")
{
    CHECK(frame().materials == std::vector<Material>(1));
    setDraw();
    setMaterial();
    auto light = sized<crevice_light>();
    need(crevice_effect_set_lights(effect, &light, 1));
    DrawItem whole;
    whole.mesh = mesh->shared->id.id();
    whole.count = 3;
    CHECK(frame().draws[0] == whole);
    CHECK(frame().materials == std::vector<Material>(1));
    const Light plain;
    CHECK(frame().lights[0].direction == plain.direction);
    CHECK(frame().lights[0].attenuation == plain.attenuation);
    CHECK(frame().lights[0].outer_angle_rad == plain.outer_angle_rad);
    CHECK(frame().lights[0].color == glm::vec3(0.0f));
    need(crevice_effect_set_materials(effect, nullptr, 0));
    CHECK(frame().materials == std::vector<Material>(1));
    CHECK(draws());
}

TEST_CASE_METHOD(CScene, "C API: the same scene again allocates nothing and draws nothing")
{
    material.base_color_map = &texture;
    crevice_draw two[] = {draw, draw};
    two[1].mesh = nullptr;
    two[1].callback = count;
    two[1].revision = 1;
    int calls = 0;
    two[1].user = &calls;
    auto light = sized<crevice_light>();
    const auto set = [&] {
        const bool well = !crevice_effect_set_draws(effect, two, 2) &&
                          !crevice_effect_set_materials(effect, &material, 1) &&
                          !crevice_effect_set_lights(effect, &light, 1);
        return well && !crevice_effect_render(effect);
    };
    REQUIRE(set());
    const int before = calls;
    CHECK(before > 0);
    REQUIRE(set());  // the log of this device grows once more
    recording->clearLog();
    const long allocations = allocationCount();
    const bool well = set();
    CHECK(allocationCount() == allocations);
    CHECK(well);
    CHECK(calls == before);
    CHECK(recording->log().find("draw mesh") == std::string::npos);
}

TEST_CASE_METHOD(CScene, "C API: what a scene has changed is drawn again, and nothing else is")
{
    int calls = 0, others = 0;
    draw.revision = 1;
    material.base_color_map = &texture;
    setDraw();
    setMaterial();
    CHECK(draws());
    CHECK_FALSE(draws());
    const auto redraws = [this] {
        setDraw();
        setMaterial();
        return draws() && !draws();
    };
    draw.revision = 2;
    CHECK(redraws());
    draw.world_from_model[0] = draw.world_from_model[5] = draw.world_from_model[10] =
        draw.world_from_model[15] = 1;
    CHECK_FALSE(redraws());
    draw.world_from_model[12] = 0.5;
    CHECK(redraws());
    material.revision = 1;
    CHECK(redraws());
    draw.callback = count;
    draw.user = &calls;
    CHECK(redraws());
    draw.user = &others;
    CHECK(redraws());
    CHECK(others > 0);
    draw.callback = [](const crevice_draw_call*, void*) {};
    CHECK(redraws());
    CHECK_FALSE(redraws());
    draw.revision = 0;
    setDraw();
    CHECK((draws() && draws()));
}

TEST_CASE_METHOD(CScene, "C API: a mesh lives as long as a program or an effect has it")
{
    const int before = recording->live(ObjectId::Kind::mesh);
    setDraw();
    crevice_mesh_destroy(std::exchange(mesh, nullptr));
    CHECK(draws());
    CHECK(recording->live(ObjectId::Kind::mesh) == before);
    need(crevice_effect_set_draws(effect, nullptr, 0));
    CHECK(recording->live(ObjectId::Kind::mesh) == before - 1);
    CHECK_FALSE(draws());
}

TEST_CASE_METHOD(CScene, "C API: the maps of materials live as long as a material has them")
{
    const int before = recording->live(ObjectId::Kind::texture);
    const auto maps = [&] { return recording->live(ObjectId::Kind::texture) - before; };
    material.base_color_map = material.normal_map = &texture;
    crevice_material two[] = {material, material};
    need(crevice_effect_set_materials(effect, two, 2));
    CHECK(maps() == 4);
    two[1].normal_map = nullptr;
    need(crevice_effect_set_materials(effect, two, 2));
    CHECK(maps() == 3);
    CHECK_FALSE(frame().materials[1].normal_map);
    crevice_texture other = texture, bad = texture;
    other.name = 9;
    bad.format = "rgb42";
    two[0].base_color_map = &other;
    two[1].base_color_map = &bad;
    const std::vector<Material> materials = frame().materials;
    CHECK(codeOf(crevice_effect_set_materials(effect, two, 2)) == 6011);
    CHECK(maps() == 3);
    CHECK(frame().materials == materials);
    need(crevice_effect_set_materials(effect, two, 1));
    CHECK(maps() == 2);
    CHECK(recording->info(frame().materials[0].base_color_map).native_name == 9);
    need(crevice_effect_set_materials(effect, nullptr, 0));
    CHECK(maps() == 0);
}
