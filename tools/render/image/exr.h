// SPDX-License-Identifier: MIT
// OpenEXR in memory: one part, one channel or red, green, blue and perhaps alpha.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/image.h>

namespace crevice {

bool isExr(std::string_view bytes);

struct ExrInfo {
    Extent extent;
    int channels = 0;     ///< 1 or 4.
    std::string failure;  ///< Why it cannot be read; empty where it may.
};

ExrInfo exrInfo(std::string_view bytes);

/// By what `exrInfo` said of it. Errors: CV7005, whose message is the reason alone.
Result<Image> decodeExr(std::string_view bytes, const ExrInfo& info);

/// 32-bit floats of 1, 3 or 4 channels (2 get a third of 0). Requires pixels.
std::string exrBytes(const Image& image);

}  // namespace crevice
