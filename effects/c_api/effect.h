// SPDX-License-Identifier: MIT
// The handles of effects: what the C++ facade draws, and what C reads of its config.
#pragma once

#include <crevice/config.h>
#include <crevice/crevice.h>
#include <crevice/effect.h>

#include "effects/c_api/report.h"
#include "effects/c_api/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace crevice {

/// What an effect is loaded from.
struct EffectRequest {
    std::string config;
    std::string folder;
    std::string patch;
    std::vector<std::string> outputs;
};

/// A config as it was loaded. Its strings stay where they are while params and features change.
struct LoadedConfig {
    Node bare;      ///< The document without the patch, ...
    Node document;  ///< ... and with it.
    Description description;
    std::vector<std::vector<const char*>> words;  ///< Of each feature.
    std::vector<std::string> outputs;             ///< Those that are drawn.
};

/// Errors: those of loadConfig and decode, and of mergePatch for the patch.
Result<std::unique_ptr<LoadedConfig>> loadEffect(const EffectRequest& request);

/// The smallest patch over `loaded.bare` that sets what `now` has, a description that was made of
/// `loaded.description` by setting params and features.
Result<Node> patchOf(const LoadedConfig& loaded, const Description& now);

}  // namespace crevice

/// The device goes last.
struct crevice_effect {
    std::shared_ptr<crevice::Device> device;
    crevice::EffectRequest request;
    std::unique_ptr<crevice::LoadedConfig> loaded;
    crevice::HostScene scene = {};
    std::optional<crevice::Effect> effect = {};
    std::unique_ptr<crevice_error> warnings = {};
    std::string patch = {};
};

namespace crevice {

/// What further views have of the effect and the host, before a frame. Errors: those of
/// Device::refresh.
Status prepareViews(crevice_effect& effect);

/// Runs a call on an effect that is not null, and keeps its warnings.
template <class Call>
crevice_error* onEffect(crevice_effect* effect, const Call& call) noexcept
{
    return guarded([&]() -> Status {
        if (Status given = checkGiven(effect, "the effect"); !given) return given;
        effect->warnings.reset();
        const Status status = call();
        if (status && !status.diagnostics().empty())
            effect->warnings = std::make_unique<crevice_error>(status.diagnostics());
        return status;
    });
}

}  // namespace crevice
