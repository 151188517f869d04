// SPDX-License-Identifier: MIT
// Between the picture and the host's own, which its projection may flip and turn by right angles into this one.
//
// What has a direction of its own or counts pixels does so in the host's picture: noise, kernels, the choice between
// texels, the order in which a filter goes through x and y. So the picture of a projection that turns is that of one
// that does not, turned. Of a turn by another angle the nearest right one is taken.

#if CAMERA_TURNED
uniform highp mat3 view_from_host;

highp mat2 turnFromHost()
{
    highp mat2 turn = mat2(view_from_host);
    return abs(turn[0].x) < abs(turn[0].y) ? mat2(0.0, sign(turn[0].y), sign(turn[1].x), 0.0)
                                           : mat2(sign(turn[0].x), 0.0, 0.0, sign(turn[1].y));
}

// Directions across the view, and with what they have along it.
highp vec2 pictureFromHost(highp vec2 direction) { return turnFromHost() * direction; }
highp vec3 pictureFromHost(highp vec3 direction) { return vec3(turnFromHost() * direction.xy, direction.z); }
highp vec3 hostFromPicture(highp vec3 direction) { return vec3(direction.xy * turnFromHost(), direction.z); }

// Where the host's own picture has what one of `size` pixels has at `at`, in pixels.
highp vec2 hostPixel(highp vec2 at, highp vec2 size)
{
    highp mat2 turn = turnFromHost();
    highp vec2 middle = 0.5 * size;
    return (at - middle) * turn + abs(middle * turn);
}

// The other way round; `size` is of the same picture.
highp vec2 pixelFromHost(highp vec2 at, highp vec2 size)
{
    highp mat2 turn = turnFromHost();
    highp vec2 middle = 0.5 * size;
    return turn * (at - abs(middle * turn)) + middle;
}
#else
highp vec2 pictureFromHost(highp vec2 direction) { return direction; }
highp vec3 pictureFromHost(highp vec3 direction) { return direction; }
highp vec3 hostFromPicture(highp vec3 direction) { return direction; }
highp vec2 hostPixel(highp vec2 at, highp vec2 size) { return at; }
highp vec2 pixelFromHost(highp vec2 at, highp vec2 size) { return at; }
#endif

// A frame's axes.
highp mat3 pictureFromHost(highp mat3 axes)
{
    return mat3(pictureFromHost(axes[0]), pictureFromHost(axes[1]), pictureFromHost(axes[2]));
}
