// SPDX-License-Identifier: MIT
// A device that counts the texture fetches of fullscreen passes, pixel by pixel.
//
// Each pass is drawn once as it is and then again, with what it was drawn with, by a shader that
// takes the same way but writes how often it fetched (countedFragment). So passes read what they
// always do, loops run as often as they really do, and any OpenGL ES 3.0 device will do.
#pragma once

#include "tools/render/device/forwarding_device.h"
#include "tools/render/scene/options.h"

#include <crevice/config.h>

namespace crevice {

/// The fragment shader's text with outputs as plain variables, each call of a built-in function
/// that fetches from a texture counted, and an output of its own of the format rgba8: in red and
/// green the count's low and high byte, as unsigned normalized numbers. Nothing where the text has
/// no `main`.
///
/// A `discard` discards the count too. textureGather counts as one.
std::optional<std::string> countedFragment(const std::string& text);

class CountingDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;
    ~CountingDevice() override;

    /// Counts in all frames from now on. Each counts for itself.
    void startCounting() { counting_ = true; }

    /// Fetches of each fullscreen pass of the last frame, summed over its pixels, by the pass's
    /// label. Errors: those of readTexture.
    Result<std::map<std::string, double>> fetches();

    Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) override;
    Result<ProgramId> createProgram(const ProgramDesc& desc) override;
    void destroy(ObjectId id) override;
    Status beginFrame() override;
    void beginPass(const PassInfo& pass) override;
    void endPass() override;
    void setProgram(ProgramId id, const StateDesc& state) override;
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) override;
    void setUniform(int location, GlslType type, int count, const void* data) override;
    void drawFullscreen() override;

private:
    struct Uniform {
        GlslType type = GlslType::float_;
        int count = 1;
        std::vector<std::uint32_t> words;
    };
    struct Binding {
        int location = -1;
        int unit = 0;
        TextureId texture;
        SamplerDesc sampler;
    };
    /// The counting twin of a program, and what the program was told so far.
    struct Twin {
        ProgramId program;
        std::map<int, int> locations;  ///< The twin's by the program's.
        std::map<int, Uniform> uniforms;
    };
    /// Where a pass of this frame was counted.
    struct Count {
        std::string pass;
        TextureId texture;
        FramebufferId framebuffer;
    };

    Status addTwin(const ProgramDesc& desc, ProgramId program);
    void drawTwin(const Twin& twin);
    void clearCounts();

    std::map<std::uint32_t, TextureId> depths_;  ///< By framebuffer.
    std::map<std::uint32_t, Twin> twins_;        ///< By program.
    std::vector<Count> counts_;
    bool counting_ = false;

    PassInfo pass_;  ///< The running one, with its program, state and textures.
    ProgramId program_;
    StateDesc state_;
    std::vector<Binding> bindings_;
    bool fullscreen_ = false;
};

/// Fetches a frame of a scene by fullscreen pass, summed over its pixels, loops counted as often as
/// they run, on the first context without a window that works. Of a config that remembers frames it
/// is one that has them. Errors: those of openDevice, CountingDevice and Renderer; a counted shader
/// may not compile.
Result<std::map<std::string, double>> countFetches(Description description, const SceneView& view);

}  // namespace crevice
