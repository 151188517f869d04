// SPDX-License-Identifier: MIT
// Work in a process of its own, which may crash, hang or ask for any amount of memory, and what it
// sends back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
    done,      ///< It sent all that was asked for.
    crashed,   ///< A signal or an exit, without the whole of it.
    too_long,  ///< It was ended at one of its time limits.
    no_child,  ///< The system gives no process or no pipe.
};

/// The child's end: what it sends. Ends the child where nobody receives any more.
class Sender {
public:
    explicit Sender(int file) : file_(file) {}
    ~Sender() { flush(); }
    Sender(const Sender&) = delete;
    Sender& operator=(const Sender&) = delete;

    void bytes(void* data, std::size_t size);
    bool holds(std::uint64_t) const { return true; }  ///< Nothing is received.

private:
    void write(const char* data, std::size_t size);
    void flush();

    int file_;
    std::vector<char> waiting_;
};

/// The parent's end. After a failure every further byte is 0.
class Receiver {
public:
    Receiver(int file, const ChildLimits& limits);

    void bytes(void* data, std::size_t size);

    /// Whether so many bytes may come; what would be more is a failure.
    bool holds(std::uint64_t size)
    {
        failed_ = failed_ || size > left_;
        return !failed_;
    }
    bool failed() const { return failed_; }
    bool late() const { return late_; }

private:
    bool fill();

    int file_;
    double deadline_s_;
    std::uint64_t left_;  // bytes that may come
    std::vector<char> read_;
    std::size_t next_ = 0;
    bool failed_ = false;
    bool late_ = false;
};

/// In a child: gives it other limits of memory and of the processor's time, counted from its start.
void limitSelf(const ChildLimits& limits);

/// Runs `send` in a copy of this process and `receive` in this one, and waits for both. The child
/// never returns from here, runs no destructor of its caller's, prints nothing and leaves no core
/// file. Past the memory limit its allocations fail; built for a sanitizer, which needs all of the
/// address space, it has no such limit.
ChildEnd runInChild(const ChildLimits& limits, const std::function<void(Sender&)>& send,
                    const std::function<void(Receiver&)>& receive);

}  // namespace crevice
