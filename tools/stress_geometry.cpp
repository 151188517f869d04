// SPDX-License-Identifier: MIT
// What stands in for geometry modules, and the textures that a host would bring.
#include "tools/stress_geometry.h"

#include "tools/read_output.h"
#include "tools/scene_upload.h"

#include "core/renderer.h"

#include <utility>

namespace crevice {
namespace {

const char* const kWhite = R"(#version 300 es
precision mediump float;
layout(location = 0) out vec4 albedo;
void main()
{
    albedo = vec4(0.8);
}
)";

const char* const kNoGuard =
    R"("guard": {"type": "float", "default": 1, "min": 1, "max": 2, "bind": "define"})";

// The host's textures have no guard band; its albedo is the same everywhere.
std::string overHost(const std::string& module)
{
    return R"({"format": 1, "name": ")" + module + R"(", "description": "A host's own.",
        "extends": [")" + module + R"("], "params": {)" + kNoGuard + R"(},
        "targets": {"albedo": {"format": ["rgba8"]}},
        "shaders": {"host_albedo": {"vertex": "common/fullscreen.vert", "fragment": "host/albedo.frag"}},
        "passes": {"host_albedo": {
            "type": "fullscreen", "shader": "host_albedo", "color": ["albedo"]}}})";
}

// `kind` ends the names of the host's modules.
MemorySources hostModules(const std::string& kind)
{
    MemorySources modules;
    modules.add("geometry/depth_normal.json", overHost("geometry/host_depth_normal" + kind));
    modules.add("geometry/depth_only.json", overHost("geometry/host_depth" + kind));
    modules.add("host/albedo.frag", kWhite);
    return modules;
}

// In the finest formats, so that what differs is the way to the points.
MemorySources positionModules()
{
    MemorySources modules;
    modules.add("geometry/depth_normal.json",
                std::string(R"({"format": 1, "name": "geometry/depth_normal",
        "description": "Stored positions.", "extends": ["geometry/position_normal"],
        "params": {)") + kNoGuard + R"(},
        "targets": {"position": {"format": ["rgba32f", "rgba16f"]}}})");
    return modules;
}

MemorySources depthModules()
{
    MemorySources modules;
    modules.add("geometry/position_normal.json",
                R"({"format": 1, "name": "geometry/position_normal",
        "description": "Depth and normals.", "extends": ["geometry/depth_normal"],
        "targets": {"depth": {"format": ["depth32f", "depth24"]},
                    "normal": {"format": ["rgba16f", "rgb10_a2"]}}})");
    return modules;
}

}  // namespace

StandIns::StandIns(const SourceSet& sources)
    : own_(sources),
      host_(hostModules("")),
      log_(hostModules("_log")),
      positions_(positionModules()),
      depths_(depthModules()),
      over_host_({&host_, &sources}),
      over_log_({&log_, &sources}),
      over_positions_({&positions_, &sources}),
      over_depths_({&depths_, &sources})
{
}

const SourceSet& StandIns::over(const std::string& geometry) const
{
    if (geometry == kHostGeometry) return over_host_;
    if (geometry == kLogGeometry) return over_log_;
    if (geometry == kPositionGeometry) return over_positions_;
    if (geometry == kDepthGeometry) return over_depths_;
    return own_;
}

Result<HostTextures> HostTextures::make(Device& device, const StressShot& shot,
                                        const SourceSet& sources)
{
    MemorySources mine;
    mine.add("configs/host.json", R"({"format": 1, "name": "host", "description": "A G-buffer.",
        "extends": ["geometry/depth_normal"],
        "targets": {"depth": {"format": ["depth32f"]}, "normal": {"format": ["rgba16f", "rgb10_a2"]}},
        "outputs": {"depth": "depth", "normal": "normal"}})");
    const LayeredSources all({&mine, &sources});
    const Result<Description> description = loadDescription({"host", {}, {}, {}}, all);
    if (!description) return description.diagnostics();
    const Result<UploadedScene> scene = UploadedScene::upload(device, shot.scene);
    if (!scene) return scene.diagnostics();
    Frame frame = makeFrame(*scene, SceneCamera(), shot.extent);
    frame.camera = shot.host_camera;
    const auto renderer =
        Renderer::create(device, *description, {shot.extent, {}, {}}, traitsOf(frame));
    if (!renderer) return renderer.diagnostics();
    if (const Status drawn = (*renderer)->render(frame); !drawn) return drawn.diagnostics();
    Result<Image> depth = readOutput(device, **renderer, "depth");
    if (!depth) return depth.diagnostics();
    Result<Image> normal = readOutput(device, **renderer, "normal");
    if (!normal) return normal.diagnostics();
    shot.host(*depth, *normal);

    HostTextures textures(device);
    const char* const name = shot.geometry == kLogGeometry ? "log_depth" : "depth";
    if (const Status made = textures.add(name, Format::r32f, *depth); !made)
        return made.diagnostics();
    if (const Status made = textures.add("normal", Format::rgba32f, *normal); !made)
        return made.diagnostics();
    return textures;
}

HostTextures::~HostTextures()
{
    for (const ImportedTexture& each : textures_) device_->destroy(each.texture);
}

HostTextures::HostTextures(HostTextures&& other) noexcept
    : device_(other.device_), textures_(std::exchange(other.textures_, {}))
{
}

Status HostTextures::add(const char* name, Format format, const Image& image)
{
    const Result<TextureId> id = device_->createTexture({name, format, image.extent});
    if (!id) return id.diagnostics();
    textures_.push_back({name, *id});
    return device_->writeTexture(*id, image);
}

}  // namespace crevice
