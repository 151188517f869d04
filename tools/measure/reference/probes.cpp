// SPDX-License-Identifier: MIT
// Hammersley points, and the passes that they are dealt out to.
#include "tools/measure/reference/probes.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace crevice {

namespace {

// The radical inverse, base 2.
double mirrored(unsigned index)
{
    double inverse = 0.0, digit = 0.5;
    for (unsigned bits = index; bits > 0; bits >>= 1, digit /= 2) inverse += (bits & 1) * digit;
    return inverse;
}

Probe makeProbe(unsigned index, int count)
{
    const double angle = 2 * glm::pi<double>() * mirrored(index);
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

// Which pass has its turn: Pascal's triangle, modulo 2, times the digits of the turn. Any window of
// its rows is invertible, so that the first 2, 4, 8 ... passes together are spread evenly, too.
unsigned passOf(unsigned turn, unsigned passes)
{
    unsigned pass = 0;
    for (unsigned row = 0; (1u << row) < passes; ++row)
        for (unsigned column = 0; column <= row; ++column)
            if ((column & ~row) == 0 && (turn >> column & 1)) pass ^= 1u << row;
    return pass;
}

}  // namespace

ProbePasses makeProbes(int count, int passes)
{
    ProbePasses made;
    const auto all = static_cast<unsigned>(count), turns = static_cast<unsigned>(passes);
    for (unsigned turn = 0; turn < turns; ++turn) {
        made.begins.push_back(static_cast<int>(made.probes.size()));
        for (unsigned group = 0; group * turns < all; ++group) {
            const unsigned index = probeOf(group, passOf(turn, turns), turns);
            if (index < all) made.probes.push_back(makeProbe(index, count));
        }
    }
    made.begins.push_back(count);
    return made;
}

}  // namespace crevice
