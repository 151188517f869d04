// SPDX-License-Identifier: MIT
// A host that has set every piece of its context's state to something random.
#pragma once

#include "backends/gl/objects.h"
#include "tests/backends/host/states/settings.h"
#include "tests/backends/host/states/state_reader.h"

namespace crevice {

class RandomHost {
public:
    /// Makes an object of every kind. Requires a current context that has nothing bound.
    RandomHost(const GlApi& gl, const GlLoader& load);
    ~RandomHost();

    /// Sets all state. The same seed sets the same.
    void randomize(std::uint32_t seed);

    /// All state.
    Snapshot snapshot();

    /// Has an object's own state read as well.
    void watchTexture(GLenum target, GLuint name) { watched_.textures.emplace_back(target, name); }
    void watchFramebuffer(GLuint name) { watched_.framebuffers.push_back(name); }
    void watchRenderbuffer(GLuint name) { watched_.renderbuffers.push_back(name); }

private:
    void makeTextures();
    void makeBuffers();
    void makeFramebuffers();
    GLuint makeProgram();
    void randomizeTextures(Random& random);
    void randomizeBuffers(Random& random);
    void randomizeImages(Random& random);
    void randomizeArrays(Random& random);
    void randomizeFeedback(Random& random);
    void endFeedback();

    const GlApi& gl_;
    GlCalls calls_;
    std::vector<GLenum> texture_targets_, buffer_targets_;
    WatchedObjects watched_;
    std::vector<GlTexture> textures_;
    std::vector<GlBuffer> buffers_;
    std::vector<GlSampler> samplers_;
    std::vector<GlFramebuffer> framebuffers_;
    std::vector<GlVertexArray> arrays_;
    GlRenderbuffer renderbuffer_;
    GlProgram program_;
    GLuint pipeline_ = 0, feedback_ = 0;
    GLint units_ = 0;
    std::optional<Settings> settings_;
    std::optional<StateReader> reader_;
};

}  // namespace crevice
