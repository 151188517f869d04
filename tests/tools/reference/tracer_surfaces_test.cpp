// SPDX-License-Identifier: MIT
// What the ray tracer sees and counts as an occluder, sentence by sentence of
// tools/reference/tracer.h: sheets, sides, holes, and no surface by itself.
#include "tests/tools/reference/tracer_shot.h"

using namespace crevice;

TEST_CASE("a sheet of one triangle is open on both sides at any radius")
{
    MeshDesc triangle = makeQuad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    triangle.indices.resize(3);
    for (const Placement& placement : kPlacements) {
        for (const double height : {20.0, -20.0}) {
            const Shot shot = shotOf(sceneOf({triangle}), placement, {20, 0, 20}, 10, height);
            for (const double part : kRadii)
                CHECK(meanOf(trace(shot, {8, 8}, part * kSize * placement.scale, 64)) == 1.0);
        }
    }
}

TEST_CASE("a convex mesh does not occlude itself at any radius")
{
    for (const Placement& placement : kPlacements) {
        const Shot shot = shotOf(sceneOf({makeSphere(50, 64)}), placement, {0, 0, 0}, 30, 60);
        const Image open = trace(shot, {16, 16}, 1e-6 * kSize * placement.scale, 64);
        CHECK(meanOf(open) > 0.999);
        for (const double part : kRadii)
            CHECK(trace(shot, {16, 16}, part * kSize * placement.scale, 64).pixels == open.pixels);
    }
}

TEST_CASE("sheets in one plane do not occlude each other, whichever way they face")
{
    MeshDesc turned = kFloor;
    std::swap(turned.indices[1], turned.indices[2]);
    std::swap(turned.indices[4], turned.indices[5]);
    const MeshDesc shorter = makeQuad({-31, 0, 31}, {69, 0, 0}, {0, 0, -83});
    for (const Placement& placement : kPlacements) {
        for (const double height : {20.0, -20.0}) {
            const Shot shot =
                shotOf(sceneOf({kFloor, turned, shorter}), placement, {0, 0, 0}, 10, height);
            CHECK(meanOf(trace(shot, {8, 8}, 1e-4 * placement.scale, 64)) == 1.0);
            CHECK(meanOf(trace(shot, {8, 8}, 1e9 * placement.scale, 64)) == 1.0);
        }
    }
}

TEST_CASE("of two sheets each hides the other however thin the gap")
{
    // Rays at a cosine below gap / radius end in the gap: (gap / radius)^2 of them.
    for (const double gap : {1e-4, 1e-2, 1.0}) {
        Scene scene = sceneOf({kFloor, kFloor});
        scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, gap, 0});
        for (const Placement& placement : kPlacements) {
            const Shot shot = shotOf(scene, placement, {0, 0, 0}, 10, gap / 2);
            for (const double part : {0.5, 1.25, 2.0, 20.0}) {
                INFO(describe(placement, part * gap));
                const double expected = part < 1 ? 1 : 1 / (part * part);
                const Image image = trace(shot, {4, 4}, part * gap * placement.scale);
                CHECK(std::abs(meanOf(image) - expected) <= kMaxBias);
            }
        }
    }
}

TEST_CASE("of two sheets the upper one is seen from above however thin the gap")
{
    Scene scene = sceneOf({kFloor, kFloor});
    scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, 1e-7, 0});
    for (const Placement& placement : kPlacements) {
        const Shot shot = shotOf(scene, placement, {0, 0, 0}, 10, 20);
        CHECK(meanOf(trace(shot, {16, 16}, placement.scale, 64)) == 1.0);
    }
}

TEST_CASE("directions below the geometric surface count as occluded")
{
    // Of the cosine-weighted hemisphere about a normal, (1 + cos(angle)) / 2 is above a plane that
    // leans by `angle`.
    for (const double angle : {0.1, 0.5, 1.2}) {
        MeshDesc floor = kFloor;
        for (Vertex& vertex : floor.vertices) {
            vertex.normal[0] = static_cast<float>(std::sin(angle));
            vertex.normal[1] = static_cast<float>(std::cos(angle));
        }
        for (const double radius : {1e-4, 1.0, 1e9}) {
            const Image image =
                trace(shotOf(sceneOf({floor}), {}, {0, 0, 0}, 1, 20), {4, 4}, radius);
            CHECK(meanOf(image) == Approx((1 + std::cos(angle)) / 2).margin(kMaxBias));
        }
    }
}

TEST_CASE("a surface occludes from both sides")
{
    MeshDesc turned = kWall;
    std::swap(turned.indices[1], turned.indices[2]);
    std::swap(turned.indices[4], turned.indices[5]);
    for (Vertex& vertex : turned.vertices) vertex.normal[2] = -1;
    const auto lit = [](const MeshDesc& wall) {
        return trace(shotOf(sceneOf({kFloor, wall}), {}, {0, 0, 1}, 1, 20), {1, 8}, 2);
    };
    CHECK(lit(kWall).pixels == lit(turned).pixels);
    CHECK(meanOf(lit(turned)) < 0.9);
}

TEST_CASE("a surface seen from behind is shaded on that side")
{
    // A wall hangs below the floor, so it is the underside that has the corner.
    Scene scene = sceneOf({kFloor, kWall});
    scene.instances[1].world_from_model = glm::translate(glm::dmat4(1), {0, -50, 0});
    CHECK(meanOf(trace(shotOf(scene, {}, {0, 0, 1}, 1, 20), {1, 8}, 2)) == 1.0);
    const double below = meanOf(trace(shotOf(scene, {}, {0, 0, 1}, 1, -20), {1, 8}, 2));
    const Scene corner = sceneOf({kFloor, kWall});
    const double above = meanOf(trace(shotOf(corner, {}, {0, 0, 1}, 1, 20), {1, 8}, 2));
    CHECK(below == Approx(above).margin(kMaxBias));
}

TEST_CASE("a hole of an alpha-tested material is not seen, and what is left has both sides")
{
    // The left half of the sheet is a hole. Over a floor 1 below, rays of length 1.25.
    Scene scene = sceneOf({kFloor, makeQuad({-50, 1, 50}, {100, 0, 0}, {0, 0, -100})});
    scene.materials.emplace_back();
    scene.materials[1].alpha_cutoff = 0.5f;
    scene.materials[1].base_color_texture = 0;
    scene.instances[1].material = 1;
    scene.textures.push_back({"half", Image({2, 1}, 4, 1.0f)});
    scene.textures[0].image.at(0, 0, 3) = 0.0f;
    const auto at = [&](double x, double height) {
        return meanOf(trace(shotOf(scene, {}, {x, 1, 0}, 1, height), {4, 4}, 1.25));
    };
    CHECK(at(25, 20) == 1.0);                              // the sheet, above
    CHECK(at(-25, 20) == 1.0);                             // the floor, through the hole
    CHECK(at(25, -0.5) == Approx(0.64).margin(kMaxBias));  // the floor's side of the sheet
    scene.instances.erase(scene.instances.begin());
    const Shot alone = shotOf(scene, {}, {-25, 1, 0}, 1, 20);
    CHECK(std::isnan(trace(alone, {1, 1}, 1).at(0, 0)));
}
