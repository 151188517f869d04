// SPDX-License-Identifier: MIT
// What compilers say of GLSL, in plain words and with a way out.
#pragma once

#include "core/glsl/preprocessor.h"

namespace crevice {

/// How the message ends on a name that nothing declares; its place is the name.
constexpr std::string_view kNotDeclared = " is not declared";

/// A stage with each token on a line of its own, so that a compiler that tells lines tells tokens.
struct SpreadStage {
    std::string text;
    GlslTokens tokens;  ///< By line of `text`, at the author's places; '#' for a directive's lines.
};

/// Its tokens point into `stage`, which must outlive it.
SpreadStage spread(const GlslStage& stage);

/// explainLog for a log of the spread text.
Diagnostics explainSpread(const GlslStage& stage, const GlslTokens& tokens, Code code,
                          const std::string& log);

/// Says it in plain words where it is one of the usual mistakes, with a way out, and points at what
/// is to be changed. Otherwise the message stays. `tokens` are the stage's.
void sayPlainly(const GlslStage& stage, const GlslTokens& tokens, Diagnostic& error);

/// The first name that the message quotes as `name', 'name' or "name"; empty when there is none.
std::string_view quotedName(std::string_view message);

}  // namespace crevice
