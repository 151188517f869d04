// SPDX-License-Identifier: MIT
// The loop over a bench's points, and the file that they go to.
#include "tools/bench.h"

#include "tools/cli_output.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace crevice {
namespace {

const char* const kWayOut =
    "what was measured before is safe; make room or name another folder, and run the same command "
    "again to go on";

Diagnostic cannotWrite(const std::string& path, const std::string& reason)
{
    Diagnostic error{Code::cannot_write, "cannot write '" + path + "': " + reason};
    error.help = kWayOut;
    return error;
}

/// Lines in a file that no path leads to would be lost.
Diagnostic lostFile(const std::string& path)
{
    Diagnostic error = cannotWrite(path, "it was deleted or replaced meanwhile");
    error.help = "put it back and run the same command again to go on";
    return error;
}

/// False once the path is gone or leads to another file.
bool isNamed(int file, const std::string& path)
{
    struct stat open = {};
    struct stat named = {};
    return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// Cuts off what follows the last line feed. Zero, or the errno of what failed.
int cutTornLine(int file)
{
    off_t end = lseek(file, 0, SEEK_END);
    char last = '\n';
    while (end > 0 && pread(file, &last, 1, end - 1) == 1 && last != '\n') --end;
    return ftruncate(file, end) == 0 ? 0 : errno;
}

/// Zero, or the errno of what failed.
int writeAll(int file, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return fdatasync(file) == 0 || errno == EINVAL ? 0 : errno;
}

std::string timeText(double seconds)
{
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string((whole + 59) / 60) + " min";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

class Loop {
public:
    Loop(const std::vector<BenchTask>& tasks, ResultFile& file, const BenchWorld& world)
        : file_(file), world_(world), start_(world.seconds())
    {
        for (const BenchTask& task : tasks) {
            if (file.has(keyOnDevice(task.point.key, world.device))) ++summary_.kept;
            else todo_.push_back(&task);
        }
    }

    BenchSummary run()
    {
        std::size_t next = 0;
        while (next < todo_.size() && !mustStop() && measureOne(*todo_[next], next)) ++next;
        for (; next < todo_.size(); ++next)
            summary_.missing.push_back(pointTitle(todo_[next]->point));
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

    /// False when the run must end before this point has a line.
    bool measureOne(const BenchTask& task, std::size_t index)
    {
        BenchPoint point = task.point;
        if (point.failure.empty()) {
            Result<BenchPoint> measured = world_.measure(task);
            summary_.interrupted = world_.interrupted();
            if (summary_.interrupted) return false;
            if (!measured && firstError(measured.diagnostics()).code == Code::cannot_write) {
                Diagnostic error = firstError(measured.diagnostics());
                error.help = kWayOut;
                summary_.written = error;
                return false;
            }
            warn(measured.diagnostics());
            if (measured) point = std::move(*measured);
            else point.failure = failureText(measured.diagnostics());
        }
        point.key = keyOnDevice(task.point.key, world_.device);
        summary_.written = file_.append(point);
        if (!summary_.written) return false;
        if (point.failure.empty()) ++summary_.measured;
        else summary_.failures.push_back(pointTitle(point) + ": " + point.failure);
        tell(point, index + 1);
        return true;
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

    void tell(const BenchPoint& point, std::size_t done) const
    {
        std::string line = "[" + std::to_string(done) + "/" + std::to_string(todo_.size()) + "] " +
                           pointTitle(point) + ": ";
        if (point.failure.empty()) {
            char figures[64];
            std::snprintf(figures, sizeof(figures), "rmse %.4f, %.2f ms, %.2f x floor",
                          point.error.rmse, point.total.median, point.ratio_floor);
            line += figures;
        } else {
            line += "failed: " + point.failure;
        }
        const std::size_t left = todo_.size() - done;
        if (left > 0)
            line += "; about " +
                    timeText(elapsed() / static_cast<double>(done) * static_cast<double>(left)) +
                    " left";
        world_.say(line);
    }

    ResultFile& file_;
    const BenchWorld& world_;
    const double start_;
    std::vector<const BenchTask*> todo_;
    std::set<std::string> warnings_;
    BenchSummary summary_;
};

}  // namespace

Result<ResultFile> ResultFile::open(const std::string& folder)
{
    const std::string path = folder + "/results.jsonl";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return cannotWrite(folder, error.message());
    ResultFile results(path, ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (results.file_ < 0) return cannotWrite(path, std::strerror(errno));
    if (flock(results.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return cannotWrite(path, "another bench is writing to it");
    if (const int failure = cutTornLine(results.file_))
        return cannotWrite(path, std::strerror(failure));
    const Result<std::vector<BenchPoint>> points = readBenchPoints({path});
    if (!points) return points.diagnostics();
    for (const BenchPoint& point : *points)
        if (point.failure.empty()) results.done_.insert(point.key);
    return results;
}

ResultFile::~ResultFile()
{
    if (file_ >= 0) close(file_);
}

ResultFile::ResultFile(ResultFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      done_(std::move(other.done_))
{
}

Status ResultFile::append(const BenchPoint& point)
{
    if (!isNamed(file_, path_)) return lostFile(path_);
    const off_t before = lseek(file_, 0, SEEK_END);
    const int failure = writeAll(file_, toJsonLine(point) + "\n");
    if (failure == 0) {
        if (point.failure.empty()) done_.insert(point.key);
        return {};
    }
    // Where even this fails, the next run cuts the torn line off.
    if (ftruncate(file_, before) != 0) return cannotWrite(path_, "the disk fails");
    return cannotWrite(path_, std::strerror(failure));
}

BenchSummary runBench(const std::vector<BenchTask>& tasks, ResultFile& file,
                      const BenchWorld& world)
{
    return Loop(tasks, file, world).run();
}

}  // namespace crevice
