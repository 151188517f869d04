// SPDX-License-Identifier: MIT
// Whole pictures by rays, on all processors; and kept on disk: tracing one takes seconds, reading
// it milliseconds.
//
// A file is named after a hash over everything that decides its pixels, so that it never goes
// stale; any of them may be deleted at any time.
#include "tools/measure/reference/tracer.h"

#include "core/base/content_hash.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/config_options.h"
#include "tools/measure/reference/pixel_tracer.h"
#include "tools/render/image/image_file.h"

#include <CLI/CLI.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstdlib>

namespace fs = std::filesystem;

namespace crevice {
namespace {

glm::dvec3 eyeOf(const Camera& camera) { return glm::inverse(camera.view_from_world)[3]; }

static_assert(sizeof(Vertex) == 8 * sizeof(float), "vertices are hashed as they lie in memory");

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
        hash.addBytes(&instance.world_from_model, sizeof(instance.world_from_model));
        addCutout(hash, scene, scene.materials[instance.material]);
    }
}

// What stands behind the picture in its file: as many digits as the key has.
std::string checksum(std::string_view pfm, const std::string& key)
{
    ContentHash hash;
    hash.addText(key);
    hash.addText(pfm);
    return hash.hex();
}

// A file that is there but is not what was kept under the key is a warning.
std::optional<Image> readKept(const std::string& file, const std::string& key, Extent extent,
                              Diagnostics& warnings)
{
    constexpr std::size_t kMostBeside = 128;  // header and checksum
    const FileBytes kept =
        readBytes(file, std::size_t(extent.width) * extent.height * sizeof(float) + kMostBeside);
    if (kept.missing) return std::nullopt;
    const std::size_t end = kept.bytes.size() - std::min(kept.bytes.size(), key.size());
    const std::string_view pfm = std::string_view(kept.bytes).substr(0, end);
    if (kept && kept.bytes.substr(end) == checksum(pfm, key))
        if (Result<Image> image = decodeImage(pfm, file)) return std::move(*image);
    warnings.push_back(asWarning({Code::image_broken,
                                  "the cached reference '" + file + "' is not as it was written",
                                  "it is traced again"}));
    return std::nullopt;
}

void keep(const std::string& file, const std::string& key, const Image& image,
          Diagnostics& warnings)
{
    std::error_code ignored;
    fs::create_directories(fs::path(file).parent_path(), ignored);
    const std::string pfm = pfmBytes(image);
    const Status written = writeFile(file, pfm + checksum(pfm, key));
    for (Diagnostic warning : written.diagnostics()) {
        warning.severity = Severity::warning;
        warning.help =
            "the reference is not kept and will be traced again; give another folder with --cache";
        warnings.push_back(std::move(warning));
    }
}

Status checkSeen(const Image& image)
{
    const bool seen = anyOf(image.pixels, [](float value) { return !std::isnan(value); });
    if (seen) return {};
    return nothingSeen();
}

}  // namespace

Result<Image> traceAmbientOcclusion(const RayScene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options)
{
    Result<ProgressiveTrace> begun = ProgressiveTrace::begin(scene, camera, extent, options, 1);
    if (!begun) return begun.diagnostics();
    ProgressiveTrace& trace = *begun;
    const std::thread::id caller = std::this_thread::get_id();
    onProcessors(options.threads, extent.height, [&](int y) {
        trace.traceRow(0, y);
        if (options.progress && std::this_thread::get_id() == caller)
            options.progress(static_cast<double>(y + 1) / extent.height);
    });
    return trace.image();
}

Result<Image> traceAmbientOcclusion(const Scene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options)
{
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    const auto built = makeRayScene(scene, eyeOf(camera));
    if (!built) return built.diagnostics();
    return traceAmbientOcclusion(**built, camera, extent, options);
}

Result<SurfaceMap> traceSurfaces(const RayScene& scene, const Camera& camera, Extent extent)
{
    const TraceOptions options;
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    const PixelTracer tracer(scene, camera, extent, options, 1);
    SurfaceMap map{extent, {}};
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            TraceHit hit;
            SurfacePoint point;
            if (tracer.surface(x, y, hit))
                point = {hit.position + scene.center(), hit.geometric_normal, true};
            map.points.push_back(point);
        }
    }
    return map;
}

Result<SurfaceMap> traceSurfaces(const Scene& scene, const Camera& camera, Extent extent)
{
    if (const Status status = checkTrace(camera, extent, {}); !status) return status.diagnostics();
    const auto built = makeRayScene(scene, eyeOf(camera));
    if (!built) return built.diagnostics();
    return traceSurfaces(**built, camera, extent);
}

std::string CacheOptions::path() const
{
    if (off) return {};
    return folder.empty() ? usualCacheFolder() : folder;
}

std::string usualCacheFolder()
{
    const auto variable = [](const char* name) -> std::string {
        const char* value = std::getenv(name);
        return value ? value : "";
    };
    const std::string cache = variable("XDG_CACHE_HOME"), home = variable("HOME");
    if (!cache.empty()) return cache + "/crevice";
    return home.empty() ? "" : home + "/.cache/crevice";
}

void addCacheOptions(CLI::App& app, CacheOptions& options)
{
    auto* folder = addText(app, "--cache", options.folder, "FOLDER",
                           "Where ray-traced references are kept. Default: "
                           "$XDG_CACHE_HOME/crevice or ~/.cache/crevice");
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
    hash.addBytes(&camera.view_from_world, sizeof(camera.view_from_world));
    hash.addBytes(&camera.clip_from_view, sizeof(camera.clip_from_view));
    hash.add(extent.width);
    hash.add(extent.height);
    hash.add(options.radius);
    hash.add(options.rays);
    return hash.hex();
}

Result<Image> cachedReference(const Scene& scene, const Camera& camera, Extent extent,
                              const TraceOptions& options, const std::string& cache_folder)
{
    Diagnostics warnings;
    const std::string key = referenceKey(scene, camera, extent, options);
    const std::string file = cache_folder + "/ao_" + key + ".pfm";
    if (!cache_folder.empty())
        if (auto kept = readKept(file, key, extent, warnings)) return std::move(*kept);
    Result<Image> traced = traceAmbientOcclusion(scene, camera, extent, options);
    if (!traced) return traced;
    if (const Status seen = checkSeen(*traced); !seen) return seen.diagnostics();
    if (!cache_folder.empty()) keep(file, key, *traced, warnings);
    return {std::move(*traced), std::move(warnings)};
}

}  // namespace crevice
