// SPDX-License-Identifier: MIT
// Triangles and rays for Embree, and its hits one by one to the doubles that decide.
#include "tools/measure/reference/trace_bodies.h"

#include <embree3/rtcore.h>

#include <algorithm>

namespace crevice {
namespace {

// What the filter must know of the rays of one call.
struct FilterContext {
    RTCIntersectContext embree;  // first, since Embree hands on its address
    TraceQuery query;
    glm::dvec3 directions[8];  // by the ray's id

    explicit FilterContext(const TraceQuery& asked) : query(asked)
    {
        rtcInitIntersectContext(&embree);
    }
};

// A hit that does not count, or is noted as the nearest, is refused, and Embree goes on.
void filter(const RTCFilterFunctionNArguments* call)
{
    auto& context = *reinterpret_cast<FilterContext*>(call->context);
    for (unsigned k = 0; k < call->N; ++k) {
        if (call->valid[k] != -1) continue;
        TraceCandidate found;
        found.instance = RTCHitN_geomID(call->hit, call->N, k);
        found.triangle = RTCHitN_primID(call->hit, call->N, k);
        found.u = RTCHitN_u(call->hit, call->N, k);
        found.v = RTCHitN_v(call->hit, call->N, k);
        const unsigned ray = RTCRayN_id(call->ray, call->N, k);
        const bool counts = context.query.hits(found, context.directions[ray]);
        if (!counts || context.query.wantsNearest()) call->valid[k] = 0;
    }
}

class EmbreeScene : public RayScene {
public:
    EmbreeScene(const Scene& scene, const glm::dvec3& eye)
        : bodies_(scene, eye),
          device_(rtcNewDevice(nullptr)),
          scene_(rtcNewScene(device_))
    {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        for (const TraceBody& body : bodies_.all()) add(body);
        rtcCommitScene(scene_);
    }

    ~EmbreeScene() override
    {
        if (scene_) rtcReleaseScene(scene_);
        if (device_) rtcReleaseDevice(device_);
    }

    RTCError error() const { return rtcGetDeviceError(device_); }

    bool intersect(const TraceRay& ray, TraceHit& hit) const override;
    int countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const override;
    const glm::dvec3& center() const override { return bodies_.center(); }

private:
    void add(const TraceBody& body);

    const TraceBodies bodies_;
    const RTCDevice device_;
    const RTCScene scene_;
};

void EmbreeScene::add(const TraceBody& body)
{
    const MeshDesc& mesh = body.mesh();
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), std::max<std::size_t>(mesh.vertices.size(), 1)));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), body.triangles()));
    for (std::size_t k = 0; positions && k < mesh.vertices.size(); ++k) {
        const glm::dvec3 place = body.place(mesh.vertices[k]);
        for (int axis = 0; axis < 3; ++axis)
            positions[3 * k + axis] = static_cast<float>(place[axis]);
    }
    if (indices) std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);  // its number is that of the instance
    rtcReleaseGeometry(geometry);
}

bool EmbreeScene::intersect(const TraceRay& ray, TraceHit& hit) const
{
    const TraceRay from_center = {ray.origin - center(), ray.direction, ray.limit};
    TraceCandidate nearest;
    FilterContext context({bodies_, from_center.origin, ray.limit, &nearest});
    context.directions[0] = ray.direction;
    const SearchRay searched = bodies_.searched(from_center);
    RTCRayHit embree = {};
    embree.ray.org_x = searched.origin.x;
    embree.ray.org_y = searched.origin.y;
    embree.ray.org_z = searched.origin.z;
    embree.ray.dir_x = searched.direction.x;
    embree.ray.dir_y = searched.direction.y;
    embree.ray.dir_z = searched.direction.z;
    embree.ray.tfar = searched.end;
    embree.ray.mask = ~0u;
    embree.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context.embree, &embree);
    if (!nearest.found()) return false;
    hit = bodies_.all()[nearest.instance].hitAt(from_center, nearest);
    return true;
}

int EmbreeScene::countOpen(const glm::dvec3& origin, const TraceBatch& batch, double limit) const
{
    FilterContext context({bodies_, origin, limit, nullptr});
    RTCRay8 rays = {};
    for (unsigned k = 0; k < 8; ++k) {
        context.directions[k] = batch.directions[k];
        const SearchRay searched = bodies_.searched(origin, batch.directions[k], limit);
        rays.org_x[k] = searched.origin.x;
        rays.org_y[k] = searched.origin.y;
        rays.org_z[k] = searched.origin.z;
        rays.dir_x[k] = searched.direction.x;
        rays.dir_y[k] = searched.direction.y;
        rays.dir_z[k] = searched.direction.z;
        rays.tfar[k] = searched.end;
        rays.mask[k] = ~0u;
        rays.id[k] = k;
    }
    rtcOccluded8(batch.valid, scene_, &context.embree, &rays);
    int open = 0;
    for (int k = 0; k < 8; ++k) open += batch.valid[k] == -1 && rays.tfar[k] >= 0.0f;
    return open;
}

}  // namespace

Result<std::unique_ptr<RayScene>> makeRayScene(const Scene& scene, const glm::dvec3& eye)
{
    auto built = std::make_unique<EmbreeScene>(scene, eye);
    const RTCError error = built->error();
    if (error != RTC_ERROR_NONE)
        return Diagnostic{Code::out_of_memory, "Embree cannot hold the scene: its error " +
                                                   std::to_string(static_cast<int>(error))};
    return std::unique_ptr<RayScene>(std::move(built));
}

}  // namespace crevice
