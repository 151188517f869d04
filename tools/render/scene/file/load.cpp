// SPDX-License-Identifier: MIT
// Finding the scene that is meant, a built-in one or a file; files are read in a process of their
// own: Assimp 5.2 asserts on some broken ones and never returns from others.
#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/file/import.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/render/scene/transfer.h"

#include <glm/geometric.hpp>

#include <filesystem>

namespace crevice {
namespace {

Result<Scene> readWithoutThrow(const std::string& path, const ImportOptions& options)
{
    try {
        return readScene(path, options);
    } catch (const std::bad_alloc&) {
        return brokenScene(
            path, "it takes more memory than it may, 768 MiB and 64 times the size of its files",
            "it may claim more than it holds; a scene that is this large has to be split");
    } catch (const std::exception& fault) {
        return brokenScene(path, fault.what());
    }
}

Diagnostic unfinished(ChildEnd end, const std::string& path, const ChildLimits& limits)
{
    if (end == ChildEnd::no_child)
        return {Code::out_of_memory, "there is no process to read the scene '" + path + "' in"};
    if (end == ChildEnd::crashed)
        return brokenScene(path, "its reader crashed",
                           "the file is damaged; export it once more, or convert it to .glb");
    return brokenScene(
        path,
        "that took longer than " + std::to_string(static_cast<long long>(limits.cpu_s)) +
            " s of the processor's time",
        "the file is damaged or very large; allow more time with --import-time SECONDS");
}

Result<Scene> importApart(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    const ChildLimits limits = readerLimits(std::filesystem::file_size(path, error), options);
    bool ok = false;
    Scene scene;
    Diagnostics diagnostics;
    const auto send = [&](Sender& sender) {
        Result<Scene> read = readWithoutThrow(path, options);
        ok = read.ok();
        diagnostics = read.diagnostics();
        transferAll(sender, ok, ok ? *read : scene, diagnostics);
    };
    std::string bytes;
    const ChildEnd end = runInChild(limits, send, bytes);
    if (end != ChildEnd::done) return unfinished(end, path, limits);
    BytesReader reader(bytes);
    transferAll(reader, ok, scene, diagnostics);
    if (!reader.whole()) return unfinished(ChildEnd::crashed, path, limits);
    if (!ok) return diagnostics;
    if (!isSound(scene)) return brokenScene(path, "its reader mixed it up");
    return {std::move(scene), std::move(diagnostics)};
}

bool looksLikeFile(const std::string& name)
{
    return name.find_first_of("/\\.") != std::string::npos;
}

Diagnostic sceneMissing(const std::string& name)
{
    Diagnostic error = {Code::scene_missing, "there is no scene '" + name + "'"};
    if (looksLikeFile(name)) error.message = "the scene file '" + name + "' does not exist";
    const std::filesystem::path path = name;
    const auto files = looksLikeFile(name)
                           ? filesBeside(name, path.filename().string(), path.extension().string())
                           : std::vector<std::string>();
    error.help = files.empty() ? suggestName(name, builtinSceneNames(), "built-in scenes")
                               : suggestName(path.filename().string(), files, "files beside it");
    return error;
}

// Over the shoulder of whoever looks at it from the front, so that it can be seen.
void addDefaultLight(Scene& scene)
{
    if (!scene.lights.empty()) return;
    SceneLight light;
    light.name = "default";
    light.light.directional = true;
    light.light.direction = glm::normalize(glm::vec3(-0.4f, -0.8f, -0.6f));
    light.light.color = glm::vec3(0.7f);
    scene.lights.push_back(light);
}

}  // namespace

Result<Scene> importScene(const std::string& path, const ImportOptions& options)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return Diagnostic{Code::scene_missing, "the scene file '" + path + "' does not exist"};
    if (!std::filesystem::is_regular_file(path, error))
        return brokenScene(path, "it is not a file");
    if (!options.any_format && !isDefaultFormat(path))
        return brokenScene(
            path, "it is in none of the formats that are read",
            std::string(kSceneFormats) + "; --any-format tries all that Assimp knows");
    try {
        return importApart(path, options);
    } catch (const std::bad_alloc&) {
        return Diagnostic{Code::out_of_memory, "the scene '" + path + "' does not fit into memory"};
    }
}

Result<Scene> loadScene(const std::string& name_or_file, const ImportOptions& options)
{
    if (contains(builtinSceneNames(), name_or_file)) return builtinScene(name_or_file);
    std::error_code error;
    if (!std::filesystem::exists(name_or_file, error)) return sceneMissing(name_or_file);
    Result<Scene> scene = importScene(name_or_file, options);
    if (scene) addDefaultLight(*scene);
    return scene;
}

}  // namespace crevice
