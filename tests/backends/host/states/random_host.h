// SPDX-License-Identifier: MIT
// A host that has set every piece of its context's state to something random.
#pragma once

#include "backends/gl/objects.h"
#include "tests/backends/host/states/gl_calls.h"
#include "tests/backends/host/states/state_reader.h"

#include <cstdint>
#include <initializer_list>
#include <random>

namespace crevice {

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }

    /// [0, count).
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    bool coin() { return below(2) == 1; }

    /// [0, 1), a multiple of 1/256.
    float unit() { return static_cast<float>(below(256)) / 256.0f; }

    template <class T>
    T pick(std::initializer_list<T> of)
    {
        return of.begin()[below(static_cast<int>(of.size()))];
    }
    template <class List>
    auto pick(const List& of)
    {
        return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
    }

private:
    std::mt19937 engine_;
};

class Settings {
public:
    /// Asks for the names of hints and of pixel storage.
    Settings(const GlApi& gl, const GlCalls& calls);

    void randomize(Random& random) const;

private:
    const GlApi& gl_;
    const GlCalls& calls_;
    std::vector<GLenum> hints_, pixel_stores_;
};

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
