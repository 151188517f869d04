// SPDX-License-Identifier: MIT
#define TINYGLTF_IMPLEMENTATION
#include "tools/render/scene/file/gltf/file.h"
