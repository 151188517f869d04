// SPDX-License-Identifier: MIT
// Reading and resolving what `crevice render` shall write.
#include "tools/cli/output_request.h"

#include "tools/image/image_file.h"

#include <unistd.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

constexpr std::string_view kTargetPrefix = "target.";

Diagnostic usageError(std::string message, std::string help)
{
    Diagnostic error{Code::usage, std::move(message)};
    error.help = std::move(help);
    return error;
}

Diagnostic unwritable(const std::string& file, const std::string& reason, std::string help)
{
    Diagnostic error{Code::cannot_write, "'" + file + "' cannot be written: " + reason};
    error.help = std::move(help);
    return error;
}

Diagnostic unknownOutput(const Description& description, const std::string& name)
{
    std::vector<std::string> names = namesOf(description.outputs);
    for (const ViewDesc& view : description.views) names.push_back(view.name);
    for (const TargetDesc& target : description.targets)
        names.push_back(findNamed(description.outputs, target.name)
                            ? std::string(kTargetPrefix) + target.name
                            : target.name);
    Diagnostic error{Code::output_missing, "the config '" + description.name +
                                               "' has no output, view or target '" + name + "'"};
    error.help = suggestName(name, std::move(names), "names");
    return error;
}

/// Exports a target under a name of its own and returns that name.
std::string exportTarget(Description& description, const std::string& target)
{
    const std::string name = std::string(kTargetPrefix) + target;
    if (!findNamed(description.outputs, name)) {
        OutputDesc output;
        output.name = name;
        output.target.name = target;
        description.outputs.push_back(std::move(output));
    }
    return name;
}

}  // namespace

Result<OutputRequest> parseOutputRequest(const std::string& text)
{
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return usageError("--out '" + text + "' is not NAME=FILE",
                          "write --out color=lit.png or --out ao=ao.pfm");
    OutputRequest request{text.substr(0, equals), text.substr(equals + 1)};
    const std::string extension = lowerExtension(request.file);
    if (extension != ".png" && extension != ".pfm")
        return usageError("the file '" + request.file + "' of --out is neither .png nor .pfm",
                          "PNG holds 8 bits a channel for looking at, PFM 32-bit floats");
    return request;
}

Result<OutputSource> exposeOutput(Description& description, const std::string& name)
{
    if (findNamed(description.outputs, name)) return OutputSource{name};
    if (const ViewDesc* view = findNamed(description.views, name))
        return OutputSource{exportTarget(description, view->target.name), view->scale,
                            view->offset};
    const bool prefixed = name.rfind(kTargetPrefix, 0) == 0;
    const std::string target = prefixed ? name.substr(kTargetPrefix.size()) : name;
    if (findNamed(description.targets, target))
        return OutputSource{exportTarget(description, target)};
    return unknownOutput(description, name);
}

void applyView(Image& image, const OutputSource& source)
{
    for (float& value : image.pixels) value = value * source.scale + source.offset;
}

Status checkWritable(const std::string& file)
{
    const fs::path folder = fs::path(file).has_parent_path() ? fs::path(file).parent_path() : ".";
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored))
        return unwritable(file, "there is no folder '" + folder.string() + "'",
                          "mkdir -p '" + folder.string() + "'");
    if (fs::is_directory(file, ignored))
        return unwritable(file, "it is a folder", "give a file's name");
    if (access(folder.c_str(), W_OK) != 0)
        return unwritable(file, "the folder '" + folder.string() + "' cannot be written",
                          "choose another folder");
    return {};
}

}  // namespace crevice
