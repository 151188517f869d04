// SPDX-License-Identifier: MIT
// A mask whose bits are the sectors of one side of a slice.

// One less than an int has bits, so that the bit beyond the last is one too.
const mediump float kSectors = 31.0;

// How many bits are set in each byte. [Anderson 2005 - counting bits set, in parallel]
highp uint bytesOf(uint mask)
{
    highp uint pairs = mask - ((mask >> 1u) & 0x55555555u);
    highp uint fours = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return (fours + (fours >> 4u)) & 0x0f0f0f0fu;
}

mediump float countOf(uint mask) { return float((bytesOf(mask) * 0x01010101u) >> 24u); }
