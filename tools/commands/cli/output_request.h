// SPDX-License-Identifier: MIT
// What `crevice render --out NAME=FILE` asks for: an output, a debug view or any target, in a file.
#pragma once

#include <crevice/diagnostic.h>

namespace crevice {

struct OutputRequest {
    std::string name;
    std::string file;  ///< Ends in .png or .pfm.
};

/// Reads "color=lit.png". Errors: CV8001 where the '=' or either side is missing, or the file is
/// neither PNG nor PFM.
Result<OutputRequest> parseOutputRequest(const std::string& text);

/// The file of a frame, [0, ...): "frame_%03d.png" gives "frame_007.png". `pattern` is one that
/// checkFramePattern accepts.
std::string frameFile(const std::string& pattern, int frame);

/// Errors: CV8001 for a file without one place for the frame's number, written %d or %03d.
Status checkFramePattern(const std::string& file);

/// Checks that a file can be written, before any work is done.
/// Errors: CV7007 for a folder that does not exist or is not writable, and for a file that is a
/// folder.
Status checkWritable(const std::string& file);

}  // namespace crevice
