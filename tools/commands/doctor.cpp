// SPDX-License-Identifier: MIT
// crevice doctor: draws a frame in memory full of poison and names the first pass that goes wrong.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/render/device/float_device.h"
#include "tools/render/device/open_device.h"
#include "tools/render/device/poison_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/output_source.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene_upload.h"
#include "tools/render/target_diagnosis.h"
#include "tools/render/view_diagnosis.h"

#include "core/base/numbers.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>

namespace crevice {
namespace {

struct DoctorOptions {
    ConfigOptions config;
    SceneOptions scene;
    std::string backend;
    std::string precision;
    std::string program_cache;
    int frames = 2;
    bool json = false;
};

// Two values that no pass writes by chance; with both, whatever depends on them differs.
constexpr float kPoison = 0.8713f;
constexpr float kOtherPoison = 0.3391f;

struct Checkup {
    Plan plan;  ///< Of the config as it is.
    std::vector<TargetHealth> health;
    std::string device;
    Diagnostics warnings;  ///< Of the plan, the machine and the view.
};

/// Draws in memory that holds the poison and reads back all that is watched.
Result<std::vector<Image>> drawIn(Device& device, const Description& description,
                                  const SceneView& view, const std::vector<WatchedTarget>& watched,
                                  const DoctorOptions& options)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame shown = makeFrame(*scene, view.camera, view.extent);
    Result<HostTextures> host = HostTextures::make(device, description, view.extent, shown);
    if (!host) return host.diagnostics();
    const Result<Frame> frame = host->frameOf(shown);
    if (!frame) return frame.diagnostics();
    CompileOptions compile_options;
    compile_options.extent = view.extent;
    compile_options.disable = {"aliasing"};
    const auto renderer = Renderer::create(device, description, compile_options, traitsOf(*frame));
    if (!renderer) return renderer.diagnostics();
    for (int i = 0; i < options.frames; ++i)
        if (const Status drawn = (*renderer)->render(*frame); !drawn) return drawn.diagnostics();
    std::vector<Image> images;
    for (const WatchedTarget& each : watched) {
        Result<Image> image = readOutput(device, **renderer, each.output);
        if (!image) return image.diagnostics();
        images.push_back(std::move(*image));
    }
    return images;
}

Result<Checkup> checkUp(const DoctorOptions& options, const SceneView& view,
                        Description description, Progress& progress)
{
    const Result<OpenDevice> open =
        openDevice(options.backend, options.precision, options.program_cache);
    if (!open) return open.diagnostics();
    Checkup checkup;
    checkup.device = open->context->description();
    Device& device = *open->device;
    const Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame frame = makeFrame(*scene, view.camera, view.extent);
    CompileOptions compile_options;
    compile_options.extent = view.extent;
    Result<Plan> plan = compile(description, traitsOf(frame), device.caps(), compile_options);
    if (!plan) return plan.diagnostics();
    checkup.warnings = plan.diagnostics();

    const std::vector<WatchedTarget> watched = watchAll(*plan, description);
    progress.begin("drawing in poison");
    PoisonDevice poison(device, kPoison, false);
    const auto drawn = drawIn(poison, description, view, watched, options);
    if (!drawn) return drawn.diagnostics();
    PoisonDevice other(device, kOtherPoison, true);
    const auto redrawn = drawIn(other, description, view, watched, options);
    if (!redrawn) return redrawn.diagnostics();
    progress.begin("drawing in floats");
    FloatDevice wide(poison);
    const auto floats = drawIn(wide, description, view, watched, options);
    if (!floats) return floats.diagnostics();

    for (std::size_t i = 0; i < watched.size(); ++i) {
        checkup.health.push_back(examine((*drawn)[i], (*redrawn)[i]));
        examineFloats((*floats)[i], formatOf(*plan, watched[i].target), checkup.health.back());
        checkup.health.back().target = watched[i].target;
        checkup.health.back().pass = watched[i].pass;
    }
    if (const Result<Image> depth = drawDepth(device, frame, view.extent))
        append(checkup.warnings, checkView(description, *plan, view.scene, frame.camera,
                                           medianDistance(*depth, frame.camera), nullptr));
    checkup.plan = std::move(*plan);
    if (open->programs) append(checkup.warnings, open->programs->warnings());
    return checkup;
}

std::string stateOf(const TargetHealth& health)
{
    if (health.not_numbers + health.infinite > 0) return "not finite";
    if (health.out_of_range > 0) return "out of range";
    if (health.undefined > 0) return "undefined";
    return health.constant ? "constant" : "varies";
}

void printTable(const Checkup& checkup, const Diagnostics& found)
{
    print("%-16s %-20s %-12s %s\n", "pass", "target", "state", "least .. most by channel");
    for (const TargetHealth& each : checkup.health) {
        print("%-16s %-20s %-12s", each.pass.c_str(), each.target.c_str(), stateOf(each).c_str());
        for (int i = 0; i < each.channels && each.minimum[i] <= each.maximum[i]; ++i)
            print(" %s..%s", significant(each.minimum[i], 4).c_str(),
                  significant(each.maximum[i], 4).c_str());
        print("\n");
    }
    if (found.empty()) print("every value is written, finite and in range\n");
}

void printJson(const Checkup& checkup, const Diagnostics& found)
{
    nlohmann::json targets = nlohmann::json::array();
    for (const TargetHealth& each : checkup.health) {
        nlohmann::json channels = nlohmann::json::array();
        for (int i = 0; i < each.channels && each.minimum[i] <= each.maximum[i]; ++i)
            channels.push_back({{"least", each.minimum[i]}, {"most", each.maximum[i]}});
        targets.push_back({{"pass", each.pass},
                           {"target", each.target},
                           {"state", stateOf(each)},
                           {"pixels", each.pixels},
                           {"undefined", each.undefined},
                           {"not_a_number", each.not_numbers},
                           {"infinite", each.infinite},
                           {"out_of_range", each.out_of_range},
                           {"channels", channels}});
    }
    const nlohmann::json json = {{"device", checkup.device},
                                 {"targets", targets},
                                 {"diagnostics", nlohmann::json::parse(toJson(found))}};
    printAsJson(json);
}

int doctor(const DoctorOptions& options)
{
    const CheckoutSources sources(options.config.checkout, options.config.roots);
    const Result<Description> description = loadDescription(options.config, sources);
    if (!description) return report(description.diagnostics(), options.json);
    Progress progress;
    progress.begin("loading " + options.scene.scene);
    const Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return report(view.diagnostics(), options.json);
    const Result<Checkup> checkup = checkUp(options, *view, *description, progress);
    progress.wipe();
    if (!checkup) return report(checkup.diagnostics(), options.json);
    const Diagnostics found = diagnose(*description, checkup->plan, checkup->health);
    Diagnostics all = found;
    append(all, checkup->warnings);
    append(all, view.diagnostics());
    if (options.json) {
        printJson(*checkup, all);
    } else {
        printTable(*checkup, found);
        report(all, false);
    }
    return hasErrors(found) ? kExitDiffers : kExitOk;
}

}  // namespace

void addDoctorCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command =
        app.add_subcommand("doctor", "Find the pass that makes a picture black, grey or noisy");
    auto options = std::make_shared<DoctorOptions>();
    command->add_option("CONFIG", options->config.config, "A shipped config's name, or a file")
        ->required();
    addSceneOptions(*command, options->scene);
    addConfigOptions(*command, options->config);
    addBackendOption(*command, options->backend);
    addPrecisionOption(*command, options->precision);
    addProgramCacheOption(*command, options->program_cache);
    command
        ->add_option("--frames", options->frames,
                     "Number of frames to draw before the targets are checked")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print what was found as JSON");
    command->footer(
        "Draws the frame three times, twice in memory that holds other poison each time and once\n"
        "with every target in 32-bit floats, and looks at each target of each pass: what is not\n"
        "finite or out of range, what depends on the poison, what is the same everywhere.\n"
        "Exit code 5 where a pass is wrong.\n"
        "Example:\n"
        "  crevice doctor my.json --scene model.glb");
    command->callback([options, &exit_code] { exit_code = doctor(*options); });
}

}  // namespace crevice
