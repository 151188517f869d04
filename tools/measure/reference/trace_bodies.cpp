// SPDX-License-Identifier: MIT
// Triangles, normals and alpha-tested holes, in doubles.
#include "tools/measure/reference/trace_bodies.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

// How far before a ray's origin its search begins, and how far behind its end it ends, as a part
// of the scene's size: a distance to a plane in floats is off by a few roundings, 6e-8 of the size,
// divided by the cosine. Only time depends on it: the distance in doubles decides.
constexpr double kSlack = 1e-5;

// How far off its plane a point computed in doubles may be, as a part of the largest coordinate: a
// few roundings, 1.1e-16 each. Enough that planes that coincide but for rounding do so here, and
// far below what a 32-bit vertex can say (6e-8).
constexpr double kRounding = 1.0 / (1ull << 36);

// The transpose of the inverse but for its scale, which also holds for singular matrices.
glm::dmat3 cofactors(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::dvec3 vec3From(const float* values) { return {values[0], values[1], values[2]}; }

// A texel with repeating coordinates.
float alphaAt(const Image& image, int x, int y)
{
    const auto wrap = [](int at, int size) { return ((at % size) + size) % size; };
    return image.at(wrap(x, image.extent.width), wrap(y, image.extent.height), 3);
}

// Bilinear, as the device samples.
float sampleAlpha(const Image& image, double u, double v)
{
    const double x = (u - std::floor(u)) * image.extent.width - 0.5;
    const double y = (v - std::floor(v)) * image.extent.height - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0, fy = y - y0;
    const double low = alphaAt(image, x0, y0) * (1 - fx) + alphaAt(image, x0 + 1, y0) * fx;
    const double high = alphaAt(image, x0, y0 + 1) * (1 - fx) + alphaAt(image, x0 + 1, y0 + 1) * fx;
    return static_cast<float>(low * (1 - fy) + high * fy);
}

float toFloat(double value)
{
    return static_cast<float>(std::min<double>(value, std::numeric_limits<float>::max()));
}

double largestCoordinate(const glm::dvec3 (&corners)[3])
{
    double largest = 0.0;
    for (const glm::dvec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(corner[axis]));
    return largest;
}

}  // namespace

TraceBody::TraceBody(const Scene& scene, const SceneInstance& instance, const glm::dvec3& center)
    : mesh_(scene.meshes[instance.mesh]),
      material_(scene.materials[instance.material]),
      texture_(nullptr),
      from_model_(instance.world_from_model)
{
    const int texture = material_.base_color_texture;
    if (texture >= 0) texture_ = &scene.textures[texture].image;
    from_model_[3] -= glm::dvec4(center, 0);
}

glm::dvec3 TraceBody::place(const Vertex& vertex) const
{
    return from_model_ * glm::dvec4(vec3From(vertex.position), 1);
}

TracePlane TraceBody::plane(unsigned triangle, const glm::dvec3& from) const
{
    glm::dvec3 corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = place(vertex(triangle, k));
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return {across, glm::dot(corners[0] - from, across)};
}

bool TraceBody::hole(unsigned triangle, double u, double v) const
{
    if (material_.alpha_cutoff <= 0.0f) return false;
    double uv[2];
    for (int axis = 0; axis < 2; ++axis)
        uv[axis] = vertex(triangle, 0).uv[axis] * (1 - u - v) + vertex(triangle, 1).uv[axis] * u +
                   vertex(triangle, 2).uv[axis] * v;
    const float alpha = texture_ ? sampleAlpha(*texture_, uv[0], uv[1]) : 1.0f;
    return material_.base_color.a * alpha < material_.alpha_cutoff;
}

// On the ray, and then on the triangle: barycentric coordinates of floats would be off by 6e-8 of
// the triangle's size, and the ray's end by the rounding of its length.
TraceHit TraceBody::hitAt(const TraceRay& ray, const TraceCandidate& found) const
{
    glm::dvec3 corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = place(vertex(found.triangle, k));
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double weights[3] = {1 - found.u - found.v, found.u, found.v};
    glm::dvec3 model_normal(0.0);
    for (int k = 0; k < 3; ++k)
        model_normal += weights[k] * vec3From(vertex(found.triangle, k).normal);
    TraceHit hit;
    hit.geometric_normal = glm::normalize(glm::dot(across, ray.direction) > 0 ? -across : across);
    hit.position = ray.origin + found.distance * ray.direction;
    hit.position +=
        hit.geometric_normal * glm::dot(corners[0] - hit.position, hit.geometric_normal);
    hit.rounding = kRounding * largestCoordinate(corners);
    const glm::dvec3 normal = cofactors(glm::dmat3(from_model_)) * model_normal;
    const double length = glm::length(normal);
    hit.normal = length > 0.0 ? normal / length : hit.geometric_normal;
    if (glm::dot(hit.normal, hit.geometric_normal) < 0) hit.normal = -hit.normal;
    return hit;
}

TraceBodies::TraceBodies(const Scene& scene, const glm::dvec3& eye)
{
    const Bounds bounds = scene.bounds();
    center_ = bounds.empty() ? glm::dvec3(0.0) : glm::clamp(eye, bounds.min, bounds.max);
    middle_ = bounds.empty() ? glm::dvec3(0.0) : bounds.center() - center_;
    size_ = bounds.diagonal() / 2.0;
    bodies_.reserve(scene.instances.size());
    for (const SceneInstance& instance : scene.instances)
        bodies_.emplace_back(scene, instance, center_);
}

SearchRay TraceBodies::searched(const TraceRay& ray) const
{
    const double entry = glm::dot(middle_ - ray.origin, ray.direction) - size_;
    const double begin = std::max(entry, 0.0) - kSlack * size_;
    return {ray.origin + begin * ray.direction, ray.direction, begin,
            toFloat(ray.limit - begin + kSlack * size_)};
}

SearchRay TraceBodies::searched(const glm::dvec3& origin, const glm::vec3& direction,
                                double limit) const
{
    const double slack = kSlack * size_;
    return {origin - slack * glm::dvec3(direction), direction, -slack, toFloat(limit + 2 * slack)};
}

float TraceBodies::endOf(const SearchRay& ray, double distance) const
{
    return toFloat(distance - ray.begin + kSlack * size_);
}

bool TraceQuery::hits(TraceCandidate found, const glm::dvec3& direction)
{
    found.distance = plane(found.instance, found.triangle).distance(direction);
    if (!(found.distance >= 0.0 && found.distance <= limit_)) return false;
    if (bodies_.all()[found.instance].hole(found.triangle, found.u, found.v)) return false;
    if (nearest_ && found.distance < nearest_->distance) *nearest_ = found;
    return true;
}

const TracePlane& TraceQuery::plane(unsigned instance, unsigned triangle)
{
    Known& known = known_[triangle % kKnown];
    if (known.instance != instance || known.triangle != triangle)
        known = {instance, triangle, bodies_.all()[instance].plane(triangle, origin_)};
    return known.plane;
}

}  // namespace crevice
