#version 300 es
// SPDX-License-Identifier: MIT
// Voxels from slices along three edges: in each channel 1 where a surface is seen along that edge. Four layers at once.
//
//   slices  as geometry/voxels/slices.vert orders them
precision highp float;

uniform highp sampler3D slices;
uniform highp int first_layer;

layout(location = 0) out vec3 voxels_0;
layout(location = 1) out vec3 voxels_1;
layout(location = 2) out vec3 voxels_2;
layout(location = 3) out vec3 voxels_3;

const int kLayers = RESOLUTION / 4;  // along an edge

vec3 voxelAt(ivec3 at, float along_z)
{
    vec4 along_x = texelFetch(slices, ivec3(at.yz, at.x >> 2), 0);
    vec4 along_y = texelFetch(slices, ivec3(at.zx, kLayers + (at.y >> 2)), 0);
    return vec3(along_x[at.x & 3], along_y[at.y & 3], along_z);
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 along_z = texelFetch(slices, ivec3(at, 2 * kLayers + (first_layer >> 2)), 0);
    voxels_0 = voxelAt(ivec3(at, first_layer), along_z.x);
    voxels_1 = voxelAt(ivec3(at, first_layer + 1), along_z.y);
    voxels_2 = voxelAt(ivec3(at, first_layer + 2), along_z.z);
    voxels_3 = voxelAt(ivec3(at, first_layer + 3), along_z.w);
}
