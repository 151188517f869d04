// SPDX-License-Identifier: MIT
// HTTP on the loopback address, and on no other; what is told to all open pages; the browser.
#pragma once

#include "tools/show/view/site.h"

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

class Server {
public:
    Server();
    ~Server();  ///< Stops.
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Takes that port of 127.0.0.1, or any free one for 0, and returns it. Errors: CV6022.
    Result<int> bind(int port);

    /// Answers from threads of its own, until `stop`. After `bind`; both must outlive this.
    void start(Site& site, Events& events);

    /// Ends all streams and waits until the last request was answered, or for a second.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Has xdg-open show the address, without a shell and without waiting. False where there is no such
/// program.
bool openBrowser(const std::string& address);

}  // namespace crevice
