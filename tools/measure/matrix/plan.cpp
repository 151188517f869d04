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
#include <functional>

namespace crevice {
namespace {

/// Only what decides a subject or a view; all else is 0.
MatrixChoice only(const MatrixChoice& choice, const std::function<bool(std::size_t)>& decides)
{
    MatrixChoice part = choice;
    for (std::size_t axis = 0; axis < part.size(); ++axis)
        if (!decides(axis)) part[axis] = 0;
    return part;
}

bool isView(std::size_t axis)
{
    return axis == kSceneAxis || axis == kCameraAxis || axis == kSizeAxis;
}

/// Lengths of scene files fit themselves, so that the scene belongs to it.
MatrixChoice subjectOf(const MatrixChoice& choice)
{
    return only(choice, [](std::size_t axis) {
        return axis == kSceneAxis || !(isView(axis) || axis == kBackendAxis);
    });
}

MatrixChoice viewOf(const MatrixChoice& choice) { return only(choice, isView); }

class MatrixPlanner {
public:
    MatrixPlanner(const Matrix& matrix, const MatrixOptions& options, const SourceSet& sources)
        : plan{matrix, {}, {}, {}},
          matrix_(matrix),
          options_(options),
          sources_(sources)
    {
    }

    void choose()
    {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < matrix_.cells.size(); ++i)
            if (has(matrix_.cells[i].name, options_.filter)) found.push_back(i);
        const auto [begin, end] = shardOf(found.size(), options_.shard, options_.shards);
        plan.cells.assign(found.begin() + begin, found.begin() + end);
        if (found.empty())
            errors.push_back({Code::usage, "no cell's name contains '" + options_.filter + "'",
                              suggestName(options_.filter, namesOf(matrix_.cells), "cells")});
    }

    void addCell(const MatrixCell& cell)
    {
        for (const std::size_t i : cell.checks) {
            const MatrixCheck& check = matrix_.checks[i];
            addChoice(cell.choice, check);
            if (!check.other.empty()) addChoice(otherChoice(check, cell.choice), check);
        }
    }

    MatrixPlan plan;
    Diagnostics errors;

private:
    void addChoice(const MatrixChoice& choice, const MatrixCheck& check)
    {
        addView(choice);
        MatrixSubject* subject = addSubject(choice);
        if (!subject) return;
        const bool truth = check.kind == CheckKind::truth || check.kind == CheckKind::open;
        const MatrixValue& config = matrix_.value(choice, kConfigAxis);
        if (truth && !subject->has_radius)
            note({{Code::unknown_param,
                   "'" + config.name + "' has no param 'radius', which the truth would have",
                   "leave it out of this check by `where`"}},
                 check.place, config.place);
        if (check.output.empty() || subject->sources.count(check.output) > 0) return;
        const Result<OutputSource> source = exposeOutput(subject->description, check.output);
        if (source)
            subject->sources[check.output] = *source;
        else
            note(source.diagnostics(), check.place, config.place);
    }

    /// Null where it cannot be loaded.
    MatrixSubject* addSubject(const MatrixChoice& choice)
    {
        const MatrixChoice key = subjectOf(choice);
        const auto known = plan.subjects.find(key);
        if (known != plan.subjects.end()) return &known->second;
        if (!broken_.insert(key).second) return nullptr;
        std::vector<std::string> overrides;
        for (std::size_t axis = 0; axis < choice.size(); ++axis)
            for (const std::string& each : matrix_.value(choice, axis).overrides)
                overrides.push_back(each);
        const MatrixValue& config = matrix_.value(choice, kConfigAxis);
        Result<LoadedConfig> loaded = loadWithContent(
            {config.text, matrix_.value(choice, kVariantAxis).text, overrides, {}, options_.roots},
            sources_, isFileScene(matrix_.value(choice, kSceneAxis).text));
        note(loaded.diagnostics(), config.place, config.place);
        if (!loaded) return nullptr;
        broken_.erase(key);
        MatrixSubject subject{std::move(loaded->description), loaded->content, {}};
        subject.exported = namesOf(subject.description.outputs);
        subject.has_radius = findNamed(subject.description.params, "radius") != nullptr;
        return &plan.subjects.emplace(key, std::move(subject)).first->second;
    }

    void addView(const MatrixChoice& choice)
    {
        const MatrixChoice key = viewOf(choice);
        if (plan.views.count(key) > 0 || !tried_.insert(key).second) return;
        const MatrixValue& name = matrix_.value(choice, kSceneAxis);
        auto scene = plan.scenes.find(name.text);
        if (scene == plan.scenes.end()) {
            if (!unreadable_.insert(name.text).second) return;
            ImportOptions import;
            import.roots = options_.roots;
            Result<Scene> loaded = loadScene(name.text, import);
            note(loaded.diagnostics(), name.place, name.place);
            if (!loaded) return;
            ContentHash hash;
            hash.addText(sceneBytes(*loaded));
            const Bounds bounds = loaded->bounds();
            MatrixScene read{std::move(*loaded), bounds, hash.hex()};
            scene = plan.scenes.emplace(name.text, std::move(read)).first;
        }
        const Extent extent = *parseSize(matrix_.value(choice, kSizeAxis).text);
        const double aspect = static_cast<double>(extent.width) / extent.height;
        const MatrixValue& camera = matrix_.value(choice, kCameraAxis);
        const auto chosen =
            chooseCamera(scene->second.scene, scene->second.bounds, camera.text, aspect);
        note(chosen.diagnostics(), camera.place, name.place);
        if (chosen) plan.views[key] = {*chosen, extent};
    }

    /// Adds them, with the place in the matrix file; errors of one text once.
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
    std::set<MatrixChoice> broken_, tried_;
    std::set<std::string> unreadable_, told_;
};

}  // namespace

const MatrixSubject& MatrixPlan::subject(const MatrixChoice& choice) const
{
    return subjects.at(subjectOf(choice));
}

const MatrixView& MatrixPlan::view(const MatrixChoice& choice) const
{
    return views.at(viewOf(choice));
}

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
        hash.addText(plan.subject(choice).content);
        hash.addText(plan.scene(choice).content);
        for (const std::size_t axis : {kCameraAxis, kSizeAxis, kBackendAxis})
            hash.addText(plan.matrix.value(choice, axis).text);
    };
    addChoice(cell.choice);
    for (const std::size_t i : cell.checks) {
        const MatrixCheck& check = plan.matrix.checks[i];
        hash.addText(check.text);
        if (!check.other.empty()) addChoice(otherChoice(check, cell.choice));
        if (check.isApproved())
            hash.addText(readBytes(approvedFile(plan.matrix, cell, check), kMaxApproved).bytes);
    }
    return hash.hex();
}

Result<MatrixPlan> planMatrix(const Matrix& matrix, const MatrixOptions& options,
                              const SourceSet& sources)
{
    MatrixPlanner planner(matrix, options, sources);
    planner.choose();
    for (const std::size_t cell : planner.plan.cells) planner.addCell(matrix.cells[cell]);
    cutShort(planner.errors);
    if (!planner.errors.empty()) return planner.errors;
    return std::move(planner.plan);
}

Diagnostics unusedApproved(const Matrix& matrix)
{
    std::set<std::string> used;
    for (const MatrixCell& cell : matrix.cells)
        for (const std::size_t i : cell.checks)
            if (matrix.checks[i].isApproved())
                used.insert(approvedFile(matrix, cell, matrix.checks[i]));
    std::vector<std::string> files =
        filesBelow(matrix.approved_folder, {".png", ".pfm", ".plan.txt"}, 0);
    eraseIf(files, [&](const std::string& name) {
        return used.count(matrix.approved_folder + "/" + name) > 0;
    });
    if (files.empty()) return {};
    std::sort(files.begin(), files.end());
    Diagnostic warning{Code::unused_name, "no cell has these approved files: " + joined(files),
                       "delete them from '" + matrix.approved_folder + "'"};
    return {asWarning(std::move(warning))};
}

}  // namespace crevice
