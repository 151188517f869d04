// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/textures.h"

#include "core/base/text.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/srgb.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/import.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <numeric>
#include <set>

namespace crevice {

namespace {

// Of an image file. A picture of 8192 x 8192 pixels that nothing compresses takes 256 MiB.
constexpr std::uintmax_t kMaxTextureBytes = 512u << 20;

// Four linear channels of an image with any number of channels.
Image linearRgba(const Image& image, Encoding encoding)
{
    Image rgba(image.extent, 4, 1.0f);
    const std::size_t count = rgba.pixels.size() / 4;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const float* from = &image.pixels[pixel * image.channels];
        float* to = &rgba.pixels[pixel * 4];
        for (int channel = 0; channel < 3; ++channel) {
            const float value = image.channels >= 3 ? from[channel] : from[0];
            to[channel] = encoding == Encoding::srgb ? pictureLinearFromSrgb(value) : value;
        }
        if (image.channels % 2 == 0) to[3] = from[image.channels - 1];
    }
    return rgba;
}

// The file whose name differs in capitals alone, which Windows would open; empty without one.
std::filesystem::path inOtherCase(const std::filesystem::path& wanted)
{
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(wanted.parent_path(), error))
        if (lowerCase(entry.path().filename().string()) == lowerCase(wanted.filename().string()))
            return entry.path();
    return {};
}

// Exporters write paths of their own machine: what follows the last slash is tried as well. Nothing
// where the only such file is one that the folder does not open.
std::optional<std::string> textureFile(const std::string& scene_path, SceneFolder& allowed,
                                       std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    name.erase(name.find_last_not_of(" \t\r") + 1);
    const std::filesystem::path folder = std::filesystem::path(scene_path).parent_path();
    std::set<std::filesystem::path> folders = {folder};  // of the scene, and of its .mtl files
    for (const std::string& file : allowed.opened())
        folders.insert(std::filesystem::path(file).parent_path());
    std::vector<std::filesystem::path> candidates;
    for (const std::string& spelling : {name, percentDecoded(name)})
        for (const std::filesystem::path& path :
             {std::filesystem::path(spelling), std::filesystem::path(spelling).filename()})
            for (const std::filesystem::path& each : folders) candidates.push_back(each / path);
    for (const auto& candidate : candidates)
        if (allowed.allows(candidate)) return candidate.string();
    for (const auto& candidate : candidates)
        if (const auto other = inOtherCase(candidate); allowed.allows(other)) return other.string();
    for (const auto& candidate : candidates)
        if (allowed.refuses(candidate)) return std::nullopt;
    return (folder / name).string();
}

Result<Image> readImageFile(const std::string& file, double most_pixels)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error && size > kMaxTextureBytes)
        return Diagnostic{Code::image_broken, "the image '" + file + "' is larger than 512 MiB"};
    return readImage(file, most_pixels);
}

}  // namespace

std::string percentDecoded(const std::string& text)
{
    std::string decoded;
    for (std::size_t at = 0; at < text.size(); ++at) {
        unsigned code = 0;
        const char* const digits = text.data() + at + 1;
        const bool escape = text[at] == '%' && at + 2 < text.size() &&
                            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
        decoded += escape ? static_cast<char>(code) : text[at];
        if (escape) at += 2;
    }
    return decoded;
}

double SceneTextures::room() const { return sceneLimits(folder_.bytes()).texels - texels_; }

int SceneTextures::inFile(const std::string& name, Encoding encoding)
{
    return find(name, encoding, [&]() -> std::optional<Result<Image>> {
        const std::optional<std::string> file = textureFile(path_, folder_, name);
        if (!file) return std::nullopt;
        folder_.opens(*file);
        return readImageFile(*file, room());
    });
}

int SceneTextures::inBytes(const std::string& name, std::string_view bytes, Encoding encoding)
{
    return find(name, encoding, [&]() {
        return decodeImage(bytes, path_ + " (embedded texture " + name + ")", room());
    });
}

int SceneTextures::inImage(const std::string& name, const Image& image, Encoding encoding)
{
    return find(name, encoding, [&]() { return Result<Image>(image); });
}

int SceneTextures::add(const std::string& name, Image image)
{
    const double texels = static_cast<double>(image.pixels.size()) / 4;
    if (texels > room()) return kNone;
    scene_.textures.push_back({name, std::move(image)});
    texels_ += texels;
    return static_cast<int>(scene_.textures.size()) - 1;
}

int SceneTextures::find(const std::string& name, Encoding encoding, const Read& read)
{
    const auto [known, added] = indices_.try_emplace({name, encoding}, kNone);
    if (!added) return known->second;
    try {
        const std::optional<Result<Image>> image = read();
        if (image && !*image) return leaveOut(image->diagnostics().front());
        if (image) known->second = add(name, linearRgba(**image, encoding));
    } catch (const std::bad_alloc&) {
        return leaveOut({Code::image_broken, "the image '" + name + "' does not fit into memory"});
    }
    return known->second;
}

int SceneTextures::leaveOut(Diagnostic warning)
{
    warning.severity = Severity::warning;
    if (!warning.help.empty()) warning.help += "; ";
    warning.help += "the material is drawn without the texture";
    warnings_.push_back(std::move(warning));
    return kNone;
}

Image paintedCorners(const std::vector<float>& colors, double most_texels, MeshDesc& mesh)
{
    const std::size_t triangles = mesh.indices.size() / 3;
    const int blocks = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(triangles))));
    const int side = 2 * blocks;
    if (triangles == 0 || static_cast<double>(side) * side > most_texels) return {};
    Image image({side, side}, 4, 1.0f);
    std::vector<Vertex> corners;
    corners.reserve(mesh.indices.size());
    for (std::size_t k = 0; k < triangles; ++k) {
        const int x = 2 * (static_cast<int>(k) % blocks), y = 2 * (static_cast<int>(k) / blocks);
        glm::vec4 texels[4];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = mesh.indices[3 * k + static_cast<std::size_t>(corner)];
            for (int channel = 0; channel < 4; ++channel) {
                const float value = colors[4 * std::size_t{index} + std::size_t(channel)];
                texels[corner][channel] = std::isfinite(value) ? value : 1.0f;
            }
            Vertex& vertex = corners.emplace_back(mesh.vertices[index]);
            vertex.uv[0] = (static_cast<float>(x + corner % 2) + 0.5f) / static_cast<float>(side);
            vertex.uv[1] = (static_cast<float>(y + corner / 2) + 0.5f) / static_cast<float>(side);
        }
        texels[3] = texels[1] + texels[2] - texels[0];
        for (int texel = 0; texel < 4; ++texel)
            for (int channel = 0; channel < 4; ++channel)
                image.at(x + texel % 2, y + texel / 2, channel) = texels[texel][channel];
    }
    mesh.vertices = std::move(corners);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    return image;
}

}  // namespace crevice
