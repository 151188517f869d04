// SPDX-License-Identifier: MIT
// Distances in view by a small rasteriser, and the warnings that follow.
#include "tools/render/view_check.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/compile/depth_precision.h"
#include "tools/scene/camera_framing.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

// Enough for a median: a tenth of a percent of the view counts.
constexpr int kColumns = 96;
constexpr int kRows = 54;

// The radius to take: this part of the view's height, or of the scene's size where that is less, since the rest
// of the view is empty then. About what radius 0.5 is in the scene 'room'.
constexpr double kShownShare = 0.08;

std::string figure(double value) { return shortest(static_cast<float>(value)); }

// To two digits.
double rounded(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
}

// What most triangles are passed over by.
struct Corner {
    float distance;
    std::int16_t x, y;     // the grid point to the lower left, where it is not behind the eye
    std::uint8_t outside;  // bits of the sides of the view beyond which it lies, and kBehind
};
constexpr std::uint8_t kSides = 63, kBehind = 64;

// The distance of the nearest surface at each point of a grid.
class DistanceGrid {
public:
    explicit DistanceGrid(const Camera& camera)
        : clip_from_view_(camera.clip_from_view),
          view_from_world_(camera.view_from_world),
          distances_(kColumns * kRows, HUGE_VAL) {}

    void add(const MeshDesc& mesh, const glm::dmat4& world_from_model)
    {
        const glm::dmat4 view_from_model = view_from_world_ * world_from_model;
        const auto viewed = [&](std::uint32_t index) {
            const float* p = mesh.vertices[index].position;
            return view_from_model * glm::dvec4(p[0], p[1], p[2], 1);
        };
        std::vector<Corner> corners;
        corners.reserve(mesh.vertices.size());
        for (std::uint32_t index = 0; index < mesh.vertices.size(); ++index)
            corners.push_back(cornerAt(viewed(index)));
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t* const of = &mesh.indices[i];
            const Range range = rangeOf(corners[of[0]], corners[of[1]], corners[of[2]]);
            if (range.empty()) continue;
            const glm::dvec4 triangle[3] = {viewed(of[0]), viewed(of[1]), viewed(of[2])};
            cover(triangle, range);
        }
    }

    std::optional<double> median() const
    {
        std::vector<double> seen;
        for (const double distance : distances_)
            if (std::isfinite(distance)) seen.push_back(distance);
        if (seen.empty())
            return std::isfinite(nearest_) ? std::optional<double>(nearest_) : std::nullopt;
        std::nth_element(seen.begin(), seen.begin() + seen.size() / 2, seen.end());
        return seen[seen.size() / 2];
    }

private:
    struct Range {
        int left, right, low, high;
        bool empty() const { return left > right || low > high; }
    };

    Corner cornerAt(const glm::dvec4& view) const
    {
        const glm::dvec4 clip = clip_from_view_ * view;
        Corner corner = {static_cast<float>(-view.z), 0, 0, 0};
        for (int axis = 0; axis < 3; ++axis)
            corner.outside |= (clip[axis] > clip.w) << 2 * axis | (-clip[axis] > clip.w) << (2 * axis + 1);
        if (!(clip.w > 0)) {
            corner.outside |= kBehind;
            return corner;
        }
        corner.x = gridIndex(clip.x / clip.w, kColumns);
        corner.y = gridIndex(clip.y / clip.w, kRows);
        return corner;
    }

    static std::int16_t gridIndex(double place, int count)
    {
        return static_cast<std::int16_t>(
            std::floor(std::clamp((place + 1) / 2 * count - 0.5, -1.0, double(count))));
    }
    static double gridPlace(int index, int count) { return (index + 0.5) / count * 2 - 1; }

    // The grid points that the triangle may cover.
    Range rangeOf(const Corner& a, const Corner& b, const Corner& c)
    {
        const Range whole = {0, kColumns - 1, 0, kRows - 1};
        if (a.outside & b.outside & c.outside & kSides) return {0, -1, 0, -1};
        if ((a.outside | b.outside | c.outside) & kBehind) return whole;
        nearest_ = std::min(nearest_, a.distance);
        return {std::max(std::min({a.x, b.x, c.x}) + 1, 0),
                std::min<int>(std::max({a.x, b.x, c.x}), whole.right),
                std::max(std::min({a.y, b.y, c.y}) + 1, 0),
                std::min<int>(std::max({a.y, b.y, c.y}), whole.high)};
    }

    // By homogeneous edges [Olano, Greer 1997], which need no clipping.
    void cover(const glm::dvec4 (&view)[3], const Range& range)
    {
        glm::dvec4 clip[3];
        glm::dvec3 flat[3];
        for (int i = 0; i < 3; ++i) {
            clip[i] = clip_from_view_ * view[i];
            flat[i] = {clip[i].x, clip[i].y, clip[i].w};
        }
        const glm::dvec3 edges[3] = {glm::cross(flat[1], flat[2]), glm::cross(flat[2], flat[0]),
                                     glm::cross(flat[0], flat[1])};
        for (int y = range.low; y <= range.high; ++y)
            for (int x = range.left; x <= range.right; ++x) {
                const glm::dvec3 point(gridPlace(x, kColumns), gridPlace(y, kRows), 1);
                glm::dvec3 share(glm::dot(edges[0], point), glm::dot(edges[1], point),
                                 glm::dot(edges[2], point));
                share /= share.x + share.y + share.z;
                if (!(share.x >= 0 && share.y >= 0 && share.z >= 0)) continue;
                const glm::dvec4 at = clip[0] * share.x + clip[1] * share.y + clip[2] * share.z;
                if (!(at.w > 0) || std::abs(at.z) > at.w) continue;
                double& kept = distances_[y * kColumns + x];
                kept = std::min(kept, -(view[0].z * share.x + view[1].z * share.y + view[2].z * share.z));
            }
    }

    glm::dmat4 clip_from_view_;
    glm::dmat4 view_from_world_;
    std::vector<double> distances_;
    float nearest_ = HUGE_VALF;
};

Diagnostic warningOf(Code code, std::string message, std::string help)
{
    Diagnostic warning = {code, std::move(message)};
    warning.help = std::move(help);
    warning.severity = Severity::warning;
    return warning;
}

// What the plan itself knows to be constant.
std::optional<Diagnostic> constantByPlan(const Plan& plan)
{
    const PlanOutput* output = findNamed(plan.outputs, "ao");
    if (!output || output->constant < 0) return std::nullopt;
    std::string why;
    for (const LeftOut& each : plan.left_out)
        if (each.rule == "identity" || each.rule == "condition")
            why += (why.empty() ? "" : "; ") + each.what + " does not run: " + each.reason;
    const float value = plan.constants[output->constant].value;
    return warningOf(Code::output_constant,
                     "the ambient occlusion is " + shortest(value) + " everywhere", why);
}

bool isConstant(const Image& image)
{
    for (std::size_t i = image.channels; i < image.pixels.size(); i += image.channels)
        if (image.pixels[i] != image.pixels[0]) return false;
    return !image.pixels.empty();
}

// Flat scenes are open everywhere.
bool isFlat(const Bounds& bounds)
{
    const glm::dvec3 size = bounds.max - bounds.min;
    return std::min({size.x, size.y, size.z}) <= 1e-6 * bounds.diagonal();
}

// What shows: a share of the view, or of the scene where that is smaller, but some pixels in any case.
double shownRadius(const ParamDesc& radius, const Bounds& bounds, double unit_px, Extent extent)
{
    const double share_of_view = kShownShare * extent.height / unit_px;
    const double least = 2 * kLeastRadiusPixels / unit_px;
    const double value =
        std::max(std::min(share_of_view, kShownShare * bounds.diagonal()), least);
    return std::clamp(rounded(value), double{radius.min}, double{radius.max});
}

Diagnostic nothingSeen(const Scene& scene, Extent extent)
{
    const SceneCamera framing = frameScene(scene, double(extent.width) / extent.height);
    const glm::dvec3 eye = glm::inverse(framing.view_from_world)[3];
    return warningOf(Code::nothing_seen, "the camera sees no surface of the scene '" + scene.name + "'",
                     "try --camera 'eye=" + figure(eye.x) + "," + figure(eye.y) + "," + figure(eye.z) +
                         "', from where all of it is seen");
}

}  // namespace

std::optional<double> medianDistance(const Scene& scene, const Camera& camera)
{
    DistanceGrid grid(camera);
    for (const SceneInstance& instance : scene.instances)
        grid.add(scene.meshes[instance.mesh], instance.world_from_model);
    return grid.median();
}

double pixelsOf(double length, double distance, const Camera& camera, Extent extent)
{
    const double scale = 0.5 * extent.height * std::abs(double{camera.clip_from_view[1][1]});
    return length * scale / (camera.orthographic() ? 1.0 : distance);
}

Diagnostics checkView(const Description& description, const Plan& plan, const Scene& scene,
                      const Camera& camera, const Image* ao)
{
    const std::optional<double> distance = medianDistance(scene, camera);
    if (!distance) return {nothingSeen(scene, plan.extent)};
    if (std::optional<Diagnostic> constant = constantByPlan(plan)) return {*constant};
    const ParamDesc* radius = resolvedLength(description);
    const Bounds bounds = scene.bounds();
    if (!radius || !findNamed(plan.params, radius->name)) return {};

    const double now = radius->value[0];
    const double unit_px = pixelsOf(1, *distance, camera, plan.extent);
    const std::string size = radius->name + " " + figure(now) + " is " + figure(rounded(now * unit_px)) +
                             " pixels at the median depth " + figure(rounded(*distance));
    const double shown = shownRadius(*radius, bounds, unit_px, plan.extent);
    const std::string help = "try --set " + radius->name + "=" + figure(shown);
    const bool constant = ao && isConstant(*ao);
    if (constant && !isFlat(bounds))
        return {warningOf(Code::output_constant, "the ambient occlusion is " + shortest(ao->pixels[0]) +
                                                     " everywhere: " + size, help)};
    if (now * unit_px < kLeastRadiusPixels)
        return {warningOf(Code::out_of_range, size + ", where no ambient occlusion shows", help)};
    if (now * unit_px > plan.extent.height)
        return {warningOf(Code::out_of_range, size + ", more than the view is high", help)};
    return {};
}

}  // namespace crevice
