// SPDX-License-Identifier: MIT
#include "./ring.glsl"
