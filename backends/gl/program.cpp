// SPDX-License-Identifier: MIT
#include "backends/gl/program.h"

#include "backends/gl/failure.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace crevice {

namespace {

GlslType glslType(GLenum type)
{
    constexpr GLenum kTypes[] = {// in the order of GlslType
                                 GL_FLOAT,        GL_FLOAT_VEC2,
                                 GL_FLOAT_VEC3,   GL_FLOAT_VEC4,
                                 GL_INT,          GL_INT_VEC2,
                                 GL_INT_VEC3,     GL_INT_VEC4,
                                 GL_UNSIGNED_INT, GL_BOOL,
                                 GL_FLOAT_MAT3,   GL_FLOAT_MAT4,
                                 GL_SAMPLER_2D,   GL_SAMPLER_2D_MULTISAMPLE};
    const auto* const known = std::find(std::begin(kTypes), std::end(kTypes), type);
    return static_cast<GlslType>(known - std::begin(kTypes));  // the last is GlslType::other
}

template <class GetValue, class GetLog>
std::string readLog(GLuint name, GetValue get_value, GetLog get_log)
{
    GLint length = 0;
    get_value(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(length > 0 ? length : 1, '\0');
    GLsizei written = 0;
    get_log(name, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(written);
    return log;
}

/// The driver's words at the author's lines; never empty, though some drivers say nothing. Where it
/// reports an error instead, which means that memory ran out or the context is lost.
Diagnostics explain(GlApi& gl, const GlslStage& stage, Code code, const std::string& label,
                    const std::string& what, const std::string& log)
{
    const Status errors = takeErrors(gl, "createProgram", label.c_str());
    if (log.empty() && !errors) return errors.diagnostics();
    Diagnostics diagnostics;
    if (stage.explain)
        diagnostics = stage.explain(stage, code, log);
    else
        diagnostics.push_back({code, log});
    if (!hasErrors(diagnostics))
        diagnostics.push_back({code, "the shader '" + label + "' does not " + what +
                                         " and the driver does not say why"});
    return diagnostics;
}

/// The text for contexts that take no shaders of OpenGL ES: GLSL 3.30 has all that they may use,
/// precisions included, under another first line.
std::string desktopText(const std::string& text)
{
    const std::size_t version = text.find("#version");
    if (version == std::string::npos) return text;
    const std::size_t end = text.find('\n', version);
    return text.substr(0, version) + "#version 330" +
           (end == std::string::npos ? "" : text.substr(end));
}

/// With highp for mediump, which is more than asked for, and as long a text: its lines and columns
/// stay.
std::string highpText(std::string text)
{
    constexpr std::string_view kMedium = "mediump", kHigh = "highp  ";
    const auto inWord = [&](std::size_t at) {
        return at < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
    };
    for (std::size_t at = text.find(kMedium); at != std::string::npos;
         at = text.find(kMedium, at + 1))
        if (!inWord(at - 1) && !inWord(at + kMedium.size()))
            text.replace(at, kMedium.size(), kHigh);
    return text;
}

std::string driverText(const GlApi& gl, const std::string& text)
{
    const std::string whole = gl.glsl_330 ? desktopText(text) : text;
    return gl.emulates_mediump ? highpText(whole) : whole;
}

Result<GlShader> compileStage(GlApi& gl, GLenum kind, const GlslStage& stage,
                              const std::string& label)
{
    GlShader shader(gl, gl.CreateShader(kind));
    const std::string whole = driverText(gl, stage.text);
    const GLchar* text = whole.data();
    const auto length = static_cast<GLint>(whole.size());
    gl.ShaderSource(shader.name(), 1, &text, &length);
    gl.CompileShader(shader.name());
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    return explain(gl, stage, Code::shader_compile, label, "compile",
                   readLog(shader.name(), gl.GetShaderiv, gl.GetShaderInfoLog));
}

std::vector<UniformInfo> readUniforms(const GlApi& gl, GLuint program)
{
    GLint count = 0;
    GLint longest = 0;
    gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    std::string buffer(longest + 1, '\0');
    std::vector<UniformInfo> uniforms;
    for (GLint i = 0; i < count; ++i) {
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = 0;
        gl.GetActiveUniform(program, i, static_cast<GLsizei>(buffer.size()), &length, &size, &type,
                            buffer.data());
        std::string name(buffer, 0, length);
        if (name.rfind("gl_", 0) == 0) continue;
        const int location = gl.GetUniformLocation(program, name.c_str());
        if (location < 0) continue;  // of a block, which the host fills
        const bool array = name.size() > 3 && name.compare(name.size() - 3, 3, "[0]") == 0;
        if (array) name.resize(name.size() - 3);
        uniforms.push_back({name, glslType(type), size, location});
    }
    return uniforms;
}

Result<GlProgram> compile(GlApi& gl, const GlProgramCache& cache, const ProgramDesc& desc)
{
    Result<GlShader> vertex = compileStage(gl, GL_VERTEX_SHADER, desc.vertex, desc.label);
    if (tellsLoss(vertex.diagnostics())) return vertex.diagnostics();
    Result<GlShader> fragment = compileStage(gl, GL_FRAGMENT_SHADER, desc.fragment, desc.label);
    if (!vertex || !fragment) {
        Diagnostics errors = vertex.diagnostics();
        append(errors, fragment.diagnostics());
        return errors;
    }
    GlProgram program(gl, gl.CreateProgram());
    const GLuint shaders[] = {vertex->name(), fragment->name()};
    for (GLuint shader : shaders) gl.AttachShader(program.name(), shader);
    cache.announce(gl, program.name());
    gl.LinkProgram(program.name());
    for (GLuint shader : shaders) gl.DetachShader(program.name(), shader);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (!linked)
        return explain(gl, desc.fragment, Code::shader_link, desc.label, "link",
                       readLog(program.name(), gl.GetProgramiv, gl.GetProgramInfoLog));
    return program;
}

}  // namespace

Result<GlLinkedProgram> makeProgram(GlApi& gl, const GlProgramCache& cache, const ProgramDesc& desc)
{
    const std::string key = cache.key(desc);
    GlProgram program = cache.load(gl, key);
    const bool missed = program.name() == 0;
    if (missed) {
        Result<GlProgram> compiled = compile(gl, cache, desc);
        if (!compiled) return compiled.diagnostics();
        program = std::move(*compiled);
    }
    setLabel(gl, GL_PROGRAM, program.name(), desc.label);
    std::vector<UniformInfo> uniforms = readUniforms(gl, program.name());
    if (Status status = takeErrors(gl, "createProgram", desc.label.c_str()); !status)
        return status.diagnostics();
    if (missed) cache.store(gl, key, program.name());
    return GlLinkedProgram{std::move(program), std::move(uniforms)};
}

void setUniformValues(const GlApi& gl, int location, GlslType type, int count, const void* data)
{
    const auto* floats = static_cast<const GLfloat*>(data);
    const auto* ints = static_cast<const GLint*>(data);
    switch (type) {
    case GlslType::float_: gl.Uniform1fv(location, count, floats); break;
    case GlslType::vec2: gl.Uniform2fv(location, count, floats); break;
    case GlslType::vec3: gl.Uniform3fv(location, count, floats); break;
    case GlslType::vec4: gl.Uniform4fv(location, count, floats); break;
    case GlslType::bool_:
    case GlslType::int_: gl.Uniform1iv(location, count, ints); break;
    case GlslType::ivec2: gl.Uniform2iv(location, count, ints); break;
    case GlslType::ivec3: gl.Uniform3iv(location, count, ints); break;
    case GlslType::ivec4: gl.Uniform4iv(location, count, ints); break;
    case GlslType::uint_: gl.Uniform1uiv(location, count, static_cast<const GLuint*>(data)); break;
    case GlslType::mat3: gl.UniformMatrix3fv(location, count, GL_FALSE, floats); break;
    case GlslType::mat4: gl.UniformMatrix4fv(location, count, GL_FALSE, floats); break;
    case GlslType::sampler2d:
    case GlslType::sampler2d_ms:
    case GlslType::sampler3d:
    case GlslType::other: assert(false && "set samplers with setTexture"); break;
    }
}

}  // namespace crevice
