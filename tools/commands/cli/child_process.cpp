// SPDX-License-Identifier: MIT
// fork, limits and pipes.
#include "tools/commands/cli/child_process.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace crevice {
namespace {

constexpr std::size_t kPipeBuffer = 1 << 16;  // what Linux keeps of a pipe
constexpr int kSentAll = 64;                  // the exit code of a child that has; no library's own

// A sanitizer needs all of the address space.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// A file descriptor that closes itself.
class File {
public:
    explicit File(int number) : number_(number) {}
    ~File() { close(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    int number() const { return number_; }
    void close()
    {
        if (number_ >= 0) ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

// Bytes of address space that this process has; 0 where the system does not report it.
std::uint64_t addressSpace()
{
    const FileBytes statistics = readStart("/proc/self/statm", 64);
    std::string_view text = statistics.bytes;
    return static_cast<std::uint64_t>(takeNumber(text).value_or(0.0)) *
           static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

template <class Resource>
void limitTo(Resource resource, std::uint64_t value)
{
    rlimit limit = {};
    if (getrlimit(resource, &limit) != 0) return;
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(value));
    setrlimit(resource, &limit);
}

// What a library says of its own end is not for the user, and no business of this process's signal
// handlers.
void silence()
{
    const int nowhere = open("/dev/null", O_WRONLY);
    for (const int file : {STDOUT_FILENO, STDERR_FILENO})
        if (nowhere >= 0) dup2(nowhere, file);
    for (const int number : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGXCPU})
        signal(number, SIG_DFL);
}

[[noreturn]] void runChild(int file, const ChildLimits& limits,
                           const std::function<void(Sender&)>& send)
{
    silence();
    limitSelf(limits);
    try {
        Sender sender(file);
        send(sender);
        sender.flush();
    } catch (...) {
        _exit(1);
    }
    _exit(kSentAll);
}

/// Reads until the other end is closed: `too_long` where the time is up before, `crashed` where
/// more than `most` bytes come.
ChildEnd readAll(int file, double time_s, std::uint64_t most, std::string& text)
{
    const double deadline_s = clockSeconds() + time_s;
    std::vector<char> part(kPipeBuffer);
    for (;;) {
        const double left_ms = std::ceil((deadline_s - clockSeconds()) * 1e3);
        if (left_ms <= 0) return ChildEnd::too_long;
        pollfd ready = {file, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(std::min(left_ms, 1e9))) <= 0) continue;
        const ssize_t count = read(file, part.data(), part.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return ChildEnd::done;
        if (text.size() + static_cast<std::size_t>(count) > most) return ChildEnd::crashed;
        text.append(part.data(), static_cast<std::size_t>(count));
    }
}

/// How it ended, as waitpid says it.
int waitFor(pid_t process)
{
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

// The time of the processor also ends a child whose parent is gone.
void limitSelf(const ChildLimits& limits)
{
    static const std::uint64_t at_start = addressSpace();
    limitTo(RLIMIT_CORE, 0);
    const double cpu_s = std::min(limits.cpu_s, limits.time_s + 1);
    limitTo(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(cpu_s)));
    if (!kSanitized) limitTo(RLIMIT_AS, at_start + limits.memory);
}

void Sender::bytes(const void* data, std::size_t size)
{
    const std::string_view more(static_cast<const char*>(data), size);
    if (waiting_.size() + size > kPipeBuffer) flush();
    if (size <= kPipeBuffer)
        waiting_ += more;
    else if (writeAll(file_, more) != 0)
        _exit(1);
}

void Sender::flush()
{
    if (writeAll(file_, waiting_) != 0) _exit(1);
    waiting_.clear();
}

ChildEnd runInChild(const ChildLimits& limits, const std::function<void(Sender&)>& send,
                    std::string& answer)
{
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) return ChildEnd::no_child;
    File out(ends[0]), in(ends[1]);
    const pid_t child = fork();
    if (child < 0) return ChildEnd::no_child;
    if (child == 0) {
        out.close();  // else its own end would keep the pipe open
        runChild(in.number(), limits, send);
    }
    in.close();
    const ChildEnd end = readAll(out.number(), limits.time_s, limits.answer, answer);
    kill(child, SIGKILL);  // it has nothing left to do, or is to do no more
    const int status = waitFor(child);
    if (end != ChildEnd::done) return end;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return ChildEnd::too_long;
    const bool sent_all = WIFEXITED(status) && WEXITSTATUS(status) == kSentAll;
    return sent_all ? ChildEnd::done : ChildEnd::crashed;
}

ProgramRun runProgram(const std::string& path, const std::vector<std::string>& variables,
                      const std::string& input, double time_s)
{
    ProgramRun run;
    int ends[2];
    // A pipe could block: the program may print before it has read all.
    const File text(memfd_create("input", MFD_CLOEXEC));
    if (writeAll(text.number(), input) != 0 || lseek(text.number(), 0, SEEK_SET) != 0 ||
        pipe2(ends, O_CLOEXEC) != 0) {
        run.failure = "there is no file or no pipe for it";
        return run;
    }
    const File out(ends[0]);
    File in(ends[1]);
    const pid_t process = access(path.c_str(), X_OK) == 0 ? fork() : -1;
    if (process < 0) {
        run.failure = std::string("it cannot be started: ") + std::strerror(errno);
        return run;
    }
    if (process == 0) {
        dup2(text.number(), STDIN_FILENO);
        for (const int file : {STDOUT_FILENO, STDERR_FILENO}) dup2(in.number(), file);
        for (const std::string& each : variables) putenv(const_cast<char*>(each.c_str()));
        execl(path.c_str(), path.c_str(), static_cast<char*>(nullptr));
        _exit(1);
    }
    in.close();
    const bool in_time = readAll(out.number(), time_s, UINT64_MAX, run.output) == ChildEnd::done;
    if (!in_time) kill(process, SIGKILL);
    const int status = waitFor(process);
    if (!in_time)
        run.failure = "it ran for more than " + fixed(time_s, 1) + " s";
    else if (!WIFEXITED(status))
        run.failure = "it was ended by signal " + std::to_string(WTERMSIG(status));
    run.ended = run.failure.empty();
    if (run.ended) run.exit_code = WEXITSTATUS(status);
    return run;
}

}  // namespace crevice
