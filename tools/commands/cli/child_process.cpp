// SPDX-License-Identifier: MIT
// fork, limits and a pipe.
#include "tools/commands/cli/child_process.h"

#include "core/base/files.h"
#include "core/base/numbers.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace crevice {
namespace {

constexpr std::size_t kPipeBuffer = 1 << 16;  // what Linux keeps of a pipe

double now()
{
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

// A sanitizer needs all of the address space.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

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
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

ChildEnd endOf(const Receiver& receiver)
{
    if (receiver.late()) return ChildEnd::too_long;
    return receiver.failed() ? ChildEnd::crashed : ChildEnd::done;
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

void Sender::bytes(void* data, std::size_t size)
{
    const char* const begin = static_cast<const char*>(data);
    if (waiting_.size() + size > kPipeBuffer) flush();
    if (size > kPipeBuffer)
        write(begin, size);
    else
        waiting_.insert(waiting_.end(), begin, begin + size);
}

void Sender::flush()
{
    write(waiting_.data(), waiting_.size());
    waiting_.clear();
}

void Sender::write(const char* data, std::size_t size)
{
    while (size > 0) {
        const ssize_t written = ::write(file_, data, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) _exit(1);
        data += written;
        size -= static_cast<std::size_t>(written);
    }
}

Receiver::Receiver(int file, const ChildLimits& limits)
    : file_(file),
      deadline_s_(now() + limits.time_s),
      left_(limits.answer)
{
}

bool Receiver::fill()
{
    for (;;) {
        const double left_ms = std::ceil((deadline_s_ - now()) * 1e3);
        pollfd ready = {file_, POLLIN, 0};
        const int polled = poll(&ready, 1, static_cast<int>(std::clamp(left_ms, 0.0, 1e9)));
        late_ = polled == 0 && left_ms <= 0;
        if (late_ || (polled < 0 && errno != EINTR)) return false;
        if (polled <= 0) continue;
        read_.resize(kPipeBuffer);
        const ssize_t count = ::read(file_, read_.data(), read_.size());
        read_.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        next_ = 0;
        if (count < 0 && errno == EINTR) continue;
        return count > 0;
    }
}

void Receiver::bytes(void* data, std::size_t size)
{
    char* to = static_cast<char*>(data);
    if (holds(size)) left_ -= size;
    while (size > 0) {
        if (!failed_ && next_ == read_.size()) failed_ = !fill();
        if (failed_) {
            std::memset(to, 0, size);
            return;
        }
        const std::size_t count = std::min(size, read_.size() - next_);
        std::memcpy(to, read_.data() + next_, count);
        next_ += count;
        to += count;
        size -= count;
    }
}

ChildEnd runInChild(const ChildLimits& limits, const std::function<void(Sender&)>& send,
                    const std::function<void(Receiver&)>& receive)
{
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) return ChildEnd::no_child;
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        runChild(ends[1], limits, send);
    }
    close(ends[1]);
    ChildEnd end = ChildEnd::no_child;
    if (child > 0) {
        Receiver receiver(ends[0], limits);
        receive(receiver);
        end = endOf(receiver);
        kill(child, SIGKILL);  // it has nothing left to do, or is to do no more
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        if (end == ChildEnd::crashed && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
            end = ChildEnd::too_long;
    }
    close(ends[0]);
    return end;
}

}  // namespace crevice
