// SPDX-License-Identifier: MIT
// Images on disk: PNG for pictures, PFM for float data. Rows run from the bottom up in memory and
// in PFM, from the top down in PNG.
//
// Every write goes to a temporary name in the same folder and is renamed when it is whole, so that
// no reader ever sees half a file.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/image.h>

#include <filesystem>

namespace crevice {

/// The file that a write to `path` makes or replaces: where links lead, also if nothing is there.
std::filesystem::path behindLinks(const std::string& path);

/// Writes all bytes to an open file. Zero, or the errno of what failed.
int writeAll(int file, std::string_view bytes);

/// Writes any bytes in that safe way. A file that is replaced keeps its mode, and its owner where
/// that is allowed; a link stays one.
/// Errors: CV7007 with the system's reason.
Status writeFile(const std::string& path, std::string_view bytes);

/// 8 bits a channel, for 1, 3 or 4 channels (2 get a blue of 0). Values are written as they are,
/// clamped to [0, 1]; those that are not a number become 0, with a warning CV4003.
/// Errors: CV7005 for an image without pixels, CV7007.
Status writePng(const std::string& path, const Image& image);

/// 32-bit floats, bit for bit, for 1 or 3 channels (2 get a third of 0; a fourth is left out).
/// Errors: CV7005 for an image without pixels, CV7007.
Status writePfm(const std::string& path, const Image& image);

/// What `writePfm` writes. Requires 1, 3 or 4 channels and all pixels.
std::string pfmBytes(const Image& image);

/// ".png" of "a/B.PNG"; empty where there is none.
std::string lowerExtension(const std::string& path);

/// By extension: ".png", ".pfm" or ".exr".
/// Errors: CV8001 for another extension, and those of the two above.
Status writeImage(const std::string& path, const Image& image);

/// Any file that stb_image reads (PNG, JPEG, TGA, BMP ...) or WebP, with values from 0 to 1 as they
/// were stored; or EXR, PFM or Radiance's .hdr, with light as it is. Channels are those of the
/// file. Errors: CV7005 when it is missing, broken or of more than `most_pixels`.
Result<Image> readImage(const std::string& path, double most_pixels = 1e12);

/// The same from memory; `name` is for messages.
Result<Image> decodeImage(std::string_view bytes, const std::string& name,
                          double most_pixels = 1e12);

}  // namespace crevice
