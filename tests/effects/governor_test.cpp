// SPDX-License-Identifier: MIT
// The governor without GL: over traces of load as they come, and as an adversary would make them.
#include <crevice/governor.h>

#include "core/base/text.h"
#include "tests/support/need.h"

#include <functional>
#include <random>

using namespace crevice;

namespace {

constexpr double kBudget = 3;

/// Levels of rising times and falling errors.
std::vector<FrontLevel> frontOf(const std::vector<double>& times)
{
    std::vector<FrontLevel> levels;
    for (const double ms : times)
        levels.push_back({{"level"}, {}, ms, 0.2 / (1.0 + double(levels.size()))});
    return levels;
}

const std::vector<double> kTimes = {0.8, 1.1, 1.6, 2.4, 3.5};

/// By how much more than on a device at rest a frame costs.
using Load = std::function<double(int frame)>;

struct Drawn {
    int level;
    double ms;

    bool over() const { return ms > kBudget; }
    bool operator==(const Drawn& other) const { return level == other.level && ms == other.ms; }
};

/// A device on which levels cost `costs`, and whose times are known `latency` frames later.
struct Device {
    std::vector<double> costs = kTimes;
    int latency = 2;
    double noise = 0;   ///< Of each frame's time, as a share in either direction.
    unsigned seed = 1;  ///< Of the noise.
    double voids = 0;   ///< Share of times that are void.

    std::vector<Drawn> run(Governor& governor, const Load& load, int frames) const
    {
        std::mt19937 random(seed);
        const auto uniform = [&random] { return double(random()) / 4294967296.0; };
        std::vector<Drawn> drawn;
        for (int frame = 0; frame < frames; ++frame) {
            const int level = governor.level();
            const double change = 1 + noise * (2 * uniform() - 1);
            drawn.push_back({level, costs[std::size_t(level)] * load(frame) * change});
            if (frame < latency) continue;
            const Drawn& known = drawn[std::size_t(frame - latency)];
            governor.addTime(uniform() < voids ? -1 : known.ms, known.level);
        }
        return drawn;
    }
};

/// Those from a frame on.
int switches(const std::vector<Drawn>& drawn, int from = 1)
{
    int count = 0;
    for (std::size_t i = std::size_t(from); i < drawn.size(); ++i)
        count += drawn[i].level != drawn[i - 1].level;
    return count;
}

int over(const std::vector<Drawn>& drawn, int from)
{
    return int(std::count_if(drawn.begin() + from, drawn.end(),
                             [](const Drawn& each) { return each.over(); }));
}

Governor governorOf(const std::vector<double>& times = kTimes, double most_error = 0)
{
    return need(Governor::create(frontOf(times), {kBudget, most_error}));
}

Load constant(double load)
{
    return [load](int) { return load; };
}

}  // namespace

TEST_CASE("Governor: it begins at the best level that fits by the front, within the error's bound")
{
    CHECK(governorOf().level() == 3);
    CHECK(governorOf({4, 5}).level() == 0);
    CHECK(governorOf({1}).level() == 0);
    Governor bound = governorOf(kTimes, 0.07);  // levels 2 to 4
    CHECK(bound.report().error == Approx(0.2 / 4));
    Device().run(bound, constant(10), 100);
    CHECK(bound.level() == 2);
    // A level that costs more and errs more is none.
    Governor dear = need(Governor::create(
        {{{"a"}, {}, 1, 0.1}, {{"b"}, {}, 2, 0.3}, {{"c"}, {}, 4, 0.05}}, {kBudget}));
    CHECK(dear.level() == 0);
    Device device;
    device.costs = {1, 2, 4};
    device.run(dear, constant(0.1), 100);
    CHECK(dear.level() == 2);
}

TEST_CASE("Governor: twice the load is above the budget for a frame once that is known, no more")
{
    for (const int latency : {0, 1, 2, 3, 4})
        for (const double noise : {0.0, 0.1})
            for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
                INFO(latency << " frames late, noise " << noise << ", seed " << seed);
                Device device;
                device.latency = latency;
                device.noise = noise;
                device.seed = seed;
                Governor governor = governorOf();
                constexpr int at = 500;
                const auto drawn = device.run(
                    governor, [](int f) { return f < at ? 1.0 : 2.0; }, 1000);
                CHECK(over(drawn, 0) > 0);
                CHECK(over(drawn, at + latency + 1) <= 3);
                CHECK(switches(drawn, at) == 1);
                CHECK(governor.level() == 1);
            }
}

TEST_CASE("Governor: under a constant load nothing changes in 10,000 frames, once it has settled")
{
    for (const double noise : {0.0, 0.1, 0.2})
        for (int i = 1; i <= 60; ++i)
            for (const bool wrong : {false, true}) {
                const double load = 0.05 * i;
                INFO("load " << load << ", noise " << noise << ", wrong front " << wrong);
                Device device;
                device.noise = noise;
                device.seed = unsigned(i);
                if (wrong) device.costs = {1.0, 1.2, 2.9, 2.9, 6.9};
                Governor governor = governorOf();
                const auto drawn = device.run(governor, constant(load), 14000);
                CHECK(switches(drawn, 4000) <= (noise > 0.1 ? 2 : 0));
                CHECK(switches(drawn) <= 16);
                const std::size_t level = std::size_t(governor.level());
                if (level > 0) CHECK(device.costs[level] * load <= kBudget);
                if (!wrong && level < 4)
                    CHECK(device.costs[level + 1] * load > 0.9 * kBudget / (1 + noise) * 0.93);
            }
}

TEST_CASE("Governor: what each trace of load leads to")
{
    struct Row {
        const char* name;
        Load load;
        int least_switches, most_switches;
        double most_over;  // share of frames
        int last;          // level at the end
    };
    const auto spikes = [](int every, int length, double base) -> Load {
        return [=](int frame) { return frame % every < length ? 5.0 : base; };
    };
    const auto saw = [](int period, double low, double high) -> Load {
        return [=](int frame) { return low + (high - low) * (frame % period) / period; };
    };
    const auto square = [](int period, double low, double high) -> Load {
        return [=](int frame) { return frame % (2 * period) < period ? low : high; };
    };
    const Row rows[] = {
        {"one slow frame", [](int frame) { return frame == 300 ? 9.0 : 1.0; }, 0, 0, 0.001, 3},
        {"three slow frames", [](int f) { return f >= 300 && f < 303 ? 9.0 : 1.0; }, 2, 8, 0.002,
         3},
        {"a slow frame in sixty", spikes(60, 1, 1), 0, 0, 0.017, 3},
        {"a slow frame in four", spikes(4, 1, 1), 0, 0, 0.26, 3},
        {"a slow frame in two", spikes(2, 1, 1), 1, 3, 0.51, 0},
        {"two slow frames in 200", spikes(200, 2, 1), 2, 120, 0.02, -1},
        {"the load goes up and back", [](int f) { return f < 3000 || f > 6000 ? 1.0 : 2.0; }, 2, 8,
         0.002, 3},
        {"a saw of 100 frames", saw(100, 0.5, 2), 2, 250, 0.15, -1},
        {"a saw of 1000 frames", saw(1000, 0.5, 2), 8, 120, 0.02, -1},
        {"a square of 40 frames", square(40, 0.5, 2), 2, 100, 0.04, -1},
        {"heat and recovery",
         [](int f) { return f < 5000 ? 0.7 + f * 2e-4 : std::max(0.7, 1.7 - (f - 5000) * 3e-4); },
         4, 16, 0.01, 4},
        {"too much for any level", constant(9), 1, 1, 1, 0},
        {"hardly anything", constant(0.01), 1, 4, 0, 4},
    };
    for (const Row& row : rows)
        for (const int latency : {0, 3}) {
            INFO(row.name << ", " << latency << " frames late");
            Device device;
            device.latency = latency;
            Governor governor = governorOf();
            const auto drawn = device.run(governor, row.load, 10000);
            CHECK(switches(drawn) >= row.least_switches);
            CHECK(switches(drawn) <= row.most_switches);
            CHECK(over(drawn, 0) <= row.most_over * 10000);
            if (row.last >= 0) CHECK(governor.level() == row.last);
        }
}

TEST_CASE("Governor: random devices and loads, and it settles, fits and keeps to the bound")
{
    for (unsigned seed = 0; seed < 1000; ++seed) {
        std::mt19937 random(seed);
        const auto between = [&random](double low, double high) {
            return low + (high - low) * double(random()) / 4294967296.0;
        };
        std::vector<double> times;
        Device device;
        device.costs.clear();
        for (int i = 0, count = 1 + int(random() % 7); i < count; ++i) {
            times.push_back((times.empty() ? between(0.3, 2) : times.back()) * between(1.05, 2));
            device.costs.push_back(times.back() * between(0.5, 2));
        }
        device.latency = int(random() % 5);
        device.noise = between(0, 0.1);
        device.seed = seed;
        device.voids = between(0, 0.1);
        std::vector<std::pair<double, int>> parts;  // a load, and what it does
        for (int i = 0; i < 6; ++i) parts.emplace_back(between(0.1, 3), int(random() % 4));
        constexpr int kPart = 300, kEnd = 6 * kPart, kAll = kEnd + 8000;
        const Load load = [&](int frame) {
            if (frame >= kEnd) return parts[0].first;
            const auto [base, kind] = parts[std::size_t(frame / kPart)];
            const double at = double(frame % kPart) / kPart;
            return kind == 0   ? base
                   : kind == 1 ? base * (1 + at)
                   : kind == 2 ? base * (frame % 23 == 0 ? 8 : 1)
                               : base * (1 + frame % 37 / 37.0);
        };
        const double bound = seed % 2 ? 0.2 / double(1 + random() % times.size()) : 0;
        const Governor fresh = governorOf(times, bound);
        Governor governor = fresh, again = fresh;
        const auto drawn = device.run(governor, load, kAll);
        INFO("seed " << seed << ", " << times.size() << " levels, load " << parts[0].first);
        CHECK(drawn == device.run(again, load, kAll));
        if (bound > 0)
            CHECK(std::all_of(drawn.begin(), drawn.end(), [&](const Drawn& each) {
                return governor.levels()[std::size_t(each.level)].error <= bound;
            }));
        CHECK(switches(drawn, kAll - 4000) == 0);
        const int last = governor.level();
        const double mean = device.costs[std::size_t(last)] * parts[0].first;
        bool fitting = false;  // below the last there is one that would
        for (int i = 0; i < last; ++i)
            fitting = fitting || (device.costs[std::size_t(i)] * parts[0].first < 0.8 * kBudget &&
                                  (bound == 0 || governor.levels()[std::size_t(i)].error <= bound));
        if (fitting) CHECK(mean <= kBudget);
    }
}
