// SPDX-License-Identifier: MIT
#include "tools/render/device/program_folder.h"

#include "core/base/files.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"

#include <unistd.h>

namespace fs = std::filesystem;

namespace crevice {
namespace {

// A driver's largest have a few hundred thousand.
constexpr std::size_t kMaxProgramBytes = 64u << 20;

}  // namespace

Result<std::unique_ptr<ProgramFolder>> ProgramFolder::open(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (fs::is_directory(path, error) && access(path.c_str(), W_OK | X_OK) == 0)
        return std::unique_ptr<ProgramFolder>(new ProgramFolder(path));
    return Diagnostic{Code::cannot_write, "'" + path + "' is no folder that can be written",
                      "name another folder with --program-cache"};
}

ProgramCache ProgramFolder::cache()
{
    const auto load = [this](const std::string& key) {
        ++asked_;
        const FileBytes file = readBytes((fs::path(path_) / key).string(), kMaxProgramBytes);
        return std::vector<std::uint8_t>(file.bytes.begin(), file.bytes.end());
    };
    const auto store = [this](const std::string& key, const std::vector<std::uint8_t>& bytes) {
        ++stored_;
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const Status written = writeFile((fs::path(path_) / key).string(), text);
        if (written || !warnings_.empty()) return;
        warnings_ = {asWarning({Code::cannot_write, written.diagnostics().front().message,
                                "what is not written is compiled again next time"})};
    };
    return {load, store};
}

}  // namespace crevice
