// SPDX-License-Identifier: MIT
// A device over another one that keeps what programs would read at every draw.
#pragma once

#include "core/run/uniform_values.h"
#include "tools/render/device/forwarding_device.h"

#include <set>

namespace crevice {

using Words = std::vector<std::uint32_t>;

/// What a program would read: uniforms stay with their program, textures with the unit.
struct Bound {
    std::map<std::string, Words> uniforms;
    std::map<std::string, std::uint32_t> textures;
};

/// A draw of the present frame. That of the host has no mesh.
struct Drawn {
    std::string pass;
    int view;
    std::uint32_t mesh;
    Cull cull;
    Bound bound;
};

/// Keeps what is bound at every draw. A host's own draw leaves nothing as it was.
class ReadingDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    Status beginFrame() override
    {
        view_ = 0;
        passes_.clear();
        drawn.clear();
        sent = {};
        return ForwardingDevice::beginFrame();
    }
    void beginPass(const PassInfo& pass) override
    {
        pass_ = pass.label;
        if (!passes_.insert(pass_).second) {
            ++view_;
            passes_ = {pass_};
        }
        ForwardingDevice::beginPass(pass);
    }
    void setProgram(ProgramId id, const StateDesc& state) override
    {
        program_ = id;
        cull_ = state.cull;
        programs_[id.value].textures.clear();
        ForwardingDevice::setProgram(id, state);
    }
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) override
    {
        programs_[program_.value].textures[nameAt(location)] = id.value;
        ForwardingDevice::setTexture(location, unit, id, sampler);
    }
    void setUniform(int location, GlslType type, int count, const void* data) override
    {
        Words words(crevice::wordsOf(type, count));
        std::memcpy(words.data(), data, words.size() * sizeof words[0]);
        programs_[program_.value].uniforms[nameAt(location)] = words;
        ++sent[nameAt(location)];
        ForwardingDevice::setUniform(location, type, count, data);
    }
    void draw(MeshId id, std::uint32_t first, std::uint32_t count) override
    {
        drawn.push_back({pass_, view_, id.value, cull_, programs_[program_.value]});
        ForwardingDevice::draw(id, first, count);
    }
    void drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host) override
    {
        drawn.push_back({pass_, view_, 0, cull_, programs_[program_.value]});
        ForwardingDevice::drawByHost(drawing, host);
        programs_[program_.value] = {};
    }

    std::vector<Drawn> drawn;
    std::map<std::string, int> sent;  // calls by the uniform's name

private:
    std::string nameAt(int location) const
    {
        for (const UniformInfo& uniform : uniforms(program_))
            if (uniform.location == location) return uniform.name;
        return {};
    }

    int view_ = 0;
    std::string pass_;
    std::set<std::string> passes_;  // of the view
    ProgramId program_;
    Cull cull_ = Cull::none;
    std::map<std::uint32_t, Bound> programs_;
};

}  // namespace crevice
