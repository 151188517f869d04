// SPDX-License-Identifier: MIT
#include "tests/backends/host/states/state_reader.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace crevice {

namespace {

constexpr std::size_t kKept = 16;     // a matrix has as many
constexpr GLint kUnset = 0x7fb1dead;  // as a float no number

/// Adds what `ask` writes.
template <class Ask>
void add(Snapshot& into, const char* function, GLenum name, GLuint object, Ask ask)
{
    static thread_local Numbers numbers;
    std::fill_n(numbers.begin(), kKept + 1, kUnset);
    ask(numbers.data());
    for (std::size_t i = 0; i < kKept && numbers[i] != kUnset; ++i)
        into.push_back({function, name, object, numbers[i]});
}

GLfloat* floats(GLint* numbers) { return reinterpret_cast<GLfloat*>(numbers); }

/// How many indices each name has that `call` takes with index 0.
template <class Call>
std::vector<std::pair<GLenum, GLuint>> indexedNames(const GlApi& gl, Call call)
{
    constexpr GLuint kMost = 128;
    std::vector<std::pair<GLenum, GLuint>> found;
    for (const GLenum name : acceptedNames(gl, [&](GLenum each) { call(each, 0); })) {
        GLuint count = 1;
        for (; count < kMost; ++count) {
            call(name, count);
            if (quiet(gl) != GL_NO_ERROR) break;
        }
        found.emplace_back(name, count);
    }
    return found;
}

constexpr GLenum kAttachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1,
                                   GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT};

}  // namespace

std::string difference(const Snapshot& before, const Snapshot& after)
{
    constexpr int kTold = 10;
    std::ostringstream text;
    if (before.size() != after.size())
        text << before.size() << " values before, " << after.size() << " after\n";
    int told = 0;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        const StateValue &a = before[i], &b = after[i];
        if (a.name == b.name && a.bits == b.bits) continue;
        if (told++ < kTold)
            text << std::hex << a.function << " 0x" << a.name << " of " << std::dec << a.object
                 << ": " << a.bits << " became " << b.bits << '\n';
    }
    if (told > kTold) text << "and " << told - kTold << " more\n";
    return text.str();
}

StateReader::StateReader(const GlApi& gl, const GlCalls& calls) : gl_(gl), calls_(calls)
{
    Numbers out;
    GLint* const to = out.data();
    gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units_);
    gl.GetIntegerv(GL_MAX_VERTEX_ATTRIBS, &attributes_);
    plain_ = acceptedNames(gl, [&](GLenum name) { gl.GetIntegerv(name, to); });
    switches_ = acceptedNames(
        gl, [&](GLenum name) { (gl.IsEnabled(name) ? gl.Enable : gl.Disable)(name); });
    indexed_ = indexedNames(gl, [&](GLenum name, GLuint i) { gl.GetIntegeri_v(name, i, to); });
    if (gl.IsEnabledi)
        indexed_switches_ = indexedNames(gl, [&](GLenum name, GLuint i) {
            // Mesa takes an index even where it tells of no second viewport.
            if (name == GL_SCISSOR_TEST && !gl.ScissorIndexed) return gl.Enable(0xFFFF);
            (gl.IsEnabledi(name, i) ? gl.Enablei : gl.Disablei)(name, i);
        });
    texture_ =
        acceptedNames(gl, [&](GLenum name) { gl.GetTexParameteriv(GL_TEXTURE_2D, name, to); });
    renderbuffer_ = acceptedNames(
        gl, [&](GLenum name) { gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, name, to); });
    attribute_ = acceptedNames(gl, [&](GLenum name) { gl.GetVertexAttribiv(1, name, to); });
    buffer_ =
        acceptedNames(gl, [&](GLenum name) { gl.GetBufferParameteriv(GL_ARRAY_BUFFER, name, to); });
    framebuffer_ = acceptedNames(gl, [&](GLenum name) {
        gl.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, name, to);
    });
    GLint bound = 0;
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &bound);
    program_ = acceptedNames(
        gl, [&](GLenum name) { gl.GetProgramiv(static_cast<GLuint>(bound), name, to); });
    gl.GetIntegerv(GL_SAMPLER_BINDING, &bound);
    sampler_ = acceptedNames(gl, [&](GLenum name) {
        calls_("glGetSamplerParameteriv", static_cast<GLuint>(bound), name, to);
    });
    findUnitNames();
}

void StateReader::findUnitNames()
{
    const auto value = [this](GLenum unit, GLenum name) {
        Numbers out;
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.GetIntegerv(name, out.data());
        return out[0];
    };
    for (const GLenum name : plain_)
        if (name != GL_ACTIVE_TEXTURE && value(0, name) != value(1, name))
            unit_names_.push_back(name);
    gl_.ActiveTexture(GL_TEXTURE0);
}

Snapshot StateReader::read(const WatchedObjects& objects) const
{
    Snapshot values;
    values.reserve(16384);
    readContext(values);
    readUnits(values);
    readFramebuffers(objects, values);
    readVertexArrays(objects, values);
    readTextures(objects, values);
    readObjects(objects, values);
    quiet(gl_);
    return values;
}

void StateReader::readContext(Snapshot& into) const
{
    for (const GLenum name : plain_) {
        add(into, "glGetIntegerv", name, 0, [&](GLint* to) { gl_.GetIntegerv(name, to); });
        add(into, "glGetFloatv", name, 0, [&](GLint* to) { gl_.GetFloatv(name, floats(to)); });
    }
    for (const GLenum name : switches_)
        into.push_back({"glIsEnabled", name, 0, gl_.IsEnabled(name)});
    for (const auto& [name, count] : indexed_switches_)
        for (GLuint i = 0; i < count; ++i)
            into.push_back({"glIsEnabledi", name, i, gl_.IsEnabledi(name, i)});
    for (const auto& [name, count] : indexed_)
        for (GLuint i = 0; i < count; ++i) {
            add(into, "glGetIntegeri_v", name, i,
                [&, name = name](GLint* to) { gl_.GetIntegeri_v(name, i, to); });
            add(into, "glGetFloati_v", name, i,
                [&, name = name](GLint* to) { calls_("glGetFloati_v", name, i, floats(to)); });
        }
}

void StateReader::readUnits(Snapshot& into) const
{
    GLint active = 0;
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLint unit = 0; unit < units_; ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        for (const GLenum name : unit_names_)
            add(into, "glGetIntegerv of unit", name, unit,
                [&](GLint* to) { gl_.GetIntegerv(name, to); });
    }
    gl_.ActiveTexture(active);
}

void StateReader::readFramebuffers(const WatchedObjects& objects, Snapshot& into) const
{
    GLint draw = 0, read = 0;
    gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw);
    gl_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    for (const GLuint framebuffer : objects.framebuffers) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        for (const GLenum point : kAttachments)
            for (const GLenum name : framebuffer_)
                add(into, "glGetFramebufferAttachmentParameteriv", name, framebuffer,
                    [&](GLint* to) {
                        gl_.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, point, name,
                                                                to);
                    });
        for (GLenum name = GL_DRAW_BUFFER0; name <= GL_DRAW_BUFFER7; ++name)
            add(into, "draw buffer", name, framebuffer,
                [&](GLint* to) { gl_.GetIntegerv(name, to); });
        add(into, "read buffer", GL_READ_BUFFER, framebuffer,
            [&](GLint* to) { gl_.GetIntegerv(GL_READ_BUFFER, to); });
    }
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, draw);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, read);
}

void StateReader::readVertexArrays(const WatchedObjects& objects, Snapshot& into) const
{
    GLint bound = 0;
    gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    for (const GLuint array : objects.vertex_arrays) {
        gl_.BindVertexArray(array);
        add(into, "indices of array", GL_ELEMENT_ARRAY_BUFFER_BINDING, array,
            [&](GLint* to) { gl_.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, to); });
        for (GLint i = 0; i < attributes_; ++i)
            for (const GLenum name : attribute_) {
                add(into, "glGetVertexAttribiv", name, i,
                    [&](GLint* to) { gl_.GetVertexAttribiv(i, name, to); });
                add(into, "glGetVertexAttribfv", name, i,
                    [&](GLint* to) { calls_("glGetVertexAttribfv", GLuint(i), name, floats(to)); });
            }
    }
    gl_.BindVertexArray(bound);
}

/// Through the last unit, which no host uses.
void StateReader::readTextures(const WatchedObjects& objects, Snapshot& into) const
{
    GLint active = 0;
    gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    gl_.ActiveTexture(GL_TEXTURE0 + units_ - 1);
    for (const auto& [target, texture] : objects.textures) {
        gl_.BindTexture(target, texture);
        for (const GLenum name : texture_)
            add(into, "glGetTexParameteriv", name, texture,
                [&, target = target](GLint* to) { gl_.GetTexParameteriv(target, name, to); });
        gl_.BindTexture(target, 0);
    }
    gl_.ActiveTexture(active);
}

void StateReader::readObjects(const WatchedObjects& objects, Snapshot& into) const
{
    for (const GLuint sampler : objects.samplers)
        for (const GLenum name : sampler_)
            add(into, "glGetSamplerParameteriv", name, sampler,
                [&](GLint* to) { calls_("glGetSamplerParameteriv", sampler, name, to); });
    GLint bound = 0;
    gl_.GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    for (const GLuint buffer : objects.renderbuffers) {
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        for (const GLenum name : renderbuffer_)
            add(into, "glGetRenderbufferParameteriv", name, buffer,
                [&](GLint* to) { gl_.GetRenderbufferParameteriv(GL_RENDERBUFFER, name, to); });
    }
    gl_.BindRenderbuffer(GL_RENDERBUFFER, bound);
    gl_.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    for (const GLuint buffer : objects.buffers) {
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer);
        for (const GLenum name : buffer_)
            add(into, "glGetBufferParameteriv", name, buffer,
                [&](GLint* to) { gl_.GetBufferParameteriv(GL_ARRAY_BUFFER, name, to); });
    }
    gl_.BindBuffer(GL_ARRAY_BUFFER, bound);
    for (const GLuint program : objects.programs) {
        for (const GLenum name : program_)
            add(into, "glGetProgramiv", name, program,
                [&](GLint* to) { gl_.GetProgramiv(program, name, to); });
        const GLint tint = gl_.GetUniformLocation(program, "tint");
        add(into, "glGetUniformfv", 0, program,
            [&](GLint* to) { calls_("glGetUniformfv", program, tint, floats(to)); });
    }
}

}  // namespace crevice
