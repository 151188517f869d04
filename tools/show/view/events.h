// SPDX-License-Identifier: MIT
// What is told to all open pages, and the wait for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

namespace crevice {

/// Events in the order in which they came, as Server-Sent Events write them. From any thread.
class Events {
public:
    /// `data` is one line.
    void push(const std::string& name, const std::string& data);

    /// Ends all waits, for good.
    void close();

    /// How many there were so far.
    std::uint64_t count() const;

    /// The next one after the first `seen`, which is then counted; "" where none came in that time.
    /// Nothing once they are closed. Who is more than 64 behind misses the oldest.
    std::optional<std::string> next(std::uint64_t& seen, std::chrono::milliseconds wait);

private:
    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::deque<std::string> kept_;  // the last ones
    std::uint64_t count_ = 0;
    bool closed_ = false;
};

}  // namespace crevice
