// SPDX-License-Identifier: MIT
#include "tools/render/host_textures.h"

#include <crevice/config.h>

#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/camera_framing.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

/// What pictures a host may have, and the module that reads them.
constexpr struct {
    const char* surface;
    bool normals;
    const char* module;
} kModules[] = {{"depth", false, "geometry/host_depth"},
                {"depth", true, "geometry/host_depth_normal"},
                {"linear_depth", false, "geometry/host_linear_depth"},
                {"linear_depth", true, "geometry/host_linear_depth_normal"},
                {"log_depth", false, "geometry/host_log_depth"},
                {"log_depth", true, "geometry/host_log_depth_normal"},
                {"position", true, "geometry/host_position_normal"}};

constexpr const char* kWays =
    "write --import depth=FILE, linear_depth=FILE or log_depth=FILE, and normal=FILE where there "
    "is one; or position=FILE and normal=FILE";

// As linear_far of geometry/host_linear_depth has it.
constexpr float kNothing = 1e30f;

/// Whether no value lies between the `steps` and one that a whole number has.
bool isOf(const Image& image, float steps)
{
    return std::all_of(image.pixels.begin(), image.pixels.end(), [&](float each) {
        return std::abs(each * steps - std::round(each * steps)) < 0.01f;
    });
}

/// A format with the steps that the values have, which biases follow.
Format formatOf(const std::string& name, const Image& image)
{
    if (name == "depth" && isOf(image, 65535)) return Format::depth16;
    return name == "normal" ? Format::rgba16f : name == "position" ? Format::rgba32f : Format::r32f;
}

Result<glm::mat4> matrixFrom(const std::string& text)
{
    glm::mat4 matrix;
    std::string_view rest = text;
    for (int k = 0; k < 16; ++k) {
        const std::optional<double> number = takeNumber(rest);
        const bool more = k < 15;
        if (!number || (more ? rest.substr(0, 1) != "," : !rest.empty()))
            return Diagnostic{Code::usage, "the projection '" + text + "' is not 16 numbers",
                              "write them by columns with commas between, or "
                              "'fov=50;near=0.1;far=100'"};
        if (more) rest.remove_prefix(1);
        glm::value_ptr(matrix)[k] = static_cast<float>(*number);
    }
    return matrix;
}

Result<glm::mat4> projectionOf(const std::string& projection, const std::string& camera,
                               Extent extent)
{
    if (!projection.empty() && !has(projection, "=")) return matrixFrom(projection);
    const std::string& given = projection.empty() ? camera : projection;
    const std::string text = projection.empty() ? camera : "eye=0,0,0;at=0,0,-1;" + projection;
    if (!has(text, "near=") || !has(text, "far="))
        return Diagnostic{Code::usage,
                          given.empty() ? "nothing says how the imported depth was projected"
                                        : "the projection '" + given + "' lacks near or far",
                          "give --projection 'fov=50;near=0.1;far=100', or the 16 numbers of the "
                          "matrix by columns, with commas between"};
    const double aspect = static_cast<double>(extent.width) / extent.height;
    const Result<SceneCamera> seen = chooseCamera({}, {}, text, aspect);
    if (!seen) return seen.diagnostics();
    return clipFromView(*seen, extent, {});
}

}  // namespace

Result<HostPictures> HostPictures::read(const HostPictureOptions& options,
                                        const std::string& camera)
{
    HostPictures host;
    for (const std::string& text : options.files) {
        const Result<NamedFile> given = parseNamedFile("--import", text, kWays);
        if (!given) return given.diagnostics();
        Result<Image> image = readImage(given->file);
        if (!image) return image.diagnostics();
        host.pictures_.emplace_back(given->name, std::move(*image));
        if (host.pictures_.back().second.extent != host.extent())
            return Diagnostic{Code::bad_size, "the imported pictures differ in size",
                              "give those of one frame"};
    }
    std::stable_sort(
        host.pictures_.begin(), host.pictures_.end(),
        [](const auto& a, const auto& b) { return (a.first == "normal") < (b.first == "normal"); });
    const auto count = [&](const std::string& name) {
        return std::count_if(host.pictures_.begin(), host.pictures_.end(),
                             [&](const auto& each) { return each.first == name; });
    };
    for (const auto& [surface, normals, module] : kModules)
        if (count(surface) == 1 && count("normal") == (normals ? 1 : 0) &&
            host.pictures_.size() == (normals ? 2u : 1u))
            host.module_ = module;
    if (!host.module_)
        return Diagnostic{Code::usage, "no geometry module reads the imported pictures", kWays};
    if (isOf(host.pictures_.front().second, 255))
        return Diagnostic{Code::image_broken,
                          "the imported " + host.pictures_.front().first +
                              " has 8 bits a pixel, too few to tell surfaces apart",
                          "write it to EXR, PFM, or PNG of 16 bits"};
    const auto clip = projectionOf(options.projection, camera, host.extent());
    if (!clip) return clip.diagnostics();
    host.camera_.clip_from_view = *clip;
    host.camera_.clip_control = ClipControl{options.zero_to_one, false};
    host.camera_.depth_range = DepthRange{};
    return host;
}

std::optional<double> HostPictures::medianDistance() const
{
    const auto& [name, image] = pictures_.front();
    if (name == "depth") return crevice::medianDistance(image, camera_);
    std::vector<double> seen;
    for (std::size_t k = 0; k < image.pixels.size(); k += image.channels) {
        const double value = image.pixels[k];
        if (name == "linear_depth" && value > 0 && value < kNothing) seen.push_back(value);
        if (name == "position" && image.channels == 4 && image.pixels[k + 3] > 0)
            seen.push_back(std::abs(image.pixels[k + 2]));
    }
    return medianOf(std::move(seen));
}

void HostPictures::fitFormats(Description& description) const
{
    for (ImportDesc& import : description.imports)
        for (const auto& [name, image] : pictures_)
            if (import.name == name) import.format = formatInfo(formatOf(name, image)).name;
}

Status HostPictures::upload(Device& device, Frame& frame)
{
    frame.camera = camera_;
    for (const auto& [name, image] : pictures_) {
        const Format format = formatOf(name, image);
        const auto texture = device.createTexture({name, format, image.extent});
        if (!texture) return texture.diagnostics();
        textures_.emplace_back(device, *texture);
        const Image pixels = withChannels(image, formatInfo(format).channels);
        if (Status written = device.writeTexture(*texture, pixels); !written) return written;
        frame.textures.push_back({name, *texture});
    }
    return {};
}

}  // namespace crevice
