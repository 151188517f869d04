// SPDX-License-Identifier: MIT
#include "tests/backends/host/states/random_host.h"

namespace crevice {

namespace {

constexpr int kDrawBuffers = 8;  // the most that a device draws into
constexpr int kViewports = 16;

GLenum compare(Random& r)
{
    return r.pick<GLenum>(
        {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS});
}

GLenum factor(Random& r)
{
    return r.pick<GLenum>({GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
                           GL_DST_ALPHA, GL_ONE_MINUS_DST_COLOR, GL_CONSTANT_COLOR,
                           GL_ONE_MINUS_CONSTANT_ALPHA});
}

GLenum equation(Random& r)
{
    return r.pick<GLenum>(
        {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX});
}

GLenum stencilAct(Random& r)
{
    return r.pick<GLenum>(
        {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP});
}

GLboolean flag(Random& r) { return r.coin() ? GL_TRUE : GL_FALSE; }

void setBlending(const GlCalls& gl, Random& r)
{
    gl("glBlendColor", r.unit(), r.unit(), r.unit(), r.unit());
    gl("glBlendFuncSeparate", factor(r), factor(r), factor(r), factor(r));
    gl("glBlendEquationSeparate", equation(r), equation(r));
    gl("glColorMask", flag(r), flag(r), flag(r), flag(r));
    const bool apart = r.coin();
    for (GLuint i = 0; apart && i < kDrawBuffers; ++i) {
        gl("glBlendFuncSeparatei", i, factor(r), factor(r), factor(r), factor(r));
        gl("glBlendEquationSeparatei", i, equation(r), equation(r));
        gl("glColorMaski", i, flag(r), flag(r), flag(r), flag(r));
    }
    constexpr GLenum kAdvanced = 0x9294;  // GL_MULTIPLY, as OpenGL ES 3.2 has it
    if (r.below(4) == 0) gl("glBlendEquation", kAdvanced);
    if (r.below(4) == 0) gl("glBlendEquationi", GLuint(r.below(kDrawBuffers)), kAdvanced);
}

void setFragments(const GlCalls& gl, Random& r)
{
    for (const GLenum face : {GL_FRONT, GL_BACK}) {
        gl("glStencilFuncSeparate", face, compare(r), GLint(r.below(256)), GLuint(r.bits()));
        gl("glStencilOpSeparate", face, stencilAct(r), stencilAct(r), stencilAct(r));
        gl("glStencilMaskSeparate", face, GLuint(r.bits()));
    }
    gl("glDepthMask", flag(r));
    gl("glDepthFunc", compare(r));
    gl("glSampleCoverage", r.unit(), flag(r));
    gl("glSampleMaski", GLuint(0), GLbitfield(r.bits()));
    gl("glMinSampleShading", r.unit());
    gl("glLogicOp", GLenum(0x1500 + r.below(16)));
    gl("glClearColor", r.unit(), r.unit(), r.unit(), r.unit());
    gl("glClearDepthf", r.unit());
    gl("glClearStencil", GLint(r.below(256)));
    gl("glDepthBoundsEXT", double(r.unit() / 2), double(r.unit() / 2 + 0.5f));
}

void setGeometry(const GlCalls& gl, Random& r)
{
    gl("glViewport", GLint(r.below(9)), GLint(r.below(9)), GLsizei(r.below(99)),
       GLsizei(r.below(99)));
    gl("glScissor", GLint(r.below(9)), GLint(r.below(9)), GLsizei(r.below(9)), GLsizei(r.below(9)));
    gl("glDepthRangef", r.unit(), r.unit());
    if (r.coin()) gl("glDepthRange", r.below(1000) / 1000.0, r.below(1000) / 1000.0);
    const bool apart = r.coin();
    for (GLuint i = 0; apart && i < kViewports; ++i) {
        gl("glViewportIndexedf", i, r.unit(), r.unit(), 20 * r.unit(), 20 * r.unit());
        gl("glScissorIndexed", i, GLint(r.below(9)), GLint(r.below(9)), GLsizei(r.below(9)),
           GLsizei(r.below(9)));
        gl("glDepthRangeIndexed", i, r.below(1000) / 1000.0, double(r.unit()));
        gl("glDepthRangeIndexedfOES", i, r.unit(), r.unit());
    }
    gl("glCullFace", r.pick<GLenum>({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
    gl("glFrontFace", r.pick<GLenum>({GL_CW, GL_CCW}));
    gl("glPolygonOffset", 4 * r.unit() - 2, 4 * r.unit() - 2);
    gl("glPolygonOffsetClamp", 4 * r.unit() - 2, 4 * r.unit() - 2, r.unit());
    gl("glPolygonMode", GLenum(GL_FRONT_AND_BACK), GLenum(0x1B00 + r.below(3)));
    gl("glPolygonMode", GLenum(GL_BACK), GLenum(0x1B00 + r.below(3)));
    gl("glLineWidth", 0.5f + r.unit());
    gl("glPointSize", 0.5f + r.unit());
    gl("glPointParameterf", GLenum(0x8128), r.unit());                    // fade threshold
    gl("glPointParameteri", GLenum(0x8CA0), GLint(0x8CA1 + r.below(2)));  // sprite's origin
    gl("glProvokingVertex", GLenum(0x8E4D + r.below(2)));
    gl("glPrimitiveRestartIndex", GLuint(r.below(6)));
    gl("glClipControl", GLenum(0x8CA1 + r.below(2)), GLenum(0x935E + r.below(2)));
    gl("glPatchParameteri", GLenum(GL_PATCH_VERTICES), GLint(1 + r.below(32)));
    const float levels[] = {1 + r.unit(), 1 + r.unit(), 1 + r.unit(), 1 + r.unit()};
    gl("glPatchParameterfv", GLenum(0x8E73), &levels[2]);
    gl("glPatchParameterfv", GLenum(0x8E74), &levels[0]);
    gl("glPrimitiveBoundingBox", -r.unit(), -r.unit(), -r.unit(), 1.0f, r.unit(), r.unit(),
       r.unit(), 1.0f);
    gl("glAlphaFunc", compare(r), r.unit());
    gl("glShadeModel", GLenum(0x1D00 + r.below(2)));
}

void setStipples(const GlCalls& gl, Random& r)
{
    gl("glLineStipple", GLint(1 + r.below(9)), GLushort(r.bits()));
    GLubyte stipple[256];  // in rows of up to 8 bytes
    for (GLubyte& each : stipple) each = static_cast<GLubyte>(r.bits());
    gl("glPolygonStipple", static_cast<const GLubyte*>(stipple));
}

}  // namespace

Settings::Settings(const GlApi& gl, const GlCalls& calls) : gl_(gl), calls_(calls)
{
    hints_ = acceptedNames(gl, [&](GLenum name) { calls("glHint", name, GLenum(GL_DONT_CARE)); });
    pixel_stores_ = acceptedNames(gl, [&](GLenum name) {
        Numbers value;
        gl.GetIntegerv(name, value.data());
        gl.PixelStorei(name, value[0]);
    });
}

void Settings::randomize(Random& random) const
{
    for (const GLenum name : hints_)
        calls_("glHint", name, random.pick<GLenum>({GL_DONT_CARE, GL_FASTEST, GL_NICEST}));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);  // the polygon stipple comes from memory
    for (const GLenum name : pixel_stores_) gl_.PixelStorei(name, 0);
    setStipples(calls_, random);
    for (const GLenum name : pixel_stores_)
        gl_.PixelStorei(name, random.below(2) << random.below(4));
    setBlending(calls_, random);
    setFragments(calls_, random);
    setGeometry(calls_, random);
    quiet(gl_);
}

}  // namespace crevice
