// SPDX-License-Identifier: MIT
// The preprocessor: resolves includes, follows #if as the driver will, and writes one text.
//
// It evaluates conditions only to know which includes and declarations count; the text keeps the
// author's directives, and the driver evaluates them again.
#pragma once

#include <crevice/glsl_stage.h>

#include "core/glsl/macros.h"

#include <deque>
#include <set>

namespace crevice {

/// `#line` counts an included file's lines from its source-string number times this, because Mesa
/// (22.3.6, all drivers) gives source string 0 for most errors, wherever they are. Line 7 of file 2
/// is line 200007 to the driver; explainLog takes it apart again.
constexpr int kLinesPerFile = 100000;

/// A stage after preprocessing.
struct GlslUnit {
    /// Before the first line, `defines` are, which must outlive it.
    explicit GlslUnit(const GlslDefines& defines) : macros(defines) {}

    std::string version;           ///< "300 es" or "310 es".
    std::string text;              ///< All that follows the #version line, without comments.
    std::vector<SourceRef> files;  ///< By source-string number.
    GlslTokens tokens;             ///< What is active, macros expanded.
    std::set<std::string_view> mentioned;  ///< Every name outside comments.
    GlslMacros macros;                     ///< As they stand at the end.
    Diagnostics errors;
    std::deque<std::string> blanked;  ///< What tokens and names point into; a deque never moves it.
};

/// Fills `unit` from the stage that begins in `files.at(path)`. The errors are those of
/// assembleStage.
void preprocess(const std::map<std::string, SourceRef>& files,
                const std::map<std::string, std::string>& interfaces, const std::string& path,
                GlslUnit& unit);

/// Where a token stands; nowhere when it comes from no file.
Place placeOf(const GlslToken& token, const std::vector<SourceRef>& files);

/// Appends the uniforms and outputs that `unit` declares at its outermost level to `stage`, and
/// what is wrong with them to `unit.errors`: array sizes and locations that cannot be read.
void scanDeclarations(GlslUnit& unit, GlslStage& stage);

/// Reads an #include line of `source`. False when it is malformed.
bool readInclude(const GlslLine& line, const SourceRef& source, GlslInclude& include);

}  // namespace crevice
