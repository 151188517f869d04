// SPDX-License-Identifier: MIT
// OpenEXR, by tinyexr. Rows run from the top down in it.
#include "tools/render/image/exr.h"

#include <tinyexr.h>

#include <cstdlib>
#include <memory>

namespace crevice {
namespace {

struct Header : EXRHeader {
    Header() { InitEXRHeader(this); }
    ~Header() { FreeEXRHeader(this); }
};

std::string reasonOf(const char* error)
{
    const std::string reason = error ? error : "it is no EXR of one part";
    if (error) FreeEXRErrorMessage(error);
    return reason;
}

}  // namespace

bool isExr(std::string_view bytes) { return bytes.substr(0, 4) == "\x76\x2f\x31\x01"; }

ExrInfo exrInfo(std::string_view bytes)
{
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
    EXRVersion version;
    Header header;
    const char* error = nullptr;
    if (ParseEXRVersionFromMemory(&version, data, bytes.size()) != TINYEXR_SUCCESS ||
        version.multipart || version.non_image ||
        ParseEXRHeaderFromMemory(&header, &version, data, bytes.size(), &error) != TINYEXR_SUCCESS)
        return {{}, 0, reasonOf(error)};
    const EXRBox2i& box = header.data_window;
    return {{box.max_x - box.min_x + 1, box.max_y - box.min_y + 1},
            header.num_channels == 1 ? 1 : 4,
            {}};
}

Result<Image> decodeExr(std::string_view bytes, const ExrInfo& info)
{
    float* rows = nullptr;
    const char* error = nullptr;
    Image image(info.extent, info.channels);
    int width = 0, height = 0;
    const int read = LoadEXRFromMemory(&rows, &width, &height,
                                       reinterpret_cast<const unsigned char*>(bytes.data()),
                                       bytes.size(), &error);
    const std::unique_ptr<float, void (*)(void*)> owner(rows, std::free);
    if (read != TINYEXR_SUCCESS || Extent{width, height} != info.extent)
        return Diagnostic{Code::image_broken, reasonOf(error)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < info.channels; ++channel)
                image.at(x, height - 1 - y, channel) =
                    rows[4 * (static_cast<std::size_t>(y) * width + x) + channel];
    return image;
}

std::string exrBytes(const Image& image)
{
    const int count = image.channels == 2 ? 3 : image.channels;
    const char* const names = count == 1 ? "Y" : count == 3 ? "BGR" : "ABGR";  // as files sort them
    std::vector<std::vector<float>> planes(static_cast<std::size_t>(count));
    std::vector<unsigned char*> images;
    std::vector<EXRChannelInfo> channels(planes.size());
    std::vector<int> types(planes.size(), TINYEXR_PIXELTYPE_FLOAT);
    for (int k = 0; k < count; ++k) {
        const int channel = count == 1 ? 0 : count - 1 - k;
        std::vector<float>& plane = planes[static_cast<std::size_t>(k)];
        for (int y = image.extent.height - 1; y >= 0; --y)
            for (int x = 0; x < image.extent.width; ++x)
                plane.push_back(channel < image.channels ? image.at(x, y, channel) : 0.0f);
        images.push_back(reinterpret_cast<unsigned char*>(plane.data()));
        channels[static_cast<std::size_t>(k)].name[0] = names[k];
    }
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = count;
    header.channels = channels.data();
    header.pixel_types = header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage exr;
    InitEXRImage(&exr);
    exr.num_channels = count;
    exr.width = image.extent.width;
    exr.height = image.extent.height;
    exr.images = images.data();
    unsigned char* memory = nullptr;
    const char* error = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&exr, &header, &memory, &error);
    const std::unique_ptr<unsigned char, void (*)(void*)> owner(memory, std::free);
    if (error) FreeEXRErrorMessage(error);
    return {reinterpret_cast<const char*>(memory), size};
}

}  // namespace crevice
