// SPDX-License-Identifier: MIT
// Triangles, normals and alpha-tested holes for Embree, and the distances that decide.
#include "tools/reference/embree_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

namespace {

// How far before a ray's origin Embree's ray begins, and how far behind its end it ends, as a part
// of the scene's size: Embree's distance to a plane is off by a few roundings of a float, 6e-8 of
// the size, divided by the cosine. Only time depends on it: the distance in doubles decides.
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

struct Triangle {
    glm::dvec3 corners[3];  // relative to EmbreeScene::center()
    glm::dvec3 across;      // along the normal

    // Along the ray, in lengths of `direction`; no number for a ray in the plane.
    double distance(const glm::dvec3& origin, const glm::dvec3& direction) const
    {
        return glm::dot(corners[0] - origin, across) / glm::dot(direction, across);
    }

    double largestCoordinate() const
    {
        double largest = 0.0;
        for (const glm::dvec3& corner : corners)
            for (int axis = 0; axis < 3; ++axis)
                largest = std::max(largest, std::abs(corner[axis]));
        return largest;
    }
};

struct Candidate {
    double distance = std::numeric_limits<double>::infinity();
    unsigned instance = 0, triangle = 0;
    double u = 0.0, v = 0.0;
};

}  // namespace

// What the filter must know of the rays of one call.
struct EmbreeScene::Query {
    RTCIntersectContext embree;  // first, since Embree hands on its address
    glm::dvec3 origin;
    glm::dvec3 directions[8];  // by the ray's id
    double limit;
    Candidate* nearest;  // to be found; null where any hit will do

    Query(const glm::dvec3& from, double end, Candidate* wanted)
        : origin(from),
          limit(end),
          nearest(wanted)
    {
        rtcInitIntersectContext(&embree);
    }
};

// One instance, and the filter that decides which of Embree's hits of it count.
struct EmbreeScene::Body {
    const MeshDesc& mesh;
    const SceneMaterial& material;
    const Image* texture;   // of its alpha; null for none
    glm::dmat4 from_model;  // relative to center()

    const Vertex& vertex(unsigned triangle, int corner) const
    {
        return mesh.vertices[mesh.indices[3 * static_cast<std::size_t>(triangle) + corner]];
    }

    glm::dvec3 place(const Vertex& vertex) const
    {
        return from_model * glm::dvec4(vec3From(vertex.position), 1);
    }

    Triangle triangle(unsigned index) const
    {
        Triangle made;
        for (int k = 0; k < 3; ++k) made.corners[k] = place(vertex(index, k));
        made.across =
            glm::cross(made.corners[1] - made.corners[0], made.corners[2] - made.corners[0]);
        return made;
    }

    bool hole(unsigned triangle, double u, double v) const
    {
        if (material.alpha_cutoff <= 0.0f) return false;
        double uv[2];
        for (int axis = 0; axis < 2; ++axis)
            uv[axis] = vertex(triangle, 0).uv[axis] * (1 - u - v) +
                       vertex(triangle, 1).uv[axis] * u + vertex(triangle, 2).uv[axis] * v;
        const float alpha = texture ? sampleAlpha(*texture, uv[0], uv[1]) : 1.0f;
        return material.base_color.a * alpha < material.alpha_cutoff;
    }

    TraceHit hitAt(const TraceRay& ray, const Candidate& found) const;

    // A hit that does not count, or is noted as the nearest, is refused, and Embree goes on.
    static void filter(const RTCFilterFunctionNArguments* call)
    {
        const auto& body = *static_cast<const Body*>(call->geometryUserPtr);
        const auto& query = *reinterpret_cast<const Query*>(call->context);
        for (unsigned k = 0; k < call->N; ++k) {
            if (call->valid[k] != -1) continue;
            const unsigned triangle = RTCHitN_primID(call->hit, call->N, k);
            const double u = RTCHitN_u(call->hit, call->N, k), v = RTCHitN_v(call->hit, call->N, k);
            const double distance = body.triangle(triangle).distance(
                query.origin, query.directions[RTCRayN_id(call->ray, call->N, k)]);
            const bool within = distance >= 0.0 && distance <= query.limit;
            const bool counts = within && !body.hole(triangle, u, v);
            if (counts && query.nearest && distance < query.nearest->distance)
                *query.nearest = {distance, RTCHitN_geomID(call->hit, call->N, k), triangle, u, v};
            if (!counts || query.nearest) call->valid[k] = 0;
        }
    }
};

EmbreeScene::EmbreeScene(const Scene& scene, const glm::dvec3& eye) : source_(scene)
{
    const Bounds bounds = scene.bounds();
    center_ = bounds.empty() ? glm::dvec3(0.0) : glm::clamp(eye, bounds.min, bounds.max);
    middle_ = bounds.empty() ? glm::dvec3(0.0) : bounds.center() - center_;
    size_ = bounds.diagonal() / 2.0;
    device_ = rtcNewDevice(nullptr);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
}

EmbreeScene::~EmbreeScene()
{
    if (scene_) rtcReleaseScene(scene_);
    if (device_) rtcReleaseDevice(device_);
}

Result<std::unique_ptr<EmbreeScene>> EmbreeScene::build(const Scene& scene, const glm::dvec3& eye)
{
    std::unique_ptr<EmbreeScene> built(new EmbreeScene(scene, eye));
    for (const SceneInstance& instance : scene.instances) built->addInstance(instance);
    rtcCommitScene(built->scene_);
    const RTCError error = rtcGetDeviceError(built->device_);
    if (error == RTC_ERROR_NONE) return built;
    return Diagnostic{Code::out_of_memory, "Embree cannot hold the scene: its error " +
                                               std::to_string(static_cast<int>(error))};
}

void EmbreeScene::addInstance(const SceneInstance& instance)
{
    const MeshDesc& mesh = source_.meshes[instance.mesh];
    const SceneMaterial& material = source_.materials[instance.material];
    const int texture = material.base_color_texture;
    glm::dmat4 from_model = instance.world_from_model;
    from_model[3] -= glm::dvec4(center_, 0);
    bodies_.push_back(std::unique_ptr<Body>(new Body{
        mesh, material, texture >= 0 ? &source_.textures[texture].image : nullptr, from_model}));
    const Body& body = *bodies_.back();

    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), std::max<std::size_t>(mesh.vertices.size(), 1)));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    for (std::size_t k = 0; positions && k < mesh.vertices.size(); ++k) {
        const glm::dvec3 place = body.place(mesh.vertices[k]);
        for (int axis = 0; axis < 3; ++axis)
            positions[3 * k + axis] = static_cast<float>(place[axis]);
    }
    if (indices) std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcSetGeometryUserData(geometry, bodies_.back().get());
    rtcSetGeometryIntersectFilterFunction(geometry, Body::filter);
    rtcSetGeometryOccludedFilterFunction(geometry, Body::filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);  // its number is that of the instance
    rtcReleaseGeometry(geometry);
}

bool EmbreeScene::intersect(const TraceRay& ray, TraceHit& hit) const
{
    const TraceRay from_center = {ray.origin - center_, ray.direction, ray.limit};
    Candidate nearest;
    Query query(from_center.origin, ray.limit, &nearest);
    query.directions[0] = ray.direction;
    // From where it enters the sphere around the bounds, since floats are coarse far away.
    const double entry = glm::dot(middle_ - from_center.origin, ray.direction) - size_;
    const double begin = std::max(entry, 0.0) - kSlack * size_;
    const glm::vec3 origin = from_center.origin + begin * ray.direction;
    const glm::vec3 direction = ray.direction;
    RTCRayHit embree = {};
    embree.ray.org_x = origin.x;
    embree.ray.org_y = origin.y;
    embree.ray.org_z = origin.z;
    embree.ray.dir_x = direction.x;
    embree.ray.dir_y = direction.y;
    embree.ray.dir_z = direction.z;
    embree.ray.tfar = toFloat(ray.limit - begin + kSlack * size_);
    embree.ray.mask = ~0u;
    embree.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &query.embree, &embree);
    if (nearest.distance > ray.limit) return false;
    hit = bodies_[nearest.instance]->hitAt(from_center, nearest);
    return true;
}

// On the ray, and then on the triangle: barycentric coordinates of floats would be off by 6e-8 of
// the triangle's size, and the ray's end by the rounding of its length.
TraceHit EmbreeScene::Body::hitAt(const TraceRay& ray, const Candidate& found) const
{
    const Triangle hit_triangle = triangle(found.triangle);
    const double weights[3] = {1 - found.u - found.v, found.u, found.v};
    glm::dvec3 model_normal(0.0);
    for (int k = 0; k < 3; ++k)
        model_normal += weights[k] * vec3From(vertex(found.triangle, k).normal);
    TraceHit hit;
    const glm::dvec3& across = hit_triangle.across;
    hit.geometric_normal = glm::normalize(glm::dot(across, ray.direction) > 0 ? -across : across);
    hit.position = ray.origin + found.distance * ray.direction;
    hit.position += hit.geometric_normal *
                    glm::dot(hit_triangle.corners[0] - hit.position, hit.geometric_normal);
    hit.rounding = kRounding * hit_triangle.largestCoordinate();
    const glm::dvec3 normal = cofactors(glm::dmat3(from_model)) * model_normal;
    const double length = glm::length(normal);
    hit.normal = length > 0.0 ? normal / length : hit.geometric_normal;
    if (glm::dot(hit.normal, hit.geometric_normal) < 0) hit.normal = -hit.normal;
    return hit;
}

int EmbreeScene::countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const
{
    Query query(origin, limit, nullptr);
    const double slack = kSlack * size_;
    RTCRay8 rays = {};
    for (unsigned k = 0; k < 8; ++k) {
        query.directions[k] = batch.directions[k];
        const glm::vec3 begin = origin - slack * query.directions[k];
        rays.org_x[k] = begin.x;
        rays.org_y[k] = begin.y;
        rays.org_z[k] = begin.z;
        rays.dir_x[k] = batch.directions[k].x;
        rays.dir_y[k] = batch.directions[k].y;
        rays.dir_z[k] = batch.directions[k].z;
        rays.tfar[k] = toFloat(limit + 2 * slack);
        rays.mask[k] = ~0u;
        rays.id[k] = k;
    }
    rtcOccluded8(batch.valid, scene_, &query.embree, &rays);
    int open = 0;
    for (int k = 0; k < 8; ++k) open += batch.valid[k] == -1 && rays.tfar[k] >= 0.0f;
    return open;
}

}  // namespace crevice
