// SPDX-License-Identifier: MIT
// A host's scene by the C API, on a device that draws nothing.
#pragma once

#include <crevice/frame.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "effects/c_api/device.h"
#include "effects/c_api/effect.h"
#include "tests/c_api/c_api.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <memory>
#include <string>

namespace crevice {

constexpr float kTriangle[] = {0, 0, -2, 1, 0, -2, 0, 1, -2};

/// An effect that draws the scene, and a mesh of one triangle.
struct CScene {
    explicit CScene(const char* config = "mobile")
    {
        auto desc = sized<crevice_effect_desc>();
        desc.config = config;
        desc.width = 64;
        desc.height = 36;
        need(crevice_effect_create(&device, &desc, &effect));
        const glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
        need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
        mesh = makeMesh();
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

    crevice_mesh* makeMesh()
    {
        auto desc = sized<crevice_mesh_desc>();
        desc.positions = kTriangle;
        desc.vertex_count = 3;
        crevice_mesh* made = nullptr;
        need(crevice_mesh_create(&device, &desc, &made));
        return made;
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
    crevice_device device{recording};
    crevice_effect* effect = nullptr;
    crevice_mesh* mesh = nullptr;
    crevice_draw draw = sized<crevice_draw>();
    crevice_material material = sized<crevice_material>();
    crevice_texture texture = sized<crevice_texture>();
};

}  // namespace crevice
