// SPDX-License-Identifier: MIT
// What glslang, the reference compiler of GLSL, makes of one stage.
#pragma once

#include <glslang/Include/glslang_c_interface.h>

#include <memory>
#include <string>

namespace crevice {

template <class T, void (*destroy)(T*)>
struct Destroyer {
    void operator()(T* object) const { destroy(object); }
};
using GlslangShader =
    std::unique_ptr<glslang_shader_t, Destroyer<glslang_shader_t, glslang_shader_delete>>;
using GlslangProgram =
    std::unique_ptr<glslang_program_t, Destroyer<glslang_program_t, glslang_program_delete>>;

struct ParsedStage {
    GlslangShader shader;
    std::string log;  ///< Empty where there is no error.
};

/// `spirv` is for text that SPIR-V is to be made of, which has to be of OpenGL ES 3.1; else the
/// text is taken by the rules of its own version.
ParsedStage parseStage(const std::string& text, glslang_stage_t kind, bool spirv);

}  // namespace crevice
