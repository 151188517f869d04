// SPDX-License-Identifier: MIT
// Holding a cell of a matrix against its checks.
#include "tools/measure/matrix/run.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/bench/measure.h"
#include "tools/measure/line_file.h"
#include "tools/measure/matrix/stage.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"
#include "tools/show/plan/print.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace fs = std::filesystem;

namespace crevice {
namespace {

constexpr int kTurns = 7;         // timed, at least; as crevice bench
constexpr int kMostPatience = 4;  // times as many, settled or not

/// Half a step of 8 bits: what a picture of 8 bits is off by.
constexpr double kHalfStep = 0.5 / 255;

/// Truth above this is open.
constexpr float kOpenTruth = 0.99f;

void judged(bool passed, std::string text, CheckResult& result)
{
    result.state = passed ? "passed" : "failed";
    result.text = std::move(text);
}

std::string percent(double share) { return significant(share * 100, 3) + " %"; }

std::string partText(long long count, long long of)
{
    return std::to_string(count) + " of " + std::to_string(of);
}

/// As a PNG keeps it.
Image inSteps(Image image)
{
    for (float& value : image.pixels)
        if (std::isfinite(value)) value = std::round(std::clamp(value, 0.0f, 1.0f) * 255) / 255;
    return image;
}

/// By each limit that the check has.
Status compare(const MatrixCheck& check, const Image& got, const Image& wanted, CheckResult& result)
{
    const double max = check.has("max") ? check["max"] : 1.0;
    const auto figures = compareImages(got, wanted, nullptr, max, false);
    if (!figures) return figures.diagnostics();
    if (figures->non_finite > 0) {
        const long long all = figures->pixels + figures->non_finite;
        judged(false, partText(figures->non_finite, all) + " pixels are not finite", result);
        return {};
    }
    std::vector<std::string> texts;
    bool passed = true;
    if (check.has("max")) {
        passed = figures->bad_fraction <= check["share"];
        texts.push_back(percent(figures->bad_fraction) + " of pixels are off by more than " +
                        shortest(max) + " (most: " + significant(figures->max, 4) + "), at most " +
                        percent(check["share"]));
    }
    const auto hold = [&](const char* name, double value) {
        passed &= std::abs(value) <= check[name];
        texts.push_back(std::string(name) + " is " + significant(value, 4) + ", at most " +
                        shortest(check[name]));
    };
    if (check.has("flip")) hold("flip", meanFlip(got, wanted));
    if (check.has("rmse")) hold("rmse", figures->rmse);
    if (check.has("bias")) hold("bias", figures->bias);
    judged(passed, joined(texts, "; "), result);
    return {};
}

/// With --approve: what becomes of the approved file.
void approve(bool there, bool same, const std::string& file, CheckResult& result)
{
    result.state = same ? "unchanged" : there ? "changed" : "new";
    result.text = file + (result.text.empty() || !there ? "" : ": " + result.text);
}

/// The first line that differs, of both.
std::string firstDifference(const std::string& got, const std::string& wanted)
{
    const auto last = std::max(split(got, '\n').size(), split(wanted, '\n').size());
    int line = 1;
    while (line < static_cast<int>(last) && lineOf(got, line) == lineOf(wanted, line)) ++line;
    return "line " + std::to_string(line) + " is '" + std::string(trimmed(lineOf(got, line))) +
           "', was '" + std::string(trimmed(lineOf(wanted, line))) + "'";
}

std::string noFile(const std::string& file)
{
    return "there is no '" + file + "': run with --approve to write it";
}

/// The plan and the options must outlive it.
class CellChecker {
public:
    CellChecker(const MatrixPlan& plan, const RunMatrixOptions& options)
        : plan_(plan),
          options_(options),
          stage_(plan)
    {
        for (const std::size_t cell : plan.cells)
            for (const std::size_t check : plan.matrix.cells[cell].checks)
                owners_.emplace(
                    approvedFile(plan.matrix, plan.matrix.cells[cell], plan.matrix.checks[check]),
                    cell);
    }

    Result<std::vector<CheckResult>> check(std::size_t index, bool times)
    {
        const MatrixCell& cell = plan_.matrix.cells[index];
        std::vector<CheckResult> results;
        for (const std::size_t i : cell.checks) {
            const MatrixCheck& check = plan_.matrix.checks[i];
            if ((check.kind == CheckKind::time) != times) continue;
            if (options_.approve && (!check.isApproved() ||
                                     owners_.at(approvedFile(plan_.matrix, cell, check)) != index))
                continue;
            CheckResult result{i, check.title};
            const double begin_s = clockSeconds();
            if (const Status done = judge(cell, check, result); !done) {
                if (firstError(done.diagnostics()).code == Code::cannot_write)
                    return done.diagnostics();
                judged(false, failureText(done.diagnostics()), result);
            }
            result.time_s = clockSeconds() - begin_s;
            results.push_back(std::move(result));
        }
        return results;
    }

private:
    Status judge(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
    {
        for (const MatrixChoice& choice : {cell.choice, otherChoice(check, cell.choice)}) {
            const Diagnostics& lacks = stage_.failureOf(choice);
            if (lacks.empty()) continue;
            result.state = options_.require_backends ? "failed" : "skipped";
            result.text = failureText(lacks);
            return {};
        }
        switch (check.kind) {
        case CheckKind::plan: return judgePlan(cell, check, result);
        case CheckKind::time: return judgeTime(cell, check, result);
        default: return judgePicture(cell, check, result);
        }
    }

    Status judgePlan(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
    {
        const Result<std::string> plan = stage_.planText(cell.choice, check.output);
        if (!plan) return plan.diagnostics();
        const std::string file = approvedFile(plan_.matrix, cell, check);
        const FileBytes known = readBytes(file, kMaxApproved);
        const bool same = known && known.bytes == *plan;
        if (options_.approve) {
            approve(bool(known), same, file, result);
            return same ? Status() : writeFile(file, *plan);
        }
        judged(same,
               !known ? noFile(file)
               : same ? "as '" + file + "'"
                      : firstDifference(*plan, known.bytes),
               result);
        return {};
    }

    Status judgeTime(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
    {
        const MatrixChoice other_choice = otherChoice(check, cell.choice);
        const auto prepare = [&](const MatrixChoice& choice) {
            const MatrixSubject& subject = *plan_.shots.at(choice).subject;
            return stage_.prepare(choice, {subject.sources.at(check.output).output});
        };
        const Result<PreparedChoice> own = prepare(cell.choice), other = prepare(other_choice);
        for (const Result<PreparedChoice>* each : {&own, &other})
            if (!*each) return each->diagnostics();
        TurnTaker turns(*own->drawn.renderer, own->drawn.frame),
            units(*other->drawn.renderer, other->drawn.frame);
        Turns both(turns, &units, kTurns, kMostPatience * kTurns);
        const Status taken = both.take(interrupted, [&](const TurnTaker& next) {
            return (&next == &turns ? own : other)->open->context->makeCurrent();
        });
        if (!taken) return taken;
        const TimeFigures ratio = ratioFigures(turns.costs(), units.costs());
        judged(ratio.median > 0 && ratio.median <= check["most"],
               "takes " + significant(ratio.median, 3) + " times as long as '" +
                   cellName(plan_.matrix, other_choice) + "', at most " + shortest(check["most"]),
               result);
        return {};
    }

    Status judgePicture(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
    {
        const MatrixChoice other = otherChoice(check, cell.choice);
        const auto pictures = stage_.pictures(cell.choice);
        if (!pictures) return pictures.diagnostics();
        const Image& got = pictures->at(check.output);
        if (check.kind == CheckKind::approved) return judgeApproved(cell, check, got, result);
        if (check.kind >= CheckKind::finite) return judgeValues(cell, check, got, result);
        Result<Image> wanted = Image();
        if (check.kind == CheckKind::truth) {
            wanted =
                stage_.truth(cell.choice, static_cast<int>(check["rays"]), options_.cache_folder);
        } else {
            const auto others = stage_.pictures(other);
            if (!others) return others.diagnostics();
            wanted = others->at(check.output);
        }
        if (!wanted) return wanted.diagnostics();
        if (const Status compared = compare(check, got, *wanted, result); !compared)
            return compared;
        if (check.kind == CheckKind::same)
            result.text = "as '" + cellName(plan_.matrix, other) + "': " + result.text;
        return keepPictures(cell, got, &*wanted, result);
    }

    Status judgeApproved(const MatrixCell& cell, const MatrixCheck& check, Image got,
                         CheckResult& result)
    {
        const std::string file = approvedFile(plan_.matrix, cell, check);
        if (plan_.matrix.approved_format == "png") got = inSteps(std::move(got));
        std::error_code unknown;
        const bool there = fs::exists(file, unknown);
        Image wanted;
        if (there) {
            Result<Image> read = readImage(file);
            if (read) wanted = std::move(*read);
            const Status compared = read ? compare(check, got, wanted, result) : read.diagnostics();
            if (!compared && !options_.approve) return compared;
            if (!compared) result.state = "failed";  // broken or of another size
        } else {
            judged(false, noFile(file), result);
        }
        if (options_.approve) {
            const bool same = result.state == "passed";
            approve(there, same, file, result);
            if (!same)
                if (const Status written = writeImage(file, got); !written) return written;
        }
        return keepPictures(cell, got, there ? &wanted : nullptr, result);
    }

    /// Values that must lie in a range, some of them everywhere and some of them where a mask is.
    Status judgeValues(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                       CheckResult& result)
    {
        double low = std::numeric_limits<float>::lowest(), high = std::numeric_limits<float>::max();
        Result<Image> mask = Image(got.extent, 1, 1.0f);
        std::string where, outside = "not finite";
        if (check.kind == CheckKind::range) {
            low = check["low"];
            high = check["high"];
            outside = "outside [" + shortest(low) + ", " + shortest(high) + "]";
        } else if (check.kind == CheckKind::background) {
            mask = stage_.background(cell.choice);
            low = check["value"] - kHalfStep;
            high = check["value"] + kHalfStep;
            where = " where no surface is";
            outside = "not " + shortest(check["value"]);
        } else if (check.kind == CheckKind::open) {
            mask =
                stage_.truth(cell.choice, static_cast<int>(check["rays"]), options_.cache_folder);
            low = check["least"];
            where = " where all is open";
            outside = "below " + shortest(low);
        }
        if (!mask) return mask.diagnostics();
        long long count = 0, bad = 0;
        float least = std::numeric_limits<float>::max(), most = -least;
        // Behind the first channel others may hold anything, such as a depth.
        const std::size_t step = where.empty() ? 1 : got.channels;
        for (std::size_t i = 0; i < got.pixels.size(); i += step) {
            if (!(mask->pixels[i / got.channels] > kOpenTruth)) continue;
            ++count;
            bad += !(got.pixels[i] >= low && got.pixels[i] <= high);
            least = std::min(least, got.pixels[i]);
            most = std::max(most, got.pixels[i]);
        }
        const double share = check.has("share") ? check["share"] : 0;
        judged(count > 0 && bad <= share * static_cast<double>(count),
               count == 0 ? "there is no pixel" + where
                          : partText(bad, count) + " values" + where + " are " + outside +
                                (share > 0 ? ", at most " + percent(share) : "") + "; they are " +
                                significant(least, 3) + " to " + significant(most, 3),
               result);
        return keepPictures(cell, got, nullptr, result);
    }

    /// The picture, once for an output, and of what did not pass what it is compared with.
    Status keepPictures(const MatrixCell& cell, const Image& got, const Image* wanted,
                        CheckResult& result)
    {
        const bool passed = result.state == "passed" || result.state == "unchanged";
        const MatrixCheck& check = plan_.matrix.checks[result.check];
        const std::string base = "pictures/" + cell.file + "." + check.output + ".";
        const auto keep = [&](const std::string& name, const Image& image, std::string& file) {
            file = base + name + "png";
            if (!kept_.insert(file).second) return Status();
            return writeImage(options_.out_folder + "/" + file, image);
        };
        if (const Status kept = keep("", got, result.got); !kept || passed || !wanted) return kept;
        const std::string number = std::to_string(result.check + 1) + ".";
        Image shown = *wanted;
        for (float& value : shown.pixels)
            if (std::isnan(value)) value = 1;  // the background of a ground truth
        if (const Status kept = keep(number + "wanted.", shown, result.wanted); !kept) return kept;
        const Result<Image> difference = differencePicture(got, *wanted);
        return difference ? keep(number + "difference.", *difference, result.difference) : Status();
    }

    const MatrixPlan& plan_;
    const RunMatrixOptions& options_;
    MatrixStage stage_;
    std::set<std::string> kept_;                 ///< Pictures that are written.
    std::map<std::string, std::size_t> owners_;  ///< The cell that approves a file: its first.
};

}  // namespace

CheckCell cellChecker(const MatrixPlan& plan, const RunMatrixOptions& options)
{
    const auto checker = std::make_shared<CellChecker>(plan, options);
    return [checker](std::size_t cell, bool times) { return checker->check(cell, times); };
}

}  // namespace crevice
