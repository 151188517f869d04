// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/check.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/measure/bench/measure.h"
#include "tools/measure/line_file.h"
#include "tools/render/image/flip.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"
#include "tools/show/plan/print.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

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

std::string pixelsText(long long count, long long of)
{
    return std::to_string(count) + " of " + std::to_string(of) + " pixels";
}

/// As a PNG keeps it.
Image inSteps(Image image)
{
    for (float& value : image.pixels)
        value =
            std::isfinite(value) ? std::round(std::clamp(value, 0.0f, 1.0f) * 255) / 255 : value;
    return image;
}

long long countNonFinite(const Image& image)
{
    return std::count_if(image.pixels.begin(), image.pixels.end(),
                         [](float value) { return !std::isfinite(value); });
}

/// By `max` and `share`, or by `flip`.
Status judgeDifference(const MatrixCheck& check, const Image& got, const Image& wanted,
                       CheckResult& result)
{
    const double max = check.has("max") ? check["max"] : 1.0;
    const auto figures = compareImages(got, wanted, nullptr, max, false);
    if (!figures) return figures.diagnostics();
    const long long all = figures->pixels + figures->non_finite;
    if (figures->non_finite > 0) {
        judged(false, pixelsText(figures->non_finite, all) + " are not finite", result);
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
    if (check.has("flip")) {
        const double flip = meanFlip(got, wanted);
        passed &= flip <= check["flip"];
        texts.push_back("FLIP is " + significant(flip, 4) + ", at most " + shortest(check["flip"]));
    }
    judged(passed, joined(texts, "; "), result);
    return {};
}

/// The first line that differs, of both.
std::string firstDifference(const std::string& got, const std::string& wanted)
{
    int line = 1;
    while (lineOf(got, line) == lineOf(wanted, line)) ++line;
    return "line " + std::to_string(line) + " is '" + std::string(trimmed(lineOf(got, line))) +
           "', was '" + std::string(trimmed(lineOf(wanted, line))) + "'";
}

}  // namespace

CellChecker::CellChecker(const MatrixPlan& plan, CheckOptions options)
    : plan_(plan),
      options_(std::move(options)),
      stage_(plan, options_.cache_folder)
{
    for (const std::size_t cell : plan.cells)
        for (const std::size_t check : plan.matrix.cells[cell].checks)
            owners_.emplace(
                approvedFile(plan.matrix, plan.matrix.cells[cell], plan.matrix.checks[check]),
                cell);
}

Result<std::vector<CheckResult>> CellChecker::check(std::size_t index, bool times)
{
    const MatrixCell& cell = plan_.matrix.cells[index];
    std::vector<CheckResult> results;
    for (const std::size_t i : cell.checks) {
        const MatrixCheck& check = plan_.matrix.checks[i];
        if ((check.kind == CheckKind::time) != times) continue;
        if (options_.approve &&
            (!check.isApproved() || owners_.at(approvedFile(plan_.matrix, cell, check)) != index))
            continue;
        CheckResult result{i, check.title()};
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

Status CellChecker::judge(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
{
    for (const MatrixChoice& choice : {cell.choice, otherChoice(check, cell.choice)}) {
        const Diagnostics& lacks = stage_.failureOf(plan_.matrix.value(choice, kBackendAxis).text);
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

Status CellChecker::judgePlan(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
{
    const Result<std::string> plan = stage_.planText(cell.choice, check.output);
    if (!plan) return plan.diagnostics();
    const std::string file = approvedFile(plan_.matrix, cell, check);
    const FileBytes known = readBytes(file, kMaxApproved);
    const bool same = known && known.bytes == *plan;
    if (options_.approve) {
        judged(true, file, result);
        result.state = same ? "unchanged" : known ? "changed" : "new";
        return same ? Status() : writeFile(file, *plan);
    }
    if (!known)
        judged(false, "there is no '" + file + "': run with --approve to write it", result);
    else
        judged(same, same ? "as '" + file + "'" : firstDifference(*plan, known.bytes), result);
    return {};
}

Status CellChecker::judgeTime(const MatrixCell& cell, const MatrixCheck& check, CheckResult& result)
{
    const auto prepare = [&](const MatrixChoice& choice) {
        return stage_.prepare(choice, {plan_.subject(choice).sources.at(check.output).output});
    };
    Result<PreparedChoice> own = prepare(cell.choice);
    if (!own) return own.diagnostics();
    Result<PreparedChoice> other = prepare(otherChoice(check, cell.choice));
    if (!other) return other.diagnostics();
    TurnTaker turns(*own->renderer, own->frame), units(*other->renderer, other->frame);
    const auto takeBoth = [&]() -> Status {
        if (const Status current = own->context->makeCurrent(); !current) return current;
        if (const Status taken = turns.takeTurn(); !taken) return taken;
        if (const Status current = other->context->makeCurrent(); !current) return current;
        return units.takeTurn();
    };
    if (const Status warm = takeBoth(); !warm) return warm;
    turns.restart();
    units.restart();
    TimeFigures ratio;
    for (int turn = 1; turn <= kMostPatience * kTurns && !interrupted(); ++turn) {
        if (const Status taken = takeBoth(); !taken) return taken;
        ratio = ratioFigures(turns.costs(), units.costs());
        const bool settled = medianMargin(ratio, turns.costs().size()) <= kSettledMargin;
        if (turn >= kTurns && settled) break;
    }
    judged(ratio.median > 0 && ratio.median <= check["most"],
           "takes " + significant(ratio.median, 3) + " times as long as '" +
               cellName(plan_.matrix, otherChoice(check, cell.choice)) + "', at most " +
               shortest(check["most"]),
           result);
    return {};
}

Status CellChecker::judgePicture(const MatrixCell& cell, const MatrixCheck& check,
                                 CheckResult& result)
{
    const auto pictures = stage_.pictures(cell.choice);
    if (!pictures) return pictures.diagnostics();
    const Image& got = pictures->at(check.output);
    switch (check.kind) {
    case CheckKind::approved: return judgeApproved(cell, check, got, result);
    case CheckKind::same: return judgeSame(cell, check, got, result);
    case CheckKind::truth: return judgeTruth(cell, check, got, result);
    default: return judgeProperty(cell, check, got, result);
    }
}

Status CellChecker::judgeApproved(const MatrixCell& cell, const MatrixCheck& check, Image got,
                                  CheckResult& result)
{
    const std::string file = approvedFile(plan_.matrix, cell, check);
    if (plan_.matrix.approved_format == "png") got = inSteps(std::move(got));
    std::error_code unknown;
    const bool there = fs::exists(file, unknown);
    Image wanted;
    if (there) {
        Result<Image> read = readImage(file);
        if (!read && !options_.approve) return read.diagnostics();
        if (read) wanted = std::move(*read);
        const Status compared = judgeDifference(check, got, wanted, result);
        if (!compared && !options_.approve) return compared;
        if (!compared) result.state = "failed";  // of another size
    } else {
        judged(false, "there is no '" + file + "': run with --approve to write it", result);
    }
    if (options_.approve) {
        const bool same = result.state == "passed";
        result.state = same ? "unchanged" : there ? "changed" : "new";
        result.text = file + (result.text.empty() || !there ? "" : ": " + result.text);
        if (!same)
            if (const Status written = writeImage(file, got); !written) return written;
    }
    return keepPictures(cell, got, there ? &wanted : nullptr, result);
}

Status CellChecker::judgeSame(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                              CheckResult& result)
{
    const auto others = stage_.pictures(otherChoice(check, cell.choice));
    if (!others) return others.diagnostics();
    const Image& wanted = others->at(check.output);
    if (const Status compared = judgeDifference(check, got, wanted, result); !compared)
        return compared;
    result.text =
        "as '" + cellName(plan_.matrix, otherChoice(check, cell.choice)) + "': " + result.text;
    return keepPictures(cell, got, &wanted, result);
}

Status CellChecker::judgeTruth(const MatrixCell& cell, const MatrixCheck& check, const Image& got,
                               CheckResult& result)
{
    const Result<Image> truth = stage_.truth(cell.choice, static_cast<int>(check["rays"]));
    if (!truth) return truth.diagnostics();
    const auto figures = compareImages(got, *truth, nullptr, 0.05, false);
    if (!figures) return figures.diagnostics();
    bool passed = figures->non_finite == 0;
    std::vector<std::string> texts;
    if (!passed) texts.push_back(std::to_string(figures->non_finite) + " pixels are not finite");
    for (const auto& [name, value] :
         {std::pair("rmse", figures->rmse), std::pair("bias", figures->bias)}) {
        if (!check.has(name)) continue;
        passed &= std::abs(value) <= check[name];
        texts.push_back(std::string(name) + " is " + significant(value, 4) + ", at most " +
                        shortest(check[name]));
    }
    judged(passed, joined(texts, "; "), result);
    return keepPictures(cell, got, &*truth, result);
}

Status CellChecker::judgeProperty(const MatrixCell& cell, const MatrixCheck& check,
                                  const Image& got, CheckResult& result)
{
    const long long all = static_cast<long long>(got.pixels.size());
    if (check.kind == CheckKind::finite) {
        const long long bad = countNonFinite(got);
        judged(bad == 0, pixelsText(bad, all) + " are not finite", result);
    } else if (check.kind == CheckKind::range) {
        const double low = check["low"], high = check["high"];
        const long long bad = std::count_if(got.pixels.begin(), got.pixels.end(),
                                            [&](float v) { return !(v >= low && v <= high); });
        judged(
            bad == 0,
            pixelsText(bad, all) + " are outside [" + shortest(low) + ", " + shortest(high) + "]",
            result);
    } else {
        const bool open = check.kind == CheckKind::open;
        const Result<Image> mask = open ? stage_.truth(cell.choice, static_cast<int>(check["rays"]))
                                        : stage_.background(cell.choice);
        if (!mask) return mask.diagnostics();
        long long count = 0, bad = 0;
        for (int y = 0; y < got.extent.height; ++y)
            for (int x = 0; x < got.extent.width; ++x) {
                const float value = got.at(x, y);
                if (!(mask->at(x, y) > kOpenTruth)) continue;
                ++count;
                bad += open ? !(value >= check["least"])
                            : !(std::abs(value - check["value"]) <= kHalfStep);
            }
        const double share = count > 0 ? static_cast<double>(bad) / static_cast<double>(count) : 1;
        if (count == 0)
            judged(false, open ? "no pixel is open" : "no pixel shows the background", result);
        else if (open)
            judged(share <= check["share"],
                   percent(share) + " of open pixels are below " + shortest(check["least"]) +
                       ", at most " + percent(check["share"]),
                   result);
        else
            judged(
                bad == 0,
                pixelsText(bad, count) + " without a surface are not " + shortest(check["value"]),
                result);
    }
    return keepPictures(cell, got, nullptr, result);
}

/// The picture, once for an output, and of what did not pass what it is compared with.
Status CellChecker::keepPictures(const MatrixCell& cell, const Image& got, const Image* wanted,
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

}  // namespace crevice
