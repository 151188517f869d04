// SPDX-License-Identifier: MIT
// tinygltf under a name of its own: Debian's libdraco.so exports another version of it, which would
// be taken or not by the order in which libraries are linked, and crash.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define tinygltf crevice_tinygltf
#include <tiny_gltf.h>
#undef tinygltf

namespace tinygltf = crevice_tinygltf;
