// SPDX-License-Identifier: MIT
// A street of boxes and leaves, from x = -4, the houses, to x = 6, the hedge.
#include "tools/render/scene/builtin/parts.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <random>

namespace crevice {

namespace {

constexpr float kNear = 5.0f;  // z of the street's ends
constexpr float kFar = -12.0f;
constexpr float kKerb = -1.4f;      // x
constexpr float kPavement = 0.15f;  // height
constexpr float kHouses = -4.0f;    // x of their front

struct Paint {
    int asphalt, concrete, steel, plaster, wood, red, blue, bark, leaf;
};

Paint addPaint(Scene& scene)
{
    return {addMaterial(scene, "asphalt", {0.32f, 0.32f, 0.34f}),
            addMaterial(scene, "concrete", {0.62f, 0.61f, 0.58f}),
            addMaterial(scene, "steel", {0.5f, 0.52f, 0.55f}, 0.4f, 48.0f),
            addMaterial(scene, "plaster", {0.8f, 0.72f, 0.6f}),
            addMaterial(scene, "wood", {0.5f, 0.38f, 0.26f}),
            addMaterial(scene, "red", {0.62f, 0.2f, 0.17f}, 0.4f, 64.0f),
            addMaterial(scene, "blue", {0.22f, 0.36f, 0.58f}, 0.4f, 64.0f),
            addMaterial(scene, "bark", {0.36f, 0.28f, 0.2f}),
            addMaterial(scene, "leaf", {0.34f, 0.5f, 0.2f})};
}

void addGround(Scene& scene, const Paint& paint)
{
    addObject(scene, "road", makeBox({kHouses - 1, -0.3f, kFar}, {6.5f, 0, kNear}), paint.asphalt);
    addObject(scene, "pavement",
              makeBox({kHouses, -0.1f, kFar + 0.01f}, {kKerb, kPavement, kNear - 0.01f}),
              paint.concrete);
}

/// A front with sills and a porch roof, thin plates that stand out from it.
void addHouse(Scene& scene, const Paint& paint)
{
    addObject(scene, "house",
              makeBox({kHouses - 0.9f, -0.05f, kFar + 0.02f}, {kHouses, 5.5f, 2.0f}),
              paint.plaster);
    MeshDesc sills, shutters;
    for (int floor = 0; floor < 2; ++floor)
        for (int window = 0; window < 4; ++window) {
            const float z = 0.6f - 3.0f * window, y = 1.1f + 2.6f * floor;
            append(sills,
                   makeBox({kHouses - 0.1f, y, z - 0.6f}, {kHouses + 0.22f, y + 0.05f, z + 0.6f}));
            append(shutters, makeBox({kHouses + 0.05f, y + 0.15f, z + 0.42f},
                                     {kHouses + 0.09f, y + 1.35f, z + 0.9f}));
        }
    addObject(scene, "sills", std::move(sills), paint.concrete);
    addObject(scene, "shutters", std::move(shutters), paint.blue);
    addObject(scene, "porch",
              makeBox({kHouses - 0.1f, 2.45f, -2.4f}, {kHouses + 1.1f, 2.5f, -0.6f}), paint.wood);
}

/// Tram rails on sleepers that lie on the road.
void addRails(Scene& scene, const Paint& paint)
{
    MeshDesc sleepers, rails;
    for (int i = 0; i < 24; ++i) {
        const float z = kNear - 0.6f - 0.68f * static_cast<float>(i);
        append(sleepers, makeBox({-0.35f, -0.02f, z}, {1.65f, 0.06f, z + 0.24f}));
    }
    for (const float x : {0.0f, 1.25f}) {
        append(rails, makeBox({x, 0.05f, kFar + 0.05f}, {x + 0.03f, 0.16f, kNear - 0.05f}));
        append(rails, makeBox({x - 0.02f, 0.15f, kFar + 0.05f}, {x + 0.05f, 0.19f, kNear - 0.05f}));
    }
    addObject(scene, "sleepers", std::move(sleepers), paint.wood);
    addObject(scene, "rails", std::move(rails), paint.steel);
}

/// Posts, two bars and balusters from `z` on towards -z, on the ground at `y`.
MeshDesc makeRailing(float x, float y, float z, float length)
{
    MeshDesc mesh;
    for (const float height : {0.12f, 0.98f})
        append(mesh, makeBox({x, y + height, z - length}, {x + 0.04f, y + height + 0.04f, z}));
    const int count = static_cast<int>(length / 0.13f);
    for (int i = 0; i <= count; ++i) {
        const float at = z - length * static_cast<float>(i) / static_cast<float>(count);
        const float half = i % 10 == 0 ? 0.03f : 0.008f;
        const float foot = i % 10 == 0 ? -0.02f : 0.13f;
        append(mesh, makeBox({x + 0.02f - half, y + foot, at - half},
                             {x + 0.02f + half, y + 1.0f, at + half}));
    }
    return mesh;
}

void addRailings(Scene& scene, const Paint& paint)
{
    addObject(scene, "railing", makeRailing(kKerb - 0.2f, kPavement, 3.2f, 5.2f), paint.steel);
    addObject(scene, "far railing", makeRailing(2.3f, 0, 1.0f, 6.5f), paint.steel);
    addObject(
        scene, "stairs", makeStairs(5, 1.3f, 0.17f, 0.28f), paint.concrete,
        glm::rotate(glm::translate(glm::mat4(1.0f), {kHouses + 1.38f, kPavement - kSunk, -1.5f}),
                    glm::radians(90.0f), {0, 1, 0}));
}

void addPoles(Scene& scene, const Paint& paint)
{
    MeshDesc poles, signs;
    for (int i = 0; i < 4; ++i) {
        const float z = 2.2f - 3.4f * static_cast<float>(i);
        append(poles, makeBox({-1.75f, kPavement - 0.05f, z}, {-1.66f, 4.2f, z + 0.09f}));
        append(poles, makeBox({-1.74f, 4.05f, z + 0.01f}, {-0.4f, 4.13f, z + 0.08f}));
        append(signs, makeBox({-2.05f, 1.75f, z + 0.1f}, {-1.36f, 2.25f, z + 0.115f}));
    }
    addObject(scene, "poles", std::move(poles), paint.steel);
    addObject(scene, "signs", std::move(signs), paint.red);
}

/// Plates on battens, each with a gap below it that no camera sees through.
void addSlabs(Scene& scene, const Paint& paint)
{
    MeshDesc slabs, battens;
    for (int i = 0; i < 6; ++i) {
        const float y = kPavement - kSunk + 0.13f * static_cast<float>(i),
                    shift = 0.05f * static_cast<float>(i % 3);
        for (const float z : {0.55f, 1.45f})
            append(battens, makeBox({-3.0f, y, z}, {-2.25f, y + 0.075f, z + 0.07f}));
        append(slabs, makeBox({-3.1f + shift, y + 0.07f, 0.4f - shift},
                              {-2.2f + shift, y + 0.12f, 1.7f - shift}));
    }
    addObject(scene, "slabs", std::move(slabs), paint.concrete);
    addObject(scene, "battens", std::move(battens), paint.wood);
}

/// A body and a cabin above the road on four wheels.
void addCar(Scene& scene, const char* name, float x, float z, float turn, int paint, int tyre)
{
    MeshDesc body = makeBox({-0.85f, 0.24f, -2.0f}, {0.85f, 0.85f, 2.0f});
    append(body, makeBox({-0.75f, 0.84f, -1.5f}, {0.75f, 1.4f, 0.9f}));
    MeshDesc wheels;
    for (const float across : {-0.84f, 0.64f})
        for (const float along : {-1.4f, 1.0f})
            append(wheels, makeBox({across, 0, along}, {across + 0.2f, 0.5f, along + 0.5f}));
    addObject(scene, name, std::move(body), paint, standing(x, z, turn));
    addObject(scene, "wheels", std::move(wheels), tyre, standing(x, z, turn));
}

/// The same numbers on every platform, in [-1, 1).
class Random {
public:
    float next() { return static_cast<float>(engine_() % 65536u) / 32768.0f - 1.0f; }

    glm::vec3 inBall()
    {
        for (;;) {
            const glm::vec3 point = {next(), next(), next()};
            const float square = glm::dot(point, point);
            if (square <= 1.0f && square > 0.01f) return point;
        }
    }

private:
    std::minstd_rand engine_ = std::minstd_rand(7);
};

/// Open rectangles in an ellipsoid or a box, each turned at random.
MeshDesc makeLeaves(Random& random, int count, const glm::vec3& half, bool box)
{
    constexpr float kLong = 0.17f, kWide = 0.1f;
    MeshDesc mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 ball = random.inBall();
        const glm::vec3 at =
            half * (box ? glm::vec3(random.next(), random.next(), random.next()) : ball);
        const glm::vec3 right = glm::normalize(random.inBall());
        const glm::vec3 aside = glm::abs(right.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const glm::vec3 up = glm::normalize(glm::cross(right, aside));
        append(mesh, makeQuad(at - 0.5f * (right * kLong + up * kWide), right * kLong, up * kWide));
    }
    return mesh;
}

void addTrees(Scene& scene, const Paint& paint)
{
    Random random;
    for (int i = 0; i < 3; ++i) {
        const float x = 3.1f, z = 0.6f - 3.6f * static_cast<float>(i);
        addObject(scene, "trunk", makeBlock(0.2f, 2.2f, 0.2f), paint.bark,
                  standing(x, z, 20.0f * static_cast<float>(i)));
        addObject(scene, "crown", makeLeaves(random, 1400, {1.15f, 1.0f, 1.15f}, false), paint.leaf,
                  glm::translate(glm::mat4(1.0f), {x, 2.5f, z}));
    }
    addObject(scene, "hedge", makeLeaves(random, 4200, {0.45f, 0.55f, 5.5f}, true), paint.leaf,
              glm::translate(glm::mat4(1.0f), {4.6f, 0.6f, -3.5f}));
}

}  // namespace

Scene makeStreetScene()
{
    Scene scene;
    const Paint paint = addPaint(scene);
    addGround(scene, paint);
    addHouse(scene, paint);
    addRails(scene, paint);
    addRailings(scene, paint);
    addPoles(scene, paint);
    addSlabs(scene, paint);
    addCar(scene, "red car", -0.35f, -6.2f, 3, paint.red, paint.asphalt);
    addCar(scene, "blue car", 3.4f, -2.6f, -4, paint.blue, paint.asphalt);
    addTrees(scene, paint);
    addCamera(scene, "main", {0.9f, 1.75f, 4.6f}, {-0.15f, 0.95f, -1.5f});
    addCamera(scene, "close", {-0.6f, 0.9f, 2.9f}, {-1.6f, 0.45f, 0.9f});
    addCamera(scene, "above", {1.6f, 4.2f, 4.8f}, {0.4f, 0.3f, -2.0f});
    addLights(scene, {0.5f, 3.4f, 1.0f});
    return scene;
}

}  // namespace crevice
