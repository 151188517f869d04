// SPDX-License-Identifier: MIT
// Groups bench samples by what they show.
#include "tools/measure/bench/views.h"

#include "core/base/text.h"

#include <set>
#include <tuple>

namespace crevice {
namespace {

auto placeOf(const ResultView& view) { return std::tie(view.device, view.scene, view.camera); }

bool shows(const ResultView& view, const BenchSample& sample)
{
    return view.device == sample.device && view.scene == sample.scene &&
           view.camera == sample.camera && view.extent == sample.extent &&
           view.radius == sample.radius && view.clock == sample.clock;
}

void nameViews(std::vector<ResultView>& views)
{
    std::map<std::string, std::set<std::string>> cameras;
    for (const ResultView& view : views) cameras[view.scene].insert(view.camera);
    for (ResultView& view : views)
        view.name = cameras[view.scene].size() > 1 ? viewName(view.scene, view.camera) : view.scene;
}

long long pixelCount(Extent extent) { return 1LL * extent.width * extent.height; }

/// The extent with the most samples on the device; of equals, the one with more pixels.
Extent commonExtent(const std::vector<ResultView>& views, const std::string& device)
{
    std::map<std::pair<int, int>, std::size_t> counts;
    for (const ResultView& view : views)
        if (view.device == device)
            counts[{view.extent.width, view.extent.height}] += view.samples.size();
    Extent best;
    std::size_t best_count = 0;
    for (const auto& [size, count] : counts) {
        const Extent extent{size.first, size.second};
        const bool larger = count == best_count && pixelCount(extent) > pixelCount(best);
        if (count < best_count || (count == best_count && !larger)) continue;
        best = extent;
        best_count = count;
    }
    return best;
}

}  // namespace

std::vector<ResultView> benchViews(const std::vector<BenchSample>& samples)
{
    std::vector<ResultView> views;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const BenchSample& sample = samples[i];
        if (!sample.failure.empty()) continue;
        auto view = std::find_if(views.begin(), views.end(),
                                 [&sample](const ResultView& v) { return shows(v, sample); });
        if (view == views.end())
            view = views.insert(views.end(), {sample.device, sample.scene, sample.camera,
                                              sample.extent, sample.radius, sample.clock});
        view->samples.push_back(i);
    }
    std::stable_sort(views.begin(), views.end(), [](const ResultView& a, const ResultView& b) {
        if (placeOf(a) != placeOf(b)) return placeOf(a) < placeOf(b);
        return a.samples.size() > b.samples.size();
    });
    nameViews(views);
    return views;
}

std::vector<ResultView> mainViews(const std::vector<ResultView>& views, const std::string& device,
                                  Extent extent)
{
    if (extent == Extent{}) extent = commonExtent(views, device);
    std::vector<ResultView> chosen;
    for (const ResultView& view : views) {
        if (view.device != device || view.extent != extent) continue;
        if (chosen.empty() || placeOf(chosen.back()) != placeOf(view)) chosen.push_back(view);
    }
    return chosen;
}

std::vector<std::string> benchDevices(const std::vector<BenchSample>& samples)
{
    std::vector<std::string> devices;
    for (const BenchSample& sample : samples)
        if (sample.failure.empty() && !contains(devices, sample.device))
            devices.push_back(sample.device);
    return devices;
}

std::string viewName(const std::string& scene, const std::string& camera)
{
    return camera.empty() ? scene : scene + " from " + camera;
}

}  // namespace crevice
