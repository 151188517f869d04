// SPDX-License-Identifier: MIT
// Which samples a bench measures: the product of its lists, and their keys.
#include "tools/measure/bench/run.h"

#include "tools/measure/line_file.h"
#include "tools/measure/reference/tracer.h"
#include "tools/measure/taps.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene/options.h"
#include "tools/render/view_diagnosis.h"

#include "core/base/content_hash.h"
#include "core/base/text.h"

#include <set>

namespace crevice {
namespace {

/// How software renderers are timed. Part of each key, so that samples by another clock are
/// measured again and never stand beside these.
constexpr const char* kClock = "processor time";

bool isPreset(const BenchTask& task) { return isPresetConfig(task.sample.config); }

/// Over all that decides a sample's figures on a device.
std::string keyOf(const BenchTask& task, double radius, const std::vector<std::string>& overrides,
                  const std::string& content, bool motion)
{
    const BenchSample& sample = task.sample;
    ContentHash hash;
    hash.addText(sample.version);
    hash.addText(sample.config);
    for (const std::string& text : overrides) hash.addText(text);
    hash.addText(sample.scene);
    hash.addText(sample.camera);
    hash.add(sample.extent.width);
    hash.add(sample.extent.height);
    hash.add(radius);
    hash.addText(task.reference);
    hash.addText(content);
    hash.addText(kClock);
    if (sample.output != kOcclusionOutput) hash.addText(sample.output);
    for (const std::string& name : sample.disable) hash.addText(name);
    if (motion) hash.addText("motion");
    return hash.hex();
}

class Planner {
public:
    Planner(const BenchOptions& options, const SourceSet& sources)
        : options_(options),
          sources_(sources)
    {
    }

    void addScene(const std::string& name, const std::vector<Extent>& extents)
    {
        Result<Scene> loaded = loadScene(name, options_.import);
        collect(loaded.diagnostics());
        std::shared_ptr<const Scene> scene;
        if (loaded) scene = std::make_shared<const Scene>(std::move(*loaded));
        for (const Extent extent : extents) {
            Place place = {name, extent, {}};
            if (scene)
                addView(scene, place);
            else
                place.failure = failureText(loaded.diagnostics());
            addConfigs(std::move(place));
        }
    }

    BenchPlan plan;

private:
    struct Place {
        std::string scene;
        Extent extent;
        std::string failure;  ///< Why there is no view; empty where the newest one is meant.
        double radius = 0;    ///< 0: the config's own.
    };

    void addView(const std::shared_ptr<const Scene>& scene, Place& place)
    {
        const Bounds bounds = scene->bounds();
        const double aspect = static_cast<double>(place.extent.width) / place.extent.height;
        const Result<SceneCamera> camera = chooseCamera(*scene, bounds, options_.camera, aspect);
        collect(camera.diagnostics());
        if (camera)
            plan.views.push_back({scene, bounds, *camera, place.extent});
        else
            place.failure = failureText(camera.diagnostics());
    }

    void addConfigs(Place place)
    {
        const std::vector<double> radii =
            options_.radii.empty() ? std::vector<double>{0.0} : options_.radii;
        const std::vector<std::string> configs =
            options_.configs.empty() ? configNames(sources_) : options_.configs;
        for (const double radius : radii) {
            place.radius = radius;
            for (const std::string& config : configs) addConfig(place, config);
        }
    }

    void addConfig(const Place& place, const std::string& config)
    {
        std::vector<std::string> overrides = options_.overrides;
        const Result<LoadedConfig> loaded =
            loadWithContent({config, {}, overrides, {}, options_.roots}, sources_);
        if (!loaded) return addTask(place, config, overrides);
        const Description& description = loaded->description;
        if (place.radius > 0.0) {
            if (findNamed(description.params, "radius"))
                overrides.push_back("radius=" + shortest(place.radius));
            else
                note("'" + config +
                     "' has no param 'radius': --radius sets that of the ground truth alone");
        }
        for (const std::vector<std::string>& samples : sampleOverrides(config, description)) {
            std::vector<std::string> all = overrides;
            all.insert(all.end(), samples.begin(), samples.end());
            addTask(place, config, std::move(all));
        }
    }

    /// What to set for each count of the sweep that the config can take; nothing for its own.
    std::vector<std::vector<std::string>> sampleOverrides(const std::string& config,
                                                          const Description& description)
    {
        if (options_.samples.empty()) return {{}};
        if (samplesOf(description) == 0) {
            note("'" + config +
                 "' has no param 'samples', nor 'slices' and 'steps': it is measured once");
            return {{}};
        }
        std::vector<std::vector<std::string>> all;
        for (const int count : options_.samples) {
            std::vector<std::string> overrides = overridesFor(description, count);
            if (!overrides.empty())
                all.push_back(std::move(overrides));
            else
                note(std::to_string(count) + " samples are outside the ranges of '" + config +
                     "' and left out");
        }
        return all;
    }

    void addTask(const Place& place, const std::string& config, std::vector<std::string> overrides)
    {
        BenchTask task;
        BenchSample& sample = task.sample;
        sample.config = config;
        sample.output = options_.output;
        sample.disable = options_.disable;
        sample.family = config;
        for (const std::string& text : options_.overrides) sample.family += " " + text;
        sample.family += nameSuffix(sample);
        sample.scene = place.scene;
        sample.camera = options_.camera;
        sample.extent = place.extent;
        sample.rays = options_.rays;
        sample.version = options_.version;
        sample.failure = place.failure;
        if (place.failure.empty()) {
            const BenchView& view = plan.views.back();
            task.view = plan.views.size() - 1;
            if (sample.camera.empty()) sample.camera = view.camera.name;
            sample.triangles = triangleCount(*view.scene);
        }

        Result<LoadedConfig> loaded = loadWithContent({config, {}, overrides, {}, options_.roots},
                                                      sources_, isFileScene(place.scene));
        const Status known = loaded ? describe(place, *loaded, task) : Status(loaded.diagnostics());
        if (!known && sample.failure.empty()) sample.failure = failureText(known.diagnostics());

        sample.key = keyOf(task, place.radius, overrides, loaded ? loaded->content : std::string(),
                           options_.motion);
        sample.overrides = std::move(overrides);
        if (keys_.insert(sample.key).second) plan.tasks.push_back(std::move(task));
    }

    /// What the loaded config says about the sample.
    Status describe(const Place& place, LoadedConfig& loaded, BenchTask& task)
    {
        if (place.failure.empty()) {
            const BenchView& view = plan.views.back();
            const auto distance = [&] {
                const auto found = distances_.find(plan.views.size());
                if (found != distances_.end()) return found->second;
                return distances_
                    .emplace(plan.views.size(),
                             medianDistance(*view.scene, view.camera, view.extent))
                    .first->second;
            };
            const Result<std::string> known = resolveLengths(
                loaded.description, view.matrices(), view.extent, view.bounds.diagonal(), distance);
            if (!known) return known.diagnostics();
        }
        const std::vector<OutputDesc>& outputs = loaded.description.outputs;
        if (!outputs.empty() && !findNamed(outputs, options_.output))
            return Diagnostic{Code::output_missing,
                              "'" + task.sample.config + "' exports no output '" + options_.output +
                                  "': give --output " + joined(namesOf(outputs), " or ")};
        const ParamDesc* radius = findNamed(loaded.description.params, "radius");
        task.sample.samples = samplesOf(loaded.description);
        task.sample.radius = place.radius > 0.0 ? place.radius : radius ? radius->value[0] : 0.0;
        if (place.radius <= 0.0 && !radius)
            return Diagnostic{
                Code::unknown_param,
                "the config has no param 'radius', so --radius must give the ground truth's"};
        if (place.failure.empty()) task.reference = referenceOf(task.sample.radius);
        task.description = loaded.description;
        return {};
    }

    /// The ground truth's key for the newest view. Hashing a large scene is slow, so once a radius
    /// must do.
    const std::string& referenceOf(double radius)
    {
        std::string& key = references_[{plan.views.size(), radius}];
        if (!key.empty()) return key;
        const BenchView& view = plan.views.back();
        return key =
                   referenceKey(*view.scene, view.matrices(), view.extent, {radius, options_.rays});
    }

    void note(const std::string& message) { collect({asWarning({Code::out_of_range, message})}); }

    /// Once each.
    void collect(const Diagnostics& diagnostics)
    {
        for (const Diagnostic& each : diagnostics)
            if (told_.insert(toText(each)).second) plan.diagnostics.push_back(each);
    }

    const BenchOptions& options_;
    const SourceSet& sources_;
    std::set<std::string> told_;
    std::set<std::string> keys_;
    std::map<std::size_t, Result<double>> distances_;  // medianDistance, by the number of the view
    std::map<std::pair<std::size_t, double>, std::string> references_;
};

}  // namespace

Result<BenchPlan> planBench(const BenchOptions& options, const SourceSet& sources)
{
    std::vector<Extent> extents;
    for (const std::string& size : options.sizes) {
        const Result<Extent> extent = parseSize(size);
        if (!extent) return extent.diagnostics();
        extents.push_back(*extent);
    }
    Planner planner(options, sources);
    for (const std::string& scene : options.scenes) planner.addScene(scene, extents);
    if (options.configs.empty())
        std::stable_partition(planner.plan.tasks.begin(), planner.plan.tasks.end(), isPreset);
    return std::move(planner.plan);
}

}  // namespace crevice
