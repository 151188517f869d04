// SPDX-License-Identifier: MIT
#include "scene.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace example {

namespace {

constexpr int kBallSteps = 24;  // along each edge of the six faces that are bent into a ball

std::uint32_t addVertex(MeshDesc& mesh, const glm::vec3& p, const glm::vec3& normal)
{
    mesh.vertices.push_back({{p.x, p.y, p.z}, {normal.x, normal.y, normal.z}, {}});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// The face of the cube between -1 and 1 whose normal is `n`.
void addFace(MeshDesc& mesh, const glm::vec3& n, const glm::vec3& u, int steps, bool round)
{
    const glm::vec3 v = glm::cross(n, u);
    for (int row = 0; row <= steps; ++row) {
        for (int column = 0; column <= steps; ++column) {
            const glm::vec2 at = glm::vec2(column, row) * (2.0f / steps) - 1.0f;
            const glm::vec3 p = n + u * at.x + v * at.y;
            const std::uint32_t here = round ? addVertex(mesh, glm::normalize(p), glm::normalize(p))
                                             : addVertex(mesh, p, n);
            if (row == 0 || column == 0) continue;
            const std::uint32_t below = here - steps - 1;
            mesh.indices.insert(mesh.indices.end(),
                                {below - 1, below, here, below - 1, here, here - 1});
        }
    }
}

/// A cube between -1 and 1, or the ball in it.
Result<MeshId> makeMesh(Device& device, bool round)
{
    MeshDesc mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), u(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = 1.0f;
            addFace(mesh, normal, u, round ? kBallSteps : 1, round);
        }
    }
    return device.createMesh(mesh);
}

void addMaterial(Frame& frame, const glm::vec3& color)
{
    frame.materials.emplace_back();
    frame.materials.back().base_color = glm::vec4(color, 1.0f);
}

/// Draws `mesh` scaled by `half` and moved to `center`.
void addBody(Frame& frame, const Device& device, MeshId mesh, const glm::dvec3& center,
             const glm::dvec3& half, int material)
{
    DrawItem item;
    item.mesh = mesh;
    item.count = device.info(mesh).index_count;
    item.world_from_model = glm::scale(glm::translate(glm::dmat4(1.0), center), half);
    item.material = material;
    item.bounds_radius = glm::root_three<float>();
    frame.draws.push_back(item);
}

}  // namespace

Status addScene(Device& device, Frame& frame)
{
    const Result<MeshId> cube = makeMesh(device, false);
    if (!cube) return cube.diagnostics();
    const Result<MeshId> ball = makeMesh(device, true);
    if (!ball) return ball.diagnostics();
    for (const glm::vec3& color : {glm::vec3(0.8f, 0.78f, 0.74f), glm::vec3(0.68f, 0.5f, 0.3f),
                                   glm::vec3(0.35f, 0.5f, 0.7f)})
        addMaterial(frame, color);
    addBody(frame, device, *cube, {2.5, -0.1, 2.5}, {2.7, 0.1, 2.7}, 0);  // floor
    addBody(frame, device, *cube, {-0.1, 1.5, 2.5}, {0.1, 1.5, 2.5}, 0);  // left wall
    addBody(frame, device, *cube, {2.5, 1.5, -0.1}, {2.5, 1.5, 0.1}, 0);  // right wall
    for (const double step : {1.0, 2.0, 3.0, 4.0})
        addBody(frame, device, *cube, {1.4, 0.2 * step - 0.1, 0.5 - 0.1 * step},
                {0.4, 0.1, 0.5 - 0.1 * step}, 1);
    addBody(frame, device, *cube, {0.3, 0.35, 1.3}, {0.2, 0.35, 0.25}, 2);
    addBody(frame, device, *ball, {1.0, 0.3, 1.3}, glm::dvec3(0.3), 2);
    frame.lights.emplace_back();
    frame.lights.back().position = {1.8, 2.2, 1.6};
    frame.lights.back().color = glm::vec3(0.6f);
    return {};
}

Camera cameraAt(float turn_rad, Extent extent)
{
    const double angle = glm::quarter_pi<double>() + turn_rad;
    const glm::dvec3 at(0.7, 0.5, 0.7);
    const glm::dvec3 eye = at + glm::dvec3(3.2 * glm::sin(angle), 1.6, 3.2 * glm::cos(angle));
    const float aspect = float(extent.width) / float(extent.height);
    Camera camera;
    camera.view_from_world = glm::lookAt(eye, at, glm::dvec3(0, 1, 0));
    camera.clip_from_view = glm::perspective(glm::radians(45.0f), aspect, 0.5f, 10.0f);
    return camera;
}

}  // namespace example
