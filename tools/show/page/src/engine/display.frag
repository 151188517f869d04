#version 300 es
// SPDX-License-Identifier: MIT
// Two pictures beside each other, each as value * scale + offset; one channel as grey or as heat.
//
//   left, right            any texture; nearest texel
//   split                  left of this share of the width `left` is shown, right of it `right`
//   left_view, right_view  scale, offset, and 1 for grey, 2 for heat: black, red, yellow, white
//   picture                rgb; magenta where a value is not finite
precision highp float;

uniform highp sampler2D left;
uniform highp sampler2D right;
uniform float split;
uniform vec3 left_view;
uniform vec3 right_view;

in vec2 uv;
layout(location = 0) out vec4 picture;

vec3 shown(vec4 value, vec3 view)
{
    vec3 color = view.z > 0.5 ? value.rrr : value.rgb;
    bool finite = !any(isnan(color)) && !any(isinf(color));
    color = color * view.x + view.y;
    if (view.z > 1.5) color = clamp(color * 3.0 - vec3(0.0, 1.0, 2.0), 0.0, 1.0);
    return finite ? color : vec3(1.0, 0.0, 1.0);
}

void main()
{
    vec3 color = uv.x < split ? shown(texture(left, uv), left_view) : shown(texture(right, uv), right_view);
    picture = vec4(color, 1.0);
}
