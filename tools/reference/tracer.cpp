// SPDX-License-Identifier: MIT
// Ambient occlusion by rays.
#include "tools/reference/tracer.h"

#include "tools/reference/embree_scene.h"

#include "core/base/numbers.h"
#include "core/frame/frame_math.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace crevice {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMaxTraceSide = 1 << 15;

// Hammersley points: an even share of the cosine-weighted hemisphere each.
struct Probe {
    float radius_squared;  // on the unit disc, before its rotation
    float cosine, sine;    // of the angle
};

std::vector<Probe> makeProbes(int count)
{
    std::vector<Probe> probes;
    for (int index = 0; index < count; ++index) {
        double inverse = 0.0, digit = 0.5;  // the radical inverse, base 2
        for (int bits = index; bits > 0; bits >>= 1, digit /= 2) inverse += (bits & 1) * digit;
        probes.push_back({static_cast<float>((index + 0.5) / count),
                          static_cast<float>(std::cos(2 * kPi * inverse)),
                          static_cast<float>(std::sin(2 * kPi * inverse))});
    }
    return probes;
}

// PCG: Jarzynski, Olano 2020, "Hash Functions for GPU Rendering".
std::uint32_t hashed(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// Uniform in [0, 1).
float fraction(std::uint32_t hash) { return static_cast<float>(hash >> 8) / 16777216.0f; }

struct Basis {
    glm::vec3 tangent, bitangent, normal;
};

Basis makeBasis(const glm::vec3& n)
{
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

class Tracer {
public:
    Tracer(const EmbreeScene& scene, const Camera& camera, Extent extent,
           const TraceOptions& options)
        : scene_(scene),
          view_from_clip_(cameraMatrices(camera).view_from_clip),
          world_from_view_(cameraMatrices(camera).world_from_view),
          orthographic_(camera.orthographic()),
          extent_(extent),
          radius_(options.radius),
          probes_(makeProbes(options.rays))
    {
    }

    /// NaN where the pixel sees no surface.
    float pixel(int x, int y) const
    {
        TraceHit hit;
        if (!scene_.intersect(primaryRay(x, y), hit))
            return std::numeric_limits<float>::quiet_NaN();
        if (radius_ <= 0.0) return 1.0f;
        return visibility(hit, hashed(static_cast<std::uint32_t>(x) + hashed(y)));
    }

    SurfacePoint surface(int x, int y) const
    {
        TraceHit hit;
        if (!scene_.intersect(primaryRay(x, y), hit)) return {};
        return {hit.position + scene_.center(), hit.geometric_normal, true};
    }

private:
    // Grows with the distance from the eye, also of points at infinity (w = 0).
    double depthOrder(const glm::dvec4& view) const
    {
        return orthographic_ ? -view.z / view.w : view.w / view.z;
    }

    // From the near plane to the far one. Reversed depth and a far plane at infinity are fine.
    TraceRay primaryRay(int x, int y) const
    {
        const double clip_x = 2.0 * (x + 0.5) / extent_.width - 1.0;
        const double clip_y = 2.0 * (y + 0.5) / extent_.height - 1.0;
        glm::dvec4 from = view_from_clip_ * glm::dvec4(clip_x, clip_y, -1.0, 1.0);
        glm::dvec4 to = view_from_clip_ * glm::dvec4(clip_x, clip_y, 1.0, 1.0);
        if (depthOrder(from) > depthOrder(to)) std::swap(from, to);
        const glm::dvec3 origin = glm::dvec3(from) / from.w;
        const glm::dvec3 along = glm::dvec3(to) * from.w - glm::dvec3(from) * to.w;
        const glm::dvec3 direction = glm::normalize(along.z > 0.0 ? -along : along);
        const double limit = std::abs(to.w) > 1e-12 * std::abs(from.w)
                                 ? glm::length(glm::dvec3(to) / to.w - origin)
                                 : std::numeric_limits<double>::infinity();
        const glm::dvec3 world = glm::dmat3(world_from_view_) * direction;  // longer if that scales
        return {glm::dvec3(world_from_view_ * glm::dvec4(origin, 1.0)), glm::normalize(world),
                limit * glm::length(world)};
    }

    float visibility(const TraceHit& hit, std::uint32_t seed) const
    {
        const glm::dvec3 origin = hit.position + hit.geometric_normal * hit.rounding;
        const glm::vec3 geometric = hit.geometric_normal;
        const Basis basis = makeBasis(hit.normal);
        const float shift = fraction(hashed(seed));
        const double angle = 2.0 * kPi * fraction(hashed(seed + 0x9e3779b9u));
        const auto turn_cos = static_cast<float>(std::cos(angle));
        const auto turn_sin = static_cast<float>(std::sin(angle));
        int open = 0;
        TraceBatch batch;
        for (std::size_t first = 0; first < probes_.size(); first += 8) {
            for (std::size_t k = 0; k < 8; ++k) {
                const Probe& probe = probes_[std::min(first + k, probes_.size() - 1)];
                const float shifted = probe.radius_squared + shift;
                const float squared = shifted < 1.0f ? shifted : shifted - 1.0f;
                const float length = std::sqrt(squared);
                const float x = length * (probe.cosine * turn_cos - probe.sine * turn_sin);
                const float y = length * (probe.cosine * turn_sin + probe.sine * turn_cos);
                const float z = std::sqrt(1.0f - squared);
                const glm::vec3 direction =
                    basis.tangent * x + basis.bitangent * y + basis.normal * z;
                const bool above = glm::dot(direction, geometric) > 0.0f;
                batch.valid[k] = first + k < probes_.size() && above ? -1 : 0;
                batch.directions[k] = direction;
            }
            open += scene_.countOpen(origin, batch, radius_);
        }
        return static_cast<float>(open) / static_cast<float>(probes_.size());
    }

    const EmbreeScene& scene_;
    const glm::dmat4 view_from_clip_;
    const glm::dmat4 world_from_view_;
    const bool orthographic_;
    const Extent extent_;
    const double radius_;
    const std::vector<Probe> probes_;
};

bool invertible(const glm::dmat4& matrix)
{
    const double determinant = glm::determinant(matrix);
    return std::isfinite(determinant) && determinant != 0.0;
}

Status checkOptions(const Camera& camera, Extent extent, const TraceOptions& options)
{
    if (!(options.radius >= 0.0) || !std::isfinite(options.radius))
        return Diagnostic{Code::out_of_range, "the radius " + significant(options.radius, 6) +
                                                  " is not a finite length of at least 0"};
    if (options.rays < 1 || options.rays > kMaxTraceRays)
        return Diagnostic{Code::out_of_range, std::to_string(options.rays) +
                                                  " rays are outside [1, " +
                                                  std::to_string(kMaxTraceRays) + "]"};
    if (extent.width < 1 || extent.height < 1 || extent.width > kMaxTraceSide ||
        extent.height > kMaxTraceSide)
        return Diagnostic{Code::bad_size, "the size " + std::to_string(extent.width) + "x" +
                                              std::to_string(extent.height) + " is outside [1, " +
                                              std::to_string(kMaxTraceSide) + "]"};
    if (!invertible(camera.clip_from_view) || !invertible(camera.view_from_world))
        return Diagnostic{Code::bad_input, "the camera's matrices have no inverse"};
    return {};
}

// Rows are dealt out one by one; each pixel depends on nothing but itself.
void traceRows(const Tracer& tracer, Image& image, std::atomic<int>& next_row,
               const std::function<void(double)>& progress)
{
    for (int y = next_row++; y < image.extent.height; y = next_row++) {
        for (int x = 0; x < image.extent.width; ++x) image.at(x, y) = tracer.pixel(x, y);
        if (progress) progress(static_cast<double>(y + 1) / image.extent.height);
    }
}

}  // namespace

Result<Image> traceAmbientOcclusion(const Scene& scene, const Camera& camera, Extent extent,
                                    const TraceOptions& options)
{
    if (const Status status = checkOptions(camera, extent, options); !status)
        return status.diagnostics();
    const glm::dvec3 eye = glm::inverse(camera.view_from_world)[3];
    const auto built = EmbreeScene::build(scene, eye);
    if (!built) return built.diagnostics();
    const Tracer tracer(**built, camera, extent, options);
    Image image(extent, 1);
    std::atomic<int> next_row = 0;
    const unsigned wanted =
        options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    std::vector<std::thread> helpers;
    for (unsigned k = 1; k < wanted; ++k)
        helpers.emplace_back([&] { traceRows(tracer, image, next_row, {}); });
    traceRows(tracer, image, next_row, options.progress);
    for (std::thread& helper : helpers) helper.join();
    return image;
}

Result<SurfaceMap> traceSurfaces(const Scene& scene, const Camera& camera, Extent extent)
{
    const TraceOptions options;
    if (const Status status = checkOptions(camera, extent, options); !status)
        return status.diagnostics();
    const auto built = EmbreeScene::build(scene, glm::inverse(camera.view_from_world)[3]);
    if (!built) return built.diagnostics();
    const Tracer tracer(**built, camera, extent, options);
    SurfaceMap map{extent, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) map.points.push_back(tracer.surface(x, y));
    return map;
}

bool canTrace() { return true; }

}  // namespace crevice
