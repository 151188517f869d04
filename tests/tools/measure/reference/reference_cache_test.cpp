// SPDX-License-Identifier: MIT
// References on disk: their keys, and what happens to broken files.
#include "tools/measure/reference/tracer.h"

#include "core/base/files.h"

#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/reference/tracer_shot.h"
#include "tools/render/image/image_file.h"

#include <set>

using namespace crevice;

namespace {

Scene sphereOnFloor()
{
    return sceneOf({makeQuad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}), makeSphere(1, 12)});
}

const Camera kCamera = {glm::lookAt(glm::vec3(0, 2, 8), glm::vec3(0), glm::vec3(0, 1, 0)),
                        glm::perspective(0.9f, 1.0f, 0.1f, 50.0f)};
const Extent kExtent = {16, 16};

const TraceOptions kOptions = {1, 8};

Result<Image> cached(const std::string& folder, const Camera& camera = kCamera)
{
    return cachedReference(sphereOnFloor(), camera, kExtent, kOptions, folder);
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
    struct Subject {
        Scene scene = sphereOnFloor();
        Camera camera = kCamera;
        Extent extent = kExtent;
        TraceOptions options = kOptions;
    };
    const auto keyAfter = [](void (*change)(Subject&)) {
        Subject subject;
        change(subject);
        return referenceKey(subject.scene, subject.camera, subject.extent, subject.options);
    };
    const std::string first = keyAfter([](Subject&) {});
    CHECK(first.size() == 16);
    void (*const other[])(Subject&) = {
        [](Subject& s) { s.scene.meshes[1].vertices[3].position[1] += 1e-3f; },
        [](Subject& s) { std::swap(s.scene.meshes[1].indices[0], s.scene.meshes[1].indices[3]); },
        [](Subject& s) { s.scene.instances[1].world_from_model[3].y = 1; },
        [](Subject& s) { s.scene.materials[0].alpha_cutoff = 0.5f; },
        [](Subject& s) {
            s.scene.materials[0].alpha_cutoff = 0.5f;
            s.scene.materials[0].base_color.a = 0.25f;
        },
        [](Subject& s) { s.camera.view_from_world[3][0] += 0.01f; },
        [](Subject& s) { s.extent.height = 17; },
        [](Subject& s) { s.options.radius = 2; },
        [](Subject& s) { s.options.rays = 9; }};
    std::set<std::string> keys = {first};
    for (const auto& change : other) CHECK(keys.insert(keyAfter(change)).second);
    void (*const same[])(Subject&) = {
        [](Subject& s) { s.scene.materials[0].base_color.a = 0.25f; },  // nothing is cut out
        [](Subject& s) { s.scene.lights.emplace_back(); },
        [](Subject& s) { s.scene.name = "renamed"; }, [](Subject& s) { s.options.threads = 3; }};
    for (const auto& change : same) CHECK(keyAfter(change) == first);
}

TEST_CASE("The texels that cut a surface out are in the key, their colours are not")
{
    Scene scene = sphereOnFloor();
    scene.materials[0].alpha_cutoff = 0.5f;
    scene.materials[0].base_color_texture = 0;
    scene.textures.push_back({"leaf", Image({2, 2}, 4, 1.0f)});
    const auto key = [&scene] { return referenceKey(scene, kCamera, kExtent, kOptions); };
    const std::string first = key();
    scene.textures[0].image.at(0, 1, 0) = 0.5f;
    CHECK(key() == first);
    scene.textures[0].image.at(0, 1, 3) = 0.0f;
    CHECK(key() != first);
}

TEST_CASE("A kept reference is read and not traced, background and all")
{
    const TemporaryFolder folder("reference_kept");
    const std::string cache = (folder.path / "new" / "cache").string();
    int progress = 0;
    TraceOptions options = kOptions;
    options.threads = 1;  // else another may trace all rows, and only the caller's reports progress
    options.progress = [&progress](double) { ++progress; };
    const auto reference = [&] {
        return need(cachedReference(sphereOnFloor(), kCamera, kExtent, options, cache));
    };
    const Image traced = reference();
    CHECK(progress > 0);
    progress = 0;
    const Image kept = reference();
    CHECK(progress == 0);
    CHECK(sameBits(traced, kept));
    CHECK(std::isnan(kept.at(0, 15)));
}

TEST_CASE("A kept reference that was changed is traced again, with one warning that names it")
{
    const TemporaryFolder folder("reference_broken");
    const std::string cache = folder.path.string();
    const Image traced = need(cached(cache));
    const std::string file = onlyFile(folder.path).string();
    const std::string whole = readBytes(file, 1 << 20).bytes;
    const auto changed = [&whole](std::size_t at) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 1);
        return bytes;
    };
    TraceOptions fewer = kOptions;
    fewer.rays = 4;
    const TemporaryFolder beside("reference_other");
    const std::string other = beside.path.string();
    need(cachedReference(sphereOnFloor(), kCamera, kExtent, fewer, other));
    const std::string broken[] = {
        pfmBytes(Image(kExtent, 1, 0.25f)),  // plausible, and not what was traced
        pfmBytes(Image(kExtent, 1, 7.0f)),   // no visibility
        pfmBytes(Image({4, 4}, 1, 0.5f)),    // another size
        pfmBytes(Image(kExtent, 1, 0.25f)) + whole.substr(whole.size() - 16),
        readBytes(onlyFile(other).string(), 1 << 20).bytes,  // of another question
        changed(100),
        changed(whole.size() - 1),
        whole.substr(0, 40),
        whole + " ",
        ""};
    for (const std::string& bytes : broken) {
        need(writeFile(file, bytes));
        const Result<Image> again = cached(cache);
        CHECK(sameBits(need(again), traced));
        REQUIRE(again.diagnostics().size() == 1);
        CHECK(again.diagnostics()[0].severity == Severity::warning);
        CHECK_THAT(again.diagnostics()[0].message, Catch::Contains(file));
        CHECK(readBytes(file, 1 << 20).bytes == whole);
        CHECK(cached(cache).diagnostics().empty());
    }
    CHECK(sameBits(need(readImage(file)), traced));
}

TEST_CASE("A folder that cannot be written is a warning, and no folder is no matter")
{
    const TemporaryFolder folder("reference_unwritable");
    const Result<Image> traced = cached(folder.write("file", "no folder") + "/cache");
    REQUIRE(traced.ok());
    REQUIRE(traced.diagnostics().size() == 1);
    CHECK(traced.diagnostics()[0].code == Code::cannot_write);
    CHECK(cached("").diagnostics().empty());
}

TEST_CASE("A camera that sees no surface is an error, and nothing is kept of it")
{
    const TemporaryFolder folder("reference_nothing");
    Camera away = kCamera;
    away.view_from_world = glm::lookAt(glm::vec3(0, 2, 8), glm::vec3(0, 2, 20), glm::vec3(0, 1, 0));
    onlyError(cached(folder.path.string(), away), Code::nothing_seen);
    CHECK(std::filesystem::is_empty(folder.path));
}
