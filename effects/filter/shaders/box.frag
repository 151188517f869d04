#version 300 es
// SPDX-License-Identifier: MIT
// The mean of BLUR_SIZE x BLUR_SIZE taps about each pixel.
//
//   ao           what is filtered, sampled linearly
//   ao_filtered  the mean
//
// The taps stand symmetrically about the pixel's centre. Where BLUR_SIZE is even they would fall between pixels: the box
// then has half of the pixels at its ends, so a tile of BLUR_SIZE noise values vanishes and the picture does not shift by
// half a pixel. One linear fetch reads two pixels of a row and two rows, so that 4 x 4 taps take 3 x 3 fetches.
// [Rakos 2010 - the fetches between pixels]
precision highp float;

uniform mediump sampler2D ao;

in vec2 uv;
layout(location = 0) out float ao_filtered;

const int kReach = BLUR_SIZE / 2;  // pixels to either side, and one fetch less than there are along a row

// A fetch's place in pixels from the centre, and how many pixels it stands for. From both ends inwards each takes two;
// where the one in the middle is left for both sides, each has half of it.
vec2 fetchAt(int i)
{
    int outer = kReach - 2 * min(i, kReach - i);  // pixels from the centre
    float outer_share = outer == kReach && BLUR_SIZE == 2 * kReach ? 0.5 : 1.0;
    float inner_share = outer == 0 ? 0.0 : outer == 1 ? 0.5 : 1.0;
    float share = outer_share + inner_share;
    float distance = float(outer) - inner_share / share;
    return vec2(2 * i < kReach ? -distance : distance, share);
}

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    float sum = 0.0;
    for (int y = 0; y <= kReach; ++y) {
        vec2 row = fetchAt(y);
        for (int x = 0; x <= kReach; ++x) {
            vec2 column = fetchAt(x);
            sum += row.y * column.y * texture(ao, uv + vec2(column.x, row.x) * texel).r;
        }
    }
    ao_filtered = sum / float(BLUR_SIZE * BLUR_SIZE);
}
