// SPDX-License-Identifier: MIT
// Rays through pixels, and rays about surfaces.
#include "tools/measure/reference/pixel_tracer.h"

#include "core/frame/frame_math.h"

#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace crevice {
namespace {

constexpr int kMaxTraceSide = 1 << 15;

// PCG [Jarzynski, Olano 2020].
std::uint32_t hashed(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// Uniform in [0, 1).
float fraction(std::uint32_t hash) { return static_cast<float>(hash >> 8) / 16777216.0f; }

// The radical inverse, base 2.
double mirrored(unsigned index)
{
    double inverse = 0.0, digit = 0.5;
    for (unsigned bits = index; bits > 0; bits >>= 1, digit /= 2) inverse += (bits & 1) * digit;
    return inverse;
}

Probe makeProbe(unsigned index, int count)
{
    const double angle = 2 * glm::pi<double>() * mirrored(index);
    return {static_cast<float>((index + 0.5) / count), static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle))};
}

// Of each group of `passes` probes, neighbours in radius whose angles are even, a pass takes one:
// which one is the group's number with all its digits, base `passes`, added without carry. So the
// angles of a pass are a scrambled radical inverse of the group, as those of all probes are of the
// probe: with powers of two each pass is a set of Hammersley points, turned.
unsigned probeOf(unsigned group, unsigned pass, unsigned passes)
{
    unsigned place = pass;
    for (unsigned digits = group; passes > 1 && digits > 0; digits /= passes)
        place ^= digits % passes;
    return group * passes + place;
}

// Which pass has its turn: Pascal's triangle, modulo 2, times the digits of the turn. Any window of
// its rows is invertible, so that the first 2, 4, 8 ... passes together are spread evenly, too.
unsigned passOf(unsigned turn, unsigned passes)
{
    unsigned pass = 0;
    for (unsigned row = 0; (1u << row) < passes; ++row)
        for (unsigned column = 0; column <= row; ++column)
            if ((column & ~row) == 0 && (turn >> column & 1)) pass ^= 1u << row;
    return pass;
}

// `count` probes, >= 1, in `passes`, a power of two of at most `count`. The probes are the same for
// any number of passes, and one pass has them in their order.
ProbePasses makeProbes(int count, int passes)
{
    ProbePasses made;
    const auto all = static_cast<unsigned>(count), turns = static_cast<unsigned>(passes);
    for (unsigned turn = 0; turn < turns; ++turn) {
        made.begins.push_back(static_cast<int>(made.probes.size()));
        for (unsigned group = 0; group * turns < all; ++group) {
            const unsigned index = probeOf(group, passOf(turn, turns), turns);
            if (index < all) made.probes.push_back(makeProbe(index, count));
        }
    }
    made.begins.push_back(count);
    return made;
}

struct Basis {
    glm::vec3 tangent, bitangent, normal;
};

// Duff et al. 2017.
Basis makeBasis(const glm::vec3& n)
{
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {
        {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

// Turns probes about a normal, and about their disc [Cranley, Patterson 1976].
struct Turn {
    Basis basis;
    float shift, cosine, sine;

    Turn(const glm::vec3& normal, std::uint32_t seed) : basis(makeBasis(normal))
    {
        shift = fraction(hashed(seed));
        const double angle = 2.0 * glm::pi<double>() * fraction(hashed(seed + 0x9e3779b9u));
        cosine = static_cast<float>(std::cos(angle));
        sine = static_cast<float>(std::sin(angle));
    }

    glm::vec3 direction(const Probe& probe) const
    {
        const float shifted = probe.radius_squared + shift;
        const float squared = shifted < 1.0f ? shifted : shifted - 1.0f;
        const float length = std::sqrt(squared);
        const float x = length * (probe.cosine * cosine - probe.sine * sine);
        const float y = length * (probe.cosine * sine + probe.sine * cosine);
        const float z = std::sqrt(1.0f - squared);
        return basis.tangent * x + basis.bitangent * y + basis.normal * z;
    }
};

bool invertible(const glm::dmat4& matrix)
{
    const double determinant = glm::determinant(matrix);
    return std::isfinite(determinant) && determinant != 0.0;
}

constexpr int kLeastPassRays = 8;  // of a TraceBatch

int passesFor(int rays, int max_passes)
{
    int passes = 1;
    while (passes * 2 <= max_passes && passes * 2 * kLeastPassRays <= rays) passes *= 2;
    return passes;
}

}  // namespace

Status checkTrace(const Camera& camera, Extent extent, const TraceOptions& options)
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

Diagnostic nothingSeen()
{
    return {Code::nothing_seen, "the camera sees no surface of the scene",
            "leave --camera out for a view of the whole scene, or turn the camera towards it"};
}

PixelTracer::PixelTracer(const RayScene& scene, const Camera& camera, Extent extent,
                         const TraceOptions& options, int passes)
    : scene_(scene),
      view_from_clip_(cameraMatrices(camera).view_from_clip),
      world_from_view_(cameraMatrices(camera).world_from_view),
      orthographic_(camera.orthographic()),
      extent_(extent),
      radius_(options.radius),
      passes_(makeProbes(options.rays, passes))
{
}

// Grows with the distance from the eye, also of points at infinity (w = 0).
double PixelTracer::depthOrder(const glm::dvec4& view) const
{
    return orthographic_ ? -view.z / view.w : view.w / view.z;
}

// From the near plane to the far one. Reversed depth and a far plane at infinity are fine.
TraceRay PixelTracer::primaryRay(int x, int y) const
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

bool PixelTracer::surface(int x, int y, TraceHit& hit) const
{
    return scene_.intersect(primaryRay(x, y), hit);
}

bool PixelTracer::probed(int x, int y, ProbedPoint& point) const
{
    TraceHit hit;
    if (!surface(x, y, hit)) return false;
    point = {hit.position + hit.geometric_normal * hit.rounding, hit.geometric_normal, hit.normal};
    return true;
}

ProbeCount PixelTracer::countOpen(const ProbedPoint& point, int x, int y, int pass) const
{
    if (radius_ <= 0.0) return {probes(pass), probes(pass)};
    const Turn turn(point.normal, hashed(static_cast<std::uint32_t>(x) + hashed(y)));
    ProbeCount count;
    TraceBatch batch;
    for (int first = passes_.begins[pass]; first < passes_.begins[pass + 1]; first += 8) {
        for (int k = 0; k < 8; ++k) {
            const int last = passes_.begins[pass + 1] - 1;
            const glm::vec3 direction = turn.direction(passes_.probes[std::min(first + k, last)]);
            const bool above = glm::dot(direction, point.geometric) > 0.0f;
            batch.valid[k] = first + k <= last && above ? -1 : 0;
            batch.directions[k] = direction;
            count.over -= batch.valid[k];
        }
        count.open += scene_.countOpen(point.origin, batch, radius_);
    }
    return count;
}

Result<ProgressiveTrace> ProgressiveTrace::begin(const RayScene& scene, const Camera& camera,
                                                 Extent extent, const TraceOptions& options,
                                                 int max_passes)
{
    if (const Status status = checkTrace(camera, extent, options); !status)
        return status.diagnostics();
    return ProgressiveTrace(
        PixelTracer(scene, camera, extent, options, passesFor(options.rays, max_passes)));
}

ProgressiveTrace::ProgressiveTrace(const PixelTracer& tracer)
    : tracer_(tracer),
      rows_(static_cast<std::size_t>(tracer.extent().height))
{
}

void ProgressiveTrace::findSurfaces(Row& row, int y) const
{
    const auto width = static_cast<std::size_t>(extent().width);
    row.counts.assign(width, {});
    row.points.resize(width);
    for (int x = 0; x < extent().width; ++x)
        if (!tracer_.probed(x, y, row.points[x])) row.counts[x].open = -1;
}

void ProgressiveTrace::traceRow(int pass, int y)
{
    Row& row = rows_[y];
    if (row.passes == 0) findSurfaces(row, y);
    for (int x = 0; x < extent().width; ++x) {
        ProbeCount& count = row.counts[x];
        if (count.open < 0) continue;
        const ProbeCount more = tracer_.countOpen(row.points[x], x, y, pass);
        count.open += more.open;
        count.over += more.over;
    }
    if (++row.passes == passes()) row.points = {};
}

void ProgressiveTrace::readRow(int y, float* visibility) const
{
    const Row& row = rows_[y];
    for (int x = 0; x < extent().width; ++x) {
        const ProbeCount count = row.passes > 0 ? row.counts[x] : ProbeCount{-1, 0};
        const bool seen = count.open >= 0;
        const float open = count.over > 0 ? float(count.open) / float(count.over) : 1.0f;
        visibility[x] = seen ? open : std::numeric_limits<float>::quiet_NaN();
    }
}

Image ProgressiveTrace::image() const
{
    Image image(extent(), 1);
    for (int y = 0; y < extent().height; ++y) readRow(y, &image.at(0, y));
    return image;
}

}  // namespace crevice
