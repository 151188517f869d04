// SPDX-License-Identifier: MIT
// Structs of other versions, as programs have them that were built with another header: cut short
// at every size, and longer than this library's. All functions take and give theirs in this way.
#include "effects/api/c/calls.h"
#include "tests/support/catch.h"

#include <algorithm>

using namespace crevice;

namespace {

/// One of this version's.
struct Known {
    std::size_t struct_size;
    double numbers[3];
};

constexpr char kByte = 1, kGarbage = '\xAA';
constexpr std::size_t kFirst = sizeof(std::size_t), kLonger = 40, kLargest = 4096;

/// A struct in memory of exactly that size, all bytes of which are `byte`, before `behind` of
/// garbage.
std::unique_ptr<char[]> structOf(std::size_t size, char byte, std::size_t behind = 0)
{
    const std::size_t bytes = std::max(size, kFirst);
    std::unique_ptr<char[]> made(new char[bytes + behind]);
    std::fill_n(made.get(), bytes, byte);
    std::fill_n(made.get() + bytes, behind, kGarbage);
    std::memcpy(made.get(), &size, kFirst);
    return made;
}

const Known* known(const std::unique_ptr<char[]>& bytes)
{
    return reinterpret_cast<const Known*>(bytes.get());
}

bool possible(std::size_t size) { return size > kFirst && size <= kLargest && size % kFirst == 0; }

}  // namespace

TEST_CASE("C API: a struct of another version is taken at its own size")
{
    for (std::size_t size = 0; size <= sizeof(Known) + kLonger; ++size) {
        INFO(size);
        const auto given = structOf(size, kByte);
        if (size > sizeof(Known)) std::fill_n(given.get() + sizeof(Known), size - sizeof(Known), 0);
        Known own = {};
        REQUIRE(take(known(given), "known", own).ok() == possible(size));
        if (!possible(size)) continue;
        const char* const bytes = reinterpret_cast<const char*>(own.numbers);
        const auto whole = std::count(bytes, bytes + sizeof own.numbers, kByte);
        CHECK(whole + kFirst == std::min(size, sizeof(Known)));
    }
    Known own = {};
    CHECK_FALSE(take(known(structOf(kLargest + kFirst, 0)), "known", own));
    // A member that this version does not know is set.
    CHECK_FALSE(take(known(structOf(sizeof(Known) + kFirst, kByte)), "known", own));
    CHECK_FALSE(take<Known>(nullptr, "known", own));
}

TEST_CASE("C API: a struct of another version is filled in at its own size")
{
    Known own = {};
    std::memset(own.numbers, kByte, sizeof own.numbers);
    for (std::size_t size = 0; size <= sizeof(Known) + kLonger; ++size) {
        INFO(size);
        const auto into = structOf(size, kGarbage, 64);
        CHECK(check(known(into), "known").ok() == possible(size));
        if (!possible(size)) continue;
        give(own, reinterpret_cast<Known*>(into.get()));
        CHECK(structSize(into.get()) == size);
        char* const begin = into.get() + kFirst;
        char* const end = into.get() + std::min(size, sizeof(Known));
        CHECK(std::count(begin, end, kByte) == end - begin);
        CHECK(std::count(end, into.get() + size, 0) == into.get() + size - end);
        CHECK(std::count(into.get() + size, into.get() + size + 64, kGarbage) == 64);
    }
}

TEST_CASE("C API: an array of another version has structs of one size, each taken at that")
{
    constexpr std::size_t kShort = 2 * kFirst, kCount = 3;
    std::unique_ptr<char[]> array(new char[kCount * kShort]);
    for (std::size_t i = 0; i < kCount; ++i) {
        const double number = static_cast<double>(i) + 0.5;
        std::memcpy(array.get() + i * kShort, &kShort, kFirst);
        std::memcpy(array.get() + i * kShort + kFirst, &number, sizeof number);
    }
    std::size_t taken = 0;
    const auto count = [&taken](std::size_t i, const Known& each) {
        taken += each.numbers[0] == static_cast<double>(i) + 0.5 && each.numbers[1] == 0;
        return Status();
    };
    CHECK(takeEach(known(array), kCount, "known", count));
    CHECK(taken == kCount);
    const std::size_t other = 3 * kFirst;
    std::memcpy(array.get() + kShort, &other, kFirst);
    CHECK_FALSE(takeEach(known(array), 2, "known", count));
    CHECK_FALSE(takeEach(known(array), -1, "known", count));
    CHECK(takeEach<Known>(nullptr, 0, "known", count));
}
