// SPDX-License-Identifier: MIT
// Events between threads: all of them, in order, to each who waits.
#include "tools/show/view/events.h"

#include "tests/support/catch.h"

using namespace crevice;

namespace {
constexpr std::chrono::milliseconds kNow(0);
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
