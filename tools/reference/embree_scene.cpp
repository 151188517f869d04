// SPDX-License-Identifier: MIT
// Triangles, normals and alpha-tested holes for Embree.
#include "tools/reference/embree_scene.h"

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

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

RTCIntersectContext makeContext()
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    return context;
}

}  // namespace

// What the filter of an alpha-tested instance must know.
struct EmbreeScene::Cutout {
    const MeshDesc& mesh;
    const SceneMaterial& material;
    const Image* texture;

    bool hole(unsigned triangle, double u, double v) const
    {
        const std::uint32_t* index = &mesh.indices[3 * static_cast<std::size_t>(triangle)];
        double uv[2];
        for (int axis = 0; axis < 2; ++axis)
            uv[axis] = mesh.vertices[index[0]].uv[axis] * (1 - u - v) +
                       mesh.vertices[index[1]].uv[axis] * u + mesh.vertices[index[2]].uv[axis] * v;
        const float alpha = texture ? sampleAlpha(*texture, uv[0], uv[1]) : 1.0f;
        return material.base_color.a * alpha < material.alpha_cutoff;
    }

    static void filter(const RTCFilterFunctionNArguments* call)
    {
        const auto& cutout = *static_cast<const Cutout*>(call->geometryUserPtr);
        for (unsigned k = 0; k < call->N; ++k)
            if (call->valid[k] == -1 &&
                cutout.hole(RTCHitN_primID(call->hit, call->N, k), RTCHitN_u(call->hit, call->N, k),
                            RTCHitN_v(call->hit, call->N, k)))
                call->valid[k] = 0;
    }
};

EmbreeScene::EmbreeScene(const Scene& scene) : source_(scene)
{
    const Bounds bounds = scene.bounds();
    center_ = bounds.empty() ? glm::dvec3(0.0) : bounds.center();
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

Result<std::unique_ptr<EmbreeScene>> EmbreeScene::build(const Scene& scene)
{
    std::unique_ptr<EmbreeScene> built(new EmbreeScene(scene));
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
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), std::max<std::size_t>(mesh.vertices.size(), 1)));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    const glm::dmat4 world_from_model = instance.world_from_model;
    for (std::size_t k = 0; positions && k < mesh.vertices.size(); ++k) {
        const glm::dvec3 model = vec3From(mesh.vertices[k].position);
        const glm::dvec3 world = world_from_model * glm::dvec4(model, 1);
        for (int axis = 0; axis < 3; ++axis)
            positions[3 * k + axis] = static_cast<float>(world[axis] - center_[axis]);
    }
    if (indices) std::copy(mesh.indices.begin(), mesh.indices.end(), indices);

    const SceneMaterial& material = source_.materials[instance.material];
    if (material.alpha_cutoff > 0.0f) {
        const int texture = material.base_color_texture;
        const Image* image = texture >= 0 ? &source_.textures[texture].image : nullptr;
        cutouts_.push_back(std::unique_ptr<Cutout>(new Cutout{mesh, material, image}));
        rtcSetGeometryUserData(geometry, cutouts_.back().get());
        rtcSetGeometryIntersectFilterFunction(geometry, Cutout::filter);
        rtcSetGeometryOccludedFilterFunction(geometry, Cutout::filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);  // its number is that of the instance
    rtcReleaseGeometry(geometry);
}

bool EmbreeScene::intersect(const TraceRay& ray, TraceHit& hit) const
{
    const glm::vec3 origin = ray.origin - center_;
    const glm::vec3 direction = ray.direction;
    RTCRayHit query = {};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tfar = static_cast<float>(ray.limit);
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context = makeContext();
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit = hitFrom(query, ray.direction);
    return true;
}

// Computed again from the triangle, in doubles: along the ray a float would be off by its distance.
TraceHit EmbreeScene::hitFrom(const RTCRayHit& ray_hit, const glm::dvec3& direction) const
{
    const SceneInstance& instance = source_.instances[ray_hit.hit.geomID];
    const MeshDesc& mesh = source_.meshes[instance.mesh];
    const glm::dmat4 world_from_model = instance.world_from_model;
    const double u = ray_hit.hit.u, v = ray_hit.hit.v;
    const double weights[3] = {1 - u - v, u, v};
    glm::dvec3 corners[3];
    glm::dvec3 model_normal(0.0);
    for (int k = 0; k < 3; ++k) {
        const std::size_t triangle = ray_hit.hit.primID;
        const Vertex& vertex = mesh.vertices[mesh.indices[3 * triangle + k]];
        const glm::dvec3 world = world_from_model * glm::dvec4(vec3From(vertex.position), 1);
        corners[k] = world - center_;
        model_normal += weights[k] * vec3From(vertex.normal);
    }
    TraceHit hit;
    hit.position = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    hit.geometric_normal = glm::normalize(glm::dot(across, direction) > 0 ? -across : across);
    const glm::dvec3 normal = cofactors(glm::dmat3(world_from_model)) * model_normal;
    const double length = glm::length(normal);
    hit.normal = length > 0.0 ? normal / length : hit.geometric_normal;
    if (glm::dot(hit.normal, hit.geometric_normal) < 0) hit.normal = -hit.normal;
    return hit;
}

int EmbreeScene::countOpen(const int* valid, RTCRay8& rays) const
{
    RTCIntersectContext context = makeContext();
    rtcOccluded8(valid, scene_, &context, &rays);
    int open = 0;
    for (int k = 0; k < 8; ++k) open += valid[k] == -1 && rays.tfar[k] >= 0.0f;
    return open;
}

}  // namespace crevice
