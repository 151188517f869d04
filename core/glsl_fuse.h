// SPDX-License-Identifier: MIT
// Fusion: two fragment shaders as one, where the second reads of what the first draws the pixel that it
// writes itself.
//
// It works on tokens, with conditions resolved and macros expanded, and knows just so much of GLSL as
// finding names takes. What it does not know it leaves alone: then the two stay two.
#pragma once

#include "core/glsl.h"

#include <optional>
#include <string>

namespace crevice {

/// Where a reader meets a writer.
struct GlslSeam {
    std::string writer;   ///< A word; goes before the names that the writer declares.
    std::string sampler;  ///< The reader's, of what the writer draws.
    std::string uv;       ///< An input of both that goes from 0 to 1 over what is drawn; empty for none.
    int channels = 4;     ///< Of the texture between them ...
    std::string stored;   ///< ... and what it makes of `highp vec4 v`: "roundEven(v * 255.0) * (1.0 / 255.0)".
};

/// The reader with the writer in place of that sampler. Uniforms and inputs that both declare alike are one
/// and must have one source. Messages of a driver lead to the author's lines as before.
///
/// Nothing where the picture could be another, or where work of neighbours would be done over and over: the
/// reader samples more than once, or not by `texture(sampler, uv)` or
/// `texelFetch(sampler, ivec2(gl_FragCoord.xy), 0)`, or the sampler is not `highp`, so that a driver may round
/// what it samples; the writer has a loop, a discard, a derivative, a global variable or several outputs, or
/// fetches more texels than it has samplers; a name of both stands for different things. Requires stages that
/// assembleStage or fuse made.
std::optional<GlslStage> fuse(const GlslStage& writer, const GlslStage& reader, const GlslSeam& seam);

/// The output of a vertex stage that goes from 0 to 1 over what is drawn: `uv`, where the last thing that the
/// stage does is `gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0)`. Empty where none is known to.
std::string spanningOutput(const GlslStage& vertex);

}  // namespace crevice
