// SPDX-License-Identifier: MIT
#include "tests/support/watched_gl.h"

#include <set>

namespace crevice {

namespace {

WatchedGl* watched = nullptr;

template <auto>
struct Constant {
};

/// Whether a member of the table is one of those; they may differ in type.
template <auto Member, auto... Others>
constexpr bool isAny = (std::is_same_v<Constant<Member>, Constant<Others>> || ...);

template <auto M>
constexpr bool kTakesMemory =
    isAny<M, &GlApi::BufferData, &GlApi::CheckFramebufferStatus, &GlApi::CompileShader,
          &GlApi::CreateProgram, &GlApi::CreateShader, &GlApi::DrawArrays, &GlApi::DrawElements,
          &GlApi::GetProgramBinary, &GlApi::LinkProgram, &GlApi::ProgramBinary, &GlApi::ReadPixels,
          &GlApi::RenderbufferStorageMultisample, &GlApi::TexImage2D, &GlApi::TexStorage2D,
          &GlApi::TexSubImage2D>;

template <auto M>
constexpr bool kCreates = isAny<M, &GlApi::CreateProgram, &GlApi::CreateShader>;

template <auto M>
constexpr bool kDeletes = isAny<M, &GlApi::DeleteProgram, &GlApi::DeleteShader>;

template <auto M>
constexpr bool kGenerates = isAny<M, &GlApi::GenBuffers, &GlApi::GenFramebuffers,
                                  &GlApi::GenQueries, &GlApi::GenRenderbuffers, &GlApi::GenSamplers,
                                  &GlApi::GenTextures, &GlApi::GenVertexArrays>;

template <auto M>
constexpr bool kDegenerates =
    isAny<M, &GlApi::DeleteBuffers, &GlApi::DeleteFramebuffers, &GlApi::DeleteQueries,
          &GlApi::DeleteRenderbuffers, &GlApi::DeleteSamplers, &GlApi::DeleteTextures,
          &GlApi::DeleteVertexArrays>;

/// By how much a call changes the count of names.
template <auto Member, class First, class... Others>
int namesOf(First first, Others...)
{
    if constexpr (kGenerates<Member>) return first;
    if constexpr (kDegenerates<Member>) return -first;
    return kDeletes<Member> ? -1 : 0;
}

template <auto Member>
int namesOf()
{
    return 0;
}

std::string nameOf(GLenum attachment)
{
    if (attachment == GL_DEPTH_ATTACHMENT) return " depth";
    return " color" + std::to_string(attachment - GL_COLOR_ATTACHMENT0);
}

}  // namespace

template <auto Member>
struct Hook;

template <class Value, class... Arguments, Value (GL_APIENTRY* GlApi::*Member)(Arguments...)>
struct Hook<Member> {
    static Value GL_APIENTRY call(Arguments... arguments)
    {
        if constexpr (isAny<Member, &GlApi::GetError>) return watched->takeError();
        if (!watched->arrives()) {
            if constexpr (isAny<Member, &GlApi::GetGraphicsResetStatus>)
                return watched->takeReset();
            return Value();
        }
        if constexpr (isAny<Member, &GlApi::CompileShader>) ++watched->compiles_;
        if constexpr (isAny<Member, &GlApi::ProgramBinary>) ++watched->binaries_;
        logCall(arguments...);
        if constexpr (kTakesMemory<Member>)
            if (watched->failsNow()) return refusal();
        watched->names_ += namesOf<Member>(arguments...);
        if constexpr (kCreates<Member>) ++watched->names_;
        return (watched->below_.*Member)(arguments...);
    }

    static void logCall([[maybe_unused]] Arguments... arguments)
    {
        if constexpr (isAny<Member, &GlApi::ClearBufferfv>) logClear(arguments...);
        if constexpr (isAny<Member, &GlApi::InvalidateFramebuffer>) logInvalidate(arguments...);
        if constexpr (isAny<Member, &GlApi::DrawArrays, &GlApi::DrawElements>) watched->log("draw");
    }

    static void logClear(GLenum buffer, GLint index, const GLfloat*)
    {
        watched->log("clear" + nameOf(buffer == GL_DEPTH ? GL_DEPTH_ATTACHMENT
                                                         : GL_COLOR_ATTACHMENT0 + index));
    }

    static void logInvalidate(GLenum, GLsizei count, const GLenum* attachments)
    {
        std::string words = "invalidate";
        for (GLsizei i = 0; i < count; ++i) words += nameOf(attachments[i]);
        watched->log(words);
    }

    static Value refusal()
    {
        if constexpr (isAny<Member, &GlApi::CheckFramebufferStatus>)
            return GL_FRAMEBUFFER_UNSUPPORTED;
        else
            return watched->pending_ = GL_OUT_OF_MEMORY, Value();
    }
};

namespace {

// No GL at all. Names of all kinds are distinct.
GLuint last_name = 0;
GLuint last_divisor = 0;  // of one vertex array, that of the last device
std::set<GLuint> made;    // shaders that were compiled, programs that were linked
FakeDriver driver;
GLenum fake_error = GL_NO_ERROR;

void GL_APIENTRY generate(GLsizei count, GLuint* names)
{
    for (GLsizei i = 0; i < count; ++i) names[i] = ++last_name;
}

void GL_APIENTRY make(GLuint name)
{
    if (name != 0) made.insert(name);
}

void GL_APIENTRY tellMade(GLuint name, GLenum what, GLint* value)
{
    const bool asked = what == GL_COMPILE_STATUS || what == GL_LINK_STATUS;
    *value = asked && made.count(name) ? GL_TRUE : 0;
    if (what == GL_PROGRAM_BINARY_LENGTH) *value = sizeof(driver.build);
}

constexpr GLint kBinaryFormat = 0x1234;

void GL_APIENTRY giveBinary(GLuint, GLsizei, GLsizei* length, GLenum* format, void* binary)
{
    *length = sizeof(driver.build);
    *format = kBinaryFormat;
    *static_cast<unsigned char*>(binary) = driver.build;
}

void GL_APIENTRY takeBinary(GLuint program, GLenum format, const void* binary, GLsizei length)
{
    const bool own = length == sizeof(driver.build) && format == kBinaryFormat &&
                     *static_cast<const unsigned char*>(binary) == driver.build;
    if (own)
        make(program);
    else if (!driver.silent)
        fake_error = GL_INVALID_VALUE;
}

const GLubyte* GL_APIENTRY tellName(GLenum what)
{
    const char* name = what == GL_VENDOR     ? "a vendor"
                       : what == GL_RENDERER ? driver.renderer
                                             : driver.version;
    return reinterpret_cast<const GLubyte*>(name);
}

void GL_APIENTRY tellLimit(GLenum name, GLint* value)
{
    if (name == GL_MAX_TEXTURE_SIZE) *value = 4096;
    if (name == GL_MAX_COLOR_ATTACHMENTS || name == GL_MAX_DRAW_BUFFERS) *value = 8;
    if (name == GL_MAX_TEXTURE_IMAGE_UNITS) *value = 16;
    if (name == GL_MAX_FRAGMENT_UNIFORM_VECTORS || name == GL_MAX_VERTEX_UNIFORM_VECTORS)
        *value = 256;
    if (name == GL_NUM_EXTENSIONS) *value = 0;
    if (name == GL_NUM_PROGRAM_BINARY_FORMATS) *value = driver.binary_formats;
    if (name == GL_PROGRAM_BINARY_FORMATS && driver.binary_formats > 0) *value = kBinaryFormat;
}

/// Every image holds as many bits as any format has.
void GL_APIENTRY tellHeld(GLenum, GLenum, GLenum what, GLint* value)
{
    constexpr GLint kMostBits = 32;
    *value = what == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING   ? GL_LINEAR
             : what == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE ? GL_UNSIGNED_NORMALIZED
                                                                : kMostBits;
}

template <class Value, class... Arguments>
void doNothing(Value(GL_APIENTRY*& function)(Arguments...))
{
    function = [](Arguments...) -> Value { return Value(); };
}

GlApi noGl()
{
    GlApi gl;
#define CREVICE_GL_NOTHING(name, upper, required) doNothing(gl.name);
    CREVICE_GL_FUNCTIONS(CREVICE_GL_NOTHING)
#undef CREVICE_GL_NOTHING
    for (auto* function : {&gl.GenBuffers, &gl.GenFramebuffers, &gl.GenRenderbuffers,
                           &gl.GenSamplers, &gl.GenTextures, &gl.GenVertexArrays})
        *function = generate;
    gl.CreateProgram = [] { return ++last_name; };
    gl.CreateShader = [](GLenum) { return ++last_name; };
    gl.CompileShader = gl.LinkProgram = make;
    gl.DeleteShader = gl.DeleteProgram = [](GLuint name) { made.erase(name); };
    gl.GetShaderiv = gl.GetProgramiv = tellMade;
    gl.GetIntegerv = tellLimit;
    gl.GetProgramBinary = giveBinary;
    gl.ProgramBinary = takeBinary;
    gl.GetFramebufferAttachmentParameteriv = tellHeld;
    gl.GetString = tellName;
    gl.GetError = [] { return std::exchange(fake_error, GLenum(GL_NO_ERROR)); };
    gl.CheckFramebufferStatus = [](GLenum) -> GLenum { return GL_FRAMEBUFFER_COMPLETE; };
    gl.IsTexture = gl.IsVertexArray = [](GLuint name) -> GLboolean { return name != 0; };
    gl.VertexAttribDivisor = [](GLuint, GLuint divisor) { last_divisor = divisor; };
    gl.GetVertexAttribiv = [](GLuint, GLenum, GLint* value) {
        *value = static_cast<GLint>(last_divisor);
    };
    return gl;
}

}  // namespace

WatchedGl::WatchedGl(const FakeDriver& fake) : below_(noGl())
{
    driver = fake;
    fake_error = GL_NO_ERROR;
    watched = this;
}

WatchedGl::WatchedGl(const GlLoader& real) : below_(loadGlApi(real).value()), real_(real)
{
    watched = this;
}

WatchedGl::~WatchedGl() { watched = nullptr; }

GlLoader WatchedGl::loader() const
{
    return [this](const char* wanted) -> void* {
        const std::string name = wanted;
#define CREVICE_GL_HOOK(function, upper, required) \
    if (name == "gl" #function && below_.function) \
        return reinterpret_cast<void*>(&Hook<&GlApi::function>::call);
        CREVICE_GL_FUNCTIONS(CREVICE_GL_HOOK)
#undef CREVICE_GL_HOOK
        return real_ ? real_(wanted) : nullptr;
    };
}

void WatchedGl::loseAt(int n, Loss loss)
{
    lose_in_ = n;
    loss_ = loss;
}

/// Counts a call; false when the context is lost.
bool WatchedGl::arrives()
{
    ++calls_;
    if (lose_in_ > 0 && --lose_in_ == 0) lost_ = true;
    if (lost_ && loss_ == Loss::by_commands) pending_ = GL_CONTEXT_LOST;
    return !lost_;
}

bool WatchedGl::failsNow()
{
    ++attempts_;
    return fail_in_ > 0 && --fail_in_ == 0;
}

GLenum WatchedGl::takeError()
{
    ++calls_;
    if (lost_ && loss_ == Loss::for_ever) return GL_CONTEXT_LOST;
    if (pending_ != GL_NO_ERROR || lost_) return std::exchange(pending_, GL_NO_ERROR);
    return below_.GetError();
}

GLenum WatchedGl::takeReset()
{
    const bool reports = loss_ == Loss::by_status && !std::exchange(reset_reported_, true);
    return reports ? GL_UNKNOWN_CONTEXT_RESET : GL_NO_ERROR;
}

}  // namespace crevice
