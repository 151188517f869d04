// SPDX-License-Identifier: MIT
// Work in a process of its own, which may crash, hang or ask for any amount of memory, and what it
// sends back; and another program run to its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace crevice {

struct ChildLimits {
    double time_s = 10;                 ///< Wall clock, until everything was received; > 0.
    double cpu_s = 1e9;                 ///< The processor's, rounded up to seconds; > 0.
    std::uint64_t memory = 4ull << 30;  ///< Bytes of address space beyond what this process has.
    std::uint64_t answer = 4ull << 30;  ///< Bytes that it may send.
};

/// How a child ended.
enum class ChildEnd {
    done,      ///< It came to its end, and all that it sent is there.
    crashed,   ///< A signal or an exit before its end, or it sent more than it may.
    too_long,  ///< It was ended at one of its time limits.
    no_child,  ///< The system gives no process or no pipe.
};

/// The child's end: what it sends. Ends the child where nobody receives any more.
class Sender {
public:
    explicit Sender(int file) : file_(file) {}

    void bytes(const void* data, std::size_t size);
    void flush();  ///< What was sent so far arrives even if the child crashes after that.
    bool holds(std::uint64_t) const { return true; }  ///< Nothing is received.

private:
    int file_;
    std::string waiting_;
};

/// In a child: gives it other limits of memory and of the processor's time, counted from its start.
void limitSelf(const ChildLimits& limits);

/// Runs `send` in a copy of this process and waits for it; `answer` is what it sent, whole or,
/// where it did not get done, as far as it came. The child never returns from here, runs no
/// destructor of its caller's, prints nothing and leaves no core file. Past the memory limit its
/// allocations fail; built for a sanitizer, which needs all of the address space, it has no such
/// limit.
ChildEnd runInChild(const ChildLimits& limits, const std::function<void(Sender&)>& send,
                    std::string& answer);

struct ProgramRun {
    bool ended = false;   ///< It ended by itself, within the time.
    int exit_code = 0;    ///< Then.
    std::string output;   ///< Of stdout and stderr, in the order in which they were written.
    std::string failure;  ///< Why it did not end so: "it was ended by signal 11"; else empty.
};

/// Runs the program at `path` with `input` on its standard input and the `variables`
/// ("NAME=value") over this process's environment, and waits until it ends, at most `time_s`
/// seconds.
ProgramRun runProgram(const std::string& path, const std::vector<std::string>& variables,
                      const std::string& input, double time_s);

}  // namespace crevice
