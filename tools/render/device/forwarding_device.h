// SPDX-License-Identifier: MIT
// A device that hands every call on to another: what devices that change a little of one begin
// with.
#pragma once

#include <crevice/device.h>

namespace crevice {

/// The other device must outlive it.
class ForwardingDevice : public Device {
public:
    explicit ForwardingDevice(Device& device) : device_(device) {}

    const DeviceCaps& caps() const override { return device_.caps(); }
    Result<TextureId> createTexture(const TextureDesc& desc) override
    {
        return device_.createTexture(desc);
    }
    Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) override
    {
        return device_.createFramebuffer(desc);
    }
    Result<ProgramId> createProgram(const ProgramDesc& desc) override
    {
        return device_.createProgram(desc);
    }
    Result<MeshId> createMesh(const MeshDesc& desc) override { return device_.createMesh(desc); }
    Result<MeshId> adoptMesh(const HostMesh& host) override { return device_.adoptMesh(host); }
    Result<TextureId> adoptTexture(const HostTexture& host) override
    {
        return device_.adoptTexture(host);
    }
    Status refresh(TextureId id) override { return device_.refresh(id); }
    ClipControl clipControl() const override { return device_.clipControl(); }
    DepthRange depthRange() const override { return device_.depthRange(); }
    ObjectInfo info(ObjectId id) const override { return device_.info(id); }
    void destroy(ObjectId id) override { device_.destroy(id); }
    Status writeTexture(TextureId id, const Image& image) override
    {
        return device_.writeTexture(id, image);
    }
    Result<Image> readTexture(TextureId id) override { return device_.readTexture(id); }
    Status beginRead(TextureId id) override { return device_.beginRead(id); }
    std::optional<std::array<float, 4>> takeRead(TextureId id) override
    {
        return device_.takeRead(id);
    }
    const std::vector<UniformInfo>& uniforms(ProgramId id) const override
    {
        return device_.uniforms(id);
    }
    Status beginFrame() override { return device_.beginFrame(); }
    Status endFrame() override { return device_.endFrame(); }
    void beginPass(const PassInfo& pass) override { device_.beginPass(pass); }
    void endPass() override { device_.endPass(); }
    void setProgram(ProgramId id, const StateDesc& state) override
    {
        device_.setProgram(id, state);
    }
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) override
    {
        device_.setTexture(location, unit, id, sampler);
    }
    void setUniform(int location, GlslType type, int count, const void* data) override
    {
        device_.setUniform(location, type, count, data);
    }
    void draw(MeshId id, std::uint32_t first, std::uint32_t count) override
    {
        device_.draw(id, first, count);
    }
    void drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host) override
    {
        device_.drawByHost(drawing, host);
    }
    void drawFullscreen() override { device_.drawFullscreen(); }
    Status present(TextureId id, const HostFramebuffer& host) override
    {
        return device_.present(id, host);
    }
    void finish() override { device_.finish(); }
    TimerId createTimer() override { return device_.createTimer(); }
    void beginTimer(TimerId id) override { device_.beginTimer(id); }
    void endTimer() override { device_.endTimer(); }
    bool timerReady(TimerId id) override { return device_.timerReady(id); }
    double readTimer(TimerId id) override { return device_.readTimer(id); }

protected:
    Device& device_;
};

}  // namespace crevice
