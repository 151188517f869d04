// SPDX-License-Identifier: MIT
// All that a host does with crevice, from making a device to destroying it, in several kinds.
#pragma once

#include "backends/gl/caps.h"
#include "tests/backends/host/states/random_host.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/watched_gl.h"

#include <crevice/effect.h>

namespace crevice {

/// Of the host's pictures.
constexpr Extent kHostSize = {32, 18};

class HostLife {
public:
    /// Makes the host's own pictures and buffers. Requires that the context is fresh.
    explicit HostLife(Context& context, const GlDeviceOptions& options = {});
    ~HostLife();

    /// Kind 0 to kConfigs - 1 have their depth in the first place, and so on.
    static constexpr int kConfigs = 4;
    int kinds() const;
    int places() const { return static_cast<int>(depths_.size()); }

    /// Has the objects' own state read too.
    void watch(RandomHost& host) const;

    /// Calls `after` after each step. Returns what was read and presented.
    std::vector<Image> live(int kind, const std::function<void(const char* step)>& after);

    GlApi gl;

private:
    struct Run;

    void makeDepths();
    void addDepth(HostTexture host);
    void allocateDepth(HostTexture& host, Extent extent);
    void makeTargets();
    void makeBuffers();
    void paintDepth(int x, int y) const;
    Image readShown(int target) const;

    GlLoader load_;
    GlCalls calls_;
    GlInfo info_;
    KeptPrograms programs_;
    GlDeviceOptions options_;
    std::vector<HostTexture> depths_;
    std::vector<std::pair<GLenum, GlTexture>> textures_;
    std::vector<GlFramebuffer> framebuffers_;
    GlRenderbuffer renderbuffer_;
    GlBuffer vertices_;
    GlVertexArray array_;
    GLuint shown_[2] = {};
    std::vector<GLuint> drawn_into_;  // the same as framebuffers
};

}  // namespace crevice
