// SPDX-License-Identifier: MIT
// References on disk: their keys, and what happens to broken files.
#include "tools/reference/reference_cache.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tools/image/image_file.h"
#include "tools/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstring>

using namespace crevice;

namespace {

Scene sphereOnFloor()
{
    Scene scene;
    scene.meshes = {makeQuad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}), makeSphere(1, 12)};
    scene.materials.emplace_back();
    scene.instances = {{0}, {1}};
    return scene;
}

const Camera kCamera = {glm::lookAt(glm::vec3(0, 2, 8), glm::vec3(0), glm::vec3(0, 1, 0)),
                        glm::perspective(0.9f, 1.0f, 0.1f, 50.0f)};
const Extent kExtent = {16, 16};

TraceOptions options(double radius = 1, int rays = 8)
{
    TraceOptions made;
    made.radius = radius;
    made.rays = rays;
    return made;
}

std::string key(const Scene& scene) { return referenceKey(scene, kCamera, kExtent, options()); }

Image need(const Result<Image>& image)
{
    INFO(toText(image.diagnostics()));
    REQUIRE(image.ok());
    return *image;
}

bool sameBits(const Image& a, const Image& b)
{
    return a.extent == b.extent && a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

std::filesystem::path onlyFile(const std::filesystem::path& folder)
{
    std::filesystem::path found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        REQUIRE(found.empty());
        found = entry.path();
    }
    REQUIRE(!found.empty());
    return found;
}

}  // namespace

TEST_CASE("A reference's key changes with all that decides its pixels and with nothing else")
{
    const Scene scene = sphereOnFloor();
    const std::string first = key(scene);
    CHECK(first.size() == 16);
    CHECK(key(sphereOnFloor()) == first);

    Scene other = scene;
    other.meshes[1].vertices[3].position[1] += 1e-3f;
    CHECK(key(other) != first);
    other = scene;
    std::swap(other.meshes[1].indices[0], other.meshes[1].indices[3]);
    CHECK(key(other) != first);
    other = scene;
    other.instances[1].world_from_model = glm::translate(glm::mat4(1), {0, 1, 0});
    CHECK(key(other) != first);
    other = scene;
    other.materials[0].alpha_cutoff = 0.5f;
    CHECK(key(other) != first);

    other = scene;
    other.materials[0].base_color = {1, 0, 0, 0.25f};  // nothing is cut out
    other.lights.emplace_back();
    other.name = "renamed";
    CHECK(key(other) == first);

    Camera camera = kCamera;
    camera.view_from_world[3][0] += 0.01f;
    CHECK(referenceKey(scene, camera, kExtent, options()) != first);
    CHECK(referenceKey(scene, kCamera, {16, 17}, options()) != first);
    CHECK(referenceKey(scene, kCamera, kExtent, options(2)) != first);
    CHECK(referenceKey(scene, kCamera, kExtent, options(1, 9)) != first);
}

TEST_CASE("The texels that cut a surface out are in the key, their colours are not")
{
    Scene scene = sphereOnFloor();
    scene.materials[0].alpha_cutoff = 0.5f;
    scene.materials[0].base_color_texture = 0;
    scene.textures.push_back({"leaf", Image({2, 2}, 4, 1.0f)});
    const std::string first = key(scene);
    scene.textures[0].image.at(0, 1, 0) = 0.5f;
    CHECK(key(scene) == first);
    scene.textures[0].image.at(0, 1, 3) = 0.0f;
    CHECK(key(scene) != first);
}

TEST_CASE("A kept reference is read and not traced, background and all")
{
    const TemporaryFolder folder("reference_kept");
    const std::string cache = (folder.path / "new" / "cache").string();
    const Scene scene = sphereOnFloor();
    int progress = 0;
    TraceOptions trace = options();
    trace.threads =
        1;  // else another thread may trace all rows, and only the caller's reports progress
    trace.progress = [&progress](double) { ++progress; };
    const Image traced = need(cachedReference(scene, kCamera, kExtent, trace, cache));
    CHECK(progress > 0);
    progress = 0;
    const Image kept = need(cachedReference(scene, kCamera, kExtent, trace, cache));
    CHECK(progress == 0);
    CHECK(sameBits(traced, kept));
    CHECK(std::isnan(kept.at(0, 15)));
}

TEST_CASE("A broken kept reference is traced again")
{
    const TemporaryFolder folder("reference_broken");
    const std::string cache = folder.path.string();
    const Scene scene = sphereOnFloor();
    const Image traced = need(cachedReference(scene, kCamera, kExtent, options(), cache));
    const std::filesystem::path file = onlyFile(folder.path);
    const auto again = [&] {
        return need(cachedReference(scene, kCamera, kExtent, options(), cache));
    };

    std::filesystem::resize_file(file, 40);
    CHECK(sameBits(again(), traced));
    REQUIRE(writePfm(file.string(), Image(kExtent, 1, 7.0f)).ok());  // no visibility
    CHECK(sameBits(again(), traced));
    REQUIRE(writePfm(file.string(), Image({4, 4}, 1, 0.5f)).ok());
    CHECK(sameBits(again(), traced));
    CHECK(sameBits(need(readImage(onlyFile(folder.path).string())), traced));
}

TEST_CASE("A folder that cannot be written is a warning, and no folder is no matter")
{
    const TemporaryFolder folder("reference_unwritable");
    const std::string file = folder.write("file", "no folder");
    const Result<Image> traced =
        cachedReference(sphereOnFloor(), kCamera, kExtent, options(), file + "/cache");
    REQUIRE(traced.ok());
    REQUIRE(traced.diagnostics().size() == 1);
    CHECK(traced.diagnostics()[0].code == Code::cannot_write);
    CHECK(cachedReference(sphereOnFloor(), kCamera, kExtent, options(), "").diagnostics().empty());
}

TEST_CASE("A camera that sees no surface is an error, and nothing is kept of it")
{
    const TemporaryFolder folder("reference_nothing");
    Camera away = kCamera;
    away.view_from_world = glm::lookAt(glm::vec3(0, 2, 8), glm::vec3(0, 2, 20), glm::vec3(0, 1, 0));
    const Result<Image> image =
        cachedReference(sphereOnFloor(), away, kExtent, options(), folder.path.string());
    REQUIRE_FALSE(image.ok());
    CHECK(image.diagnostics().front().code == Code::nothing_seen);
    CHECK(std::filesystem::is_empty(folder.path));
}
