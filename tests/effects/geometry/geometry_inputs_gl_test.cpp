// SPDX-License-Identifier: MIT
// What a surface is read from: stored, rebuilt from depth, or the host's own textures.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace crevice;

namespace {

const char* const kShowNormals = R"(#version 300 es
precision highp float;
#include <surface>
in vec2 uv;
layout(location = 0) out vec4 color;
void main()
{
    vec3 point;
    color = viewPosition(uv, point) ? vec4(normalAt(uv) * 0.5 + 0.5, 1.0) : vec4(0.0);
}
)";

const char* const kShow = R"({
    "format": 1,
    "targets": {"color": {"format": ["rgba16f", "rgba8"]}},
    "shaders": {"show": {"vertex": "common/fullscreen.vert", "fragment": "mine/show.frag"}},
    "passes": {"show": {"type": "fullscreen", "shader": "show", "color": ["color"]}},
    "outputs": {"color": "color"}})";

/// Normals in view space as a geometry module finds them; alpha 0 in the background.
Image normals(SceneRig& rig, const std::string& geometry, const std::string& camera = "")
{
    const GivenConfig config({"geometry/" + geometry, "mine/show"}, "",
                             {{"mine/show.frag", kShowNormals}, {"mine/show.json", kShow}});
    return rig.draw(config.description(), rig.frame(camera), "color");
}

glm::vec3 normalOf(const Image& image, int x, int y)
{
    return glm::vec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) * 2.0f - 1.0f;
}

/// A wall of one unit square at z = 0 that fills most of the picture of kFront.
Scene wall()
{
    Scene scene;
    MeshDesc mesh;
    mesh.label = "wall";
    const glm::vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const glm::vec2& at : corners)
        mesh.vertices.push_back({{at.x - 0.5f, at.y - 0.5f, 0}, {0, 0, 1}, {at.x, at.y}});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes = {mesh};
    scene.instances.resize(1);
    scene.materials.resize(1);
    return scene;
}

const char* const kFront = "eye=0,0,2;at=0,0,0;fov=25";

SceneTexture oneColor(const glm::vec4& color)
{
    SceneTexture texture{"color", Image({2, 2}, 4)};
    for (int i = 0; i < 16; ++i) texture.image.pixels[i] = color[i % 4];
    return texture;
}

Image target(const std::string& name, const Scene& scene, const std::string& camera = kFront,
             const std::string& config = "hemisphere_box")
{
    PictureRequest request;
    request.config = config;
    request.camera = camera;
    request.output = "color";
    request.target = name;
    return picture(request, scene);
}

/// The share of the seen surface whose normals are less than that many degrees apart.
double shareWithin(const Image& a, const Image& b, double degrees)
{
    int seen = 0, near = 0;
    for (int y = 0; y < a.extent.height; ++y)
        for (int x = 0; x < a.extent.width; ++x) {
            REQUIRE(a.at(x, y, 3) == b.at(x, y, 3));
            if (a.at(x, y, 3) == 0.0f) continue;
            const glm::vec3 u = normalOf(a, x, y), v = normalOf(b, x, y);
            CHECK(glm::length(u) == Approx(1.0).margin(0.01));
            ++seen;
            const float cosine = glm::dot(u, v) / (glm::length(u) * glm::length(v));
            near += cosine > std::cos(degrees * 0.0174533) ? 1 : 0;
        }
    REQUIRE(seen > 0);
    return double(near) / seen;
}

/// A view space turned by 90 degrees about z, and left-handed: what x, y and z of the upright one
/// are.
const glm::dmat3 kTurn = {0, 1, 0, -1, 0, 0, 0, 0, -1};

/// The occlusion, and the surface as a host has it whose view space is turned.
const char* const kTurned = R"(,
    "targets": {
        "host_position": {"format": "rgba32f"},
        "host_distance": {"format": "r32f"},
        "host_normal": {"format": "rgba16f"}
    },
    "shaders": {"turn": {"vertex": "common/fullscreen.vert", "fragment": "configs/turn.frag"}},
    "passes": {"turn": {"type": "fullscreen", "shader": "turn",
                        "color": ["host_position", "host_distance", "host_normal"]}},
    "outputs": {"depth": "depth", "position": "host_position", "linear_depth": "host_distance",
                "normal": "host_normal"})";
const char* const kTurnedShader = R"(#version 300 es
precision highp float;
#include <surface>
in vec2 uv;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 distance_ahead;
layout(location = 2) out vec4 stored_normal;
vec3 turned(vec3 v) { return vec3(-v.y, v.x, -v.z); }
void main()
{
    vec3 point;
    bool seen = viewPosition(uv, point);
    position = vec4(turned(point), float(seen));
    distance_ahead = vec4(seen ? -point.z : 0.0);
    stored_normal = vec4(turned(normalAt(uv)) * 0.5 + 0.5, 1.0);
}
)";

using Names = std::vector<std::string>;

/// A frame of what a host drew itself, outputs of a renderer.
Frame hostFrame(const Camera& camera, const Renderer& host, const Names& textures)
{
    Frame bare;
    bare.camera = camera;
    for (const std::string& name : textures) bare.textures.push_back({name, host.output(name)});
    return bare;
}

}  // namespace

TEST_CASE("Normals rebuilt from depth are those of the mesh on flat surfaces, edges included")
{
    SceneRig rig("corner");
    for (const char* camera : {"", "eye=3,2,4;at=0,0,0;ortho=4", "eye=0,1.5,4;at=0,0,0;fov=100"}) {
        INFO(camera);
        const Image stored = normals(rig, "depth_normal", camera);
        CHECK(shareWithin(normals(rig, "depth_only", camera), stored, 2) > 0.97);
    }
}

TEST_CASE("Normals rebuilt from depth follow round surfaces, of unit length in any size")
{
    SceneRig spheres("spheres", {256, 144});
    const Image stored = normals(spheres, "depth_normal");
    CHECK(shareWithin(normals(spheres, "depth_only"), stored, 10) > 0.9);
    SceneRig rig("plane");
    for (const Extent extent : {Extent{1, 1}, Extent{2, 1}, Extent{1, 37}, Extent{3, 2}}) {
        rig.extent = extent;
        shareWithin(normals(rig, "depth_only"), normals(rig, "depth_normal"), 90);
    }
}

TEST_CASE("The host's own depth and normals give the occlusion that ours give")
{
    SceneRig rig("spheres");
    const Names rest = {"ssao/hemisphere", "filter/bilateral_normal"};
    const GivenConfig drawn({"geometry/depth_normal", rest[0], rest[1]},
                            R"(, "outputs": {"depth": "depth", "normal": "normal"})");
    const auto host = rig.renderer(drawn.description(), rig.frame());
    need(host->render(rig.frame()));
    const Image ours = rig.read(host->output("ao"));
    const auto hosted = [&](const char* geometry, const Names& textures) {
        return rig.draw(GivenConfig({geometry, rest[0], rest[1]}).description(),
                        hostFrame(rig.frame().camera, *host, textures));
    };
    CHECK(mean(ours) < 0.99);
    CHECK(meanChange(hosted("geometry/host_depth_normal", {"depth", "normal"}), ours) == 0.0);
    CHECK(meanChange(hosted("geometry/host_depth", {"depth"}), ours) < 0.02);
}

TEST_CASE("Distances of a host count as surfaces above 0 and below the far, and nowhere else")
{
    // A sphere kernel shades all surfaces, and no background.
    const Description description =
        GivenConfig({"geometry/host_linear_depth", "ssao/sphere", "filter/none"},
                    R"(, "params": {"linear_far": 10})")
            .description();
    SceneRig rig("spheres");
    Frame bare;
    bare.camera = rig.frame().camera;
    const auto occlusionAt = [&](float distance) {
        const TextureId image = rig.texture(Format::r32f, rig.extent);
        need(rig.device->writeTexture(image, Image(rig.extent, 1, distance)));
        bare.textures = {{"linear_depth", image}};
        return 1 - mean(rig.draw(description, bare));
    };
    for (const float distance : {5.0f, 9.9f}) CHECK(occlusionAt(distance) > 0.1);
    for (const float distance : {-5.0f, 0.0f, 10.0f, 11.0f}) CHECK(occlusionAt(distance) == 0);
}

TEST_CASE("A turned view space changes no picture but for noise, nor does what a host stored in it")
{
    SceneRig rig("spheres", {96, 54});
    const Frame upright = rig.frame();
    Frame turned = upright;
    const glm::dmat4 turn(kTurn);
    turned.camera.view_from_world = turn * upright.camera.view_from_world;
    turned.camera.clip_from_view =
        glm::mat4(glm::dmat4(upright.camera.clip_from_view) * glm::transpose(turn));
    const GivenConfig drawn(
        {"geometry/depth_normal", "ssao/gtao", "filter/bilateral_normal", "lighting/blinn_phong"},
        kTurned, {{"configs/turn.frag", kTurnedShader}});
    const auto host = rig.renderer(drawn.description(), upright);
    const auto own = rig.renderer(drawn.description(), turned);
    need(host->render(upright));
    need(own->render(turned));
    const auto of = [&](const Renderer& renderer, const char* output) {
        return rig.read(renderer.output(output));
    };
    const Image ao = of(*host, "ao"), own_ao = of(*own, "ao");
    CHECK(mean(ao) < 0.99);
    CHECK(meanChange(of(*own, "depth"), of(*host, "depth")) == 0.0);
    CHECK(meanChange(own_ao, ao) < 0.02);  // the noise turns with the space
    CHECK(meanChange(of(*own, "color"), of(*host, "color")) < 0.02);

    const std::pair<std::string, Names> inputs[] = {
        {"host_depth", {"depth"}},
        {"host_depth_normal", {"depth", "normal"}},
        {"host_linear_depth_normal", {"linear_depth", "normal"}},
        {"host_position_normal", {"position", "normal"}}};
    for (const auto& input : inputs) {
        INFO(input.first);
        const GivenConfig config(
            {"geometry/" + input.first, "ssao/gtao", "filter/bilateral_normal"});
        const auto occlusion = [&](const Frame& seen_by) {
            return rig.draw(config.description(), hostFrame(seen_by.camera, *host, input.second));
        };
        const bool in_view_space = input.first != "host_depth";
        // Noise is in the picture; how far stored positions are off is known in four steps.
        CHECK(meanChange(occlusion(turned), own_ao) < (in_view_space ? 4e-3 : 0.02));
        CHECK((meanChange(occlusion(upright), ao) > 0.02) == in_view_space);
    }
}

TEST_CASE("A normal map tilts the normal towards growing u and v, from whichever side and scale")
{
    Scene scene = wall();
    const glm::vec3 tilted = glm::normalize(glm::vec3(0.6f, 0.3f, 0.7f));
    scene.textures = {oneColor(glm::vec4(tilted * 0.5f + 0.5f, 1.0f))};
    scene.materials[0].normal_texture = 0;
    const auto middle = [&](const char* camera) {
        return glm::normalize(normalOf(target("normal", scene, camera), 64, 36));
    };
    CHECK(glm::distance(middle(kFront), tilted) < 0.02f);
    const glm::vec3 mirrored = tilted * glm::vec3(-1, 1, 1);
    CHECK(glm::distance(middle("eye=0,0,-2;at=0,0,0;fov=25"), mirrored) < 0.02f);
    scene.instances[0].world_from_model = glm::mat4(glm::mat3(1e-6f));
    CHECK(glm::distance(middle("eye=0,0,2e-6;at=0,0,0;fov=25"), tilted) < 0.02f);
    scene.instances[0].world_from_model = glm::mat4(1.0f);

    scene.materials[0].normal_scale = 0.5f;
    const glm::vec3 flatter = glm::normalize(tilted * glm::vec3(0.5f, 0.5f, 1.0f));
    CHECK(glm::distance(middle(kFront), flatter) < 0.02f);
    scene.materials[0].normal_scale = 0.0f;
    CHECK(glm::distance(middle(kFront), glm::vec3(0, 0, 1)) < 0.02f);
    scene.materials.push_back({});
    scene.materials[0].normal_scale = 1.0f;
    scene.instances[0].material = 1;
    scene.instances.push_back(scene.instances[0]);
    scene.instances[1].material = 0;
    scene.instances[1].world_from_model[3] = glm::vec4(9, 9, 9, 1);
    CHECK(glm::distance(middle(kFront), glm::vec3(0, 0, 1)) < 0.02f);
}

TEST_CASE("What the alpha test cuts away is background to all that follows")
{
    Scene scene = wall();
    SceneTexture holes{"holes", Image({2, 1}, 4, 1.0f)};
    holes.image.at(0, 0, 3) = 0.0f;
    scene.textures = {holes};
    scene.materials[0].base_color_texture = 0;
    scene.materials[0].alpha_cutoff = 0.5f;
    const Image normal = target("normal", scene);
    CHECK(normal.at(50, 36, 3) == 0.0f);
    CHECK(normal.at(78, 36, 3) == 1.0f);
    CHECK(target("ao_filtered", scene).at(50, 36) == 1.0f);
}

TEST_CASE("A wall is seen and lit from either side")
{
    const Scene scene = wall();
    for (const char* camera : {kFront, "eye=0,0,-2;at=0,0,0;fov=25"})
        CHECK(glm::distance(normalOf(target("normal", scene, camera), 64, 36), {0, 0, 1}) < 0.02f);
}

TEST_CASE(
    "A floor is seen from above up to its horizon, where the next pixel's place is behind the "
    "camera")
{
    Scene floor = wall();
    for (Vertex& vertex : floor.meshes[0].vertices)
        vertex = {{1000 * vertex.position[0], 0, -1000 * vertex.position[1]}, {0, 1, 0}, {0, 0}};
    for (const char* eye : {"0,1,0", "0,0.5,0", "0,0.1,0"})
        for (const char* at : {"0,0.1,-100", "30,0.1,-100"}) {
            INFO(eye << ' ' << at);
            const Image normals =
                target("normal", floor, "eye=" + std::string(eye) + ";at=" + at + ";fov=45");
            for (int y = 0; y < normals.extent.height; ++y)
                for (int x = 0; x < normals.extent.width; ++x)
                    if (normals.at(x, y, 3) > 0.5f) CHECK(normals.at(x, y, 1) > 0.9f);
        }
}

TEST_CASE("Baked occlusion joins that of the screen by the lesser of both")
{
    Scene scene = wall();
    scene.textures = {oneColor({0.4f, 1, 1, 1})};
    CHECK(target("ao_filtered", scene, kFront, "baked").at(64, 36) > 0.98f);
    scene.materials[0].occlusion_texture = 0;
    CHECK(target("ao_joined", scene, kFront, "baked").at(64, 36) == Approx(0.4).margin(0.01));
    scene.materials[0].occlusion_strength = 0.5f;
    CHECK(target("ao_joined", scene, kFront, "baked").at(64, 36) == Approx(0.7).margin(0.01));
    CHECK(target("ao_joined", scene, kFront, "baked").at(1, 1) == 1.0f);
}
