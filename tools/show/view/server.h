// SPDX-License-Identifier: MIT
// HTTP on the loopback address, and on no other.
#pragma once

#include "tools/show/view/events.h"
#include "tools/show/view/site.h"

namespace crevice {

class Server {
public:
    Server();
    ~Server();  ///< Stops.
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Takes that port of 127.0.0.1, or any free one for 0, and returns it. Errors: CV6022.
    Result<int> bind(int port);

    /// Answers from threads of its own, until `stop`. After `bind`; both must outlive this.
    void start(const Site& site, Events& events);

    /// Ends all streams and waits until the last request was answered, or for a second.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace crevice
