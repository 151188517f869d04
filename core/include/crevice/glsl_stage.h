// SPDX-License-Identifier: MIT
// GLSL text: includes, defines, and what a shader declares, found without a GL context.
//
// An `#include "common/view_space.glsl"` names a file of the sources; an `#include <surface>` names
// an interface that some module of the config provides. Each file is included once. #line keeps
// driver messages in the author's file. The scan evaluates #if with the defines given, so it sees
// the declarations that the compiler will see.
#pragma once

#include <crevice/diagnostic.h>

namespace crevice {

/// GLSL types that a uniform may have here.
enum class GlslType {
    float_,
    vec2,
    vec3,
    vec4,
    int_,
    ivec2,
    ivec3,
    ivec4,
    uint_,
    bool_,
    mat3,
    mat4,
    sampler2d,
    sampler2d_ms,
    sampler3d,
    other,
};

/// The GLSL spelling; "other" for other.
const char* glslName(GlslType type);

/// The type of that spelling; other when it is none of the above.
GlslType glslTypeFromName(std::string_view name);

bool isSampler(GlslType type);

/// One `uniform` declaration.
struct GlslUniform {
    std::string name;
    GlslType type = GlslType::float_;
    int count = 1;  ///< Array length; 1 for a plain uniform.
    bool array = false;
    Place place;
    std::string spelling = {};  ///< Of the type, in GLSL.
};

/// One `out` of a fragment shader.
struct GlslOutput {
    std::string name;
    int location = 0;
    Place place;
    GlslType type = GlslType::float_;
};

/// A shader stage ready for a driver.
struct GlslStage {
    std::string text;              ///< With #version, defines and #line.
    std::vector<SourceRef> files;  ///< By source-string number; only explainLog reads lines.
    std::vector<GlslUniform> uniforms;
    std::vector<GlslOutput> outputs;
    std::vector<GlslUniform> blocks;        ///< Uniform blocks by name, which a host alone fills.
    std::vector<std::string> defines_used;  ///< Of those offered, the ones that the text mentions.

    /// What makes diagnostics of a driver's log: explainLog, or null for the log as it is.
    Diagnostics (*explain)(const GlslStage& stage, Code code, const std::string& log) = nullptr;
};

using GlslDefines = std::map<std::string, std::string>;

/// Assembles the stage that begins in `files.at(path)`. Of `defines`, only those whose name the
/// text mentions are written, so that a shader is the same text, and the same program, whatever
/// else a config defines. `interfaces` maps an interface's name to the path of its file.
///
/// Errors: CV5005, CV5006, CV5009 with the place in the GLSL file; CV2104 when there is no `path`.
Result<GlslStage> assembleStage(const std::map<std::string, SourceRef>& files,
                                const std::map<std::string, std::string>& interfaces,
                                const std::string& path, const GlslDefines& defines);

/// Makes a plain variable of the output, so that a driver leaves out what only it needs. False, and
/// nothing changed, where no line declares it alone, be it one that an #if leaves out.
bool dropOutput(GlslStage& stage, const std::string& name);

/// The paths and <interfaces> that a text includes, in order, with their places.
struct GlslInclude {
    std::string name;
    bool interface = false;
    Place place;
};
std::vector<GlslInclude> findIncludes(const SourceRef& source);

/// Turns a driver's log into diagnostics at the author's file and line. Understands the forms of
/// Mesa ("0:5(12): error: ..."), NVIDIA ("0(5) : error C1234: ...") and ANGLE, ARM and Qualcomm
/// ("ERROR: 0:5: ..."); lines of no known form become one error at the stage's first file. A
/// driver's warning stays one. Never empty: a driver that says nothing gives an error that says so.
Diagnostics explainLog(const GlslStage& stage, Code code, const std::string& log);

}  // namespace crevice
