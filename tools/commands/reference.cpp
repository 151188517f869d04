// SPDX-License-Identifier: MIT
// crevice reference: the ray-traced ambient occlusion that configs are measured against.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/image/image_file.h"
#include "tools/render/view_diagnosis.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>

namespace crevice {
namespace {

struct ReferenceOptions : SceneOptions {
    TraceOptions trace;
    std::string radius;
    CacheOptions cache;
    std::string file;
};

int reference(const ReferenceOptions& options)
{
    const Status writable = checkWritable(options.file);
    if (!writable) return report(writable.diagnostics(), false);
    Progress progress;
    progress.begin("loading " + options.scene);
    const Result<SceneView> view = loadSceneView(options);
    progress.wipe();
    report(view.diagnostics(), false);
    if (!view) return exitCodeOf(view.diagnostics());

    ConfigOptions config{"gtao", "", {}, ""};  // whose radius is read like any config's
    if (!options.radius.empty()) config.overrides = {"radius=" + options.radius};
    Result<Description> description =
        loadDescription(config, shippedSources(), isFileScene(options.scene));
    const Result<std::string> lengths =
        description ? resolveLengths(*description, *view) : description.diagnostics();
    if (!lengths) return report(lengths.diagnostics(), false);
    if (!lengths->empty()) printMessage("%s\n", lengths->c_str());

    progress.begin("tracing");
    TraceOptions trace = options.trace;
    trace.radius = findNamed(description->params, "radius")->value[0];
    trace.progress = [&progress](double done) { progress.update(done); };
    const Camera camera = {view->camera.view_from_world,
                           clipFromView(view->camera, view->extent, view->bounds)};
    const Result<Image> ground_truth =
        cachedReference(view->scene, camera, view->extent, trace, options.cache.path());
    progress.wipe();
    report(ground_truth.diagnostics(), false);
    if (!ground_truth) return exitCodeOf(ground_truth.diagnostics());

    const Status written = writeImage(options.file, *ground_truth);
    report(written.diagnostics(), false);
    if (written) printMessage("wrote %s\n", printableLine(options.file).c_str());
    return exitCodeOf(written.diagnostics());
}

}  // namespace

void addReferenceCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("reference", "Ray-trace the ground truth of ambient occlusion");
    auto options = std::make_shared<ReferenceOptions>();
    addSceneOptions(*command, *options);
    command
        ->add_option("--radius", options->radius,
                     "Largest distance of an occluder, in scene units, or as 5% or 40px. Default: "
                     "0.5, and 5% of a file")
        ->type_name("LENGTH");
    command->add_option("--rays", options->trace.rays, "Rays per pixel")->capture_default_str();
    addCacheOptions(*command, options->cache);
    addText(*command, "--out", options->file, "FILE.pfm",
            "Image file to write: 1 is open, the background is NaN")
        ->required();
    command->footer(
        "Examples:\n"
        "  crevice reference --radius 1 --rays 256 --out ground_truth.pfm\n"
        "  crevice render learnopengl --set radius=1 --out ao=ao.pfm\n"
        "  crevice compare ao.pfm ground_truth.pfm");
    command->callback([options, &exit_code] { exit_code = reference(*options); });
}

}  // namespace crevice
