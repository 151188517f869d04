// SPDX-License-Identifier: MIT
// The maps of materials: normals, what an alpha test cuts away, and baked occlusion.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <glm/geometric.hpp>

using namespace crevice;

namespace {

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
    SceneRig rig(scene);
    return rig.draw(showing(descriptionOf({config}), name), rig.frame(camera), "shown");
}

glm::vec3 normalInTheMiddle(const Scene& scene, const char* camera = kFront)
{
    const Image image = target("normal", scene, camera);
    const glm::vec3 stored(image.at(64, 36, 0), image.at(64, 36, 1), image.at(64, 36, 2));
    return glm::normalize(stored * 2.0f - 1.0f);
}

}  // namespace

TEST_CASE("A normal map tilts the normal towards growing u and v, from whichever side and scale")
{
    Scene scene = wall();
    const glm::vec3 tilted = glm::normalize(glm::vec3(0.6f, 0.3f, 0.7f));
    scene.textures = {oneColor(glm::vec4(tilted * 0.5f + 0.5f, 1.0f))};
    scene.materials[0].normal_texture = 0;
    const auto points = [&](const char* camera, const glm::vec3& wanted) {
        return glm::distance(normalInTheMiddle(scene, camera), glm::normalize(wanted)) < 0.02f;
    };
    CHECK(points(kFront, tilted));
    CHECK(points("eye=0,0,-2;at=0,0,0;fov=25", tilted * glm::vec3(-1, 1, 1)));
    scene.instances[0].world_from_model = glm::mat4(glm::mat3(1e-6f));
    CHECK(points("eye=0,0,2e-6;at=0,0,0;fov=25", tilted));
    scene.instances[0].world_from_model = glm::mat4(1.0f);
    scene.materials[0].normal_scale = 0.5f;
    CHECK(points(kFront, tilted * glm::vec3(0.5f, 0.5f, 1.0f)));

    // One without a map, beside another that has one.
    scene.materials.push_back({});
    scene.instances.push_back(scene.instances[0]);
    scene.instances[0].material = 1;
    scene.instances[1].world_from_model[3] = glm::vec4(9, 9, 9, 1);
    CHECK(points(kFront, {0, 0, 1}));
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
