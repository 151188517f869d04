// SPDX-License-Identifier: MIT
#include "tools/render/glsl/glslang_stage.h"

#include <glslang/Public/resource_limits_c.h>

namespace crevice {
namespace {

/// Once a process.
struct Glslang {
    Glslang() { glslang_initialize_process(); }
    ~Glslang() { glslang_finalize_process(); }
};

}  // namespace

ParsedStage parseStage(const std::string& text, glslang_stage_t kind, bool spirv)
{
    static const Glslang glslang;
    glslang_input_t input = {};
    input.language = GLSLANG_SOURCE_GLSL;
    input.stage = kind;
    input.client = spirv ? GLSLANG_CLIENT_OPENGL : GLSLANG_CLIENT_NONE;
    input.client_version = GLSLANG_TARGET_OPENGL_450;
    input.target_language = spirv ? GLSLANG_TARGET_SPV : GLSLANG_TARGET_NONE;
    input.target_language_version = GLSLANG_TARGET_SPV_1_0;
    input.code = text.c_str();
    input.default_version = 310;
    input.default_profile = GLSLANG_ES_PROFILE;
    input.messages = GLSLANG_MSG_DEFAULT_BIT;
    input.resource = glslang_default_resource();
    ParsedStage parsed = {GlslangShader(glslang_shader_create(&input)), {}};
    glslang_shader_t* shader = parsed.shader.get();
    // SPIR-V wants numbers for all that GLSL finds by name.
    if (spirv)
        glslang_shader_set_options(
            shader, GLSLANG_SHADER_AUTO_MAP_BINDINGS | GLSLANG_SHADER_AUTO_MAP_LOCATIONS);
    if (!glslang_shader_preprocess(shader, &input) || !glslang_shader_parse(shader, &input))
        parsed.log = glslang_shader_get_info_log(shader) + std::string("\n");
    return parsed;
}

}  // namespace crevice
