// SPDX-License-Identifier: MIT
// What of a step in depth between two taps is not one slope with the step before it: 0 on a plane, however steep. Ours.

mediump float unevenStep(mediump float step_here, mediump float step_before)
{
    mediump float uneven = step_here - step_before;
    return abs(uneven) < abs(step_here) ? uneven : step_here;
}

// Of four at once, which need not fit 16 bits.
highp vec4 unevenStep(highp vec4 step_here, highp vec4 step_before)
{
    highp vec4 uneven = step_here - step_before;
    return mix(step_here, uneven, lessThan(abs(uneven), abs(step_here)));
}
