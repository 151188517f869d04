// SPDX-License-Identifier: MIT
// A folder of linked programs, a file for each, named by its key: what --program-cache names.
#pragma once

#include <crevice/gl_device.h>

namespace crevice {

class ProgramFolder {
public:
    /// Makes the folder where it is not there. Errors: CV7007 when it cannot be written.
    static Result<std::unique_ptr<ProgramFolder>> open(const std::string& path);

    ProgramFolder(const ProgramFolder&) = delete;

    /// For a device that does not outlive this.
    ProgramCache cache();

    int asked() const { return asked_; }            ///< Programs that were wanted so far.
    int found() const { return asked_ - stored_; }  ///< Those not compiled and stored again.

    /// That a program could not be written; once, however many.
    const Diagnostics& warnings() const { return warnings_; }

private:
    explicit ProgramFolder(std::string path) : path_(std::move(path)) {}

    std::string path_;
    int asked_ = 0;
    int stored_ = 0;
    Diagnostics warnings_;
};

}  // namespace crevice
