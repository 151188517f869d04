// SPDX-License-Identifier: MIT
// Orthonormal frames about a normal.

// Two unit vectors that stand on the unit vector `n` and on each other; defined for every n.
// [Duff et al. 2017 - the form without branches]
void tangentFrame(highp vec3 n, out highp vec3 tangent, out highp vec3 bitangent)
{
    highp float s = n.z >= 0.0 ? 1.0 : -1.0;
    highp float a = -1.0 / (s + n.z);
    highp float b = n.x * n.y * a;
    tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}

// The frame (t, b, n) whose t is the part of `r` across n, as most have it; b = n x t. For r along n both are zero.
highp mat3 projectedFrame(highp vec3 n, highp vec3 r)
{
    highp vec3 across = r - n * dot(r, n);
    highp vec3 tangent = across / max(length(across), 1e-6);
    return mat3(tangent, cross(n, tangent), n);
}

// The frame turned about n by the angle whose cosine and sine are `rotation`, as columns (t, b, n).
highp mat3 rotatedFrame(highp vec3 n, highp vec2 rotation)
{
    highp vec3 tangent;
    highp vec3 bitangent;
    tangentFrame(n, tangent, bitangent);
    return mat3(tangent * rotation.x + bitangent * rotation.y,
                bitangent * rotation.x - tangent * rotation.y, n);
}
