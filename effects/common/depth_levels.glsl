// SPDX-License-Identifier: MIT
// Where the levels of depth lie in one texture of the size of depth: level 1, of half its width and height, at
// the corner; levels 2 to 4 one above the other beside it. Level 0 is depth itself.
//
// A texel of a level is one texel of depth, never a mean, which would lie on no surface.
// [McGuire et al. 2012 - taps from levels by distance, and the rotated grid of levelSource; theirs is a mip chain]

const highp int kDepthLevels = 4;

// The first texel of a level.
highp ivec2 levelCorner(highp int level, highp ivec2 size)
{
    if (level == 1) return ivec2(0);
    return ivec2(size.x >> 1, level == 2 ? 0 : level == 3 ? size.y >> 2 : (size.y >> 2) + (size.y >> 3));
}

// The texel of depth that texel `at` of a level holds: the one at its middle, turned from texel to texel, so that
// rows of them do not all miss the same thin object.
highp ivec2 levelSource(highp int level, highp ivec2 at)
{
    highp int half_step = 1 << (level - 1);
    return (at << level) + half_step - ivec2((at.y & 1) ^ 1, (at.x & 1) ^ 1);
}
