// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/folder.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/scene/file/import.h"

#include <unistd.h>

#include <cmath>

namespace crevice {
namespace {

namespace fs = std::filesystem;

// A part that any file may take, and another for each of its bytes.
constexpr double kMiB = 1 << 20;

// Scenes of ten million triangles, 180 to 500 MiB, take 10 to 20 s: a twentieth of what this leaves
// them.
constexpr double kLeastTime = 3;  // s
constexpr double kTimePerMiB = 1;

// Those scenes take 5 to 15 times their size. Never above half of the machine's memory, since this
// process holds the scene too.
constexpr double kLeastMemory = 768 * kMiB;
constexpr double kMemoryPerByte = 64;

// A reader that waits for a disk and does not work.
constexpr double kLongestWait = 600;  // s

}  // namespace

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

// A triangle takes at least a byte, compressed, and its reader some 300; a texel 16 and as many
// while it is decoded, and a byte of a JPEG holds up to ten. A node takes 16 bytes in JSON and 1100
// in Assimp; a primitive 30 in JSON and 7000 here and on the GPU. What small files may have beyond
// that fits into a gigabyte.
SceneLimits sceneLimits(std::uint64_t bytes)
{
    const auto size = static_cast<double>(bytes);
    return {65536 + size / 16, 32768 + size / 256, 2e6 + 2 * size, 8e6 + 4 * size, 2e7 + 16 * size};
}

ChildLimits readerLimits(std::uint64_t bytes, const ImportOptions& options)
{
    const auto size = static_cast<double>(bytes);
    const double half = 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<double>(sysconf(_SC_PAGESIZE));
    ChildLimits limits;
    const bool given = options.time_s > 0;
    limits.time_s = given ? options.time_s : kLongestWait + kTimePerMiB * size / kMiB;
    limits.cpu_s = given ? options.time_s : kLeastTime + kTimePerMiB * size / kMiB;
    limits.memory =
        static_cast<std::uint64_t>(std::min(half, kLeastMemory + kMemoryPerByte * size));
    limits.answer = static_cast<std::uint64_t>(half);
    return limits;
}

Diagnostic overLimit(const std::string& path, const std::string& what, double count, double limit,
                     std::uint64_t bytes)
{
    return Diagnostic{Code::scene_broken,
                      "the scene '" + path + "' has " + significant(count, 15) + " " + what +
                          ", and " + std::to_string(bytes) + " bytes of files may have " +
                          significant(std::floor(limit), 15),
                      "it may claim more than it holds; export it once more, smaller or in parts"};
}

}  // namespace crevice
