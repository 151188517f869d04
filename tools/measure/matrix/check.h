// SPDX-License-Identifier: MIT
// Holding a cell of a matrix against its checks.
#pragma once

#include "tools/measure/matrix/result.h"
#include "tools/measure/matrix/stage.h"

namespace crevice {

struct CheckOptions {
    std::string out_folder;         ///< Pictures go to its pictures/.
    std::string cache_folder = {};  ///< For ground truths; empty for none.
    bool approve = false;           ///< Write approved files instead of judging.
    bool require_backends = false;  ///< A backend that cannot be had is a failure.
};

/// The plan must outlive it.
class CellChecker {
public:
    CellChecker(const MatrixPlan& plan, CheckOptions options);

    /// Looks at the checks that time, or at all others, of a cell by its index. What cannot be
    /// drawn fails every check that needs it. Errors: CV7007 for pictures and approved files.
    Result<std::vector<CheckResult>> check(std::size_t cell, bool times);

private:
    Status judge(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result);
    Status judgePlan(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result);
    Status judgeTime(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result);
    Status judgePicture(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result);
    Status judgeApproved(const MatrixCell& cell, const MatrixCheck& check, Image got,
                         CheckResult& result);
    Status judgeSame(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                     CheckResult& result);
    Status judgeTruth(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                      CheckResult& result);
    Status judgeProperty(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                         CheckResult& result);
    Status keepPictures(const MatrixCell& cell, const Image& got, const Image* wanted,
                        CheckResult& result);

    const MatrixPlan& plan_;
    const CheckOptions options_;
    MatrixStage stage_;
    std::set<std::string> kept_;                 ///< Pictures that are written.
    std::map<std::string, std::size_t> owners_;  ///< The cell that approves a file: its first.
};

}  // namespace crevice
