// SPDX-License-Identifier: MIT
// A small pipeline that has one of everything, on a recording device, for tests of the renderer.
#pragma once

#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "tests/support/need.h"
#include "tests/support/test_config.h"

#include <glm/gtc/type_ptr.hpp>

namespace crevice {

inline const char* const kRigConfig = R"({
  "format": 1, "name": "rig",
  "params": {
    "radius": {"default": 0.5, "min": 0.001, "max": 100, "unit": "scene units"},
    "intensity": {"default": 1, "min": 0, "max": 4},
    "taps": {"type": "int", "default": 3, "min": 1, "max": 8},
    "samples": {"type": "int", "default": 4, "min": 1, "max": 64, "bind": "define"},
    "edge": {"default": 0.5, "min": 0, "max": 1, "bind": "define"},
    "resolution": {"default": 0.5, "min": 0.25, "max": 1},
    "tile": {"type": "int", "default": 4, "min": 1, "max": 16},
    "tint": {"type": "vec3", "default": [1, 0.5, 0.25], "min": 0, "max": 1}
  },
  "features": {"soft": {"type": "bool", "default": true},
               "look": {"type": "enum", "values": ["lit", "flat"]}},
  "imports": {"camera": {"type": "camera"}, "scene": {"type": "draw_list"},
              "lights": {"type": "lights"}, "decal": {"type": "texture", "optional": true}},
  "generated": {"kernel": {"generator": "hemisphere_kernel", "count": "samples"},
                "noise": {"generator": "rotation_noise", "count": "tile"}},
  "targets": {"depth": {"format": ["depth24"]}, "normal": {"format": ["rgba8"]},
              "albedo": {"format": ["rgba8"]}, "color": {"format": ["rgba8"]},
              "smooth_ao": {"format": ["r8"], "history": false},
              "ao": {"format": ["r8"], "size": {"scale": "resolution"}}},
  "shaders": {"geometry": {"vertex": "mesh.vert", "fragment": "geometry.frag"},
              "occlusion": {"vertex": "full.vert", "fragment": "occlusion.frag"},
              "filter": {"vertex": "full.vert", "fragment": "filter.frag"},
              "lighting": {"vertex": "full.vert", "fragment": "lighting.frag"}},
  "passes": {
    "geometry": {"type": "draw", "shader": "geometry", "color": ["normal", "albedo"],
                 "depth": "depth", "clear": {"albedo": [0.25, 0, 0, 1]}},
    "occlusion": {"type": "fullscreen", "shader": "occlusion", "color": "ao",
                  "no_op": {"intensity": {"at": 0, "gives": {"ao": 1}}}},
    "filter": {"type": "fullscreen", "shader": "filter", "color": "smooth_ao",
               "when": {"soft": true}, "bypass": {"smooth_ao": "ao"},
               "inputs": {"source": {"from": "ao", "filter": "linear"}}},
    "lighting": {"type": "fullscreen", "shader": "lighting", "color": "color"}
  },
  "outputs": {"ao": "smooth_ao", "color": "color"}
})";

inline const char* const kRigLighting =
    "#version 300 es\n"
    "precision highp float;\n"
    "#define LOOK_NOW LOOK\n"
    "uniform vec4 light_position[MAX_LIGHTS];\n"
    "uniform vec3 light_color[MAX_LIGHTS], light_attenuation[MAX_LIGHTS];\n"
    "uniform vec3 ambient_light, tint;\n"
    "uniform int light_count;\n"
    "uniform sampler2D albedo, smooth_ao, decal;\n"
    "layout(location = 0) out vec4 color;\n";

/// Its shaders; the filter also declares what is given.
inline std::vector<TestFile> rigSources(const std::string& remembering)
{
    return {
        {"mesh.vert",
         "#version 300 es\nuniform mat4 clip_from_model, view_from_model;\n"
         "uniform mat3 view_normal_from_model;\n"},
        {"geometry.frag",
         "#version 300 es\n"
         "precision highp float;\n"
         "uniform vec4 base_color;\n"
         "uniform vec3 specular;\n"
         "uniform float alpha_cutoff, shininess;\n"
         "uniform sampler2D base_color_map;\n"
         "layout(location = 0) out vec4 normal;\n"
         "layout(location = 1) out vec4 albedo;\n"},
        {"full.vert", "#version 300 es\nvoid main() {}\n"},
        {"occlusion.frag",
         "#version 300 es\n"
         "precision highp float;\n"
         "uniform mat4 clip_from_view, view_from_clip, view_from_window;\n"
         "uniform mat4 view_from_world, world_from_view;\n"
         "uniform vec3 kernel[SAMPLES];\n"
         "uniform vec2 viewport_size;\n"
         "uniform float radius, intensity;\n"
         "uniform sampler2D depth, normal, noise;\n"
         "layout(location = 0) out float ao;\n"},
        {"filter.frag",
         "#version 300 es\nprecision highp float;\n"
         "uniform vec2 viewport_size;\n"
         "uniform int taps;\n"
         "const float edge = EDGE;\n"
         "uniform sampler2D source;\n" +
             remembering + "layout(location = 0) out float smooth_ao;\n"},
        {"lighting.frag", kRigLighting},
    };
}

/// With `remembers`, its filter reads what it wrote in the last frame.
inline Description rigDescription(bool remembers = false)
{
    std::string config = kRigConfig;
    std::string remembering;
    if (remembers) {
        config.replace(config.find("\"history\": false"), 16, "\"history\": true");
        remembering =
            "uniform sampler2D smooth_ao_history;\n"
            "uniform mat4 previous_view_from_view, previous_clip_from_view;\n"
            "uniform float history_valid;\n"
            "uniform int frame_index;\n";
    }
    return describe(config, rigSources(remembering));
}

/// A device with a mesh, a frame with a draw, a material and a light, and a renderer for them. The
/// test fails where the device was misused.
struct Rig {
    explicit Rig(bool remembering = false) : remembers(remembering) {}
    ~Rig()
    {
        for (const std::string& each : device.misuse()) FAIL_CHECK(each);
    }

    bool remembers;
    RecordingDevice device;
    MeshId mesh = device.createMesh({"cube", std::vector<Vertex>(3), {0, 1, 2, 2, 1, 0}}).value();
    Frame frame = makeFrame();
    std::unique_ptr<Renderer> renderer = make(device);

    Frame makeFrame() const
    {
        Frame made;
        made.draws = {{mesh, 0, 6, glm::mat4(1.0f), 0}};
        made.materials.resize(1);
        made.lights.resize(1);
        return made;
    }

    std::unique_ptr<Renderer> make(Device& on) const
    {
        return need(Renderer::create(on, rigDescription(remembers), {{64, 32}}, traitsOf(frame)));
    }

    /// Takes another renderer, for what is in the frame now.
    void use(const Description& description, const CompileOptions& options = {{64, 32}})
    {
        renderer = need(Renderer::create(device, description, options, traitsOf(frame)));
    }

    /// The log of one frame that must succeed.
    std::string draw()
    {
        device.clearLog();
        need(renderer->render(frame));
        return device.log();
    }

    bool logged(const std::string& part) const
    {
        return device.log().find(part) != std::string::npos;
    }
    bool ranPass(const std::string& name) const { return logged("beginPass " + name + ' '); }

    float value(const char* param) const
    {
        return findNamed(renderer->description().params, param)->value[0];
    }
    int feature(const char* name) const
    {
        return findNamed(renderer->description().features, name)->value;
    }
};

/// The matrix that was last sent as the uniform `name`.
inline glm::mat4 sentMatrix(const Rig& rig, const char* name)
{
    const std::vector<float> values = rig.device.lastUniform(name);
    REQUIRE(values.size() == 16);
    return glm::make_mat4(values.data());
}

/// The code of a status' first error; Code::internal when there is none.
inline Code codeOf(const Status& status)
{
    return status.ok() ? Code::internal : status.diagnostics().front().code;
}

}  // namespace crevice
