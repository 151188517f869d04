// SPDX-License-Identifier: MIT
// Hammersley points, and the passes that they are dealt out to.
#include "tools/reference/probes.h"

#include <cmath>

namespace crevice {

namespace {

constexpr double kPi = 3.14159265358979323846;

// The radical inverse, base 2.
double mirrored(unsigned index)
{
    double inverse = 0.0, digit = 0.5;
    for (unsigned bits = index; bits > 0; bits >>= 1, digit /= 2) inverse += (bits & 1) * digit;
    return inverse;
}

Probe makeProbe(unsigned index, int count)
{
    const double angle = 2 * kPi * mirrored(index);
    return {static_cast<float>((index + 0.5) / count), static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle))};
}

// Of each group of `passes` probes, neighbours in radius whose angles are even, a pass takes one:
// which one is the group's number with all its digits, base `passes`, added without carry. So the
// angles of a pass are a scrambled radical inverse of the group, as those of all probes are of the
// probe: with powers of two each pass is a set of Hammersley points, turned.
unsigned probeOf(unsigned group, unsigned pass, unsigned passes)
{
    unsigned place = pass;
    for (unsigned digits = group; passes > 1 && digits > 0; digits /= passes)
        place ^= digits % passes;
    return group * passes + place;
}

}  // namespace

ProbePasses makeProbes(int count, int passes)
{
    ProbePasses made;
    const auto groups = static_cast<unsigned>((count + passes - 1) / passes);
    for (int turn = 0; turn < passes; ++turn) {
        const auto pass = static_cast<unsigned>(mirrored(static_cast<unsigned>(turn)) * passes);
        made.begins.push_back(static_cast<int>(made.probes.size()));
        for (unsigned group = 0; group < groups; ++group) {
            const unsigned index = probeOf(group, pass, static_cast<unsigned>(passes));
            if (index < static_cast<unsigned>(count))
                made.probes.push_back(makeProbe(index, count));
        }
    }
    made.begins.push_back(count);
    return made;
}

}  // namespace crevice
