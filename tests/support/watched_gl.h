// SPDX-License-Identifier: MIT
// GL functions under a test's control, over a real context or over no GL at all: they count the
// names that live, run out of memory on demand, lose their context, and tell what no pixel shows.
#pragma once

#include "backends/gl/api.h"

namespace crevice {

/// How a lost context shows.
enum class Loss {
    for_ever,     ///< glGetError says GL_CONTEXT_LOST and nothing else.
    by_commands,  ///< The same, once after each command; glGetError itself takes it.
    by_status,    ///< glGetGraphicsResetStatus says so once, and nothing else does.
    by_nothing,   ///< Calls do nothing, as where no context is current.
};

/// Who no GL at all says that it is.
struct FakeDriver {
    const char* renderer = "a test";
    int binary_formats = 1;     ///< Of program binaries; 0 for a driver without.
    unsigned char build = 'a';  ///< Refuses the binaries of other builds,
    bool silent = false;        ///< ... without an error.
    const char* version = "OpenGL ES 3.2 of a test";
};

/// One at a time. Whatever its loader gave must not be called after it died.
class WatchedGl {
public:
    /// No GL at all: hands out names, and every shader compiles.
    explicit WatchedGl(const FakeDriver& driver = {});

    /// The functions of the current context.
    explicit WatchedGl(const GlLoader& real);
    ~WatchedGl();
    WatchedGl(const WatchedGl&) = delete;

    GlLoader loader() const;

    /// Makes the n-th coming call that takes memory do nothing, as a driver without any would; 0
    /// makes none. A framebuffer is then incomplete, all else an error GL_OUT_OF_MEMORY.
    void failAt(int n) { fail_in_ = n; }

    /// Loses the context with the n-th coming call.
    void loseAt(int n, Loss loss);

    /// Makes it current again.
    void regain() { lost_ = false; }

    int calls() const { return calls_; }        ///< So far, lost or not.
    int attempts() const { return attempts_; }  ///< Of them those that take memory.
    int compiles() const { return compiles_; }  ///< Calls of glCompileShader.
    int binaries() const { return binaries_; }  ///< Calls of glProgramBinary.
    int names() const { return names_; }        ///< That live.
    bool errorPends() const { return pending_ != GL_NO_ERROR; }

    /// From here on, what passes do: "clear color0, draw, invalidate color1 depth".
    void logPasses() { logs_passes_ = true; }
    std::string takePassLog() { return std::exchange(pass_log_, {}); }

private:
    template <auto Member>
    friend struct Hook;

    bool arrives();
    bool failsNow();
    void log(const std::string& words)
    {
        if (logs_passes_) pass_log_ += (pass_log_.empty() ? "" : ", ") + words;
    }
    GLenum takeError();
    GLenum takeReset();

    GlApi below_;
    GlLoader real_;
    bool logs_passes_ = false;
    std::string pass_log_;
    int calls_ = 0;
    int attempts_ = 0;
    int compiles_ = 0;
    int binaries_ = 0;
    int names_ = 0;
    int fail_in_ = 0;
    int lose_in_ = 0;
    bool lost_ = false;
    bool reset_reported_ = false;
    Loss loss_ = Loss::for_ever;
    GLenum pending_ = GL_NO_ERROR;
};

/// A host that keeps linked programs in memory.
struct KeptPrograms {
    std::map<std::string, std::vector<std::uint8_t>> entries;
    int loads = 0;   ///< Calls so far; a program that is not there counts too.
    int stores = 0;  ///< Calls so far.

    /// Must not outlive this.
    ProgramCache cache()
    {
        return {[this](const std::string& key) {
                    ++loads;
                    const auto found = entries.find(key);
                    return found == entries.end() ? std::vector<std::uint8_t>() : found->second;
                },
                [this](const std::string& key, const std::vector<std::uint8_t>& bytes) {
                    ++stores;
                    entries[key] = bytes;
                }};
    }

    GlDeviceOptions options()
    {
        GlDeviceOptions made;
        made.program_cache = cache();
        return made;
    }
};

}  // namespace crevice
