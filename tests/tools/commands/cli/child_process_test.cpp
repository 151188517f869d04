// SPDX-License-Identifier: MIT
// Work in a process of its own: what comes back, and every way in which it can go wrong.
#include "tools/commands/cli/child_process.h"

#include "tests/support/catch.h"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <new>

using namespace crevice;

namespace {

const auto kNothing = [](Receiver& receiver) {
    char byte = 0;
    receiver.bytes(&byte, 1);
};

}  // namespace

TEST_CASE("what a child sends arrives as it was, small and large")
{
    std::vector<int> numbers(300000);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<int>(i * 7);
    std::vector<int> received(numbers.size());
    int first = 42, arrived = 0;
    const ChildEnd end = runInChild(
        {},
        [&](Sender& sender) {
            sender.bytes(&first, sizeof(first));
            sender.bytes(numbers.data(), numbers.size() * sizeof(int));
        },
        [&](Receiver& receiver) {
            receiver.bytes(&arrived, sizeof(arrived));
            receiver.bytes(received.data(), received.size() * sizeof(int));
        });
    CHECK(end == ChildEnd::done);
    CHECK(arrived == 42);
    CHECK(received == numbers);
}

TEST_CASE("a child that crashes, ends, throws or hangs is distinguished from one that is done")
{
    void (*const crashes[])(Sender&) = {[](Sender&) { std::abort(); },
                                        [](Sender&) { std::_Exit(0); }, [](Sender&) { throw 1; }};
    for (const auto& work : crashes) CHECK(runInChild({}, work, kNothing) == ChildEnd::crashed);
    ChildLimits limits;
    limits.time_s = 0.2;
    const auto hang = [](Sender&) {
        for (;;) pause();
    };
    const auto begin = std::chrono::steady_clock::now();
    CHECK(runInChild(limits, hang, kNothing) == ChildEnd::too_long);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    CHECK(taken.count() < 5);
}

TEST_CASE("a child is ended at its limit of the processor's time, and may give itself more")
{
    ChildLimits limits;
    limits.time_s = 300;
    limits.cpu_s = 1;
    const auto work = [](double seconds) {
        while (static_cast<double>(std::clock()) / CLOCKS_PER_SEC < seconds) {
        }
    };
    CHECK(runInChild(
              limits, [&](Sender&) { work(100); }, kNothing) == ChildEnd::too_long);
    const auto more = [&](Sender& sender) {
        ChildLimits larger = limits;
        larger.cpu_s = 100;
        limitSelf(larger);
        work(1.5);
        sender.bytes(&larger, 1);
    };
    CHECK(runInChild(limits, more, kNothing) == ChildEnd::done);
}

TEST_CASE("a child that sends more than it may is not listened to")
{
    ChildLimits limits;
    limits.answer = 1000;
    for (const std::size_t size : {1000u, 1001u}) {
        std::vector<char> sent(size, 'x'), received(size);
        const ChildEnd end = runInChild(
            limits, [&](Sender& sender) { sender.bytes(sent.data(), size); },
            [&](Receiver& receiver) { receiver.bytes(received.data(), size); });
        CHECK(end == (size <= limits.answer ? ChildEnd::done : ChildEnd::crashed));
        CHECK(received.back() == (size <= limits.answer ? 'x' : '\0'));
    }
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("a child that wants more memory than it may have is refused it")
{
    ChildLimits limits;
    limits.memory = 64 << 20;
    char refused = 0;
    const ChildEnd end = runInChild(
        limits,
        [](Sender& sender) {
            char answer = 'n';
            try {
                std::vector<char> much(std::size_t{128} << 20);
                if (much.back() == 1) answer = 'o';
            } catch (const std::bad_alloc&) {
                answer = 'y';
            }
            sender.bytes(&answer, 1);
        },
        [&](Receiver& receiver) { receiver.bytes(&refused, 1); });
    CHECK(end == ChildEnd::done);
    CHECK(refused == 'y');
}
#endif
