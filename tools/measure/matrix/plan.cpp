// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/plan.h"

#include "core/base/content_hash.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene/scene_bytes.h"

#include <algorithm>

namespace crevice {
namespace {

class MatrixPlanner {
public:
    MatrixPlanner(const Matrix& matrix, const MatrixOptions& options, const SourceSet& sources)
        : plan{matrix},
          matrix_(matrix),
          options_(options),
          sources_(sources)
    {
    }

    void choose()
    {
        for (std::size_t i = 0; i < matrix_.cells.size(); ++i)
            if (has(matrix_.cells[i].name, options_.filter)) plan.cells.push_back(i);
        if (plan.cells.empty())
            errors.push_back({Code::usage, "no cell's name contains '" + options_.filter + "'",
                              "the first cell is '" + matrix_.cells[0].name + "'"});
        plan.cells = shardOf(plan.cells, options_.shard, options_.shards);
        for (const std::size_t cell : plan.cells)
            for (const std::size_t i : matrix_.cells[cell].checks) {
                const MatrixCheck& check = matrix_.checks[i];
                addChoice(matrix_.cells[cell].choice, check);
                addChoice(otherChoice(check, matrix_.cells[cell].choice), check);
            }
    }

    void warnOfUnused()
    {
        std::set<std::string> used;
        for (const MatrixCell& cell : matrix_.cells)
            for (const std::size_t i : cell.checks)
                used.insert(approvedFile(matrix_, cell, matrix_.checks[i]));
        const std::string& folder = matrix_.approved_folder;
        std::vector<std::string> files = filesBelow(folder, {".png", ".pfm", ".plan.txt"}, 0);
        eraseIf(files, [&](const std::string& name) { return used.count(folder + "/" + name); });
        std::sort(files.begin(), files.end());
        if (!files.empty())
            plan.warnings.push_back(
                asWarning({Code::unused_name, "no cell has these approved files: " + joined(files),
                           "delete them from '" + folder + "'"}));
    }

    MatrixPlan plan;
    Diagnostics errors;

private:
    void addChoice(const MatrixChoice& choice, const MatrixCheck& check)
    {
        MatrixSubject* const subject = shoot(choice);
        if (!subject) return;
        const bool truth = check.kind == CheckKind::truth || check.kind == CheckKind::open;
        const MatrixValue& config = matrix_.value(choice, kConfigAxis);
        if (truth && !findNamed(subject->description.params, "radius"))
            note({{Code::unknown_param,
                   "'" + config.name + "' has no param 'radius', which the truth would have",
                   "leave it out of this check by `where`"}},
                 check.place, config.place);
        if (check.output.empty() || subject->sources.count(check.output) > 0) return;
        const Result<OutputSource> source = exposeOutput(subject->description, check.output);
        note(source.diagnostics(), check.place, config.place);
        if (source) subject->sources[check.output] = *source;
    }

    /// Adds the shot; null, and errors, where something of it cannot be loaded.
    MatrixSubject* shoot(const MatrixChoice& choice)
    {
        const auto known = plan.shots.find(choice);
        if (known != plan.shots.end()) return known->second.subject;
        const MatrixValue& config = matrix_.value(choice, kConfigAxis);
        const MatrixValue& place = matrix_.value(choice, kSceneAxis);
        const MatrixValue& view = matrix_.value(choice, kCameraAxis);
        MatrixSubject* const subject =
            once(plan.subjects, subjectKey(choice), config, [&] { return load(choice); });
        MatrixScene* const scene =
            once(plan.scenes, place.text, place, [&] { return read(place); });
        if (!scene) return nullptr;
        const Extent extent = *parseSize(matrix_.value(choice, kSizeAxis).text);
        const auto camera = chooseCamera(scene->scene, scene->bounds, view.text,
                                         static_cast<double>(extent.width) / extent.height);
        note(camera.diagnostics(), view.place, place.place);
        if (camera && subject) plan.shots[choice] = {scene, subject, *camera, extent};
        return camera ? subject : nullptr;
    }

    std::vector<std::string> overridesOf(const MatrixChoice& choice) const
    {
        std::vector<std::string> overrides;
        for (std::size_t axis = kParamAxes; axis < choice.size(); ++axis)
            overrides.push_back(matrix_.axes[axis].name + "=" + matrix_.value(choice, axis).text);
        return overrides;
    }

    /// Lengths of scene files fit themselves.
    bool fits(const MatrixChoice& choice) const
    {
        return isFileScene(matrix_.value(choice, kSceneAxis).text);
    }

    std::string subjectKey(const MatrixChoice& choice) const
    {
        return matrix_.value(choice, kConfigAxis).text + "\n" +
               matrix_.value(choice, kVariantAxis).text + "\n" + joined(overridesOf(choice), "\n") +
               (fits(choice) ? "\n" : "");
    }

    Result<MatrixSubject> load(const MatrixChoice& choice) const
    {
        Result<LoadedConfig> loaded = loadWithContent(
            {matrix_.value(choice, kConfigAxis).text, matrix_.value(choice, kVariantAxis).text,
             overridesOf(choice), options_.checkout, options_.roots},
            sources_, fits(choice));
        if (!loaded) return loaded.diagnostics();
        std::vector<std::string> outputs;
        for (const OutputDesc& output : loaded->description.outputs)
            if (!output.on_request) outputs.push_back(output.name);
        return {{std::move(loaded->description), std::move(loaded->content), std::move(outputs)},
                loaded.diagnostics()};
    }

    Result<MatrixScene> read(const MatrixValue& name) const
    {
        ImportOptions import;
        import.roots = options_.roots;
        Result<Scene> loaded = loadScene(name.text, import);
        if (!loaded) return loaded.diagnostics();
        ContentHash hash;
        hash.addText(sceneBytes(*loaded));
        const Bounds bounds = loaded->bounds();
        return {{std::move(*loaded), bounds, hash.hex()}, loaded.diagnostics()};
    }

    /// What is known by the key, or made now; null where it cannot be.
    template <class Value, class Make>
    Value* once(std::map<std::string, Result<Value>>& all, const std::string& key,
                const MatrixValue& of, Make make)
    {
        auto found = all.find(key);
        if (found == all.end()) found = all.emplace(key, make()).first;
        note(found->second.diagnostics(), of.place, of.place);
        return found->second ? &*found->second : nullptr;
    }

    /// Adds them, with the place in the matrix file; each text once.
    void note(Diagnostics found, const Place& place, const Place& entry)
    {
        for (Diagnostic& each : found) {
            if (each.place.line == 0)
                each.place = place;
            else
                each.notes.push_back({entry, "asked for here"});
            if (!told_.insert(toText(each)).second) continue;
            (each.severity == Severity::error ? errors : plan.warnings).push_back(std::move(each));
        }
    }

    const Matrix& matrix_;
    const MatrixOptions& options_;
    const SourceSet& sources_;
    std::set<std::string> told_;
};

}  // namespace

std::string approvedFile(const Matrix& matrix, const MatrixCell& cell, const MatrixCheck& check)
{
    const std::string name = cell.approved + (check.output.empty() ? "" : "." + check.output);
    return matrix.approved_folder + "/" + name + "." +
           (check.kind == CheckKind::plan ? "plan.txt" : matrix.approved_format);
}

std::string keyOf(const MatrixPlan& plan, const MatrixCell& cell, const std::string& version)
{
    ContentHash hash;
    hash.addText(version);
    hash.addText(cell.name);
    const auto addChoice = [&](const MatrixChoice& choice) {
        const MatrixShot& shot = plan.shots.at(choice);
        hash.addText(shot.subject->content);
        hash.addText(shot.scene->content);
        for (const std::size_t axis : {kCameraAxis, kSizeAxis, kBackendAxis})
            hash.addText(plan.matrix.value(choice, axis).text);
    };
    for (const std::size_t i : cell.checks) {
        const MatrixCheck& check = plan.matrix.checks[i];
        hash.addText(check.text);
        addChoice(cell.choice);
        addChoice(otherChoice(check, cell.choice));
        if (check.isApproved())
            hash.addText(readBytes(approvedFile(plan.matrix, cell, check), kMaxApproved).bytes);
    }
    return hash.hex();
}

std::vector<std::size_t> shardOf(const std::vector<std::size_t>& list, std::size_t shard,
                                 std::size_t shards)
{
    return {list.begin() + list.size() * (shard - 1) / shards,
            list.begin() + list.size() * shard / shards};
}

Result<MatrixPlan> planMatrix(const Matrix& matrix, const MatrixOptions& options,
                              const SourceSet& sources)
{
    MatrixPlanner planner(matrix, options, sources);
    planner.choose();
    planner.warnOfUnused();
    cutShort(planner.errors);
    if (!planner.errors.empty()) return planner.errors;
    return std::move(planner.plan);
}

}  // namespace crevice
