// SPDX-License-Identifier: MIT
// A picture's pixels in 4x4 tiles of every fourth pixel each, in a texture of the picture's size. Where that is not a
// multiple of four, the first columns and rows of tiles are a pixel wider and higher.

// The first texel of a tile.
highp ivec2 cornerOf(highp ivec2 tile, highp ivec2 size)
{
    return tile * (size / 4) + min(tile, size % 4);
}

// The tile of a texel: its pixels are 4 * (texel - cornerOf(tile)) + tile.
highp ivec2 tileOf(highp ivec2 texel, highp ivec2 size)
{
    highp ivec2 tile = ivec2(0);
    for (int i = 1; i < 4; ++i) tile += ivec2(greaterThanEqual(texel, cornerOf(ivec2(i), size)));
    return tile;
}

highp ivec2 texelOfPixel(highp ivec2 pixel, highp ivec2 size)
{
    return cornerOf(pixel % 4, size) + pixel / 4;
}
