// SPDX-License-Identifier: MIT
// GL names that delete themselves, and the table behind the device's typed ids.
#pragma once

#include "backends/gl/api.h"

#include <cassert>
#include <cstdint>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace crevice {

/// Owns one GL name and deletes it through the table member `Delete`. Moved-from is zero. The
/// context must be current when it dies, and the table must outlive it.
template <auto Delete>
class GlObject {
public:
    GlObject() = default;
    GlObject(const GlApi& gl, GLuint name) : gl_(&gl), name_(name) {}
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject()
    {
        if (name_ == 0) return;
        using Function = std::decay_t<decltype(gl_->*Delete)>;
        if constexpr (std::is_invocable_v<Function, GLsizei, const GLuint*>)
            (gl_->*Delete)(1, &name_);
        else
            (gl_->*Delete)(name_);
    }

    GLuint name() const { return name_; }

private:
    const GlApi* gl_ = nullptr;
    GLuint name_ = 0;
};

/// The same for kinds that come from a glGen function.
template <auto Generate, auto Delete>
class GlGenerated : public GlObject<Delete> {
public:
    using GlObject<Delete>::GlObject;

    static GlGenerated make(const GlApi& gl)
    {
        GLuint name = 0;
        (gl.*Generate)(1, &name);
        return GlGenerated(gl, name);
    }
};

using GlTexture = GlGenerated<&GlApi::GenTextures, &GlApi::DeleteTextures>;
using GlSampler = GlGenerated<&GlApi::GenSamplers, &GlApi::DeleteSamplers>;
using GlQuery = GlGenerated<&GlApi::GenQueries, &GlApi::DeleteQueries>;
using GlRenderbuffer = GlGenerated<&GlApi::GenRenderbuffers, &GlApi::DeleteRenderbuffers>;
using GlFramebuffer = GlGenerated<&GlApi::GenFramebuffers, &GlApi::DeleteFramebuffers>;
using GlBuffer = GlGenerated<&GlApi::GenBuffers, &GlApi::DeleteBuffers>;
using GlVertexArray = GlGenerated<&GlApi::GenVertexArrays, &GlApi::DeleteVertexArrays>;
using GlShader = GlObject<&GlApi::DeleteShader>;
using GlProgram = GlObject<&GlApi::DeleteProgram>;

/// Objects by small ids that count from 1. An id that was freed is given out again. References stay
/// valid until the object is removed.
template <class T>
class GlPool {
public:
    std::uint32_t add(T object)
    {
        if (free_.empty()) {
            slots_.emplace_back();
            free_.push_back(static_cast<std::uint32_t>(slots_.size()));
        }
        const std::uint32_t id = free_.back();
        free_.pop_back();
        slots_[id - 1].emplace(std::move(object));
        return id;
    }

    const T& at(std::uint32_t id) const
    {
        assert(find(id));
        return *slots_[id - 1];
    }

    T& at(std::uint32_t id)
    {
        assert(find(id));
        return *slots_[id - 1];
    }

    /// Null for an id that is none.
    const T* find(std::uint32_t id) const
    {
        return id > 0 && id <= slots_.size() && slots_[id - 1] ? &*slots_[id - 1] : nullptr;
    }

    /// Frees the id, and keeps what was behind it for `deleteRetired`. Ignores an id that is none.
    void retire(std::uint32_t id)
    {
        if (!find(id)) return;
        retired_.push_back(std::move(*slots_[id - 1]));
        slots_[id - 1].reset();
        free_.push_back(id);
    }

    /// Requires that the objects' context is current.
    void deleteRetired() { retired_.clear(); }

private:
    std::deque<std::optional<T>> slots_;
    std::vector<std::uint32_t> free_;  // ids
    std::deque<T> retired_;
};

}  // namespace crevice
