// SPDX-License-Identifier: MIT
// Files on disk: reading them, and which of them a config may name.
#pragma once

#include <crevice/diagnostic.h>

#include <limits>

namespace crevice {

/// What reading a file gave.
struct FileBytes {
    std::string bytes;
    std::string failure = {};  ///< Why there are none: "it is a folder"; empty when it was read.
    bool missing = false;      ///< The failure is that there is no such file.

    explicit operator bool() const { return failure.empty(); }
};

/// A whole regular file. Devices, pipes and sockets are not opened, since they may have no end;
/// larger files than `limit` bytes are not read.
FileBytes readBytes(const std::string& path, std::size_t limit);

/// The first `count` bytes of a regular file of any size.
FileBytes readStart(const std::string& path, std::size_t count);

/// Of what was not read: "does not exist", or "cannot be read: it is a folder".
std::string absenceOf(const std::string& path);

/// Regular files with one of the endings in the folder and those below it, down to `depth`, as seen
/// from it; of `most` entries at most.
std::vector<std::string> filesBelow(const std::string& folder,
                                    const std::vector<std::string_view>& endings, int depth = -1,
                                    int most = std::numeric_limits<int>::max());

/// Regular files in the folder of `path` and in those right below it whose names end in `ending`,
/// for a suggestion: few of many. Each is named from where `written` is, as somebody wrote `path`.
std::vector<std::string> filesBeside(const std::string& path, const std::string& written,
                                     std::string_view ending);

/// True when the file at `path` is, or would be, below one of the folders, which are seen from the
/// current folder. A link counts as where it leads, for both.
bool isBelow(const std::string& path, const std::vector<std::string>& folders);

/// What to write for a name that an editor of Windows gave: "paths have '/'", with the path where
/// such a file is. Empty for one without a backslash, or what JSON makes of "\t" and the like.
std::string slashed(const SourceText& by, std::string_view name);

/// Whether the text `by` may have the file at `path` read. Errors: CV1204, without a place, for one
/// that lies below none of the text's roots; whether it exists is not looked at.
Status mayName(const SourceText& by, const std::string& path);

/// Reads the file at `path`, which the text `by` names, for decode and loadConfig: its name is
/// `path`, its roots are those of `by`. Null where there is none or it cannot be read. One of more
/// than kMaxDocumentBytes is cut one byte behind that, for whoever parses it to refuse.
///
/// Errors: those of mayName.
Result<SourceRef> openNamed(const SourceText& by, const std::string& path);

}  // namespace crevice
