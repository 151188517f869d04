// SPDX-License-Identifier: MIT
#include "tools/commands/cli/output_request.h"

#include "tools/render/image/image_file.h"

#include <unistd.h>

namespace fs = std::filesystem;

namespace crevice {
namespace {

Diagnostic unwritable(const std::string& file, const std::string& reason, std::string help)
{
    return {Code::cannot_write, "'" + file + "' cannot be written: " + reason, std::move(help)};
}

/// Whether %d or %0Nd, with N of 1 to 9, begins there.
bool isFramePlace(const std::string& pattern, std::size_t at)
{
    if (pattern.compare(at, 2, "%d") == 0) return true;
    return pattern.size() >= at + 4 && pattern[at + 1] == '0' && pattern[at + 2] >= '1' &&
           pattern[at + 2] <= '9' && pattern[at + 3] == 'd';
}

}  // namespace

Result<OutputRequest> parseOutputRequest(const std::string& text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::usage, "--out '" + text + "' is not NAME=FILE",
                          "write --out color=lit.png or --out ao=ao.pfm"};
    OutputRequest request{text.substr(0, equals), text.substr(equals + 1)};
    const std::string extension = lowerExtension(request.file);
    if (extension != ".png" && extension != ".pfm")
        return Diagnostic{Code::usage,
                          "the file '" + request.file + "' of --out is neither .png nor .pfm",
                          "PNG holds 8 bits a channel for looking at, PFM 32-bit floats"};
    return request;
}

std::string frameFile(const std::string& pattern, int frame)
{
    const std::size_t at = pattern.find('%'), end = pattern.find('d', at) + 1;
    const std::size_t digits = end - at == 4 ? pattern[at + 2] - '0' : 1;
    std::string number = std::to_string(frame);
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return pattern.substr(0, at) + number + pattern.substr(end);
}

Status checkFramePattern(const std::string& file)
{
    const std::size_t at = file.find('%');
    if (at != file.npos && isFramePlace(file, at) && file.find('%', at + 1) == file.npos) return {};
    return Diagnostic{Code::usage,
                      "the file '" + file + "' of --out has not one place for the frame's number",
                      "with --path write a file as 'frame_%03d.png', with one %d or %03d"};
}

Status checkWritable(const std::string& file)
{
    const fs::path target = behindLinks(file);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        return unwritable(file, "there is no folder '" + folder.string() + "'",
                          file[0] == '~' ? "write $HOME for '~', which no shell replaces behind '='"
                                         : "mkdir -p '" + folder.string() + "'");
    if (fs::is_directory(file, ignored))
        return unwritable(file, "it is a folder", "give a file's name");
    if (access(folder.c_str(), W_OK) != 0)
        return unwritable(file, "the folder '" + folder.string() + "' cannot be written",
                          "choose another folder");
    return {};
}

}  // namespace crevice
