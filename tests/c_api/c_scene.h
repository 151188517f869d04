// SPDX-License-Identifier: MIT
// A host's scene by the C API, on a device that draws nothing.
#pragma once

#include <crevice/frame.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "effects/c_api/device.h"
#include "effects/c_api/effect.h"
#include "tests/c_api/c_api.h"
#include "tools/render/device/forwarding_device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <memory>
#include <string>

namespace crevice {

constexpr float kTriangle[] = {0, 0, -2, 1, 0, -2, 0, 1, -2};

/// Keeps the last structs that it was handed.
struct HearingDevice : ForwardingDevice {
    using ForwardingDevice::ForwardingDevice;

    Result<MeshId> createMesh(const MeshDesc& desc) override
    {
        mesh = desc;
        return ForwardingDevice::createMesh(desc);
    }
    Result<MeshId> adoptMesh(const HostMesh& host) override
    {
        host_mesh = host;
        return ForwardingDevice::adoptMesh(host);
    }
    Result<TextureId> adoptTexture(const HostTexture& host) override
    {
        texture = host;
        return ForwardingDevice::adoptTexture(host);
    }
    Status present(TextureId id, const HostFramebuffer& host) override
    {
        target = host;
        return ForwardingDevice::present(id, host);
    }

    MeshDesc mesh;
    HostMesh host_mesh;
    HostTexture texture;
    HostFramebuffer target;
};

inline crevice_effect* makeEffect(crevice_device& device, const char* config)
{
    auto desc = sized<crevice_effect_desc>();
    desc.config = config;
    desc.width = 64;
    desc.height = 36;
    crevice_effect* effect = nullptr;
    need(crevice_effect_create(&device, &desc, &effect));
    const glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
    need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
    return effect;
}

inline crevice_mesh* makeMesh(crevice_device& device)
{
    auto desc = sized<crevice_mesh_desc>();
    desc.positions = kTriangle;
    desc.vertex_count = 3;
    crevice_mesh* made = nullptr;
    need(crevice_mesh_create(&device, &desc, &made));
    return made;
}

/// An effect that draws the scene, and a mesh of one triangle.
struct CScene {
    explicit CScene(const char* config = "mobile")
        : effect(makeEffect(device, config)),
          mesh(makeMesh(device))
    {
        draw.mesh = mesh;
        texture.name = 5;
        texture.format = "rgba8";
        texture.width = texture.height = 4;
    }
    ~CScene()
    {
        crevice_mesh_destroy(mesh);
        crevice_effect_destroy(effect);
        for (const std::string& each : recording->misuse()) FAIL_CHECK(each);
        CHECK(recording->live() == 0);
    }

    void setDraw() { need(crevice_effect_set_draws(effect, &draw, 1)); }
    void setMaterial() { need(crevice_effect_set_materials(effect, &material, 1)); }

    /// Whether the scene is drawn in a frame.
    bool draws()
    {
        recording->clearLog();
        need(crevice_effect_render(effect));
        return recording->log().find("draw mesh") != std::string::npos ||
               recording->log().find("drawByHost") != std::string::npos;
    }

    Frame& frame() { return effect->effect->frame(); }

    std::shared_ptr<RecordingDevice> recording = std::make_shared<RecordingDevice>();
    std::shared_ptr<HearingDevice> hearing = std::make_shared<HearingDevice>(*recording);
    crevice_device device{hearing};
    crevice_effect* effect;
    crevice_mesh* mesh;
    crevice_draw draw = sized<crevice_draw>();
    crevice_material material = sized<crevice_material>();
    crevice_texture texture = sized<crevice_texture>();
};

/// Two views of a host's depth, which the first one has.
struct CViews : CScene {
    CViews()
        : CScene(R"({ "format": 1, "name": "ao", "extends": ["mobile", "geometry/host_depth"] })")
    {
        texture.format = "depth24";
        need(crevice_effect_set_texture(effect, "depth", &texture));
        std::copy_n(glm::value_ptr(frame().camera.clip_from_view), 16, view.clip_from_view);
        need(crevice_effect_set_views(effect, &view, 1));
    }

    int setTexture(int of_view)
    {
        return codeOf(crevice_effect_set_view_texture(effect, of_view, "depth", &texture));
    }

    crevice_view view = sized<crevice_view>();
};

}  // namespace crevice
