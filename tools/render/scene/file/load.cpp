// SPDX-License-Identifier: MIT
// Finding the scene that is meant: a built-in one or a file.
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/lights.h"
#include "tools/render/scene/scene.h"

#include "core/base/files.h"

#include <algorithm>
#include <filesystem>

namespace crevice {

namespace {

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

}  // namespace

Result<Scene> loadScene(const std::string& name_or_file, const ImportOptions& options)
{
    const auto& names = builtinSceneNames();
    if (std::find(names.begin(), names.end(), name_or_file) != names.end())
        return builtinScene(name_or_file);
    std::error_code error;
    if (!std::filesystem::exists(name_or_file, error)) return sceneMissing(name_or_file);
    Result<Scene> scene = importScene(name_or_file, options);
    if (scene) addDefaultLight(*scene);
    return scene;
}

}  // namespace crevice
