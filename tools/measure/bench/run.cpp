// SPDX-License-Identifier: MIT
// The loop over the samples of a bench.
#include "tools/measure/bench/run.h"

#include "core/base/content_hash.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace crevice {
namespace {

std::string figuresText(const BenchSample& sample)
{
    const std::string text = "rmse " + fixed(sample.error.rmse, 4) + ", " +
                             fixed(sample.total.median, 2) + " ms, " +
                             fixed(sample.ratio_learnopengl, 2) + " x learnopengl";
    return sample.motion_failure.empty() ? text : text + ", no motion: " + sample.motion_failure;
}

std::string timeText(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string((whole + 59) / 60) + " min";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

class Run {
public:
    Run(const BenchPlan& plan, BenchFile& file, const MeasureWorld& world)
        : file_(file.lines),
          world_(world),
          start_(world.seconds())
    {
        for (const BenchTask& task : plan.tasks) {
            if (file.done.count(keyOnDevice(task.sample.key, world.device)) > 0)
                ++summary_.kept;
            else
                todo_.push_back(&task);
        }
    }

    MeasureSummary run()
    {
        std::size_t next = 0;
        while (next < todo_.size() && !mustStop() && measureOne(next)) ++next;
        for (; next < todo_.size(); ++next)
            summary_.missing.push_back(sampleTitle(todo_[next]->sample));
        return std::move(summary_);
    }

private:
    double elapsed() const { return world_.seconds() - start_; }

    bool mustStop()
    {
        summary_.interrupted = world_.interrupted();
        const bool spent = world_.time_budget_s > 0 && elapsed() >= world_.time_budget_s;
        return summary_.interrupted || spent;
    }

    /// False when the run must end before this sample has its line.
    bool measureOne(std::size_t place)
    {
        const BenchTask& task = *todo_[place];
        if (!task.sample.failure.empty()) return fail(place, task.sample.failure);
        world_.begin(sampleTitle(task.sample));
        const Result<BenchSample> sample = world_.measure(task);
        summary_.interrupted = world_.interrupted();
        if (summary_.interrupted) return false;
        warn(sample.diagnostics());
        if (sample) {
            if (!write(place, *sample)) return false;
            ++summary_.measured;
            printProgress(place, figuresText(*sample));
            return true;
        }
        Diagnostic error = firstError(sample.diagnostics());
        if (error.code != Code::cannot_write) return fail(place, failureText({error}));
        error.help = LineFile::wayOut();
        summary_.written = error;
        return false;
    }

    bool fail(std::size_t place, const std::string& failure)
    {
        BenchSample sample = todo_[place]->sample;
        sample.failure = failure;
        if (!write(place, std::move(sample))) return false;
        summary_.failures.push_back(sampleTitle(todo_[place]->sample) + ": " + failure);
        printProgress(place, "failed: " + failure);
        return true;
    }

    /// A failure has its device, too, so that figures can take its place.
    bool write(std::size_t place, BenchSample sample)
    {
        sample.key = keyOnDevice(todo_[place]->sample.key, world_.device);
        sample.device = world_.device;
        summary_.written = file_.append(toJsonLine(sample));
        return summary_.written.ok();
    }

    /// Once each.
    void warn(const Diagnostics& diagnostics)
    {
        for (const Diagnostic& each : diagnostics) {
            if (each.severity != Severity::warning) continue;
            std::string text = toText(each);
            text.pop_back();  // say() ends the line
            if (warnings_.insert(text).second) world_.say(text);
        }
    }

    void printProgress(std::size_t place, const std::string& outcome) const
    {
        const std::size_t done = place + 1;
        const std::size_t left = todo_.size() - done;
        std::string line = "[" + std::to_string(done) + "/" + std::to_string(todo_.size()) + "] " +
                           sampleTitle(todo_[place]->sample) + ": " + outcome;
        const double each = elapsed() / static_cast<double>(done);
        if (left > 0) line += "; about " + timeText(each * static_cast<double>(left)) + " left";
        world_.say(line);
    }

    LineFile& file_;
    const MeasureWorld& world_;
    const double start_;
    std::vector<const BenchTask*> todo_;
    std::set<std::string> warnings_;
    MeasureSummary summary_;
};

constexpr std::size_t kTitlesShown = 20;

void printNamed(const char* what, const std::vector<std::string>& titles)
{
    for (std::size_t i = 0; i < titles.size() && i < kTitlesShown; ++i)
        printMessage("%s: %s\n", what, titles[i].c_str());
    if (titles.size() > kTitlesShown)
        printMessage("%s: %zu more\n", what, titles.size() - kTitlesShown);
}

void printSummary(const MeasureSummary& summary, const std::string& file)
{
    printNamed("failed", summary.failures);
    printNamed("missing", summary.missing);
    printMessage("%d measured, %d were there already, %zu failed, %zu not begun: %s\n",
                 summary.measured, summary.kept, summary.failures.size(), summary.missing.size(),
                 file.c_str());
    if (!summary.missing.empty() || !summary.failures.empty())
        printMessage("run the same command again to measure the rest\n");
}

}  // namespace

Result<BenchFile> openBench(const std::string& folder)
{
    Result<LineFile> lines = LineFile::open(folder + "/results.jsonl");
    if (!lines) return lines.diagnostics();
    const Result<std::vector<BenchSample>> known = readBenchSamples({lines->path()});
    if (!known) return known.diagnostics();
    BenchFile file{std::move(*lines), {}};
    for (const BenchSample& sample : *known)
        if (sample.failure.empty()) file.done.insert(sample.key);
    return file;
}

MeasureSummary measureAll(const BenchPlan& plan, BenchFile& file, const MeasureWorld& world)
{
    return Run(plan, file, world).run();
}

std::string keyOnDevice(const std::string& key, const std::string& device)
{
    ContentHash hash;
    hash.addText(key);
    hash.addText(device);
    return hash.hex();
}

void addRunOptions(CLI::App& app, RunOptions& options)
{
    app.add_option("--time-budget", options.time_budget,
                   "Begin no bench sample after this time: 90s, 5m, 1.5h");
    addText(app, "--out", options.out, "FOLDER",
            "Folder for results.jsonl and pictures; what is there already is not measured "
            "again");
}

Result<double> timeBudgetOf(const RunOptions& options)
{
    if (options.time_budget.empty()) return 0.0;
    std::string_view unit = options.time_budget;
    const double number = takeNumber(unit).value_or(0.0);
    const double factor = unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
    const double seconds = number * factor;
    if (seconds > 0.0 && std::isfinite(seconds)) return seconds;
    return Diagnostic{Code::usage,
                      "'" + options.time_budget + "' is not a time above 0 with its unit",
                      "write --time-budget 90s, 5m or 1.5h"};
}

MeasureSummary measureOnConsole(const BenchPlan& plan, BenchFile& file, MeasureWorld world,
                                Progress& progress)
{
    world.seconds = clockSeconds;
    world.interrupted = interrupted;
    world.begin = [&progress](const std::string& title) { progress.begin("measuring " + title); };
    world.say = [&progress](const std::string& line) {
        progress.wipe();
        printMessage("%s\n", printableLine(line).c_str());
    };
    catchInterrupts();
    MeasureSummary summary = measureAll(plan, file, world);
    progress.wipe();
    report(summary.written.diagnostics(), false);
    printSummary(summary, file.lines.path());
    return summary;
}

int exitCodeOf(const MeasureSummary& summary)
{
    if (!summary.written) return exitCodeOf(summary.written.diagnostics());
    if (summary.interrupted) return kExitInterrupted;
    return summary.failures.empty() ? kExitOk : kExitBadInput;
}

}  // namespace crevice
