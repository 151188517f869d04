// SPDX-License-Identifier: MIT
// Groups bench samples by what they show, and chooses between measured configs.
#include "tools/measure/bench/choice.h"

#include "core/base/text.h"
#include "tools/show/plan/print.h"

#include <array>
#include <cmath>
#include <limits>
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
    std::map<std::string, std::set<std::string>> paths;  // by the name of the file
    const auto fileOf = [](const std::string& scene) {
        return scene.substr(scene.find_last_of('/') + 1);
    };
    for (const ResultView& view : views) {
        cameras[view.scene].insert(view.camera);
        paths[fileOf(view.scene)].insert(view.scene);
    }
    for (ResultView& view : views) {
        const std::string file = fileOf(view.scene);
        const std::string& scene = paths[file].size() > 1 ? view.scene : file;
        view.name = viewName(scene, cameras[view.scene].size() > 1 ? view.camera : "");
    }
}

/// The extent with the most samples on the device; of equals, the one with more pixels.
Extent commonExtent(const std::vector<ResultView>& views, const std::string& device)
{
    std::map<std::pair<int, int>, std::size_t> counts;
    for (const ResultView& view : views)
        if (view.device == device)
            counts[{view.extent.width, view.extent.height}] += view.samples.size();
    std::array<long long, 4> best = {};
    for (const auto& [size, count] : counts) {
        const long long width = size.first, height = size.second;
        best = std::max(best, {static_cast<long long>(count), width * height, width, height});
    }
    return {static_cast<int>(best[2]), static_cast<int>(best[3])};
}

Diagnostic scopeError(std::string message, std::string help)
{
    return {Code::usage, std::move(message), std::move(help)};
}

Result<std::string> chooseDevice(const std::vector<BenchSample>& samples, const std::string& part)
{
    std::vector<std::string> devices = benchDevices(samples);
    if (devices.empty())
        return Diagnostic{Code::results_broken, "no bench sample of these results has figures"};
    const std::string all = "the results hold: " + joined(devices, "; ");
    eraseIf(devices, [&part](const std::string& device) { return !has(device, part); });
    if (devices.size() == 1) return devices.front();
    if (devices.empty()) return scopeError("no device has '" + part + "' in its name", all);
    return scopeError("the results come from " + std::to_string(devices.size()) +
                          " devices, whose times do not compare",
                      "give --device with a part of one name; " + all);
}

std::string missingScope(const std::vector<ResultView>& views)
{
    std::set<std::string> names;
    for (const ResultView& view : views) names.insert(view.scene + " at " + sizeText(view.extent));
    return "the results hold: " + joined({names.begin(), names.end()});
}

/// A candidate while its views are gathered.
struct Gathered {
    Candidate candidate;
    std::vector<std::string> views;
    bool harmful = false;
};

void addSample(const std::string& view, const BenchSample& sample, bool motion, Gathered& gathered)
{
    const double flicker = motion ? flickerOf(sample.motion) : 0.0;
    const double error = flicker > 0 ? std::hypot(sample.error.rmse, flicker) : sample.error.rmse;
    Candidate& candidate = gathered.candidate;
    const auto isWorst = [&](double value, double& worst, std::string& where) {
        if (!gathered.views.empty() && value <= worst) return false;
        worst = value;
        where = view;
        return true;
    };
    isWorst(sample.cost.median, candidate.ms, candidate.slowest_view);
    isWorst(sample.ratio_learnopengl, candidate.ratio, candidate.ratio_view);
    if (isWorst(error, candidate.error, candidate.worst_view)) candidate.flicker = flicker;
    gathered.harmful = gathered.harmful || sample.error.rmse >= sample.error_without_ao;
    gathered.views.push_back(view);
}

/// All samples of the candidates' views, by label. Whether something was measured in all of them.
bool gather(const std::vector<BenchSample>& samples, bool motion, Candidates& candidates)
{
    std::vector<Gathered> all;
    std::map<std::string, std::size_t> places;
    for (const ResultView& view : candidates.views)
        for (const std::size_t i : view.samples) {
            const auto [place, is_new] = places.emplace(sampleLabel(samples[i]), all.size());
            if (is_new) all.push_back({{place->first, i}, {}});
            addSample(view.name, samples[i], motion, all[place->second]);
            candidates.error_without_ao =
                std::max(candidates.error_without_ao, samples[i].error_without_ao);
        }
    bool shared = false;
    for (Gathered& gathered : all) {
        std::vector<std::string> lacking;
        for (const ResultView& view : candidates.views)
            if (!contains(gathered.views, view.name)) lacking.push_back(view.name);
        shared = shared || lacking.empty();
        const std::string& label = gathered.candidate.label;
        if (gathered.harmful)
            candidates.harmful.push_back(label);
        else if (!lacking.empty())
            candidates.elided.push_back(label + ": no figures for " + joined(lacking));
        else
            candidates.list.push_back(std::move(gathered.candidate));
    }
    return shared;
}

/// Notes what was measured in the scope, but with another radius or size than the rest.
void addOtherwiseMeasured(const std::vector<BenchSample>& samples,
                          const std::vector<ResultView>& in_scope, Candidates& candidates)
{
    std::set<std::string> known;
    for (const ResultView& view : candidates.views)
        for (const std::size_t i : view.samples) known.insert(sampleLabel(samples[i]));
    for (const ResultView& view : in_scope)
        for (const std::size_t i : view.samples) {
            const std::string label = sampleLabel(samples[i]);
            if (known.insert(label).second)
                candidates.elided.push_back(label + ": measured at " + sizeText(view.extent) +
                                            " and radius " + significant(view.radius, 6) +
                                            " alone");
        }
}

bool isOfError(const ChoiceLimit& limit) { return limit.kind == ChoiceLimit::Kind::error; }

/// What a candidate spends of a limit.
double spentOf(const Candidate& candidate, ChoiceLimit::Kind kind)
{
    if (kind == ChoiceLimit::Kind::error) return candidate.error;
    if (kind == ChoiceLimit::Kind::time_ms) return candidate.ms;
    return candidate.ratio > 0 ? candidate.ratio : std::numeric_limits<double>::infinity();
}

std::string shortText(const Candidate& candidate)
{
    return candidate.label + ": " + significant(candidate.ms, 3) + " ms, " +
           significant(candidate.ratio, 3) + " times learnopengl, error " +
           fixed(candidate.error, 4);
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

Result<Candidates> findCandidates(const std::vector<BenchSample>& samples, const ChoiceScope& scope)
{
    const Result<std::string> device = chooseDevice(samples, scope.device);
    if (!device) return device.diagnostics();
    const std::vector<ResultView> all = benchViews(samples);
    std::vector<ResultView> in_scope;
    for (const ResultView& view : all)
        if (view.device == *device && (scope.scene.empty() || view.scene == scope.scene))
            in_scope.push_back(view);

    Candidates candidates;
    candidates.device = *device;
    candidates.views = mainViews(in_scope, *device, scope.extent);
    if (candidates.views.empty()) {
        const std::string scene = scope.scene.empty() ? "" : " of '" + scope.scene + "'";
        const std::string size = scope.extent == Extent{} ? "" : " at " + sizeText(scope.extent);
        return scopeError("there are no results" + scene + size, missingScope(all));
    }
    std::vector<std::string> unshared;
    while (!gather(samples, scope.motion, candidates)) {  // a single view is shared by itself
        std::vector<ResultView>& views = candidates.views;
        const auto least = std::min_element(views.begin(), views.end(),
                                            [](const ResultView& a, const ResultView& b) {
                                                return a.samples.size() < b.samples.size();
                                            });
        unshared.push_back("scene " + least->name + ": nothing was measured in it and the others");
        const auto same = [&](const ResultView& view) { return view.name == least->name; };
        eraseIf(in_scope, same);
        views.erase(least);
        candidates = {*device, std::move(views), {}, {}, {}, 0};
    }
    addOtherwiseMeasured(samples, in_scope, candidates);
    candidates.elided.insert(candidates.elided.begin(), unshared.begin(), unshared.end());
    return candidates;
}

double flickerOf(const MotionFigures& motion)
{
    double squares = 0;
    for (const char* path : kFlickerPaths)
        if (const auto found = motion.paths.find(path); found != motion.paths.end())
            squares += found->second.rms * found->second.rms;
    return std::sqrt(squares / std::size(kFlickerPaths));
}

std::vector<std::size_t> frontOf(const std::vector<Candidate>& list)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].ms > 0.0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&list](std::size_t a, std::size_t b) {
        return std::make_pair(list[a].ms, list[a].error) <
               std::make_pair(list[b].ms, list[b].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || list[i].error < list[front.back()].error) front.push_back(i);
    return front;
}

std::size_t balancedOf(const std::vector<Candidate>& list, const std::vector<std::size_t>& front)
{
    const Candidate &first = list[front.front()], &last = list[front.back()];
    const double width = std::log(last.ms / first.ms), height = first.error - last.error;
    const bool last_is_better = last.ms * last.error < first.ms * first.error;
    std::size_t best = last_is_better ? front.back() : front.front();
    double best_depth = 0.0;
    for (const std::size_t i : front) {
        // Both from 0 to 1 along the front, so that the line between the ends is at + down = 1.
        const double along = std::log(list[i].ms / first.ms) / width;
        const double up = (list[i].error - last.error) / height;
        const double depth = 1.0 - along - up;
        if (depth <= best_depth) continue;
        best_depth = depth;
        best = i;
    }
    return best;
}

Result<ChoiceLimit> parseBudget(const std::string& text)
{
    std::string_view unit = text;
    const double number = takeNumber(unit).value_or(0.0);
    if (number > 0.0 && std::isfinite(number)) {
        if (unit == "ms") return ChoiceLimit{ChoiceLimit::Kind::time_ms, number};
        if (unit == "s") return ChoiceLimit{ChoiceLimit::Kind::time_ms, number * 1000.0};
        if (unit == "us") return ChoiceLimit{ChoiceLimit::Kind::time_ms, number / 1000.0};
        if (unit == "x") return ChoiceLimit{ChoiceLimit::Kind::ratio, number};
    }
    return scopeError("'" + text + "' is not a time above 0 in s, ms, us or x",
                      "write --budget 2ms, 500us, or 0.5x for half the time of learnopengl");
}

bool wantsLeastTime(const ChoiceLimits& limits)
{
    return anyOf(limits, [](const ChoiceLimit& limit) { return isOfError(limit); });
}

std::string limitText(const ChoiceLimits& limits)
{
    std::vector<std::string> texts;
    for (const ChoiceLimit& limit : limits) {
        const std::string most = "at most " + significant(limit.most, 6);
        const bool of_time = limit.kind == ChoiceLimit::Kind::time_ms;
        texts.push_back(isOfError(limit) ? "an error of " + most
                                         : most + (of_time ? " ms" : " times learnopengl"));
    }
    return joined(texts, " and ");
}

Result<Choice> choose(const Candidates& candidates, const ChoiceLimits& limits)
{
    const std::vector<Candidate>& list = candidates.list;
    const bool least_time = wantsLeastTime(limits);
    // Of the limit that is spent most: above 1 it is broken.
    const auto spends = [&](std::size_t i) {
        double most = 0;
        for (const ChoiceLimit& limit : limits)
            most = std::max(most, spentOf(list[i], limit.kind) / limit.most);
        return most;
    };
    // What is to be small once the limits are kept; errors up to `as_good` are the same.
    double as_good = 0;
    const auto merit = [&](std::size_t i) {
        return least_time ? list[i].ms : std::max(as_good, list[i].error);
    };
    std::vector<std::size_t> within, beyond;
    for (std::size_t i = 0; i < list.size(); ++i) (spends(i) <= 1.0 ? within : beyond).push_back(i);
    std::sort(beyond.begin(), beyond.end(), [&](std::size_t a, std::size_t b) {
        return std::make_pair(spends(a), merit(a)) < std::make_pair(spends(b), merit(b));
    });
    for (const std::size_t i : within)
        if (as_good == 0 || list[i].error < as_good * (1.0 - kWorth))
            as_good = list[i].error / (1.0 - kWorth);
    std::sort(within.begin(), within.end(), [&](std::size_t a, std::size_t b) {
        return std::make_pair(merit(a), list[a].ms) < std::make_pair(merit(b), list[b].ms);
    });
    if (!within.empty()) return Choice{std::move(within), std::move(beyond)};
    Diagnostic error{Code::out_of_range,
                     "none of " + std::to_string(list.size() + candidates.harmful.size()) +
                         " configs is better than no ambient occlusion and has " +
                         limitText(limits)};
    const char* nearest = least_time ? "the nearest is " : "the fastest is ";
    if (!beyond.empty()) error.help = nearest + shortText(list[beyond[0]]);
    std::set<std::string> scenes;
    for (const ResultView& view : candidates.views) scenes.insert(view.scene);
    if (scenes.size() > 1)
        error.help += (beyond.empty() ? "" : "; ") +
                      ("each counts with its worst scene; name one, as in --scene " +
                       *scenes.begin() + ": " + joined({scenes.begin(), scenes.end()}));
    return error;
}

}  // namespace crevice
