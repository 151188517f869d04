// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/folder.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/scene/file/limits.h"

namespace crevice {

namespace fs = std::filesystem;

SceneFolder::SceneFolder(const std::string& scene, const ImportOptions& options)
    : scene_(scene),
      options_(options),
      roots_(options.roots)
{
    const fs::path folder = fs::path(scene).parent_path();
    roots_.push_back(folder.empty() ? "." : folder.string());
    opens(scene);
}

bool SceneFolder::allows(const fs::path& file) const
{
    std::error_code error;
    return fs::is_regular_file(file, error) && (file == scene_ || isBelow(file.string(), roots_));
}

bool SceneFolder::refuses(const fs::path& file)
{
    std::error_code error;
    if (file == scene_ || !fs::exists(file, error) || isBelow(file.string(), roots_)) return false;
    refused_.insert(file.string());
    return true;
}

void SceneFolder::opens(const fs::path& file)
{
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (error || !opened_.insert(file.string()).second) return;
    bytes_ += size;
    if (file.extension() == ".mtl") lacking_.clear();
    limitSelf(readerLimits(bytes_, options_));
}

Diagnostic SceneFolder::warning() const
{
    const std::vector<std::string> files(refused_.begin(), refused_.end());
    return asWarning({Code::module_escape,
                      "the scene '" + scene_ +
                          "' names files outside its "
                          "folder, which are not read: " +
                          joined(files),
                      "move them below the scene's folder, or allow theirs with --root FOLDER"});
}

}  // namespace crevice
