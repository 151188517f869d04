// SPDX-License-Identifier: MIT
// The class behind makeGlDevice: device.cpp makes and reads objects, frame.cpp draws.
#pragma once

#include <crevice/gl_device.h>

#include "backends/gl/copy.h"
#include "backends/gl/host/host_texture.h"
#include "backends/gl/reads.h"
#include "backends/gl/timers.h"

namespace crevice {

class GlDevice final : public Device {
public:
    GlDevice(const GlApi& gl, const GlInfo& info, const GlDeviceOptions& options)
        : gl_(gl),
          info_(info),
          check_errors_(options.check_errors),
          state_(gl_, info_, options.restore_state)
    {
    }

    /// Deletes nothing in another context than its own, nor where none is current.
    ~GlDevice() override;

    /// Reads what the context can do and makes the device's own objects.
    Status prepare(const ProgramCache& program_cache);

    const DeviceCaps& caps() const override { return caps_; }
    Result<TextureId> createTexture(const TextureDesc& desc) override;
    Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) override;
    Result<ProgramId> createProgram(const ProgramDesc& desc) override;
    Result<MeshId> createMesh(const MeshDesc& desc) override;
    Result<MeshId> adoptMesh(const HostMesh& host) override;
    Result<TextureId> adoptTexture(const HostTexture& host) override;
    Status refresh(TextureId id) override;
    ClipControl clipControl() const override { return state_.clipControl(); }
    DepthRange depthRange() const override { return state_.depthRange(); }
    ObjectInfo info(ObjectId id) const override;
    void destroy(ObjectId id) override;
    Status writeTexture(TextureId id, const Image& image) override;
    Result<Image> readTexture(TextureId id) override;
    Status beginRead(TextureId id) override;
    std::optional<std::array<float, 4>> takeRead(TextureId id) override;
    const std::vector<UniformInfo>& uniforms(ProgramId id) const override
    {
        return programs_.at(id.value).uniforms;
    }
    Status beginFrame() override;
    Status endFrame() override;
    void beginPass(const PassInfo& pass) override;
    void endPass() override;
    void setProgram(ProgramId id, const StateDesc& state) override;
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) override;
    void setUniform(int location, GlslType type, int count, const void* data) override
    {
        setUniformValues(gl_, location, type, count, data);
    }
    void draw(MeshId id, std::uint32_t first, std::uint32_t count) override;
    void drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host) override;
    void drawFullscreen() override;
    Status present(TextureId id, const HostFramebuffer& host) override;
    void finish() override { gl_.Finish(); }
    void abandon() { crevice::abandon(gl_); }
    TimerId createTimer() override { return {caps_.timers ? timers_.add({}) : 0}; }
    void beginTimer(TimerId id) override { timing_.begin(gl_, timers_.at(id.value)); }
    void endTimer() override { timing_.end(gl_); }
    bool timerReady(TimerId id) override { return timing_.isReady(gl_, timers_.at(id.value)); }
    double readTimer(TimerId id) override { return timing_.read(gl_, timers_.at(id.value)); }

private:
    struct TextureSlot {
        GlTexture owned;              // nothing when adopted, or when several samples make it a
        GlRenderbuffer renderbuffer;  // ... drawn into but never sampled
        GLuint name;                  // whichever it is
        Format format;
        Extent extent;
        int samples = 1;
        GlHostCopy copy = {};  // nothing where no copy is kept of the host's
        GlRead read = {};
        int depth = 0;  // layers of a volume
        bool mips = false;

        /// Whether it is the host's own, which may have deleted it.
        bool adopted() const
        {
            return owned.name() == 0 && renderbuffer.name() == 0 && copy.texture() == 0;
        }
        GLenum target() const
        {
            if (depth > 0) return GL_TEXTURE_3D;
            return samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
        }
    };

    struct FramebufferSlot {
        GlFramebuffer drawn;
        GlFramebuffer resolved;  // nothing where a pixel has one sample
        std::vector<TextureId> color = {};
    };

    struct MeshSlot {
        GlVertexArray vertex_array;
        GlBuffer vertices;  // of a host's mesh what it has no attributes for, or nothing
        GlBuffer indices;   // nothing of a host's mesh
        std::uint32_t index_count = 0;
        MeshOrigin origin = {};
        std::vector<std::uint32_t> sheets = {};
        bool indexed = true;
        IndexType index_type = IndexType::uint32;
        std::uint32_t index_offset = 0;  // in bytes
        std::string label = {};
        bool normals = true;
        bool uv = true;
    };

    /// Sets the host's state and errors aside in a call that may come outside of a frame.
    class Scope {
    public:
        explicit Scope(GlDevice& device) : state_(device.state_)
        {
            if (!state_.entered()) device.takeHostErrors();
            state_.enter();
        }
        ~Scope() { state_.leave(); }
        Scope(const Scope&) = delete;

    private:
        GlState& state_;
    };

    /// Makes what `isCurrent` knows the context by.
    void markContext();
    bool isCurrent() const;

    /// Before all that the host calls. Errors: CV6004 where no context is current, or another than
    /// the device's; CV6016 where it is lost.
    Status checkCurrent();

    /// Deletes what was destroyed. Requires that the context is current.
    void deleteRetired();

    /// The sampler object; nearest where the format takes no filter.
    GLuint sampler(const SamplerDesc& desc, Format format) const;
    void makeSamplers();
    Result<TextureId> createMultisampled(const TextureDesc& desc);
    Status checkName(const HostTexture& host);

    /// A failure, or CV6016 where the reason is that the context is lost.
    Status unlessLost(const Status& failed, const char* what);
    void attach(GLenum point, TextureId id, int layer);

    /// Has the running pass draw into its layers of volumes.
    void attachLayers(const FramebufferSlot& framebuffer);
    void makeMips(const FramebufferSlot& framebuffer);
    void multiplyColors();
    Status fill(GlFramebuffer& framebuffer, const std::string& label,
                const std::vector<TextureId>& color, TextureId depth);

    /// Leaves the running pass's framebuffer with nothing to store.
    void resolve(const FramebufferSlot& framebuffer);

    /// Sets where in its framebuffer a pass draws.
    void setArea(const PassInfo& pass);

    /// Takes the errors that the host left pending, for endFrame to warn of.
    void takeHostErrors();

    /// Keeps the errors of a call that returns none, for endFrame.
    void noteErrors(const char* what, const char* label = "");
    void noteDeleted(GLuint name);

    GlApi gl_;
    GlInfo info_;
    bool check_errors_;
    GlState state_;
    DeviceCaps caps_;
    GlVertexArray
        mark_;  // contexts do not share vertex arrays, and no other device's has its divisor
    GLint mark_divisor_ = 0;
    GlProgramCache program_cache_;
    GlCopier copier_;
    GlSampler samplers_[3][2];
    GlTimers timing_;
    GlReads reads_;
    GlPool<TextureSlot> textures_;
    GlPool<MeshSlot> meshes_;
    GlPool<GlLinkedProgram> programs_;
    GlPool<FramebufferSlot> framebuffers_;
    GlPool<GlTimer> timers_;
    PassInfo pass_ = {};
    Diagnostics host_errors_;  // a warning of what the host left pending
    Diagnostics errors_;       // of this frame's passes
};

}  // namespace crevice
