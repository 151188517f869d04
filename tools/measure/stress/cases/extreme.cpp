// SPDX-License-Identifier: MIT
// Stress cases of extreme radii, sizes and counts, of broken meshes and of lights.
#include "tools/measure/stress/cases/all.h"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>

namespace crevice {
namespace {

StressShot sceneRadius(double radius, Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    shot.radius = radius;
    return shot;
}

StressShot cornerRadius(double radius, Extent size)
{
    StressView view = testView();
    view.eye = {0, 1, 4};
    StressShot shot = sceneShot(view, size, cornerScene());
    shot.radius = radius;
    shot.middle = view.eye.z;
    return shot;
}

StressShot sceneSamples(double samples, Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    shot.samples = static_cast<int>(samples);
    return shot;
}

// Identities, sizes, what is empty

StressShot noOp(double kind, Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    const bool no_radius = kind >= 2;
    if (no_radius)
        shot.radius = 0;
    else
        shot.settings = {"intensity=0"};
    shot.keep_no_ops = kind == 1 || kind == 3;
    return shot;
}

StressShot sceneShape(double kind, Extent) { return sceneShot(testView(), shapeOf(kind)); }

StressShot emptyShape(double kind, Extent)
{
    Scene nothing = testScene();
    nothing.instances.clear();
    nothing.meshes.clear();
    return sceneShot(testView(), shapeOf(kind), nothing);
}

// Meshes

/// A mesh of the test scene, the sphere, which stands free.
MeshDesc& ball(Scene& scene) { return scene.meshes.back(); }

void setNormals(MeshDesc& mesh, float value)
{
    for (Vertex& vertex : mesh.vertices)
        for (float& part : vertex.normal) part = value;
}

/// Every other triangle becomes a point or a line.
void flattenTriangles(MeshDesc& mesh)
{
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 6)
        mesh.indices[i + 1] = mesh.indices[i + (i % 4 == 0 ? 0 : 2)];
}

/// A normal map on everything.
void mapNormals(Scene& scene, float value)
{
    scene.textures.push_back({"normals", Image({4, 4}, 4, value)});
    for (SceneMaterial& material : scene.materials) material.normal_texture = 0;
}

void setCoordinates(Scene& scene, float value)
{
    for (MeshDesc& mesh : scene.meshes)
        for (Vertex& vertex : mesh.vertices)
            for (float& part : vertex.uv) part = value;
}

StressShot sceneMeshes(double kind, Extent size)
{
    Scene scene = testScene();
    glm::dmat4& placed_at = scene.instances.back().world_from_model;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto scaled = [](double x, double y, double z) {
        return glm::scale(glm::dmat4(1.0), {x, y, z});
    };
    switch (static_cast<int>(kind)) {
    case 1: setNormals(ball(scene), 0); break;
    case 2: setNormals(ball(scene), nan); break;
    case 3: flattenTriangles(ball(scene)); break;
    case 4: ball(scene).indices.clear(); break;
    case 5: placed_at = scaled(1, 0, 1); break;
    case 6: placed_at = scaled(0, 0, 0); break;
    case 7: placed_at = scaled(-1, 1, 1); break;
    case 8: placed_at = scaled(1e3, 1, 1e-3); break;
    case 9:
        mapNormals(scene, 0.5f);
        setCoordinates(scene, nan);
        break;
    case 10: mapNormals(scene, nan); break;
    default: break;
    }
    StressShot shot = sceneShot(testView(), size, std::move(scene));
    shot.radius = 1;
    shot.draws = true;
    return shot;
}

// Lights

/// Lights that lie on the surface itself, at the middles of pixels.
void putOnSurface(StressShot& shot, double distance)
{
    const SceneLight scene_light = shot.scene.lights.front();
    shot.scene.lights.clear();
    const glm::dmat4 view_from_clip = glm::inverse(glm::dmat4(shot.camera.clip_from_view));
    for (int i = 1; i <= 8; ++i) {
        const double x = (i * shot.extent.width / 9 + 0.5) / shot.extent.width * 2 - 1;
        const double y = (i * shot.extent.height / 9 + 0.5) / shot.extent.height * 2 - 1;
        const glm::dvec4 ray = view_from_clip * glm::dvec4(x, y, 1, 1);
        shot.scene.lights.push_back(scene_light);
        shot.scene.lights.back().light.position = glm::dvec3(ray) * (distance / -ray.z);
    }
}

StressShot planeLights(double value, Extent size)
{
    constexpr double kDistance = 4;
    StressShot shot = planeShot({}, size, kDistance, 0);
    const int kind = static_cast<int>(value);
    const bool all = kind == 8;
    SceneMaterial& material = shot.scene.materials[0];
    material.shininess = kind == 3 ? 0.0f : kind == 4 || all ? 1e6f : 16.0f;
    if (kind == 1 || all) putOnSurface(shot, kDistance);
    for (SceneLight& scene_light : shot.scene.lights) {
        if (kind == 2 || all) scene_light.light.attenuation = glm::vec3(0);
        if (kind == 5 || all) scene_light.light.color = glm::vec3(1e6f);
        if (kind == 6) scene_light.light.position = glm::dvec3(0);
        if (kind == 7) scene_light.light.direction = glm::vec3(0);
    }
    return shot;
}

/// Of ambient light alone, 0 without occlusion.
StressShot ambientAlone(double kind, Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    shot.output = "color";
    for (SceneLight& scene_light : shot.scene.lights) scene_light.light.color = glm::vec3(0);
    shot.settings = {"multi_bounce=false", "display=lit"};
    if (kind == 0) shot.settings.push_back("intensity=0");
    return shot;
}

/// A light behind a plane that faces the camera: 0 none, 1 a directional one, 2 a point.
StressShot lightBehind(double kind, Extent size)
{
    StressShot shot = planeShot({}, size, 4, 0);
    shot.output = "color";
    const int kept = static_cast<int>(kind);
    for (int i = 0; i < 2; ++i)
        if (i + kept != 2) shot.scene.lights[i].light.color = glm::vec3(0);
    shot.scene.lights[0].light.position = {0, 0, -5};
    shot.scene.lights[1].light.direction = {0, 0, 1};
    return shot;
}

/// From so far that most of the picture is background.
StressShot farAway(double, Extent size)
{
    StressView view = testView();
    view.eye.z = 12;
    StressShot shot = sceneShot(view, size);
    shot.radius = 1;
    shot.farthest = 0;  // other cases ask how strong it is
    return shot;
}

}  // namespace

std::vector<StressCase> extremeCases()
{
    using E = Expectation;
    const StressCondition with = "with {}", lit = "in the lit picture with {}";
    return {
        {"radius_to_zero",
         "The test scene under ever smaller radii.",
         "scene units",
         {{1e-9, "1e-9"},
          {1e-6, "1e-6"},
          {1e-4, "1e-4"},
          {1e-3, "1e-3"},
          {1e-2, "0.01"},
          {0.05, "0.05"},
          {0.1, "0.1"},
          {0.25, "0.25"},
          {0.5, "0.5"}},
         8,
         E::opens,
         sceneRadius,
         "",
         kSmallRadius},
        {"corner_radius", "An inner corner under larger radii.", "scene units",
         steps({0.001, 0.01, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 6.4, 25.6, 100, 1e4}), 6, E::darkens,
         cornerRadius, kTallRadius, kSmallRadius},
        {"samples", "The test scene by few and many depth taps a pixel.", "taps",
         steps({1, 2, 4, 16}), 3, E::sound, sceneSamples, kManyTaps, kFewTaps},
        {"no_op", "No intensity, no radius: planned away, and drawn all the same.", "",
         kinds({"intensity 0", "intensity 0, drawn", "radius 0", "radius 0, drawn"}), 0, E::one,
         noOp, with},
        {"sizes", "The test scene in pictures of other sizes.", "", shapes(), 0, E::sound,
         sceneShape, kPictureSize},
        {"empty", "Nothing but background, in pictures of other sizes.", "", shapes(), 0, E::one,
         emptyShape, kPictureSize},
        {"meshes", "Broken meshes and maps, and singular matrices.", "",
         kinds({"ordinary", "normals of no length", "normals of NaN", "triangles of no area",
                "no triangles", "flattened", "shrunk to a point", "mirrored", "stretched 1e6:1",
                "texture coordinates of NaN", "normal maps of NaN"}),
         0, E::sound, sceneMeshes, with},
        {"lights", "Lights on a plane, without attenuation, too bright; extreme highlights.", "",
         kinds({"ordinary", "on the surface", "no attenuation", "shininess 0", "shininess 1e6",
                "intensity 1e6", "at the camera", "no direction", "all of it"}),
         0, E::sound, planeLights, "under lights ({})"},
        {"ambient_alone", "Ambient light alone: the colour is that without occlusion, times it.",
         "", kinds({"no occlusion", "occlusion"}), 0, E::dims, ambientAlone, lit, "", kSameLight},
        {"light_behind", "A light behind a plane adds nothing to it and takes nothing away.", "",
         kinds({"no light", "a directional light", "a point"}), 0, E::same, lightBehind, lit},
        {"background", "The test scene from afar: what shows no surface is open.", "",
         kinds({"from afar"}), 0, E::sound, farAway, with},
    };
}

}  // namespace crevice
