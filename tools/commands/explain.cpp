// SPDX-License-Identifier: MIT
// crevice explain: the plan of a config, what it leaves out and why, and where a value came from.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/device/open_device.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene_upload.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <crevice/recording_device.h>

#include "core/base/text.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

struct ExplainOptions {
    ConfigOptions config;
    SceneOptions scene;
    std::string backend;
    std::vector<std::string> outputs;
    std::vector<std::string> disable;
    std::string why;
    std::string format = "text";
    int views = 1;
};

/// What the scene has; everything when none was named. Lengths are resolved, as `lengths` says.
Result<SceneTraits> sceneTraits(const ExplainOptions& options, Description& description,
                                std::string& lengths)
{
    if (options.scene.scene.empty()) return usualTraits();
    const Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return view.diagnostics();
    const Result<std::string> known = resolveLengths(description, *view, options.backend);
    if (!known) return known.diagnostics();
    lengths = *known;
    RecordingDevice device;
    const Result<UploadedScene> scene = UploadedScene::upload(device, view->scene);
    if (!scene) return scene.diagnostics();
    return {traitsOf(makeFrame(*scene, view->camera, view->extent)), view.diagnostics()};
}

/// What --backend's device can do; the usual device's abilities when none was named.
Result<DeviceCaps> deviceCaps(const std::string& backend)
{
    if (backend.empty()) return usualCaps();
    const Result<OpenDevice> open = openDevice(backend);
    if (!open) return open.diagnostics();
    return open->device->caps();
}

Result<Plan> makePlan(const ExplainOptions& options, const SourceSet& sources)
{
    CompileOptions compile_options;
    const Result<Extent> extent = parseSize(options.scene.size);
    if (!extent) return extent.diagnostics();
    compile_options.extent = *extent;
    compile_options.disable = options.disable;
    Result<Description> description =
        loadDescription(options.config, sources, isFileScene(options.scene.scene));
    if (!description) return description.diagnostics();
    for (const std::string& name : options.outputs) {
        const Result<OutputSource> source = exposeOutput(*description, name);
        if (!source) return source.diagnostics();
        compile_options.outputs.push_back(source->output);
    }
    std::string lengths;
    Result<SceneTraits> traits = sceneTraits(options, *description, lengths);
    if (!traits) return traits.diagnostics();
    traits->views = options.views;
    const Result<DeviceCaps> caps = deviceCaps(options.backend);
    if (!caps) return caps.diagnostics();
    return compile(*description, *traits, *caps, compile_options);
}

int explainValue(const ExplainOptions& options, const SourceSet& sources)
{
    const bool json = options.format == "json";
    const Result<Node> document = loadConfig(sources, requestOf(options.config));
    if (!document) return report(document.diagnostics(), json);
    const Result<FoundValue> value = findValue(*document, options.why);
    if (!value) return report(value.diagnostics(), json);
    printLines(json ? explainJson(*value) : explainText(*value));
    if (json || options.scene.scene.empty()) return kExitOk;
    std::string lengths;
    Result<Description> description =
        loadDescription(options.config, sources, isFileScene(options.scene.scene));
    const Result<SceneTraits> traits =
        description ? sceneTraits(options, *description, lengths) : description.diagnostics();
    if (!traits) return report(traits.diagnostics(), json);
    if (startsWith(lengths, options.why + " ")) print("%s\n", lengths.c_str());
    return kExitOk;
}

int explain(const ExplainOptions& options)
{
    const CheckoutSources sources(options.config.checkout, options.config.roots);
    if (!options.why.empty()) return explainValue(options, sources);
    const Result<Plan> plan = makePlan(options, sources);
    if (!plan) return report(plan.diagnostics(), options.format == "json");
    report(plan.diagnostics(), false);
    const std::string text = options.format == "json"  ? toJson(*plan)
                             : options.format == "dot" ? toDot(*plan)
                                                       : toText(*plan);
    printLines(text);
    return kExitOk;
}

/// What to plan for.
void addPlanOptions(CLI::App& app, ExplainOptions& options)
{
    app.add_option("--output", options.outputs,
                   "Plan only for this output, view or target; may be repeated")
        ->allow_extra_args(false);
    addDisableOption(app, options.disable);
    app.add_option("--views", options.views, "Number of views of a frame, 2 for stereo")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
}

}  // namespace

void addExplainCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("explain", "Show what a config does, and why");
    auto options = std::make_shared<ExplainOptions>();
    options->scene.scene.clear();
    command->add_option("CONFIG", options->config.config, "A shipped config's name, or a file")
        ->required();
    addConfigOptions(*command, options->config);
    addSceneOptions(*command, options->scene);
    addBackendOption(*command, options->backend);
    addPlanOptions(*command, *options);
    command->add_option("--why", options->why,
                        "Print which files set this value: a param's or feature's name, "
                        "passes.ssao.shader or /passes/ssao/shader");
    command->add_option("--format", options->format, "text, json or dot")
        ->check(CLI::IsMember({"text", "json", "dot"}))
        ->capture_default_str();
    command->footer(
        "Examples:\n"
        "  crevice explain learnopengl\n"
        "  crevice explain learnopengl --set intensity=0 --output ao\n"
        "  crevice explain my.json --why radius\n"
        "  crevice explain thesis --format dot | dot -Tsvg > thesis.svg");
    command->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace crevice
