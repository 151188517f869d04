// SPDX-License-Identifier: MIT
// crevice render: draws a scene through a config and writes what was asked for.
#include "tools/cli_output.h"
#include "tools/commands.h"
#include "tools/config_options.h"
#include "tools/image_file.h"
#include "tools/open_device.h"
#include "tools/output_request.h"
#include "tools/read_output.h"
#include "tools/save_patch.h"
#include "tools/scene_options.h"
#include "tools/scene_upload.h"
#include "tools/stereo.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>

namespace crevice {
namespace {

struct RenderOptions {
    ConfigOptions config;
    SceneOptions scene;
    StereoOptions stereo;
    std::string backend;
    std::vector<std::string> out = {"color=color.png"};
    std::string save_patch;
    int frames = 1;
    bool json = false;
};

struct Picture {
    OutputRequest request;
    OutputSource source;
    Image image = {};
};

/// What the run tells when it is done.
struct Summary {
    std::string config, scene, device;
    Extent extent;  ///< Of a view.
    int views = 1;
    long long triangles = 0;
    std::size_t passes = 0;
    double ms = 0;  ///< Wall clock of the first frame, the wait for the GPU included.
};

using Clock = std::chrono::steady_clock;

/// Everything about --out that can be wrong, found before anything slow begins.
Result<std::vector<Picture>> readRequests(const std::vector<std::string>& texts)
{
    std::vector<Picture> pictures;
    for (const std::string& text : texts) {
        const Result<OutputRequest> request = parseOutputRequest(text);
        if (!request) return request.diagnostics();
        const Status writable = checkWritable(request->file);
        if (!writable) return writable.diagnostics();
        for (const Picture& other : pictures)
            if (other.request.file == request->file)
                return Diagnostic{Code::usage, "two --out write '" + request->file + "'"};
        pictures.push_back({*request, {}});
    }
    return pictures;
}

/// Has the description export every picture, and lists those exports.
Result<std::vector<std::string>> exposeAll(std::vector<Picture>& pictures, Description& description)
{
    Diagnostics errors;
    std::vector<std::string> names;
    for (Picture& picture : pictures) {
        const Result<OutputSource> source = exposeOutput(description, picture.request.name);
        append(errors, source.diagnostics());
        if (!source) continue;
        picture.source = *source;
        if (std::find(names.begin(), names.end(), source->output) == names.end())
            names.push_back(source->output);
    }
    if (!errors.empty()) return errors;
    return names;
}

Status readPicture(Device& device, const Renderer& renderer, Picture& picture)
{
    Result<Image> image = readOutput(device, renderer, picture.source.output);
    if (!image) return image.diagnostics();
    picture.image = std::move(*image);
    if (renderer.plan().views > 1) {
        const Result<Image> right = readOutput(device, renderer, picture.source.output, 1);
        if (!right) return right.diagnostics();
        picture.image = sideBySide(picture.image, *right);
    }
    applyView(picture.image, picture.source);
    return {};
}

/// Draws the frames and reads every picture of the last one back.
Result<Summary> draw(const RenderOptions& options, const SceneView& view, Description description,
                     const std::vector<std::string>& outputs, std::vector<Picture>& pictures,
                     Progress& progress)
{
    CompileOptions compile_options;
    compile_options.extent = view.extent;
    compile_options.outputs = outputs;
    const Result<std::vector<SceneCamera>> cameras =
        eyeCameras(view.camera, options.stereo, double(view.extent.width) / view.extent.height);
    if (!cameras) return cameras.diagnostics();
    const Result<OpenDevice> open = openDevice(options.backend);
    if (!open) return open.diagnostics();
    Device& device = *open->device;
    progress.begin("uploading the scene");
    const Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame frame = makeFrame(*scene, *cameras, view.extent);
    progress.begin("compiling shaders");
    const Result<std::unique_ptr<Renderer>> created =
        Renderer::create(device, std::move(description), compile_options, traitsOf(frame));
    if (!created) return created.diagnostics();
    Renderer& renderer = **created;

    progress.begin("drawing");
    device.finish();
    const Clock::time_point start = Clock::now();
    const Status drawn = renderer.render(frame);
    if (!drawn) return drawn.diagnostics();
    device.finish();
    const std::chrono::duration<double, std::milli> time = Clock::now() - start;
    for (int drawn_before = 1; drawn_before < options.frames; ++drawn_before)
        if (const Status again = renderer.render(frame); !again) return again.diagnostics();
    for (Picture& picture : pictures) {
        const Status read = readPicture(device, renderer, picture);
        if (!read) return read.diagnostics();
    }

    Diagnostics warnings = open.diagnostics();
    append(warnings, created.diagnostics());
    append(warnings, drawn.diagnostics());
    return {Summary{renderer.description().name, view.scene.name, open->context->description(),
                    view.extent, renderer.plan().views, triangleCount(view.scene),
                    renderer.plan().passes.size(), time.count()},
            std::move(warnings)};
}

Status writePictures(const std::vector<Picture>& pictures)
{
    Diagnostics all;
    for (const Picture& picture : pictures)
        append(all, writeImage(picture.request.file, picture.image).diagnostics());
    return all;
}

void printSummary(const Summary& summary, const std::vector<Picture>& pictures)
{
    std::fprintf(stderr, "%s: %d passes over %s, %lld triangles, %dx%d%s\n",
                 summary.config.c_str(), static_cast<int>(summary.passes), summary.scene.c_str(),
                 summary.triangles, summary.extent.width, summary.extent.height,
                 summary.views > 1 ? " an eye" : "");
    std::fprintf(stderr, "on %s\n", summary.device.c_str());
    std::fprintf(stderr, "drawn in %.1f ms (wall clock, first frame)\n", summary.ms);
    for (const Picture& picture : pictures)
        std::fprintf(stderr, "wrote %s (%s)\n", picture.request.file.c_str(),
                     picture.request.name.c_str());
}

void printJson(const Summary& summary, const std::vector<Picture>& pictures,
               const Diagnostics& warnings)
{
    nlohmann::json files = nlohmann::json::array();
    for (const Picture& picture : pictures)
        files.push_back({{"name", picture.request.name}, {"file", picture.request.file}});
    const nlohmann::json json = {
        {"config", summary.config},
        {"scene", summary.scene},
        {"triangles", summary.triangles},
        {"width", summary.extent.width},
        {"height", summary.extent.height},
        {"views", summary.views},
        {"passes", summary.passes},
        {"device", summary.device},
        {"first_frame_ms", summary.ms},
        {"files", files},
        {"diagnostics", nlohmann::json::parse(toJson(warnings))},
    };
    std::puts(json.dump(2).c_str());
}

int render(const RenderOptions& options)
{
    Result<std::vector<Picture>> pictures = readRequests(options.out);
    if (!pictures) return report(pictures.diagnostics(), options.json);
    const bool saves = !options.save_patch.empty();
    if (saves)
        if (const Status patch = checkPatchFile(options.config, options.save_patch); !patch)
            return report(patch.diagnostics(), options.json);
    const CheckoutSources sources(options.config.checkout);
    Result<Description> description = loadDescription(options.config, sources);
    if (!description) return report(description.diagnostics(), options.json);
    const Result<std::vector<std::string>> outputs = exposeAll(*pictures, *description);
    if (!outputs) return report(outputs.diagnostics(), options.json);

    Progress progress;
    progress.begin("loading " + options.scene.scene);
    const Result<SceneView> view = loadSceneView(options.scene);
    const Result<Summary> summary =
        view ? draw(options, *view, *description, *outputs, *pictures, progress) : view.diagnostics();
    progress.wipe();
    if (!summary) return report(summary.diagnostics(), options.json);

    const Status written = writePictures(*pictures);
    if (!written) return report(written.diagnostics(), options.json);
    if (saves)
        if (const Status patch = savePatch(options.config, sources, options.save_patch); !patch)
            return report(patch.diagnostics(), options.json);
    Diagnostics warnings = description.diagnostics();
    for (const Diagnostics* more :
         {&view.diagnostics(), &summary.diagnostics(), &written.diagnostics()})
        append(warnings, *more);
    if (options.json) {
        printJson(*summary, *pictures, warnings);
    } else {
        report(warnings, false);
        printSummary(*summary, *pictures);
    }
    return kExitOk;
}

}  // namespace

void addRenderCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("render", "Draw a scene through a config");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("CONFIG", options->config.config, "A shipped config's name, or a file")
        ->required();
    addSceneOptions(*command, options->scene);
    addStereoOptions(*command, options->stereo);
    addConfigOptions(*command, options->config);
    addBackendOption(*command, options->backend);
    command->add_option("--out", options->out,
                        "What to write where: an output, a debug view or a target (target.NAME where "
                        "an output has that name), to .png or .pfm; may be repeated")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->capture_default_str();
    command->add_option("--frames", options->frames,
                        "How many to draw before the last is written; configs that gather over "
                        "frames need several")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--save-patch", options->save_patch,
                        "Write a config that extends CONFIG and says what --variant and --set changed")
        ->type_name("FILE.json");
    command->add_flag("--json", options->json, "Print the summary and diagnostics as JSON");
    command->footer("Examples:\n"
                    "  crevice render learnopengl\n"
                    "  crevice render learnopengl --scene model.glb --size 1920x1080 --set radius=0.8 \\\n"
                    "      --out color=lit.png --out ao=ao.pfm\n"
                    "  crevice render my.json --scene room --camera 'eye=4,2,6;at=0,1,0;fov=50'");
    command->callback([options, &exit_code] { exit_code = render(*options); });
}

}  // namespace crevice
