// SPDX-License-Identifier: MIT
// The table of GL functions, loaded from the current context, and the names of what they report.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/gl_device.h>

#define GL_GLES_PROTOTYPES 0  // types and constants only: nothing here can be linked by accident
#include <GLES3/gl32.h>
// Extensions, which need the types above.
#include <GLES2/gl2ext.h>

#include <string>

namespace crevice {

// Of desktop OpenGL alone.
typedef void(GL_APIENTRYP PFNGLDEPTHRANGEPROC)(double near_value, double far_value);
typedef void(GL_APIENTRYP PFNGLDEPTHRANGEINDEXEDPROC)(GLuint index, double near_value,
                                                      double far_value);
// Of WebGL, which maps no buffer to be read: there its own functions for that are missing.
typedef void(GL_APIENTRYP PFNGLGETBUFFERSUBDATAPROC)(GLenum target, GLintptr offset,
                                                     GLsizeiptr size, void* data);

// X(name, NAME, required): a context that lacks a required one is refused. The others are null
// where the context does not promise them; `settleOptional` sees to that.
#define CREVICE_GL_FUNCTIONS(X) \
    X(ActiveTexture, ACTIVETEXTURE, true) \
    X(AttachShader, ATTACHSHADER, true) \
    X(BeginQuery, BEGINQUERY, false) \
    X(BindBuffer, BINDBUFFER, true) \
    X(BindFramebuffer, BINDFRAMEBUFFER, true) \
    X(BindRenderbuffer, BINDRENDERBUFFER, true) \
    X(BindSampler, BINDSAMPLER, true) \
    X(BindTexture, BINDTEXTURE, true) \
    X(BindVertexArray, BINDVERTEXARRAY, true) \
    X(BlendEquation, BLENDEQUATION, true) \
    X(BlendEquationSeparate, BLENDEQUATIONSEPARATE, true) \
    X(BlendEquationSeparatei, BLENDEQUATIONSEPARATEI, false) \
    X(BlendEquationi, BLENDEQUATIONI, false) \
    X(BlendFuncSeparate, BLENDFUNCSEPARATE, true) \
    X(BlendFuncSeparatei, BLENDFUNCSEPARATEI, false) \
    X(BlitFramebuffer, BLITFRAMEBUFFER, true) \
    X(BufferData, BUFFERDATA, true) \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS, true) \
    X(Clear, CLEAR, true) \
    X(ClearBufferfv, CLEARBUFFERFV, true) \
    X(ClipControl, CLIPCONTROLEXT, false) \
    X(ClientWaitSync, CLIENTWAITSYNC, true) \
    X(ColorMask, COLORMASK, true) \
    X(ColorMaski, COLORMASKI, false) \
    X(CompileShader, COMPILESHADER, true) \
    X(CreateProgram, CREATEPROGRAM, true) \
    X(CreateShader, CREATESHADER, true) \
    X(CullFace, CULLFACE, true) \
    X(DeleteBuffers, DELETEBUFFERS, true) \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS, true) \
    X(DeleteProgram, DELETEPROGRAM, true) \
    X(DeleteQueries, DELETEQUERIES, false) \
    X(DeleteRenderbuffers, DELETERENDERBUFFERS, true) \
    X(DeleteSamplers, DELETESAMPLERS, true) \
    X(DeleteShader, DELETESHADER, true) \
    X(DeleteSync, DELETESYNC, true) \
    X(DeleteTextures, DELETETEXTURES, true) \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS, true) \
    X(DepthFunc, DEPTHFUNC, true) \
    X(DepthMask, DEPTHMASK, true) \
    X(DepthRange, DEPTHRANGE, false) \
    X(DepthRangeIndexed, DEPTHRANGEINDEXED, false) \
    X(DepthRangeIndexedf, DEPTHRANGEINDEXEDFOES, false) \
    X(DepthRangef, DEPTHRANGEF, false) \
    X(DetachShader, DETACHSHADER, true) \
    X(Disable, DISABLE, true) \
    X(Disablei, DISABLEI, false) \
    X(DrawArrays, DRAWARRAYS, true) \
    X(DrawBuffers, DRAWBUFFERS, true) \
    X(DrawElements, DRAWELEMENTS, true) \
    X(Enable, ENABLE, true) \
    X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY, true) \
    X(Enablei, ENABLEI, false) \
    X(EndQuery, ENDQUERY, false) \
    X(FenceSync, FENCESYNC, true) \
    X(Finish, FINISH, true) \
    X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER, true) \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D, true) \
    X(FramebufferTextureLayer, FRAMEBUFFERTEXTURELAYER, true) \
    X(FrontFace, FRONTFACE, true) \
    X(GenBuffers, GENBUFFERS, true) \
    X(GenFramebuffers, GENFRAMEBUFFERS, true) \
    X(GenQueries, GENQUERIES, false) \
    X(GenRenderbuffers, GENRENDERBUFFERS, true) \
    X(GenSamplers, GENSAMPLERS, true) \
    X(GenTextures, GENTEXTURES, true) \
    X(GenVertexArrays, GENVERTEXARRAYS, true) \
    X(GenerateMipmap, GENERATEMIPMAP, true) \
    X(GetActiveUniform, GETACTIVEUNIFORM, true) \
    X(GetBooleanv, GETBOOLEANV, true) \
    X(GetBufferParameteriv, GETBUFFERPARAMETERIV, true) \
    X(GetBufferSubData, GETBUFFERSUBDATA, false) \
    X(GetError, GETERROR, true) \
    X(GetFloatv, GETFLOATV, true) \
    X(GetFramebufferAttachmentParameteriv, GETFRAMEBUFFERATTACHMENTPARAMETERIV, true) \
    X(GetGraphicsResetStatus, GETGRAPHICSRESETSTATUS, false) \
    X(GetIntegeri_v, GETINTEGERI_V, true) \
    X(GetIntegerv, GETINTEGERV, true) \
    X(GetInternalformativ, GETINTERNALFORMATIV, false) \
    X(GetProgramBinary, GETPROGRAMBINARY, false) \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG, true) \
    X(GetProgramiv, GETPROGRAMIV, true) \
    X(GetQueryObjectui64v, GETQUERYOBJECTUI64VEXT, false) \
    X(GetQueryObjectuiv, GETQUERYOBJECTUIV, true) \
    X(GetQueryiv, GETQUERYIV, true) \
    X(GetRenderbufferParameteriv, GETRENDERBUFFERPARAMETERIV, true) \
    X(GetShaderInfoLog, GETSHADERINFOLOG, true) \
    X(GetShaderiv, GETSHADERIV, true) \
    X(GetString, GETSTRING, true) \
    X(GetStringi, GETSTRINGI, true) \
    X(GetTexLevelParameteriv, GETTEXLEVELPARAMETERIV, false) \
    X(GetTexParameteriv, GETTEXPARAMETERIV, true) \
    X(GetUniformLocation, GETUNIFORMLOCATION, true) \
    X(GetVertexAttribiv, GETVERTEXATTRIBIV, true) \
    X(InvalidateFramebuffer, INVALIDATEFRAMEBUFFER, false) \
    X(IsBuffer, ISBUFFER, true) \
    X(IsEnabled, ISENABLED, true) \
    X(IsEnabledi, ISENABLEDI, false) \
    X(IsTexture, ISTEXTURE, true) \
    X(IsVertexArray, ISVERTEXARRAY, true) \
    X(LinkProgram, LINKPROGRAM, true) \
    X(MapBufferRange, MAPBUFFERRANGE, false) \
    X(ObjectLabel, OBJECTLABEL, false) \
    X(PauseTransformFeedback, PAUSETRANSFORMFEEDBACK, false) \
    X(PixelStorei, PIXELSTOREI, true) \
    X(PolygonMode, POLYGONMODENV, false) \
    X(ProgramBinary, PROGRAMBINARY, false) \
    X(ProgramParameteri, PROGRAMPARAMETERI, false) \
    X(ReadBuffer, READBUFFER, true) \
    X(ReadPixels, READPIXELS, true) \
    X(RenderbufferStorageMultisample, RENDERBUFFERSTORAGEMULTISAMPLE, true) \
    X(ResumeTransformFeedback, RESUMETRANSFORMFEEDBACK, false) \
    X(SamplerParameteri, SAMPLERPARAMETERI, true) \
    X(Scissor, SCISSOR, true) \
    X(ScissorIndexed, SCISSORINDEXEDOES, false) \
    X(ShaderSource, SHADERSOURCE, true) \
    X(TexImage2D, TEXIMAGE2D, true) \
    X(TexImage3D, TEXIMAGE3D, true) \
    X(TexParameteri, TEXPARAMETERI, true) \
    X(TexStorage2D, TEXSTORAGE2D, false) \
    X(TexSubImage2D, TEXSUBIMAGE2D, true) \
    X(Uniform1fv, UNIFORM1FV, true) \
    X(Uniform1i, UNIFORM1I, true) \
    X(Uniform1iv, UNIFORM1IV, true) \
    X(Uniform1uiv, UNIFORM1UIV, true) \
    X(Uniform2fv, UNIFORM2FV, true) \
    X(Uniform2iv, UNIFORM2IV, true) \
    X(Uniform3fv, UNIFORM3FV, true) \
    X(Uniform3iv, UNIFORM3IV, true) \
    X(Uniform4fv, UNIFORM4FV, true) \
    X(Uniform4iv, UNIFORM4IV, true) \
    X(UniformMatrix3fv, UNIFORMMATRIX3FV, true) \
    X(UniformMatrix4fv, UNIFORMMATRIX4FV, true) \
    X(UnmapBuffer, UNMAPBUFFER, false) \
    X(UseProgram, USEPROGRAM, true) \
    X(VertexAttribDivisor, VERTEXATTRIBDIVISOR, true) \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER, true) \
    X(Viewport, VIEWPORT, true) \
    X(ViewportIndexedf, VIEWPORTINDEXEDFOES, false)

/// The functions, without their "gl".
struct GlApi {
#define CREVICE_GL_MEMBER(name, upper, required) PFNGL##upper##PROC name = nullptr;
    CREVICE_GL_FUNCTIONS(CREVICE_GL_MEMBER)
#undef CREVICE_GL_MEMBER
    /// Makes 16-bit arithmetic from many operations, as llvmpipe does: a march over the screen
    /// takes five times as long as with 32 bits (Mesa 22.3.6).
    bool emulates_mediump = false;
    bool glsl_330 = false;  ///< Takes shaders of desktop OpenGL 3.3, and none of OpenGL ES.
};

/// Errors: CV6003 for each required function that the context lacks, and CV6004 when no context is
/// current.
Result<GlApi> loadGlApi(const GlLoader& load);

/// "GL_INVALID_ENUM" and the like.
const char* glErrorName(GLenum error);

/// "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT" and the like.
const char* framebufferStatusName(GLenum status);

// Of a context with several viewports these set the first alone: no shader here draws into another,
// and the host's stay.

/// Where window depth goes to: glDepthRangef, or glDepthRange where that is missing.
void setDepthRange(const GlApi& gl, float near_depth, float far_depth);

void setScissor(const GlApi& gl, GLint x, GLint y, GLsizei width, GLsizei height);

/// Fractions count only where there are several.
void setViewport(const GlApi& gl, float x, float y, float width, float height);

/// Takes all pending errors. Allocates nothing when there is none.
///
/// Errors: CV6005, or CV6009 when memory ran out; "WHAT gave NAME, NAME". CV6016 alone when the
/// context is lost: the table is then abandoned.
Status takeErrors(GlApi& gl, const char* what, const char* label = "");

/// For a context that is lost or destroyed: from now on no function of the table reaches a driver,
/// so that nothing is deleted in whatever context is current then, and glGetError says
/// GL_CONTEXT_LOST.
void abandon(GlApi& gl);

/// Abandons the table where the context reports that the GPU was reset: where GL_KHR_robustness is
/// missing, and GL_EXT_robustness alone is there, no error says so.
void noticeReset(GlApi& gl);

/// Gives an object a name for debuggers, where the context can. `identifier` is GL_TEXTURE or the
/// like.
void setLabel(const GlApi& gl, GLenum identifier, GLuint name, const std::string& label);

}  // namespace crevice
