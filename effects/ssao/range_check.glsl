// SPDX-License-Identifier: MIT
// How much an occluder counts whose view depth differs by `difference` from the shaded point's.

#if RANGE_CHECK == RANGE_CHECK_SMOOTHSTEP
// Fades with distance beyond the radius. [LearnOpenGL, "SSAO"]
highp float rangeWeight(highp float difference, highp float limit)
{
    return smoothstep(0.0, 1.0, limit / max(abs(difference), limit * 1e-6));
}
#elif RANGE_CHECK == RANGE_CHECK_HARD
// In full within the radius, not at all beyond.
highp float rangeWeight(highp float difference, highp float limit)
{
    return abs(difference) < limit ? 1.0 : 0.0;
}
#else
highp float rangeWeight(highp float difference, highp float limit)
{
    return 1.0;
}
#endif
