// SPDX-License-Identifier: MIT
// Reads every value of a context's state that GL can be asked for.
#pragma once

#include "tests/backends/host/states/gl_calls.h"

namespace crevice {

/// One number, and how it was asked for.
struct StateValue {
    const char* function;
    GLenum name;
    GLuint object;  ///< ... or the index, unit or attachment.
    GLint bits;
};

using Snapshot = std::vector<StateValue>;

/// What changed, a line each; empty for nothing. At most ten are told.
std::string difference(const Snapshot& before, const Snapshot& after);

/// The host's objects whose own state is read too.
struct WatchedObjects {
    std::vector<std::pair<GLenum, GLuint>> textures;  ///< Each with its target.
    std::vector<GLuint> samplers, framebuffers, renderbuffers, vertex_arrays, programs, buffers;
};

class StateReader {
public:
    /// Asks for every name. What a unit has bound is known by its difference: every kind of texture
    /// and a sampler must be bound to unit 0, and none to unit 1.
    StateReader(const GlApi& gl, const GlCalls& calls);

    /// Leaves the state as it is. Requires that no error is pending.
    Snapshot read(const WatchedObjects& objects) const;

    /// What glEnable takes, and glEnablei with how many indices.
    const std::vector<GLenum>& switches() const { return switches_; }
    const std::vector<std::pair<GLenum, GLuint>>& indexedSwitches() const
    {
        return indexed_switches_;
    }

private:
    using Names = std::vector<GLenum>;
    using Indexed = std::vector<std::pair<GLenum, GLuint>>;  // each with how many indices

    void findUnitNames();
    void readContext(Snapshot& into) const;
    void readUnits(Snapshot& into) const;
    void readFramebuffers(const WatchedObjects& objects, Snapshot& into) const;
    void readVertexArrays(const WatchedObjects& objects, Snapshot& into) const;
    void readTextures(const WatchedObjects& objects, Snapshot& into) const;
    void readObjects(const WatchedObjects& objects, Snapshot& into) const;

    const GlApi& gl_;
    const GlCalls& calls_;
    Names plain_, switches_, unit_names_;
    Names texture_, sampler_, framebuffer_, renderbuffer_, attribute_, program_, buffer_;
    Indexed indexed_, indexed_switches_;
    GLint units_ = 0, attributes_ = 0;
};

}  // namespace crevice
