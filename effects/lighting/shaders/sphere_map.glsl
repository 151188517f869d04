// SPDX-License-Identifier: MIT
// Directions in the world, y up, and places on a map of all of them: longitude by latitude, as in an .hdr panorama.

// Maps that `reflections` holds, one above the other: of roughness 0, 1/3, 2/3 and 1, and of matte surfaces.
const highp float kMaps = 5.0;

// 0..1 each; the middle of the map is -z.
highp vec2 placeOf(highp vec3 direction)
{
    highp vec2 around = abs(direction.x) + abs(direction.z) > 0.0 ? direction.xz : vec2(0.0, -1.0);
    return vec2(atan(around.x, -around.y) * 0.15915494 + 0.5,
                asin(clamp(direction.y, -1.0, 1.0)) * 0.31830989 + 0.5);
}

highp vec3 directionAt(highp vec2 place)
{
    highp float longitude = (place.x - 0.5) * 6.2831853;
    highp float latitude = (place.y - 0.5) * 3.1415927;
    return vec3(cos(latitude) * sin(longitude), sin(latitude), -cos(latitude) * cos(longitude));
}
