// SPDX-License-Identifier: MIT
// A host's scene and its views by the C API, without GL: when something is drawn again, and who
// keeps what alive.
// Draws by the C API, on a device that draws nothing: callbacks, what is refused, and the times of
// passes.
#include "tests/c_api/c_scene.h"
#include "tests/core/run/allocations.h"

using namespace crevice;

namespace {

/// Counts its calls.
void count(const crevice_draw_call*, void* calls) { ++*static_cast<int*>(calls); }

/// What a callback was given.
struct Heard {
    std::vector<std::string> passes;
    std::uint32_t program = 0;
    glm::mat4 clip_from_model = glm::mat4(0.0f);
    bool knows_names = false;

    static void draw(const crevice_draw_call* call, void* user)
    {
        Heard& self = *static_cast<Heard*>(user);
        self.passes.push_back(call->pass);
        self.program = call->program;
        self.clip_from_model = glm::make_mat4(crevice_draw_call_matrix(call, "clip_from_model"));
        self.knows_names = call->struct_size == sizeof *call &&
                           crevice_draw_call_matrix(call, "view_normal_from_model") &&
                           !crevice_draw_call_matrix(call, "base_color") &&
                           !crevice_draw_call_matrix(call, nullptr);
    }
};

}  // namespace

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

TEST_CASE_METHOD(CViews,
                 "C API: a view has the textures that it is given, as long as there is the view")
{
    texture.name = 9;
    CHECK(setTexture(1) == 0);
    const int attempts = recording->attempts();
    CHECK(setTexture(1) == 0);
    CHECK(recording->attempts() == attempts);
    const auto& textures = frame().other_views[0].textures;
    REQUIRE(textures.size() == 1);
    CHECK(textures[0].name == "depth");
    CHECK(recording->info(textures[0].texture).native_name == 9);
    texture.kind = CREVICE_LAYER;  // which is copied for each frame
    CHECK(setTexture(1) == 0);
    recording->clearLog();
    need(crevice_effect_render(effect));
    CHECK(recording->log().find("refresh") != std::string::npos);
    const TextureId second = textures[0].texture;
    need(crevice_effect_set_views(effect, nullptr, 0));
    CHECK(setTexture(0) == 0);
    need(crevice_effect_render(effect));
    CHECK_FALSE(recording->info(second).exists);
}

TEST_CASE_METHOD(CViews, "C API: a texture or an output of a view that is not there is refused")
{
    auto output = sized<crevice_output>();
    const auto get = [&](int of_view) {
        return codeOf(crevice_effect_get_view_output(effect, of_view, "ao", &output));
    };
    CHECK(setTexture(2) == 6011);
    CHECK(setTexture(-1) == 6011);
    CHECK(codeOf(crevice_effect_set_view_texture(effect, 1, "dept", &texture)) == 2102);
    texture.format = "depth16";
    CHECK(setTexture(1) == 6011);
    CHECK(frame().other_views[0].textures.empty());
    CHECK(get(1) == 6011);  // before a frame
    need(crevice_effect_render(effect));
    CHECK(get(0) == 0);
    const std::uint32_t first = output.texture;
    CHECK(get(1) == 0);
    CHECK(output.texture != first);
    CHECK(get(2) == 6011);
    CHECK(get(-1) == 6011);
    auto target = sized<crevice_target>();
    target.width = target.height = 4;
    const auto present = [&](int of_view) {
        target.view = of_view;
        recording->clearLog();
        const int code = codeOf(crevice_effect_present(effect, "ao", &target));
        return code == 0 ? recording->log() : std::to_string(code);
    };
    CHECK(present(2) == "6011");
    CHECK(present(0) != present(1));
    CHECK(codeOf(crevice_effect_present(effect, "aoo", &target)) == 2209);
}

TEST_CASE_METHOD(CScene, "C API: a callback is given its pass, program and matrices by name")
{
    Heard heard;
    draw.callback = Heard::draw;
    draw.user = &heard;
    draw.world_from_model[0] = draw.world_from_model[5] = draw.world_from_model[10] = 2;
    draw.world_from_model[15] = 1;
    setDraw();
    CHECK(draws());
    const Camera& camera = frame().camera;
    const glm::dmat4 wanted = glm::dmat4(camera.clip_from_view) * camera.view_from_world *
                              glm::make_mat4(draw.world_from_model);
    CHECK(heard.clip_from_model == glm::mat4(wanted));
    CHECK(heard.passes == std::vector<std::string>{"geometry", "lighting"});
    CHECK(heard.program != 0);
    CHECK(heard.knows_names);
}

TEST_CASE_METHOD(CScene, "C API: a callback that throws is an error, and is called again")
{
    static bool throws = true;
    throws = true;
    draw.callback = [](const crevice_draw_call*, void*) {
        if (throws) throw 7;
    };
    draw.revision = 1;
    setDraw();
    CHECK(codeOf(crevice_effect_render(effect)) == 6011);
    throws = false;
    CHECK(draws());
    CHECK_FALSE(draws());
}

TEST_CASE_METHOD(CScene, "C API: what cannot be drawn is refused, and the scene stays as it was")
{
    crevice_device elsewhere{std::make_shared<RecordingDevice>()};
    crevice_mesh* other = makeMesh(elsewhere);
    setDraw();
    const std::vector<DrawItem> before = frame().draws;
    crevice_draw two[] = {draw, draw};
    two[0].sheet = true;
    const auto refuses = [&](const char* why) {
        crevice_error* error = crevice_effect_set_draws(effect, two, 2);
        const std::string text = crevice_error_text(error);
        two[1] = draw;
        return codeOf(error) == 6011 && text.find(why) != std::string::npos &&
               frame().draws == before;
    };
    two[1].mesh = nullptr;
    CHECK(refuses("draw 1 has neither mesh nor callback"));
    two[1].mesh = other;
    CHECK(refuses("draw 1 has a mesh of another device"));
    two[1].first = 4;
    CHECK(refuses("draw 1 begins at index 4"));
    two[1].first = 1;
    two[1].count = std::numeric_limits<std::uint32_t>::max();
    CHECK(refuses("and its mesh has 3"));
    auto light = sized<crevice_light>();
    light.kind = static_cast<crevice_light_kind>(3);
    CHECK(codeOf(crevice_effect_set_lights(effect, &light, 1)) == 6011);
    texture.samples = 4;
    material.normal_map = &texture;
    CHECK(codeOf(crevice_effect_set_materials(effect, &material, 1)) == 6011);
    crevice_mesh_destroy(other);
}

TEST_CASE_METHOD(CScene, "C API: a mesh that cannot be made is refused")
{
    crevice_mesh* made = mesh;
    const std::uint32_t past[] = {0, 1, 3};
    auto desc = sized<crevice_mesh_desc>();
    const auto code = [&] { return codeOf(crevice_mesh_create(&device, &desc, &made)); };
    desc.vertex_count = 3;
    CHECK(code() == 6011);
    CHECK(made == nullptr);
    desc.positions = kTriangle;
    desc.index_count = 3;
    CHECK(code() == 6011);
    desc.indices = past;
    CHECK(code() == 6011);
    desc.vertex_count = 0;
    CHECK(code() == 6011);
    desc.vertex_count = std::numeric_limits<std::uint32_t>::max();
    CHECK(code() == 6007);

    auto host = sized<crevice_host_mesh>();
    const auto adopted = [&] { return codeOf(crevice_mesh_adopt(&device, &host, &made)); };
    host.position.buffer = 3;
    host.vertex_count = 3;
    host.uv.type = static_cast<crevice_vertex_type>(7);
    CHECK(adopted() == 6011);
    host.uv.type = CREVICE_FLOAT32;
    host.index_type = static_cast<crevice_index_type>(3);
    CHECK(adopted() == 6011);
    host.index_type = CREVICE_UINT32;
    CHECK(adopted() == 0);
    CHECK(made->shared->device->info(made->shared->id.id()).index_count == 3);
    crevice_mesh_destroy(made);
}

TEST_CASE_METHOD(CScene, "C API: times of passes come by name, once they are in")
{
    need(crevice_effect_set_timing(effect, true));
    CHECK(crevice_error_code(crevice_effect_warnings(effect)) == 6018);
    recording->setTimers({0.5});
    draw.callback = [](const crevice_draw_call*, void*) {};  // in every frame
    setDraw();
    need(crevice_effect_set_timing(effect, true));
    CHECK(crevice_effect_warnings(effect) == nullptr);
    CHECK(crevice_effect_pass_time_count(effect) == 0);
    for (int i = 0; i < 7; ++i) need(crevice_effect_render(effect));
    const std::vector<PlanPass>& now = effect->effect->renderer().plan().passes;
    const int count = static_cast<int>(now.size());
    REQUIRE(crevice_effect_pass_time_count(effect) == count);
    auto time = sized<crevice_pass_time>();
    need(crevice_effect_get_pass_time(effect, count - 1, &time));
    CHECK(time.name == now.back().name);
    CHECK(time.milliseconds == 0.5);
    CHECK(codeOf(crevice_effect_get_pass_time(effect, -1, &time)) == 6011);
    CHECK(codeOf(crevice_effect_get_pass_time(effect, count, &time)) == 6011);
}
