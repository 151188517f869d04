// SPDX-License-Identifier: MIT
#include "tools/measure/motion/figures.h"

#include "core/base/text.h"
#include "tools/render/camera_path.h"
#include "tools/render/view_diagnosis.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Of a texel. Places nearer to a centre are that centre: a still camera compares pixels with
/// themselves, and a neighbour of which nothing shows does not have to be on the surface.
constexpr double kSnap = 1e-3;

/// The four texels about a place, and their shares.
struct Texels {
    int x, y;
    double shares[4];

    explicit Texels(const glm::dvec2& place)
        : x(static_cast<int>(std::floor(place.x))),
          y(static_cast<int>(std::floor(place.y)))
    {
        const double right = place.x - x, up = place.y - y;
        for (int k = 0; k < 4; ++k) shares[k] = (k & 1 ? right : 1 - right) * (k & 2 ? up : 1 - up);
    }

    /// Calls `visit(x, y, share)` for each that has a share, until it gives false.
    template <class Visit>
    bool all(Visit&& visit) const
    {
        for (int k = 0; k < 4; ++k)
            if (shares[k] > 0.0 && !visit(x + (k & 1), y + (k >> 1), shares[k])) return false;
        return true;
    }
};

double snapped(double place)
{
    const double whole = std::round(place);
    return std::abs(place - whole) < kSnap ? whole : place;
}

/// A point in another picture.
class Projected {
public:
    Projected(const SurfacePoint& point, const SurfaceMap& map, const Camera& camera)
        : point_(point),
          map_(map)
    {
        const glm::dvec4 view = camera.view_from_world * glm::dvec4(point.position, 1.0);
        const glm::dvec4 clip = glm::dmat4(camera.clip_from_view) * view;
        if (!point.seen || !(clip.w > 0.0)) return;
        place_.x = snapped((clip.x / clip.w * 0.5 + 0.5) * map.extent.width - 0.5);
        place_.y = snapped((clip.y / clip.w * 0.5 + 0.5) * map.extent.height - 0.5);
        // Also false for NaN.
        inside_ = place_.x >= 0 && place_.y >= 0 && place_.x <= map.extent.width - 1 &&
                  place_.y <= map.extent.height - 1;
        pixel_ = 1.0 / pixelsOf(1.0, std::abs(view.z), camera, map.extent);
    }

    bool inside() const { return inside_; }
    const glm::dvec2& place() const { return place_; }

    /// Whether the texel shows the point's own surface.
    bool isShownAt(int x, int y) const
    {
        const SurfacePoint& other = map_.at(x, y);
        return other.seen &&
               std::abs(glm::dot(other.position - point_.position, point_.normal)) <= pixel_;
    }

private:
    const SurfacePoint& point_;
    const SurfaceMap& map_;
    glm::dvec2 place_ = glm::dvec2(-1.0);
    double pixel_ = 0;
    bool inside_ = false;
};

/// Half a step of 8 bits: less is no change in a picture.
constexpr float kStillChange = 0.5f / 255.0f;

class Squares {
public:
    void add(double value)
    {
        sum_ += value * value;
        ++count_;
    }
    double rms() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0.0; }
    long long count() const { return count_; }

private:
    double sum_ = 0;
    long long count_ = 0;
};

/// By the nearest rank; reorders the values.
double percentile(std::vector<float>& values, double share)
{
    if (values.empty()) return 0.0;
    const double rank = std::ceil(share * static_cast<double>(values.size()));
    const auto place = values.begin() + std::max(static_cast<std::ptrdiff_t>(rank) - 1,
                                                 static_cast<std::ptrdiff_t>(0));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

void addErrors(const Image& frame, const Image& truth, const Image* mask, Squares& errors)
{
    for (int y = 0; y < truth.extent.height; ++y)
        for (int x = 0; x < truth.extent.width; ++x)
            if (std::isfinite(truth.at(x, y)) && (!mask || mask->at(x, y) > 0.0f))
                errors.add(static_cast<double>(frame.at(x, y)) - truth.at(x, y));
}

/// Of the frames since surfaces were uncovered, those that the table shows.
constexpr int kShownFrames[] = {1, 4, 16};

std::string figure(double value) { return fixed(value, 4); }

std::string changeCell(const MotionFigures& motion, const char* path)
{
    const auto found = motion.paths.find(path);
    if (found == motion.paths.end()) return "";
    const ChangeFigures& change = found->second;
    return figure(change.rms) + ", " + fixed(change.p99, 3) + ", " + fixed(change.p999, 3);
}

std::string uncoveredCell(const MotionFigures& motion, int frames)
{
    for (const UncoveredFigures& each : motion.uncovered)
        if (each.frames == frames) return figure(each.rmse);
    return "";
}

}  // namespace

Image flowTo(const SurfaceMap& from, const SurfaceMap& to, const Camera& camera)
{
    Image flow(from.extent, 2, kNone);
    for (int y = 0; y < from.extent.height; ++y)
        for (int x = 0; x < from.extent.width; ++x) {
            const Projected point(from.at(x, y), to, camera);
            if (!point.inside()) continue;
            const bool shown = Texels(point.place()).all([&point](int tx, int ty, double) {
                return point.isShownAt(tx, ty);
            });
            for (int axis = 0; axis < 2 && shown; ++axis)
                flow.at(x, y, axis) = static_cast<float>(point.place()[axis]);
        }
    return flow;
}

Image uncoveredSince(const SurfaceMap& before, const Camera& camera, const SurfaceMap& now)
{
    Image mask(now.extent, 1);
    for (int y = 0; y < now.extent.height; ++y)
        for (int x = 0; x < now.extent.width; ++x) {
            const Projected point(now.at(x, y), before, camera);
            if (!point.inside()) continue;
            const bool hidden = Texels(point.place()).all([&point](int tx, int ty, double) {
                return !point.isShownAt(tx, ty);
            });
            mask.at(x, y) = hidden ? 1.0f : 0.0f;
        }
    return mask;
}

Image changeAlong(const Image& flow, const Image& from, const Image& to)
{
    Image change(flow.extent, 1, kNone);
    for (int y = 0; y < flow.extent.height; ++y)
        for (int x = 0; x < flow.extent.width; ++x) {
            const glm::dvec2 place(flow.at(x, y, 0), flow.at(x, y, 1));
            if (std::isnan(place.x)) continue;
            double sum = 0;
            Texels(place).all([&sum, &to](int tx, int ty, double share) {
                sum += share * to.at(tx, ty);
                return true;
            });
            change.at(x, y) = static_cast<float>(sum - from.at(x, y));
        }
    return change;
}

ChangeFigures changeFigures(const std::vector<Image>& frames, const PathTruth& truth)
{
    Squares beyond, own, errors;
    std::vector<float> sizes;
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        const Image changes = changeAlong(truth.flows[i], frames[i], frames[i + 1]);
        const Image owns = changeAlong(truth.flows[i], truth.frames[i], truth.frames[i + 1]);
        for (std::size_t k = 0; k < changes.pixels.size(); ++k) {
            if (std::isnan(owns.pixels[k])) continue;
            const float change = changes.pixels[k] - owns.pixels[k];
            own.add(owns.pixels[k]);
            beyond.add(change);
            sizes.push_back(std::abs(change));
        }
    }
    for (std::size_t i = 0; i < frames.size(); ++i)
        addErrors(frames[i], truth.frames[i], nullptr, errors);
    return {beyond.rms(), percentile(sizes, 0.99), percentile(sizes, 0.999), own.rms(),
            errors.rms(), beyond.count()};
}

double errorOver(const Image& frame, const Image& truth, const Image* mask)
{
    Squares errors;
    addErrors(frame, truth, mask, errors);
    return errors.rms();
}

void Settling::add(const Image& frame)
{
    ++count_;
    bool changed = count_ == 1;
    for (std::size_t k = 0; k < last_.pixels.size() && !changed; ++k)
        changed = !(std::abs(frame.pixels[k] - last_.pixels[k]) <= kStillChange);
    if (changed) changed_ = count_;
    last_ = frame;
}

std::string motionTable(const std::vector<MotionRow>& rows)
{
    std::string head = "| config | at rest |", line = "|---|---|";
    for (const CameraPath& path : kCameraPaths)
        head += " " + std::string(path.name) + " |", line += "---|";
    head += " error in the pan | settles after |";
    for (const int frames : kShownFrames) head += " uncovered " + std::to_string(frames) + " |";
    head += " there at rest |\n";
    std::string text = head + line + "---|---|---|---|---|---|\n";
    for (const MotionRow& row : rows) {
        const MotionFigures& motion = row.motion;
        text += "| `" + row.name + "` | " + figure(row.rest) + " |";
        for (const CameraPath& path : kCameraPaths)
            text += " " + changeCell(motion, path.name) + " |";
        const auto pan = motion.paths.find("pan");
        text += " " + (pan == motion.paths.end() ? "" : figure(pan->second.rmse)) + " |";
        const int settled = motion.settled_after;
        text += " " + (settled > 0 ? std::to_string(settled) : "never") + " |";
        for (const int frames : kShownFrames) text += " " + uncoveredCell(motion, frames) + " |";
        text += " " + figure(motion.uncovered_rest) + " |\n";
    }
    return text;
}

}  // namespace crevice
