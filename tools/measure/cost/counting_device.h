// SPDX-License-Identifier: MIT
// A device that counts the texture fetches and the runs of loops of fullscreen passes, pixel by
// pixel.
//
// Each pass is drawn once as it is and then again, with what it was drawn with, by a shader that
// takes the same way but writes how often it did so (countedFragment). So passes read what they
// always do, loops run as often as they really do, and any OpenGL ES 3.0 device will do.
#pragma once

#include "tools/render/device/forwarding_device.h"
#include "tools/render/scene/options.h"

#include <crevice/config.h>

namespace crevice {

/// What a fullscreen pass did in a frame.
struct PassCount {
    double fetches = 0;        ///< Summed over its pixels.
    double pixels = 0;         ///< Those drawn: what its mask, scissor and `discard` leave.
    std::vector<double> runs;  ///< For each loop, how often its body ran when it was entered.
};
using PassCounts = std::map<std::string, PassCount>;  ///< By the pass's label.

class CountingDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;
    ~CountingDevice() override;

    /// Counts in all frames from now on. Each counts for itself.
    void startCounting() { counting_ = true; }

    /// Those of the last frame's fullscreen passes. Errors: those of readTexture.
    Result<PassCounts> counts();

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
        int loops = 0;
        int which = -1;                ///< The location of crevice_which.
        std::map<int, int> locations;  ///< The twin's by the program's.
        std::map<int, Uniform> uniforms;
    };
    /// Where a pass of this frame was counted.
    struct Count {
        std::string pass;
        int which = 0;
        TextureId texture;
        FramebufferId framebuffer;
    };

    Status addTwin(const ProgramDesc& desc, ProgramId program);
    void drawTwin(const Twin& twin, int which);
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

/// Those of a frame of a scene, on the first context without a window that works. Of a config that
/// remembers frames it is one that has them. Errors: those of openDevice, CountingDevice and
/// Renderer; a counted shader may not compile.
Result<PassCounts> countFrame(Description description, const SceneView& view);

}  // namespace crevice
