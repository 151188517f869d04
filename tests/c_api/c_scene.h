// SPDX-License-Identifier: MIT
// The C API from tests in C++, and a host's scene by it on a device that draws nothing.
#pragma once

#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "effects/api/c/handles.h"
#include "tests/support/need.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

/// The test ends where there is an error, which is freed.
inline void need(crevice_error* error)
{
    INFO(crevice_error_text(error));
    const bool failed = error != nullptr;
    crevice_error_free(error);
    REQUIRE(!failed);
}

/// 0 for none; the error is freed.
inline int codeOf(crevice_error* error)
{
    const int code = crevice_error_code(error);
    crevice_error_free(error);
    return code;
}

/// A struct with its size and zeros.
template <class Struct>
Struct sized()
{
    Struct made = {};
    made.struct_size = sizeof made;
    return made;
}

namespace crevice {

constexpr float kTriangle[] = {0, 0, -2, 1, 0, -2, 0, 1, -2};

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
    explicit CScene(const char* config = "mobile") : mesh(makeMesh(device))
    {
        auto desc = sized<crevice_effect_desc>();
        desc.config = config;
        desc.width = 64;
        desc.height = 36;
        need(crevice_effect_create(&device, &desc, &effect));
        const glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
        need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
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
    crevice_device device{recording};
    crevice_effect* effect = nullptr;
    crevice_mesh* mesh;
    crevice_draw draw = sized<crevice_draw>();
    crevice_material material = sized<crevice_material>();
    crevice_texture texture = sized<crevice_texture>();
};

/// Two views of a host's depth, which the first one has.
struct CViews : CScene {
    CViews() : CScene("mobile+geometry/host_depth")
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
