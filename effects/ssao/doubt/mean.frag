#version 300 es
// SPDX-License-Identifier: MIT
// The root of the mean square over a part of a picture, or with OF_ALL over all of it, where there are surfaces.
//
//   parts  y: the expected error; z: the share of it that sees a surface
//   mean   the same of each part; with OF_ALL the error alone, in x
precision highp float;

uniform highp sampler2D parts;
uniform vec2 viewport_size;

layout(location = 0) out vec4 mean;

void main()
{
    vec2 part = vec2(textureSize(parts, 0)) / viewport_size;
    ivec2 first = ivec2(floor(part * floor(gl_FragCoord.xy)));
    ivec2 end = ivec2(floor(part * floor(gl_FragCoord.xy + 1.0)));
    float squares = 0.0;
    float surfaces = 0.0;
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            vec2 value = texelFetch(parts, ivec2(x, y), 0).yz;
            squares += value.x * value.x * value.y;
            surfaces += value.y;
        }
    }
    float root = sqrt(squares / max(surfaces, 1e-6));
#ifdef OF_ALL
    mean = vec4(root);
#else
    float count = float((end.x - first.x) * (end.y - first.y));
    mean = vec4(0.0, root, surfaces / max(count, 1.0), 1.0);
#endif
}
