// SPDX-License-Identifier: MIT
// What becomes of each member of a struct of C, on a device that draws nothing.
// Structs of other versions, as programs have them that were built with another header: cut short
// at every size, and longer than this library's. All functions take and give theirs in this way.
#include "tests/c_api/c_scene.h"

#include "effects/api/c/calls.h"

#include <algorithm>
#include <numeric>

using namespace crevice;

namespace {

/// One of this version's.
struct Known {
    std::size_t struct_size;
    double numbers[3];
};

constexpr char kByte = 1, kGarbage = '\xAA';
constexpr std::size_t kFirst = sizeof(std::size_t), kLonger = 40, kLargest = 4096;

/// A struct in memory of exactly that size, all bytes of which are `byte`, before `behind` of
/// garbage.
std::unique_ptr<char[]> structOf(std::size_t size, char byte, std::size_t behind = 0)
{
    const std::size_t bytes = std::max(size, kFirst);
    std::unique_ptr<char[]> made(new char[bytes + behind]);
    std::fill_n(made.get(), bytes, byte);
    std::fill_n(made.get() + bytes, behind, kGarbage);
    std::memcpy(made.get(), &size, kFirst);
    return made;
}

const Known* known(const std::unique_ptr<char[]>& bytes)
{
    return reinterpret_cast<const Known*>(bytes.get());
}

bool possible(std::size_t size) { return size > kFirst && size <= kLargest && size % kFirst == 0; }

}  // namespace

TEST_CASE_METHOD(CScene, "C API: each member of a draw becomes that of a frame's draw")
{
    draw.first = 1;
    draw.count = 2;
    std::iota(draw.world_from_model, draw.world_from_model + 16, 1.5);
    draw.material = 7;
    std::iota(draw.bounds_center, draw.bounds_center + 3, 2.0f);
    draw.bounds_radius = 5;
    draw.sheet = true;
    draw.revision = (1ull << 40) + 1;
    setDraw();
    const glm::dmat4 placed = glm::make_mat4(draw.world_from_model);
    const DrawItem wanted = {
        mesh->shared->id.id(), 1, 2, placed, 7, {2, 3, 4}, 5, true, nullptr, nullptr,
        draw.revision};
    CHECK(frame().draws == std::vector<DrawItem>{wanted});
}

TEST_CASE_METHOD(CScene, "C API: each member of a material becomes that of a frame's material")
{
    std::iota(material.base_color, material.base_color + 4, 0.125f);
    std::iota(material.specular, material.specular + 3, 0.25f);
    material.shininess = 3;
    material.ambient_dimming = 0.25f;
    material.alpha_cutoff = 0.5f;
    material.normal_scale = 0.6f;
    material.occlusion_strength = 0.7f;
    material.blended = true;
    material.unlit = true;
    material.metallic = 0.8f;
    material.smoothness = 0.25f;
    material.reflectance = 0.1f;
    std::iota(material.emission, material.emission + 3, 0.5f);
    crevice_texture normals = texture, open = texture, metals = texture, lamps = texture;
    normals.name = 6;
    open.name = 7;
    metals.name = 8;
    lamps.name = 9;
    material.base_color_map = &texture;
    material.normal_map = &normals;
    material.occlusion_map = &open;
    material.metallic_roughness_map = &metals;
    material.emission_map = &lamps;
    setMaterial();
    REQUIRE(frame().materials.size() == 1);
    const Material made = frame().materials[0];
    CHECK(recording->info(made.base_color_map).native_name == 5);
    CHECK(recording->info(made.normal_map).native_name == 6);
    CHECK(recording->info(made.occlusion_map).native_name == 7);
    CHECK(recording->info(made.metallic_roughness_map).native_name == 8);
    CHECK(recording->info(made.emission_map).native_name == 9);
    Material wanted = made;  // with its maps
    wanted.base_color = {0.125f, 1.125f, 2.125f, 3.125f};
    wanted.specular = {0.25f, 1.25f, 2.25f};
    wanted.shininess = 3;
    wanted.ambient = 0.75f;
    wanted.alpha_cutoff = 0.5f;
    wanted.normal_scale = 0.6f;
    wanted.occlusion_strength = 0.7f;
    wanted.blended = true;
    wanted.unlit = true;
    wanted.metallic = 0.8f;
    wanted.roughness = 0.75f;
    wanted.reflectance = 0.1f;
    wanted.emission = {0.5f, 1.5f, 2.5f};
    CHECK(made == wanted);
}

TEST_CASE_METHOD(CScene, "C API: each member of a light becomes that of a frame's light")
{
    crevice_light lights[] = {sized<crevice_light>(), sized<crevice_light>()};
    lights[0].kind = CREVICE_DIRECTIONAL;
    crevice_light& spot = lights[1];
    spot.kind = CREVICE_SPOT;
    std::iota(spot.position, spot.position + 3, 1.0);
    std::iota(spot.direction, spot.direction + 3, 4.0f);
    std::iota(spot.color, spot.color + 3, 7.0f);
    std::iota(spot.attenuation, spot.attenuation + 3, 10.0f);
    spot.inner_angle_rad = 0.25f;
    spot.outer_angle_rad = 0.5f;
    const float ambient[] = {0.5f, 0.6f, 0.7f};
    need(crevice_effect_set_lights(effect, lights, 2));
    need(crevice_effect_set_ambient_light(effect, ambient));
    const std::vector<Light>& made = frame().lights;
    REQUIRE(made.size() == 2);
    CHECK((made[0].directional && !made[0].spot));
    CHECK((made[1].spot && !made[1].directional));
    CHECK(made[1].position == glm::dvec3(1, 2, 3));
    CHECK(made[1].direction == glm::vec3(4, 5, 6));
    CHECK(made[1].color == glm::vec3(7, 8, 9));
    CHECK(made[1].attenuation == glm::vec3(10, 11, 12));
    CHECK(made[1].inner_angle_rad == 0.25f);
    CHECK(made[1].outer_angle_rad == 0.5f);
    CHECK(frame().ambient_light == glm::vec3(0.5f, 0.6f, 0.7f));
}

TEST_CASE_METHOD(CScene, "C API: what is zero in a scene is the default")
{
    setDraw();
    setMaterial();
    auto light = sized<crevice_light>();
    need(crevice_effect_set_lights(effect, &light, 1));
    CHECK(frame().draws == std::vector<DrawItem>{{mesh->shared->id.id(), 0, 3}});
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

TEST_CASE("C API: each array of a mesh is copied; without indices vertices have them")
{
    const float normals[] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, uvs[] = {10, 11, 12, 13, 14, 15};
    const std::uint32_t indices[] = {2, 1, 0};
    auto desc = sized<crevice_mesh_desc>();
    desc.label = "statue";
    desc.positions = kTriangle;
    desc.normals = normals;
    desc.uvs = uvs;
    desc.vertex_count = 3;
    CHECK(meshOf(desc).indices == std::vector<std::uint32_t>{0, 1, 2});
    desc.indices = indices;
    desc.index_count = 3;
    const MeshDesc made = meshOf(desc);
    CHECK(made.label == "statue");
    CHECK(made.indices == std::vector<std::uint32_t>{2, 1, 0});
    REQUIRE(made.vertices.size() == 3);
    for (int i = 0; i < 3; ++i) {
        const Vertex& vertex = made.vertices[i];
        CHECK(std::equal(vertex.position, vertex.position + 3, kTriangle + 3 * i));
        CHECK(std::equal(vertex.normal, vertex.normal + 3, normals + 3 * i));
        CHECK(std::equal(vertex.uv, vertex.uv + 2, uvs + 2 * i));
    }
}

TEST_CASE("C API: each member of a mesh in buffers becomes that of a host's mesh")
{
    auto host = sized<crevice_host_mesh>();
    host.label = "statue";
    host.position = {3, CREVICE_FLOAT16, 4, 12};
    host.normal = {5, CREVICE_SNORM10, 8, 16};
    host.uv = {6, CREVICE_UNORM16, 10, 20};
    host.vertex_count = 9;
    CHECK(meshOf(host).index_count == 9);  // vertices in their order
    host.index_buffer = 7;
    host.index_type = CREVICE_UINT16;
    host.index_offset = 14;
    host.index_count = 6;
    const HostMesh made = meshOf(host);
    const auto is = [](const HostAttribute& one, const HostAttribute& wanted) {
        return std::memcmp(&one, &wanted, sizeof one) == 0;
    };
    CHECK(made.label == "statue");
    CHECK(is(made.position, {3, VertexType::float16, 4, 12}));
    CHECK(is(made.normal, {5, VertexType::snorm10, 8, 16}));
    CHECK(is(made.uv, {6, VertexType::unorm16, 10, 20}));
    CHECK((made.vertex_count == 9 && made.index_count == 6));
    CHECK((made.index_buffer == 7 && made.index_offset == 14));
    CHECK(made.index_type == IndexType::uint16);
}

TEST_CASE("C API: each member of a texture becomes that of a host's texture")
{
    auto texture = sized<crevice_texture>();
    HostTexture made;
    need(takeTexture(&texture, made));
    CHECK(made == HostTexture{0, "", Format::none});
    texture.name = 5;
    texture.format = "depth16";
    texture.width = 8;
    texture.height = 9;
    texture.kind = CREVICE_LAYER;
    texture.layer = 2;
    texture.samples = 4;
    texture.part = true;
    texture.x = 3;
    texture.y = 4;
    need(takeTexture(&texture, made));
    CHECK(made ==
          HostTexture{5, "", Format::depth16, {8, 9}, 4, HostTexture::Kind::layer, 2, true, 3, 4});
    texture.kind = static_cast<crevice_texture_kind>(4);
    CHECK_FALSE(takeTexture(&texture, made));
}

TEST_CASE("C API: each member of a target becomes that of a host's framebuffer")
{
    auto target = sized<crevice_target>();
    target.framebuffer = 1;
    target.texture = 2;
    target.level = 3;
    target.x = 4;
    target.y = 5;
    target.width = 6;
    target.height = 7;
    target.multiply = true;
    const HostFramebuffer made = framebufferOf(target);
    CHECK((made.name == 1 && made.texture == 2 && made.level == 3));
    CHECK((made.x == 4 && made.y == 5 && made.extent == Extent{6, 7} && made.multiply));
}

TEST_CASE_METHOD(CViews, "C API: each member of a view becomes that of a frame's view")
{
    std::iota(view.clip_from_view, view.clip_from_view + 16, 1.0f);
    std::iota(view.view_from_world, view.view_from_world + 16, 2.0);
    crevice_view two[] = {sized<crevice_view>(), view};
    need(crevice_effect_set_clip_control(effect, false, true));
    need(crevice_effect_set_depth_range(effect, 1, 0.5f));
    need(crevice_effect_set_views(effect, two, 2));
    REQUIRE(frame().other_views.size() == 2);
    const Camera& first = frame().other_views[0].camera;
    const Camera& second = frame().other_views[1].camera;
    CHECK(first.view_from_world == glm::dmat4(1.0));
    CHECK(second.clip_from_view == glm::make_mat4(view.clip_from_view));
    CHECK(second.view_from_world == glm::make_mat4(view.view_from_world));
    CHECK(second.clip_control == ClipControl{false, true});
    CHECK(second.depth_range == DepthRange{1, 0.5f});
    need(crevice_effect_set_clip_control(effect, true, false));
    CHECK(second.clip_control == ClipControl{true, false});
    need(crevice_effect_set_depth_range(effect, 0, 0.5f));
    CHECK(
        (second.depth_range == frame().camera.depth_range && second.depth_range->near_depth == 0));
}

TEST_CASE("C API: a struct of another version is taken at its own size")
{
    for (std::size_t size = 0; size <= sizeof(Known) + kLonger; ++size) {
        INFO(size);
        const auto given = structOf(size, kByte);
        if (size > sizeof(Known)) std::fill_n(given.get() + sizeof(Known), size - sizeof(Known), 0);
        Known own = {};
        REQUIRE(take(known(given), "known", own).ok() == possible(size));
        if (!possible(size)) continue;
        const char* const bytes = reinterpret_cast<const char*>(own.numbers);
        const auto whole = std::count(bytes, bytes + sizeof own.numbers, kByte);
        CHECK(whole + kFirst == std::min(size, sizeof(Known)));
    }
    Known own = {};
    CHECK_FALSE(take(known(structOf(kLargest + kFirst, 0)), "known", own));
    // A member that this version does not know is set.
    CHECK_FALSE(take(known(structOf(sizeof(Known) + kFirst, kByte)), "known", own));
    CHECK_FALSE(take<Known>(nullptr, "known", own));
}

TEST_CASE("C API: a struct of another version is filled in at its own size")
{
    Known own = {};
    std::memset(own.numbers, kByte, sizeof own.numbers);
    for (std::size_t size = 0; size <= sizeof(Known) + kLonger; ++size) {
        INFO(size);
        const auto into = structOf(size, kGarbage, 64);
        CHECK(check(known(into), "known").ok() == possible(size));
        if (!possible(size)) continue;
        give(own, reinterpret_cast<Known*>(into.get()));
        CHECK(structSize(into.get()) == size);
        char* const begin = into.get() + kFirst;
        char* const end = into.get() + std::min(size, sizeof(Known));
        CHECK(std::count(begin, end, kByte) == end - begin);
        CHECK(std::count(end, into.get() + size, 0) == into.get() + size - end);
        CHECK(std::count(into.get() + size, into.get() + size + 64, kGarbage) == 64);
    }
}

TEST_CASE("C API: an array of another version has structs of one size, each taken at that")
{
    constexpr std::size_t kShort = 2 * kFirst, kCount = 3;
    std::unique_ptr<char[]> array(new char[kCount * kShort]);
    for (std::size_t i = 0; i < kCount; ++i) {
        const double number = static_cast<double>(i) + 0.5;
        std::memcpy(array.get() + i * kShort, &kShort, kFirst);
        std::memcpy(array.get() + i * kShort + kFirst, &number, sizeof number);
    }
    std::size_t taken = 0;
    const auto count = [&taken](std::size_t i, const Known& each) {
        taken += each.numbers[0] == static_cast<double>(i) + 0.5 && each.numbers[1] == 0;
        return Status();
    };
    CHECK(takeEach(known(array), kCount, "known", count));
    CHECK(taken == kCount);
    const std::size_t other = 3 * kFirst;
    std::memcpy(array.get() + kShort, &other, kFirst);
    CHECK_FALSE(takeEach(known(array), 2, "known", count));
    CHECK_FALSE(takeEach(known(array), -1, "known", count));
    CHECK(takeEach<Known>(nullptr, 0, "known", count));
}
