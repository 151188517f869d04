// SPDX-License-Identifier: MIT
// How far off its own plane a surface may come out, as its depth is stored, in two bits of a texture beside its normal.
// Ours.

// In radii of what is stored in 0..1: 0.0002, 0.002, 0.02 or 0.25. The first is within any bias.
highp float toleranceOf(mediump float stored)
{
    return 0.25 * exp2(10.5 * (stored - 1.0));
}

// Rounded up to the next of them.
highp float storedTolerance(highp float tolerance)
{
    return ceil(clamp(3.0 + log2(max(4.0 * tolerance, 1e-9)) * (3.0 / 10.5), 0.0, 3.0)) / 3.0;
}
