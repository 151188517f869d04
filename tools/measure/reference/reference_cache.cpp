// SPDX-License-Identifier: MIT
// Keys of references, and their files.
#include "tools/measure/reference/reference_cache.h"

#include "core/base/content_hash.h"
#include "tools/render/image/image_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

static_assert(sizeof(Vertex) == 8 * sizeof(float), "vertices are hashed as they lie in memory");

std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

template <typename Matrix>
void addTransform(ContentHash& hash, const Matrix& matrix)
{
    hash.addBytes(&matrix[0][0], sizeof(matrix));
}

void addMesh(ContentHash& hash, const MeshDesc& mesh)
{
    hash.add(static_cast<std::uint64_t>(mesh.vertices.size()));
    hash.addBytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
    hash.add(static_cast<std::uint64_t>(mesh.indices.size()));
    hash.addBytes(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
}

// What the tracer sees of a material: where it is cut away.
void addCutout(ContentHash& hash, const Scene& scene, const SceneMaterial& material)
{
    hash.add(material.alpha_cutoff);
    if (material.alpha_cutoff <= 0.0f) return;
    hash.add(material.base_color.a);
    if (material.base_color_texture < 0) return;
    const Image& image = scene.textures[material.base_color_texture].image;
    hash.add(image.extent.width);
    hash.add(image.extent.height);
    for (std::size_t k = 3; k < image.pixels.size(); k += 4) hash.add(image.pixels[k]);
}

void addTracedScene(ContentHash& hash, const Scene& scene)
{
    for (const MeshDesc& mesh : scene.meshes) addMesh(hash, mesh);
    for (const SceneInstance& instance : scene.instances) {
        hash.add(instance.mesh);
        addTransform(hash, instance.world_from_model);
        addCutout(hash, scene, scene.materials[instance.material]);
    }
}

bool whole(const Image& image, Extent extent)
{
    return image.extent == extent && image.channels == 1 &&
           std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) {
               return std::isnan(value) || (value >= 0.0f && value <= 1.0f);
           });
}

Diagnostics keep(const std::string& folder, const std::string& file, const Image& image)
{
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    Diagnostics warnings = writePfm(file, image).diagnostics();
    for (Diagnostic& warning : warnings) {
        warning.severity = Severity::warning;
        warning.help =
            "the reference is not kept and will be traced again; give another folder with --cache";
    }
    return warnings;
}

Status checkSeen(const Image& image)
{
    const bool seen = std::any_of(image.pixels.begin(), image.pixels.end(),
                                  [](float value) { return !std::isnan(value); });
    if (seen) return {};
    Diagnostic error{Code::nothing_seen, "the camera sees no surface of the scene"};
    error.help = "leave --camera out for a view of the whole scene, or turn the camera towards it";
    return error;
}

}  // namespace

std::string CacheOptions::path() const
{
    if (off) return {};
    if (!folder.empty()) return folder;
    if (const std::string cache = environment("XDG_CACHE_HOME"); !cache.empty())
        return cache + "/crevice";
    const std::string home = environment("HOME");
    return home.empty() ? "" : home + "/.cache/crevice";
}

void addCacheOptions(CLI::App& app, CacheOptions& options)
{
    auto* folder = app.add_option("--cache", options.folder,
                                  "Where ray-traced references are kept. Default: "
                                  "$XDG_CACHE_HOME/crevice or ~/.cache/crevice")
                       ->type_name("FOLDER");
    app.add_flag("--no-cache", options.off,
                 "Trace the reference even if it is cached, and do not cache it")
        ->excludes(folder);
}

std::string referenceKey(const Scene& scene, const Camera& camera, Extent extent,
                         const TraceOptions& options)
{
    ContentHash hash;
    hash.add(kTracerVersion);
    addTracedScene(hash, scene);
    addTransform(hash, camera.view_from_world);
    addTransform(hash, camera.clip_from_view);
    hash.add(extent.width);
    hash.add(extent.height);
    hash.add(options.radius);
    hash.add(options.rays);
    return hash.hex();
}

Result<Image> cachedReference(const Scene& scene, const Camera& camera, Extent extent,
                              const TraceOptions& options, const std::string& cache_folder)
{
    std::string file;
    if (!cache_folder.empty()) {
        file = cache_folder + "/ao_" + referenceKey(scene, camera, extent, options) + ".pfm";
        const Result<Image> kept = readImage(file);
        if (kept && whole(*kept, extent)) return kept;
    }
    Result<Image> traced = traceAmbientOcclusion(scene, camera, extent, options);
    if (!traced) return traced;
    if (const Status seen = checkSeen(*traced); !seen) return seen.diagnostics();
    if (file.empty()) return traced;
    Diagnostics warnings = keep(cache_folder, file, *traced);
    return {std::move(*traced), std::move(warnings)};
}

}  // namespace crevice
