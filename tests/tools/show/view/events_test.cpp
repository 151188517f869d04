// SPDX-License-Identifier: MIT
// Events between threads: all of them, in order, to each who waits.
#include "tools/show/view/events.h"

#include "tests/support/catch.h"

#include <thread>

using namespace crevice;

namespace {
constexpr std::chrono::milliseconds kNow(0), kLong(20000);
}

TEST_CASE("who waits for events gets those that come, in order")
{
    Events events;
    events.push("file", "before");
    std::uint64_t seen = events.count(), all = 0;
    CHECK(events.next(seen, kNow) == "");
    events.push("file", "{1}");
    events.push("file", "{2}");
    CHECK(events.next(seen, kNow) == "event: file\ndata: {1}\n\n");
    CHECK(events.next(seen, kNow) == "event: file\ndata: {2}\n\n");
    CHECK(events.next(seen, kNow) == "");
    CHECK(events.next(all, kNow) == "event: file\ndata: before\n\n");
}

TEST_CASE("who is far behind goes on with the oldest event that is kept")
{
    Events events;
    std::uint64_t seen = 0;
    for (int k = 0; k < 100; ++k) events.push("n", std::to_string(k));
    CHECK(events.next(seen, kNow) == "event: n\ndata: 36\n\n");
    CHECK(seen == 37);
}

TEST_CASE("a wait for events ends when one comes, and for good when they are closed")
{
    Events events;
    std::uint64_t seen = 0;
    std::thread pusher([&] { events.push("file", "x"); });
    CHECK(events.next(seen, kLong) == "event: file\ndata: x\n\n");
    pusher.join();
    std::thread closer([&] { events.close(); });
    CHECK_FALSE(events.next(seen, kLong).has_value());
    closer.join();
    CHECK_FALSE(events.next(seen, kLong).has_value());
}
