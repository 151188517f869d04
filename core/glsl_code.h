// SPDX-License-Identifier: MIT
// A shader stage as the compiler sees it, for whoever takes one apart: what it declares, and the tokens
// with conditions resolved and macros expanded.
#pragma once

#include "core/glsl_preprocessor.h"

#include <initializer_list>

namespace crevice {

/// One statement of a text's outermost level.
struct GlslStatement {
    enum class Kind { precision, structure, function, variables };

    Kind kind = Kind::variables;
    std::size_t begin = 0;  ///< Its tokens are from here
    std::size_t end = 0;    ///< to before here.
    std::string_view storage = {};    ///< "in", "out", "uniform", "const" or nothing.
    std::string_view precision = {};  ///< Said, or for floats the default there; else empty.
    std::size_t type = 0;             ///< Of a function or variables: the token.
    std::vector<std::size_t> names = {};  ///< That it declares; none for precision.
};

/// Neither copied nor moved: tokens point into it.
class GlslCode {
public:
    /// Requires a stage that assembleStage or fuse made.
    explicit GlslCode(const GlslStage& stage);
    GlslCode(const GlslCode&) = delete;
    GlslCode& operator=(const GlslCode&) = delete;

    /// False where it has #extension, #pragma, a default precision of other types than float, or something
    /// that is no GLSL; then no more than a part of `statements` is there.
    bool known() const { return known_; }

    const std::string& version() const { return unit_.version; }
    const GlslTokens& tokens() const { return unit_.tokens; }  ///< At the author's lines.
    const std::vector<GlslStatement>& statements() const { return statements_; }

    const GlslToken& operator[](std::size_t i) const { return unit_.tokens[i]; }

    /// Whether the token is a name by itself, not a member or a swizzle of something.
    bool isFree(std::size_t i) const;

    /// Whether these words stand at `begin`.
    bool stands(std::size_t begin, std::initializer_list<std::string_view> words) const;

    /// The statement that declares the name, or null.
    const GlslStatement* declarationOf(std::string_view name) const;

    /// Whether the function about the token has a parameter or a variable of that name.
    bool isHidden(std::size_t token, std::string_view name) const;

private:
    GlslUnit unit_;
    std::vector<GlslStatement> statements_;
    bool known_ = false;
};

}  // namespace crevice
