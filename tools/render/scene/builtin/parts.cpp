// SPDX-License-Identifier: MIT
#include "tools/render/scene/builtin/parts.h"

#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice {

int addMaterial(Scene& scene, const char* name, const glm::vec3& color, float specular,
                float shininess)
{
    SceneMaterial material;
    material.name = name;
    material.base_color = glm::vec4(color, 1.0f);
    material.specular = glm::vec3(specular);
    material.shininess = shininess;
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
}

void addObject(Scene& scene, const char* name, MeshDesc mesh, int material,
               const glm::mat4& world_from_model)
{
    mesh.label = name;
    scene.meshes.push_back(std::move(mesh));
    const int index = static_cast<int>(scene.meshes.size()) - 1;
    scene.instances.push_back({index, world_from_model, material});
}

glm::mat4 standing(float x, float z, float turn_degrees)
{
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), {x, -kSunk, z});
    return glm::rotate(moved, glm::radians(turn_degrees), {0, 1, 0});
}

MeshDesc makeBlock(float width, float height, float depth)
{
    return makeBox({-width / 2, 0, -depth / 2}, {width / 2, height, depth / 2});
}

void addCamera(Scene& scene, const char* name, const glm::vec3& eye, const glm::vec3& at)
{
    SceneCamera camera;
    camera.name = name;
    camera.view_from_world = glm::lookAt(eye, at, glm::vec3(0, 1, 0));
    scene.cameras.push_back(camera);
}

void addLights(Scene& scene, const glm::vec3& light)
{
    SceneLight point;
    point.name = "light";
    point.light.position = light;
    point.light.color = {0.5f, 0.47f, 0.41f};
    point.light.attenuation = {1.0f, 0.09f, 0.032f};
    SceneLight sky;
    sky.name = "sky";
    sky.light.directional = true;
    sky.light.direction = glm::normalize(glm::vec3(-0.35f, -0.9f, -0.4f));
    sky.light.color = {0.08f, 0.09f, 0.11f};
    scene.ambient_light = {1.3f, 1.3f, 1.35f};  // much of a room's light has no direction
    scene.lights = {point, sky};
}

}  // namespace crevice
