// SPDX-License-Identifier: MIT
// What stands in for geometry modules, and the textures that a host would bring.
#include "tools/measure/stress/geometry.h"

#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"

#include <tuple>

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

const char* const kNoGuardBand =
    R"("guard_band": {"type": "float", "default": 1, "min": 1, "max": 2, "bind": "define"})";

// The host's textures have no guard band; its albedo is the same everywhere.
std::string overHost(const std::string& module)
{
    return R"({"format": 1, "name": ")" + module + R"(", "description": "A host's own.",
        "extends": [")" +
           module + R"("], "params": {)" + kNoGuardBand + R"(},
        "targets": {"albedo": {"format": ["rgba8"]}},
        "shaders": {"host_albedo": {"vertex": "common/fullscreen.vert", "fragment": "host/albedo.frag"}},
        "passes": {"host_albedo": {
            "type": "fullscreen", "shader": "host_albedo", "color": ["albedo"]}}})";
}

MemorySources hostModules()
{
    MemorySources modules;
    modules.add("geometry/depth_normal.json", overHost("geometry/host_depth_normal"));
    modules.add("geometry/depth_only.json", overHost("geometry/host_depth"));
    modules.add("host/albedo.frag", kWhite);
    return modules;
}

// The module that stores linear depth extends the one that it stands in for.
MemorySources linearModules(const SourceSet& sources)
{
    const char* const kDrawn = "geometry/depth_normal";
    const std::string path = std::string(kDrawn) + ".json";
    MemorySources modules;
    const SourceRef drawn = sources.find(path);
    const SourceRef linear = sources.find("geometry/linear_depth_normal.json");
    if (!drawn || !linear) return modules;
    std::string text = linear->text;
    text.replace(text.find(kDrawn), std::string(kDrawn).size(), "geometry/drawn");
    modules.add(path, text);
    modules.add("geometry/drawn.json", drawn->text);
    return modules;
}

// In the finest formats, so that what differs is the way to the points.
MemorySources positionModules()
{
    MemorySources modules;
    modules.add(
        "geometry/depth_normal.json", std::string(R"({"format": 1, "name": "geometry/depth_normal",
        "description": "Stored positions.", "extends": ["geometry/position_normal"],
        "params": {)") + kNoGuardBand + R"(},
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

Substitutes::Layer::Layer(MemorySources substitutes, const SourceSet& sources)
    : modules(std::move(substitutes)),
      all({&modules, &sources})
{
}

Substitutes::Substitutes(const SourceSet& sources) : own_(sources)
{
    over_.try_emplace(kHostGeometry, hostModules(), sources);
    over_.try_emplace(kPositionGeometry, positionModules(), sources);
    over_.try_emplace(kLinearGeometry, linearModules(sources), sources);
    over_.try_emplace(kDepthGeometry, depthModules(), sources);
}

const SourceSet& Substitutes::over(const std::string& geometry) const
{
    const auto found = over_.find(geometry);
    return found == over_.end() ? own_ : found->second.all;
}

Result<std::shared_ptr<const std::vector<ImportedTexture>>> changedTextures(Device& device,
                                                                            const StressShot& shot)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, shot.scene);
    if (!scene) return scene.diagnostics();
    Frame frame = makeFrame(*scene, SceneCamera(), shot.extent);
    frame.camera = shot.host_camera;
    Description wanted;
    for (const auto& [name, format] :
         {std::pair{"depth", Format::depth32f}, {"normal", Format::rgba16f}}) {
        ImportDesc import;
        import.name = name;
        import.type = ImportType::texture;
        import.format = formatInfo(format).name;
        wanted.imports.push_back(import);
    }
    Result<HostTextures> host = HostTextures::make(device, wanted, shot.extent, frame);
    if (!host) return host.diagnostics();
    const Result<Frame> drawn = host->frameOf(frame);
    if (!drawn) return drawn.diagnostics();
    Result<Image> depth = device.readTexture(drawn->textures[0].texture);
    if (!depth) return depth.diagnostics();
    Result<Image> normal = device.readTexture(drawn->textures[1].texture);
    if (!normal) return normal.diagnostics();
    shot.host(*depth, *normal);

    const std::shared_ptr<std::vector<ImportedTexture>> textures(
        new std::vector<ImportedTexture>, [&device](std::vector<ImportedTexture>* all) {
            for (const ImportedTexture& each : *all) device.destroy(each.texture);
            delete all;
        });
    for (const auto& [name, format, image] :
         {std::tuple{"depth", Format::r32f, &*depth}, {"normal", Format::rgba32f, &*normal}}) {
        const Result<TextureId> id = device.createTexture({name, format, image->extent});
        if (!id) return id.diagnostics();
        textures->push_back({name, *id});
        if (const Status written = device.writeTexture(*id, *image); !written)
            return written.diagnostics();
    }
    return {textures};
}

}  // namespace crevice
