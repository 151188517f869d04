// SPDX-License-Identifier: MIT
#include "tests/backends/host/states/random_host.h"

#include "backends/gl/formats.h"
#include "tests/support/gl_fixture.h"

namespace crevice {

namespace {

constexpr GLsizeiptr kBytes = 4096;
constexpr int kBuffers = 4;
constexpr GLenum kIndexedTargets[] = {GL_UNIFORM_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER,
                                      GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER};

template <class Object>
GLuint nameOr0(Random& random, const std::vector<Object>& objects)
{
    return random.below(4) == 0 ? 0 : objects[random.below(int(objects.size()))].name();
}

}  // namespace

RandomHost::RandomHost(const GlApi& gl, const GlLoader& load) : gl_(gl), calls_(load)
{
    gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units_);
    settings_.emplace(gl, calls_);
    makeBuffers();
    makeTextures();
    makeFramebuffers();
    program_ = GlProgram(gl, makeProgram());
    watched_.programs = {program_.name()};
    gl.UseProgram(program_.name());
    calls_("glGenProgramPipelines", GLsizei(1), &pipeline_);
    calls_("glGenTransformFeedbacks", GLsizei(1), &feedback_);
    reader_.emplace(gl, calls_);
}

RandomHost::~RandomHost()
{
    endFeedback();
    calls_("glDeleteProgramPipelines", GLsizei(1), static_cast<const GLuint*>(&pipeline_));
    calls_("glDeleteTransformFeedbacks", GLsizei(1), static_cast<const GLuint*>(&feedback_));
    quiet(gl_);
}

/// One of every kind that the context has, left bound to unit 0.
void RandomHost::makeTextures()
{
    texture_targets_ = acceptedNames(gl_, [&](GLenum target) { gl_.BindTexture(target, 0); });
    for (const GLenum target : texture_targets_) {
        const GLuint name = textures_.emplace_back(GlTexture::make(gl_)).name();
        gl_.BindTexture(target, name);
        watchTexture(target, name);
    }
    for (int i = 0; i < 2; ++i) {
        samplers_.push_back(GlSampler::make(gl_));
        gl_.BindSampler(0, samplers_.back().name());
        watched_.samplers.push_back(samplers_.back().name());
    }
}

void RandomHost::makeBuffers()
{
    for (int i = 0; i < kBuffers; ++i) {
        const GLuint name = buffers_.emplace_back(GlBuffer::make(gl_)).name();
        gl_.BindBuffer(GL_ARRAY_BUFFER, name);
        gl_.BufferData(GL_ARRAY_BUFFER, kBytes, nullptr, GL_STATIC_DRAW);
        watched_.buffers.push_back(name);
    }
    for (int i = 0; i < 2; ++i) {
        arrays_.push_back(GlVertexArray::make(gl_));
        watched_.vertex_arrays.push_back(arrays_.back().name());
    }
    gl_.BindVertexArray(arrays_[0].name());
    buffer_targets_ = acceptedNames(gl_, [&](GLenum target) { gl_.BindBuffer(target, 0); });
}

void RandomHost::makeFramebuffers()
{
    renderbuffer_ = GlRenderbuffer::make(gl_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer_.name());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH24_STENCIL8, 4, 4);
    watched_.renderbuffers = {renderbuffer_.name()};
    for (int i = 0; i < 2; ++i) {
        const GLuint texture = textures_.emplace_back(GlTexture::make(gl_)).name();
        gl_.BindTexture(GL_TEXTURE_2D, texture);
        allocateTexture(gl_, GL_RGBA8, {4, 4});
        watchTexture(GL_TEXTURE_2D, texture);
        framebuffers_.push_back(GlFramebuffer::make(gl_));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().name());
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                    renderbuffer_.name());
        watchFramebuffer(framebuffers_.back().name());
    }
}

/// It captures, and has a uniform to be spoilt.
GLuint RandomHost::makeProgram()
{
    const GLuint made = gl_.CreateProgram();
    const std::string version = gl_.glsl_330 ? "#version 330\n" : "#version 300 es\n";
    const std::string vertex = version + "void main() { gl_Position = vec4(0.0); }\n";
    const std::string painted =
        version + "uniform highp vec4 tint; out highp vec4 c; void main() { c = tint; }\n";
    for (const auto& [type, text] :
         {std::pair(GL_VERTEX_SHADER, &vertex), {GL_FRAGMENT_SHADER, &painted}}) {
        const GlShader shader(gl_, gl_.CreateShader(type));
        const char* const source = text->c_str();
        gl_.ShaderSource(shader.name(), 1, &source, nullptr);
        gl_.CompileShader(shader.name());
        gl_.AttachShader(made, shader.name());
    }
    const char* const captured[] = {"gl_Position"};
    calls_("glTransformFeedbackVaryings", made, GLsizei(1),
           static_cast<const char* const*>(captured), GLenum(GL_INTERLEAVED_ATTRIBS));
    gl_.LinkProgram(made);
    return made;
}

void RandomHost::endFeedback()
{
    GLboolean active = GL_FALSE;
    gl_.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    if (active) calls_("glEndTransformFeedback");
    quiet(gl_);
}

void RandomHost::randomize(std::uint32_t seed)
{
    Random random(seed);
    endFeedback();
    settings_->randomize(random);
    for (const GLenum name : reader_->switches()) (random.coin() ? gl_.Enable : gl_.Disable)(name);
    const bool apart = random.coin();
    for (const auto& [name, count] : reader_->indexedSwitches())
        for (GLuint i = 0; apart && i < count; ++i)
            (random.coin() ? gl_.Enablei : gl_.Disablei)(name, i);
    randomizeArrays(random);
    randomizeBuffers(random);
    randomizeTextures(random);
    randomizeImages(random);
    randomizeFeedback(random);
    quiet(gl_);
}

void RandomHost::randomizeTextures(Random& random)
{
    for (const auto& [target, texture] : watched_.textures) {
        gl_.BindTexture(target, texture);
        gl_.TexParameteri(target, GL_TEXTURE_MAG_FILTER,
                          random.pick<GLint>({GL_NEAREST, GL_LINEAR}));
        gl_.TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                          random.pick<GLint>({GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR}));
        gl_.TexParameteri(target, GL_TEXTURE_WRAP_S,
                          random.pick<GLint>({GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE}));
        gl_.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, random.below(9));
        gl_.TexParameteri(target, GL_TEXTURE_COMPARE_MODE,
                          random.pick<GLint>({GL_NONE, GL_COMPARE_REF_TO_TEXTURE}));
        gl_.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC,
                          random.pick<GLint>({GL_LEQUAL, GL_GREATER, GL_NEVER}));
        gl_.TexParameteri(target, GL_TEXTURE_MIN_LOD, random.below(4));
        gl_.TexParameteri(target, GL_TEXTURE_MAX_LOD, random.below(4));
    }
    for (const GlSampler& sampler : samplers_) {
        gl_.SamplerParameteri(sampler.name(), GL_TEXTURE_COMPARE_MODE,
                              random.pick<GLint>({GL_NONE, GL_COMPARE_REF_TO_TEXTURE}));
        gl_.SamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER,
                              random.pick<GLint>({GL_NEAREST, GL_LINEAR}));
        gl_.SamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T,
                              random.pick<GLint>({GL_REPEAT, GL_CLAMP_TO_EDGE}));
    }
    for (GLint unit = 0; unit < units_ - 1; ++unit) {  // the reader has the last one
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindSampler(unit, nameOr0(random, samplers_));
        for (const GLenum target : texture_targets_) gl_.BindTexture(target, 0);
        for (int i = 0; i < 4; ++i) {
            const auto [target, texture] = random.pick(watched_.textures);
            gl_.BindTexture(target, texture);
        }
    }
    gl_.ActiveTexture(GL_TEXTURE0 + random.below(units_ - 1));
}

void RandomHost::randomizeBuffers(Random& random)
{
    for (const GLenum target : kIndexedTargets)
        for (GLuint i = 0; i < 4; ++i) {
            const GLuint name = nameOr0(random, buffers_);
            if (random.coin())
                calls_("glBindBufferBase", target, i, name);
            else
                calls_("glBindBufferRange", target, i, name, GLintptr(256), GLsizeiptr(64));
        }
    for (const GLenum target : buffer_targets_) gl_.BindBuffer(target, nameOr0(random, buffers_));
}

void RandomHost::randomizeImages(Random& random)
{
    for (const GlFramebuffer& each : framebuffers_) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, each.name());
        const GLenum buffer = random.coin() ? GL_NONE : GL_COLOR_ATTACHMENT0;
        gl_.DrawBuffers(1, &buffer);
        gl_.ReadBuffer(random.coin() ? GL_NONE : GL_COLOR_ATTACHMENT0);
    }
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, nameOr0(random, framebuffers_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, nameOr0(random, framebuffers_));
    gl_.BindRenderbuffer(GL_RENDERBUFFER, random.coin() ? renderbuffer_.name() : 0);
    for (GLuint i = 0; i < 4; ++i)
        calls_("glBindImageTexture", i, random.coin() ? textures_.back().name() : 0, GLint(0),
               GLboolean(GL_FALSE), GLint(0),
               random.pick<GLenum>({GL_READ_ONLY, GL_WRITE_ONLY, GL_READ_WRITE}), GLenum(GL_RGBA8));
    calls_("glBindProgramPipeline", random.coin() ? pipeline_ : 0);
}

void RandomHost::randomizeArrays(Random& random)
{
    for (const GlVertexArray& array : arrays_) {
        gl_.BindVertexArray(array.name());
        for (GLuint i = 0; i < 8; ++i) {
            gl_.BindBuffer(GL_ARRAY_BUFFER, random.pick(watched_.buffers));
            gl_.VertexAttribPointer(i, 1 + random.below(4),
                                    random.pick<GLenum>({GL_FLOAT, GL_BYTE, GL_UNSIGNED_SHORT}),
                                    random.coin() ? GL_TRUE : GL_FALSE, 16 + random.below(16),
                                    reinterpret_cast<const void*>(std::size_t(random.below(64))));
            gl_.VertexAttribDivisor(i, random.below(3));
            calls_(random.coin() ? "glEnableVertexAttribArray" : "glDisableVertexAttribArray", i);
            calls_("glVertexAttrib4f", i, random.unit(), random.unit(), random.unit(),
                   random.unit());
        }
    }
    gl_.BindVertexArray(nameOr0(random, arrays_));
}

/// A program, and in one case of four transform feedback, which may be paused for another program.
void RandomHost::randomizeFeedback(Random& random)
{
    gl_.UseProgram(random.coin() ? program_.name() : 0);
    if (!gl_.PauseTransformFeedback) return;  // where none can be paused, drawing is refused
    calls_("glBindTransformFeedback", GLenum(GL_TRANSFORM_FEEDBACK), random.coin() ? feedback_ : 0);
    if (random.below(4) != 0) return;
    gl_.UseProgram(program_.name());
    gl_.Uniform4fv(gl_.GetUniformLocation(program_.name(), "tint"), 1,
                   &std::array{random.unit(), random.unit(), 0.0f, 1.0f}[0]);
    calls_("glBindBufferBase", GLenum(GL_TRANSFORM_FEEDBACK_BUFFER), GLuint(0), buffers_[0].name());
    calls_("glBeginTransformFeedback", GLenum(GL_TRIANGLES));
    if (random.coin()) return;
    gl_.PauseTransformFeedback();
    gl_.UseProgram(random.coin() ? program_.name() : 0);
}

Snapshot RandomHost::snapshot() { return reader_->read(watched_); }

}  // namespace crevice
