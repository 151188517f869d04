// SPDX-License-Identifier: MIT
// crevice doctor: draws a frame in memory full of poison and names the first pass that goes wrong,
// then compares AO with ground truth, and light with what it must be.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/commands.h"
#include "tools/measure/reference/tracer.h"
#include "tools/measure/stress/run.h"
#include "tools/render/device/open_device.h"
#include "tools/render/device/poison_device.h"
#include "tools/render/glsl/glsl_check.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene_upload.h"
#include "tools/render/target_diagnosis.h"
#include "tools/render/view_diagnosis.h"

#include "core/base/text.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace crevice {
namespace {

struct DoctorOptions {
    ConfigOptions config;
    SceneOptions scene;
    CacheOptions cache;
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
    std::vector<TargetHealth> health;
    std::string device;
    Diagnostics warnings;  ///< Of the plan, the machine and the view.
    Diagnostics found;     ///< What is wrong.
};

/// Draws in memory that holds the poison and reads back all that is watched.
Result<std::vector<Image>> drawIn(Device& device, const Description& description,
                                  const SceneView& view, const std::vector<WatchedTarget>& watched,
                                  const DoctorOptions& options)
{
    const Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    Drawn drawn;
    Status done = drawn.prepare(device, description, makeFrame(*scene, view.camera, view.extent),
                                {view.extent, {}, {"aliasing"}});
    for (int i = 0; i < options.frames && done; ++i) done = drawn.renderer->render(drawn.frame);
    if (!done) return done.diagnostics();
    std::vector<Image> images;
    for (const WatchedTarget& each : watched) {
        Result<Image> image = readOutput(device, *drawn.renderer, each.output);
        if (!image) return image.diagnostics();
        images.push_back(std::move(*image));
    }
    return images;
}

constexpr Extent kAnswerSize = {256, 144};  // for which the limits of stress cases are made
constexpr const char* kAnswers[] = {"ambient_alone", "light_behind", "background"};

/// The view as a stress case, in the size that tracing takes a second for.
StressCase caseOf(const SceneView& view, double radius)
{
    StressCase own;
    own.name = "the scene";
    own.steps = {{0, "against ground truth"}};
    own.expectation = Expectation::sound;
    own.shot = [&view, radius](double, Extent size) {
        StressShot shot;
        shot.scene = view.scene;
        shot.camera = {view.camera.view_from_world, clipFromView(view.camera, size, view.bounds)};
        shot.extent = size;
        shot.radius = radius;
        return shot;
    };
    return own;
}

std::vector<StressRecord> drawAll(const std::vector<StressCase>& cases, const ConfigOptions& config,
                                  StressRunner&& runner)
{
    std::vector<StressRecord> records;
    for (const StressCase& each : cases)
        for (int step = 0; step < static_cast<int>(each.steps.size()); ++step)
            records.push_back(runner.measure({config, &each, step}, kAnswerSize).record);
    return records;
}

/// Errors CV9005: where the config is worse than as it is shipped or than the shipped one that it
/// extends, or without one than no ambient occlusion. Nothing where the plan leaves out its own.
Diagnostics checkAnswers(Device& device, const DoctorOptions& options, const SceneView& view,
                         const SourceSet& sources, const Description& description, const Plan& plan)
{
    const PlanOutput* ao = findNamed(plan.outputs, "ao");
    const ParamDesc* radius = findNamed(description.params, "radius");
    if (!ao || ao->constant >= 0 || !radius) return {};
    std::vector<StressCase> cases;
    for (const StressCase& each : stressCases())
        if (std::count(std::begin(kAnswers), std::end(kAnswers), each.name) > 0)
            cases.push_back(each);
    cases.push_back(caseOf(view, radius->value[0]));
    const ConfigOptions& config = options.config;
    const std::string folder = options.cache.path();
    const std::vector<StressRecord> records =
        drawAll(cases, config, StressRunner(device, sources, folder));

    KnownConfig with = {shippedNameOf(config, sources), false};
    with.same = with.name == config.config && config.overrides.empty();
    KnownSteps known;
    if (!with.name.empty()) {
        std::vector<StressRecord> before =
            drawAll(cases, {with.name, with.same ? config.variant : "", {}, {}},
                    StressRunner(device, shippedSources(), folder));
        for (StressRecord& each : before) each.config = with.name;
        known = standingsOf(seriesOf(before, cases));
    } else {
        with = {"no AO", true};
        known[{with.name, cases.back().name}][cases.back().steps[0].label].error =
            records.back().rmse < 0 ? 1 : records.back().rmse_white;
    }
    Diagnostics found;
    int unjudged = 0;
    for (const StressSeries& series : seriesOf(records, cases))
        for (std::string& each : worseThan(known, with, series, unjudged))
            found.push_back({Code::answer_wrong, std::move(each),
                             "drawn at 256x144 and compared with '" + with.name + "'"});
    return found;
}

Result<Checkup> checkUp(const DoctorOptions& options, const SceneView& view,
                        const SourceSet& sources, Description description, Progress& progress)
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
    Result<Plan> plan = compile(description, traitsOf(frame), device.caps(), {view.extent});
    if (!plan) return plan.diagnostics();
    checkup.warnings = plan.diagnostics();
    GlslCheck shaders;
    shaders.add(*plan);
    if (Diagnostics wrong = shaders.check(description, &device); !wrong.empty()) return wrong;

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
    checkup.found = diagnose(description, *plan, checkup.health);
    progress.begin("comparing with ground truth");
    if (!hasErrors(checkup.found))
        append(checkup.found, checkAnswers(device, options, view, sources, description, *plan));
    if (const Result<Image> depth = drawDepth(device, frame, view.extent))
        append(checkup.warnings, checkView(description, *plan, view.scene, frame.camera,
                                           medianDistance(*depth, frame.camera), nullptr));
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
    if (found.empty())
        print("every value is written, finite and in range; AO and light are as they must be\n");
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
    Result<Description> description =
        loadDescription(options.config, sources, isFileScene(options.scene.scene));
    if (!description) return report(description.diagnostics(), options.json);
    Progress progress;
    progress.begin("loading " + options.scene.scene);
    const Result<SceneView> view = loadSceneView(options.scene);
    if (!view) return report(view.diagnostics(), options.json);
    const Result<std::string> lengths = resolveLengths(*description, *view, options.backend);
    if (!lengths) return report(lengths.diagnostics(), options.json);
    const Result<Checkup> checkup = checkUp(options, *view, sources, *description, progress);
    progress.wipe();
    if (!checkup) return report(checkup.diagnostics(), options.json);
    const Diagnostics& found = checkup->found;
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
    addCacheOptions(*command, options->cache);
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
        "Then compares AO in 256x144 pixels with ray-traced ground truth: it must be no worse than "
        "in\n"
        "the shipped config that this is, or have no more than twice the error of the one that it\n"
        "extends, or of none than without AO. Where there is no surface AO must be 1, ambient "
        "light\n"
        "must be dimmed by it exactly, and a light behind a surface must do nothing.\n"
        "Exit code 5 where something is wrong.\n"
        "Example:\n"
        "  crevice doctor my.json --scene model.glb");
    command->callback([options, &exit_code] { exit_code = doctor(*options); });
}

}  // namespace crevice
