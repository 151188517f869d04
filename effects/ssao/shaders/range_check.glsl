// SPDX-License-Identifier: MIT
// How much an occluder counts, by the depths in view space of the shaded point, of the probe and of what is
// seen there, which is in front of the probe.

#if RANGE_CHECK == RANGE_CHECK_SMOOTHSTEP
// Fades with distance beyond the radius. [Gedge 2014; de Vries 2020] The least distance only keeps the quotient
// finite.
highp float rangeWeight(highp float origin_z, highp float probe_z, highp float seen_z, highp float limit)
{
    return smoothstep(0.0, 1.0, limit / max(abs(origin_z - seen_z), limit * 1e-6));
}
#elif RANGE_CHECK == RANGE_CHECK_HARD
// In full within the radius, not at all beyond. [Meiri n.d.]
highp float rangeWeight(highp float origin_z, highp float probe_z, highp float seen_z, highp float limit)
{
    return abs(origin_z - seen_z) < limit ? 1.0 : 0.0;
}
#elif RANGE_CHECK == RANGE_CHECK_PENETRATION
// Fades the deeper the probe lies behind what is seen, to nothing at the radius. [Habr n.d.]
highp float rangeWeight(highp float origin_z, highp float probe_z, highp float seen_z, highp float limit)
{
    return max(1.0 - (seen_z - probe_z) / max(limit, 1e-30), 0.0);
}
#else
highp float rangeWeight(highp float origin_z, highp float probe_z, highp float seen_z, highp float limit)
{
    return 1.0;
}
#endif
