// SPDX-License-Identifier: MIT
// Types of uniforms as GLSL spells them.
#include <crevice/glsl_stage.h>

#include <algorithm>

namespace crevice {
namespace {

/// In the order of GlslType.
constexpr const char* kTypes[] = {"float",     "vec2",        "vec3",      "vec4", "int",  "ivec2",
                                  "ivec3",     "ivec4",       "uint",      "bool", "mat3", "mat4",
                                  "sampler2D", "sampler2DMS", "sampler3D", "other"};

}  // namespace

const char* glslName(GlslType type) { return kTypes[static_cast<int>(type)]; }

GlslType glslTypeFromName(std::string_view name)
{
    const auto* const known = std::find(std::begin(kTypes), std::end(kTypes) - 1, name);
    return static_cast<GlslType>(known - std::begin(kTypes));
}

bool isSampler(GlslType type) { return type >= GlslType::sampler2d && type <= GlslType::sampler3d; }

}  // namespace crevice
