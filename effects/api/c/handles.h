// SPDX-License-Identifier: MIT
// The handles of the C API: devices, meshes, and effects, which are what the C++ facade draws, what
// C reads of its config, and who keeps the scene of a frame alive.
#pragma once

#include <crevice/baked.h>
#include <crevice/effect.h>
#include <crevice/governor.h>

#include "core/frame/frame_math.h"
#include "core/gpu/owned.h"
#include "effects/api/c/calls.h"

namespace crevice {

/// The device goes last.
struct SharedMesh {
    std::shared_ptr<Device> device;
    Owned<MeshId> id;
};

/// What a draw has beyond its DrawItem.
struct HostDraw {
    std::shared_ptr<const SharedMesh> mesh = nullptr;
    crevice_draw_callback callback = nullptr;
    void* user = nullptr;
    bool* threw = nullptr;  ///< Becomes true when the callback throws.
};

struct HostMap {
    HostTexture host = {};
    Owned<TextureId> id = {};
};

/// What a material has beyond a Material: its maps in the order of kMaterialMaps.
struct HostMaterial {
    HostMap maps[std::size(kMaterialMaps)];
    std::uint64_t revision = 0;
};

/// The host's scene, behind what a Frame has of it.
struct HostScene {
    std::vector<HostDraw> draws = {};
    std::vector<HostMaterial> materials = {};
    bool callback_threw = false;
};

/// What an effect is loaded from.
struct EffectRequest {
    std::string config;
    std::string folder;
    std::string patch;
    std::vector<std::string> outputs;
    Limits limits;
    std::vector<std::string> overrides = {};                          ///< Of a level.
    std::shared_ptr<const std::vector<BakedConfig>> baked = nullptr;  ///< In place of files.
};

/// A config as it was loaded. Its strings stay where they are while params and features change.
struct LoadedConfig {
    std::shared_ptr<const struct LoadedDocument> document;  ///< Null where it was baked.
    Description description;
    SceneTraits scene = {};                       ///< What it is planned for before a frame.
    std::vector<std::vector<const char*>> words;  ///< Of each feature.
    std::vector<std::string> outputs;             ///< Those that are drawn.
};

/// Of a text that may be null.
inline std::string textOf(const char* text) { return text ? text : ""; }

/// Of a description, as C reads it; `outputs` empty for all.
std::unique_ptr<LoadedConfig> loadedOf(Description description, std::vector<std::string> outputs);

/// Of what was baked. Errors: CV2301 for a name that is none of it, and for a folder or a patch.
Result<std::unique_ptr<LoadedConfig>> loadBaked(const EffectRequest& request);

// What reads configs: load.cpp has it, and in the runtime, which has none, load_baked_only.cpp.

/// Errors: those of loadConfig and decode, and of mergePatch for the patch.
Result<std::unique_ptr<LoadedConfig>> loadEffect(const EffectRequest& request);

/// The smallest patch over the config that sets what `now` has, a description that was made of
/// `loaded.description` by setting params and features, as JSON. Errors: CV2301 of what was baked.
Result<std::string> patchOf(const LoadedConfig& loaded, const Description& now);

/// The error of patchOf for what was baked.
Diagnostic noPatch();

/// Errors: those of readFront.
Result<std::vector<FrontLevel>> levelsOf(const char* front);

}  // namespace crevice

/// The effects that were made on the device keep it alive too.
struct crevice_device {
    std::shared_ptr<crevice::Device> device;
};

struct crevice_mesh {
    std::shared_ptr<const crevice::SharedMesh> shared;
};

/// The device goes last.
struct crevice_effect {
    std::shared_ptr<crevice::Device> device;
    crevice::EffectRequest request;
    std::shared_ptr<crevice::LoadedConfig> loaded;
    std::vector<std::shared_ptr<crevice::LoadedConfig>> levels = {};  ///< Of its governor.
    crevice::HostScene scene = {};
    std::optional<crevice::Effect> effect = {};
    std::unique_ptr<crevice_error> warnings = {};
    std::string patch = {};
};

namespace crevice {

inline const Renderer& rendererOf(const crevice_effect& effect)
{
    return const_cast<Effect&>(*effect.effect).renderer();
}

/// By columns; 1 where all numbers are 0.
glm::dmat4 matrixOf(const double (&numbers)[16]);

/// What structs of C say.
MeshDesc meshOf(const crevice_mesh_desc& desc);
HostMesh meshOf(const crevice_host_mesh& from);
HostFramebuffer framebufferOf(const crevice_target& target);

/// Errors: CV6011 for null, a struct of a wrong size, no format's name, and an unknown kind.
Status takeTexture(const crevice_texture* given, HostTexture& host);

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
