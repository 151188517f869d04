// SPDX-License-Identifier: MIT
// PNG through stb, PFM by hand, and writing that never leaves half a file.
#include "tools/render/image/image_file.h"

#include "tools/render/image/exr.h"

#include "core/base/files.h"
#include "core/base/text.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS (1 << 15)  // no device holds more, and a broken header often says more
#include <stb/stb_image.h>
#include <webp/decode.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace crevice {
namespace {

Diagnostic cannotWrite(const std::string& path, const std::string& reason)
{
    return {Code::cannot_write, "cannot write '" + path + "': " + reason,
            "name a file in a folder that exists and that you may write to"};
}

/// Most values, over all channels, that an image may have: 16384x8192 pixels of four. A file of a
/// few bytes can say that it has more than there is memory.
constexpr double kMaxImageValues = 1 << 29;
constexpr std::size_t kMaxImageBytes = (std::size_t(1) << 31) + 128;  // as floats, behind a header

Diagnostic brokenImage(const std::string& name, const std::string& reason, std::string help = {})
{
    return {Code::image_broken, "the image '" + name + "' cannot be read: " + reason,
            std::move(help)};
}

// A new file in the folder, or -1. Names are tried until one is free: process ids come again, and
// what was killed leaves its file behind. They are short, since the target's own may be as long as
// names can be.
int openTemporary(const std::filesystem::path& folder, mode_t mode, std::string& path)
{
    constexpr int kTries = 1000;
    static std::atomic<unsigned> count{0};
    for (int i = 0; i < kTries; ++i) {
        const std::string name =
            ".crevice-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp";
        path = (folder / name).string();
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (file >= 0 || errno != EEXIST) return file;
    }
    return -1;
}

// The file gets the owner of the old one, as far as that is allowed, and its mode.
void keepAccess(int file, const struct stat& old)
{
    mode_t mode = old.st_mode & 0777;
    struct stat now = {};
    const bool ours =
        fstat(file, &now) == 0 && now.st_uid == old.st_uid && now.st_gid == old.st_gid;
    if (!ours && fchown(file, old.st_uid, old.st_gid) != 0 && fchown(file, -1, old.st_gid) != 0)
        mode &= ~S_IRWXG;  // it was another group that might
    fchmod(file, mode);    // where a disk has no modes, only the owner may
}

Status checkPixels(const std::string& path, const Image& image)
{
    const std::size_t wanted = static_cast<std::size_t>(std::max(image.extent.width, 0)) *
                               std::max(image.extent.height, 0) * std::max(image.channels, 0);
    if (wanted > 0 && image.pixels.size() == wanted && image.channels <= 4) return {};
    return Diagnostic{Code::image_broken, "there is no image to write to '" + path +
                                              "': " + std::to_string(image.extent.width) + "x" +
                                              std::to_string(image.extent.height) + " pixels of " +
                                              std::to_string(image.channels) + " channels"};
}

float channelOrZero(const Image& image, int x, int y, int channel)
{
    return channel < image.channels ? image.at(x, y, channel) : 0.0f;
}

void appendBytes(void* context, void* data, int size)
{
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), size);
}

// PFM is written with its low byte first, whatever the machine's order.
void appendFloat(std::string& out, float value)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(bits >> shift & 255);
}

float floatAt(std::string_view bytes, std::size_t at, bool low_byte_first)
{
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto byte = static_cast<unsigned char>(bytes[at + (low_byte_first ? k : 3 - k)]);
        bits |= static_cast<std::uint32_t>(byte) << (8 * k);
    }
    float value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

bool isPfm(std::string_view bytes)
{
    return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == 'F' || bytes[1] == 'f') &&
           std::isspace(static_cast<unsigned char>(bytes[2]));
}

// "PF 640 480 -1.0" and one white space; then the floats.
Result<Image> decodePfm(std::string_view bytes, const std::string& name)
{
    std::string_view rest = bytes.substr(2, 126);
    double numbers[3] = {};
    for (double& number : numbers) number = takeNumber(rest).value_or(0.0);
    const auto& [width, height, scale] = numbers;
    const auto isSide = [](double n) { return n >= 1 && n <= 1e9 && n == std::floor(n); };
    if (!isSide(width) || !isSide(height) || !std::isfinite(scale) || scale == 0.0)
        return brokenImage(name, "its PFM header is not 'PF WIDTH HEIGHT SCALE'");
    const int channels = bytes[1] == 'F' ? 3 : 1;
    const std::size_t header = static_cast<std::size_t>(rest.data() - bytes.data()) + 1;
    const std::size_t begin = std::min(header, bytes.size());
    const std::size_t floats = (bytes.size() - begin) / 4;
    const double wanted = width * height * channels;
    if (static_cast<double>(floats) < wanted)
        return brokenImage(name, "it ends after " + std::to_string(floats) + " of " +
                                     std::to_string(static_cast<long long>(wanted)) + " values");
    Image image({static_cast<int>(width), static_cast<int>(height)}, channels);
    for (std::size_t k = 0; k < image.pixels.size(); ++k)
        image.pixels[k] = floatAt(bytes, begin + 4 * k, scale < 0.0);
    return image;
}

// stb gives rows from the top down; `one` is what it gives for 1.
template <class Number>
Image imageFromRows(const Number* rows, Extent extent, int channels, float one = 65535.0f)
{
    Image image(extent, channels);
    const std::size_t row_size = static_cast<std::size_t>(extent.width) * channels;
    for (int y = 0; y < extent.height; ++y) {
        const Number* from = rows + (extent.height - 1 - y) * row_size;
        float* to = &image.pixels[y * row_size];
        for (std::size_t k = 0; k < row_size; ++k) to[k] = from[k] / one;
    }
    return image;
}

Status checkImageSize(const std::string& name, Extent extent, int channels, double most_pixels)
{
    const double limit = std::min(kMaxImageValues / channels, std::floor(most_pixels));
    if (static_cast<double>(extent.width) * extent.height <= limit) return {};
    return brokenImage(name,
                       "it is " + std::to_string(extent.width) + "x" +
                           std::to_string(extent.height) + " pixels, more than the " +
                           std::to_string(static_cast<long long>(limit)) + " that it may have here",
                       "scale it down");
}

Result<Image> decodeByStb(std::string_view bytes, const std::string& name, double most_pixels)
{
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), INT32_MAX));
    Extent extent;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &extent.width, &extent.height, &channels))
        if (const Status fits = checkImageSize(name, extent, channels, most_pixels); !fits)
            return fits.diagnostics();
    if (stbi_is_hdr_from_memory(data, size)) {
        const std::unique_ptr<float, void (*)(void*)> light(
            stbi_loadf_from_memory(data, size, &extent.width, &extent.height, &channels, 0),
            stbi_image_free);
        if (!light) return brokenImage(name, stbi_failure_reason());
        return imageFromRows(light.get(), extent, channels, 1.0f);
    }
    // Of 8 bits it makes the 257-fold, which is the same part of the whole.
    const std::unique_ptr<stbi_us, void (*)(void*)> rows(
        stbi_load_16_from_memory(data, size, &extent.width, &extent.height, &channels, 0),
        stbi_image_free);
    if (!rows)
        return brokenImage(name, stbi_failure_reason(),
                           "is it a picture? PNG, PFM, JPEG, WebP, BMP, TGA and others are read");
    return imageFromRows(rows.get(), extent, channels);
}

Result<Image> decodeExrFile(std::string_view bytes, const std::string& name, double most_pixels)
{
    const ExrInfo info = exrInfo(bytes);
    if (!info.failure.empty()) return brokenImage(name, info.failure);
    if (const Status fits = checkImageSize(name, info.extent, info.channels, most_pixels); !fits)
        return fits.diagnostics();
    Result<Image> image = decodeExr(bytes, info);
    return image ? std::move(image)
                 : brokenImage(name, image.diagnostics().front().message,
                               "channels are to be one, or R, G, B and perhaps A");
}

bool isWebp(std::string_view bytes)
{
    return bytes.size() > 12 && bytes.substr(0, 4) == "RIFF" && bytes.substr(8, 4) == "WEBP";
}

Result<Image> decodeWebp(std::string_view bytes, const std::string& name, double most_pixels)
{
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    constexpr int kChannels = 4;
    Extent extent;
    if (!WebPGetInfo(data, bytes.size(), &extent.width, &extent.height))
        return brokenImage(name, "its header is damaged");
    if (const Status fits = checkImageSize(name, extent, kChannels, most_pixels); !fits)
        return fits.diagnostics();
    const std::unique_ptr<std::uint8_t, void (*)(void*)> rows(
        WebPDecodeRGBA(data, bytes.size(), &extent.width, &extent.height), WebPFree);
    if (!rows) return brokenImage(name, "its pixels are damaged");
    const auto count = static_cast<std::size_t>(extent.width) * extent.height * kChannels;
    std::vector<stbi_us> wide(rows.get(), rows.get() + count);
    for (stbi_us& each : wide) each = static_cast<stbi_us>(each * 257);
    return imageFromRows(wide.data(), extent, kChannels);
}

}  // namespace

std::string lowerExtension(const std::string& path)
{
    return lowerCase(std::filesystem::path(path).extension().string());
}

std::filesystem::path behindLinks(const std::string& path)
{
    constexpr int kMostLinks = 40;  // as on Linux
    std::filesystem::path file = path;
    std::error_code error;
    for (int k = 0; k < kMostLinks && std::filesystem::is_symlink(file, error); ++k)
        file = file.parent_path() / std::filesystem::read_symlink(file, error);
    return file;
}

int writeAll(int file, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

Status writeFile(const std::string& path, std::string_view bytes)
{
    const auto target = behindLinks(path);
    struct stat old = {};
    const bool replaces = stat(target.c_str(), &old) == 0;
    if (!replaces && errno != ENOENT) return cannotWrite(path, std::strerror(errno));
    if (replaces && !S_ISREG(old.st_mode))
        return cannotWrite(path, S_ISDIR(old.st_mode) ? "it is a folder" : "it is no regular file");
    std::string temporary;
    const int file = openTemporary(target.parent_path(), replaces ? 0600 : 0666, temporary);
    if (file < 0) return cannotWrite(path, std::strerror(errno));
    if (replaces) keepAccess(file, old);
    int failure = writeAll(file, bytes);
    if (close(file) != 0 && failure == 0) failure = errno;
    if (failure == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) failure = errno;
    if (failure == 0) return {};
    std::remove(temporary.c_str());
    return cannotWrite(path, std::strerror(failure));
}

Status writePng(const std::string& path, const Image& image)
{
    if (Status status = checkPixels(path, image); !status) return status;
    const int channels = image.channels == 2 ? 3 : image.channels;
    std::vector<unsigned char> rows;
    rows.reserve(static_cast<std::size_t>(image.extent.width) * image.extent.height * channels);
    bool undefined = false;
    for (int y = image.extent.height - 1; y >= 0; --y)
        for (int x = 0; x < image.extent.width; ++x)
            for (int channel = 0; channel < channels; ++channel) {
                const float value = channelOrZero(image, x, y, channel);
                undefined |= std::isnan(value);
                const float shown = std::isnan(value) ? 0.0f : std::clamp(value, 0.0f, 1.0f);
                rows.push_back(static_cast<unsigned char>(std::lround(shown * 255.0f)));
            }
    std::string bytes;
    if (!stbi_write_png_to_func(appendBytes, &bytes, image.extent.width, image.extent.height,
                                channels, rows.data(), image.extent.width * channels))
        return cannotWrite(path, "there is not enough memory");
    Status status = writeFile(path, bytes);
    if (!status || !undefined) return status;
    return asWarning({Code::not_finite, "'" + path + "' has pixels that are not a number",
                      "they are written as 0; PFM keeps them"});
}

std::string pfmBytes(const Image& image)
{
    const int channels = image.channels == 1 ? 1 : 3;
    std::string bytes = channels == 1 ? "Pf\n" : "PF\n";
    bytes += std::to_string(image.extent.width) + " " + std::to_string(image.extent.height);
    bytes += "\n-1.0\n";
    for (int y = 0; y < image.extent.height; ++y)
        for (int x = 0; x < image.extent.width; ++x)
            for (int channel = 0; channel < channels; ++channel)
                appendFloat(bytes, channelOrZero(image, x, y, channel));
    return bytes;
}

Status writePfm(const std::string& path, const Image& image)
{
    Status status = checkPixels(path, image);
    return status ? writeFile(path, pfmBytes(image)) : status;
}

Status writeImage(const std::string& path, const Image& image)
{
    const std::string extension = lowerExtension(path);
    if (extension == ".exr") {
        Status status = checkPixels(path, image);
        return status ? writeFile(path, exrBytes(image)) : status;
    }
    if (extension == ".png") return writePng(path, image);
    if (extension == ".pfm") return writePfm(path, image);
    return Diagnostic{Code::usage, "'" + path + "' names no kind of image that can be written",
                      "end the name in .png for a picture, in .pfm or .exr for floats"};
}

Result<Image> readImage(const std::string& path, double most_pixels)
{
    const FileBytes file = readBytes(path, kMaxImageBytes);
    if (!file)
        return brokenImage(
            path, file.failure,
            suggestName(path, filesBeside(path, path, lowerExtension(path)), "files there"));
    return decodeImage(file.bytes, path, most_pixels);
}

Result<Image> decodeImage(std::string_view bytes, const std::string& name, double most_pixels)
{
    if (bytes.empty()) return brokenImage(name, "it is empty");
    if (isPfm(bytes)) return decodePfm(bytes, name);
    if (isExr(bytes)) return decodeExrFile(bytes, name, most_pixels);
    if (bytes.substr(1, 3) == "KTX")
        return brokenImage(name, "KTX textures are not read",
                           "convert it: 'gltf-transform ktxdecompress in.glb out.glb'");
    return isWebp(bytes) ? decodeWebp(bytes, name, most_pixels)
                         : decodeByStb(bytes, name, most_pixels);
}

}  // namespace crevice
