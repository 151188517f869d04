// SPDX-License-Identifier: MIT
// The host's scene, behind what a Frame has of it: who keeps meshes and maps alive, and what a
// frame compares with the one before.
#pragma once

#include <crevice/crevice.h>
#include <crevice/device.h>

#include "core/frame/frame_values.h"
#include "core/gpu/owned.h"

#include <glm/mat4x4.hpp>

#include <iterator>
#include <memory>
#include <string>
#include <vector>

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

/// A texture of one of the further views.
struct ViewTexture {
    int view;  ///< From 1.
    std::string import;
    HostMap map;
};

struct HostScene {
    std::vector<HostDraw> draws = {};
    std::vector<ViewTexture> view_textures = {};
    std::vector<HostMaterial> materials = {};
    bool callback_threw = false;
};

/// By columns; 1 where all numbers are 0.
glm::dmat4 matrixOf(const double (&numbers)[16]);

}  // namespace crevice

struct crevice_mesh {
    std::shared_ptr<const crevice::SharedMesh> shared;
};
