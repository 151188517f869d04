// SPDX-License-Identifier: MIT
#include "backends/gl/copy.h"

#include "backends/gl/formats.h"

namespace crevice {

namespace {

// These are no effects and belong to no module, so they stand here and not in a shader file. Their
// one sampler keeps its default, unit 0.

const char* const kVertex = R"(#version 300 es
out highp vec2 uv;
void main()
{
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
)";

const char* const kCopy = R"(#version 300 es
precision highp float;
uniform highp sampler2D source;
uniform bool grey;
in vec2 uv;
out vec4 color;
void main()
{
    vec4 read = textureLod(source, uv, 0.0);
    color = grey ? vec4(read.rrr, 1.0) : read;
}
)";

// Every OpenGL ES 3.0 device renders to unsigned integers of 32 bits and reads them back; floats
// need more.
const char* const kFetchBits = R"(#version 300 es
precision highp float;
uniform highp sampler2D source;
out highp uvec4 bits;
void main() { bits = floatBitsToUint(texelFetch(source, ivec2(gl_FragCoord.xy), 0)); }
)";

Result<GlLinkedProgram> ownProgram(GlApi& gl, const GlProgramCache& cache, const char* fragment,
                                   const char* label)
{
    ProgramDesc desc;
    desc.label = label;
    desc.vertex.text = kVertex;
    desc.fragment.text = fragment;
    return makeProgram(gl, cache, desc);
}

}  // namespace

Result<GlCopier> GlCopier::make(GlApi& gl, const GlProgramCache& cache)
{
    Result<GlLinkedProgram> copy = ownProgram(gl, cache, kCopy, "crevice copy");
    if (!copy) return copy.diagnostics();
    Result<GlLinkedProgram> fetch_bits = ownProgram(gl, cache, kFetchBits, "crevice fetch bits");
    if (!fetch_bits) return fetch_bits.diagnostics();
    GlCopier copier;
    copier.copy_ = std::move(copy->program);
    copier.grey_ = gl.GetUniformLocation(copier.copy_.name(), "grey");
    copier.fetch_bits_ = std::move(fetch_bits->program);
    copier.no_attributes_ = GlVertexArray::make(gl);
    return copier;
}

void GlCopier::copy(const GlApi& gl, GlState& state, GLuint texture, GLuint sampler,
                    int channels) const
{
    gl.UseProgram(copy_.name());
    gl.Uniform1i(grey_, channels == 1);
    state.bindTexture(0, texture, sampler);
    drawTriangle(gl);
}

Result<Image> GlCopier::read(GlApi& gl, GlState& state, GLuint texture, GLuint nearest,
                             Extent extent) const
{
    auto target = GlTexture::make(gl);
    state.bindTexture(0, target.name(), 0);
    allocateTexture(gl, GL_RGBA32UI, extent);
    auto framebuffer = GlFramebuffer::make(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.name(), 0);
    if (Status status = takeErrors(gl, "readTexture"); !status) return status.diagnostics();

    fetchBits(gl, state, texture, nearest, extent);
    Image image(extent, 4);
    static_assert(sizeof(GLuint) == sizeof(float));
    gl.ReadPixels(0, 0, extent.width, extent.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                  image.pixels.data());
    if (Status status = takeErrors(gl, "readTexture"); !status) return status.diagnostics();
    return image;
}

void GlCopier::fetchBits(const GlApi& gl, GlState& state, GLuint texture, GLuint nearest,
                         Extent extent) const
{
    setViewport(gl, 0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height));
    gl.UseProgram(fetch_bits_.name());
    state.bindTexture(0, texture, nearest);
    drawTriangle(gl);
}

void GlCopier::drawTriangle(const GlApi& gl) const
{
    gl.BindVertexArray(no_attributes_.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace crevice
