// SPDX-License-Identifier: MIT
// How far a pixel's normal may be from that of its cell's plane for the pixel to be open with its cell, as the
// length of their difference.

const highp float kNormalTolerance = 0.006;
// As far as the plane's normal, stored in ten bits, tells: the rest is left to its rounding.
const highp float kSeenTolerance = 0.004;
