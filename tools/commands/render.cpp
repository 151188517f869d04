// SPDX-License-Identifier: MIT
// crevice render: draws a scene through a config and writes what was asked for.
#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/commands/cli/watched_files.h"
#include "tools/commands/commands.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/session.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

#include "core/base/text.h"
#include "core/plan/depth_precision.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <thread>

namespace crevice {
namespace {

/// What a picture of another size than the view's is; nothing of others.
std::string otherSize(const Picture& picture, Extent view)
{
    const Extent& size = picture.image.extent;
    if (size == view || size.width == 0) return {};
    const bool band = size.width > view.width && size.height > view.height;
    return ", " + sizeText(size) +
           (band ? ": the view and around it the guard band, which --set guard_band=1 leaves out"
                 : "");
}

/// With the modules laid over it, which the description's name lacks.
std::string nameOf(const RenderOptions& options, const Session& session)
{
    const bool more = has(options.config.config, "+");
    return more ? options.config.config : session.renderer->description().name;
}

/// What is drawn, and where: `ms` is the wall clock of the first frame.
void printSummary(const RenderOptions& options, const Session& session, const SceneView& view,
                  const std::vector<Picture>& pictures, double ms)
{
    const Renderer& renderer = *session.renderer;
    printMessage("%s: %d passes over %s, %lld triangles, %dx%d\n",
                 printableLine(nameOf(options, session)).c_str(),
                 static_cast<int>(renderer.plan().passes.size()),
                 printableLine(view.scene.name).c_str(), triangleCount(view.scene),
                 view.extent.width, view.extent.height);
    if (!session.lengths.empty()) printMessage("%s\n", session.lengths.c_str());
    if (!session.pictures)
        printMessage("camera '%s'\n", cameraText(view.camera, view.bounds).c_str());
    for (const HostTextures::Picture& each : session.host->pictures())
        printMessage("%s is %s\n", each.name.c_str(), printableLine(each.file).c_str());
    printMessage("on %s\n", session.open.context->description().c_str());
    printMessage("read in %s ms, planned in %s ms, compiled in %s ms (wall clock)\n",
                 fixed(options.read_ms, 1).c_str(), fixed(session.plan_ms, 1).c_str(),
                 fixed(std::max(session.create_ms - session.plan_ms, 0.0), 1).c_str());
    if (options.warm) printMessage("warmed in %s ms\n", fixed(session.warm_ms, 1).c_str());
    if (const ProgramFolder* programs = session.open.programs.get();
        programs && programs->asked() > 0)
        printMessage("%d of %d programs came from the cache\n", programs->found(),
                     programs->asked());
    else if (programs)
        printMessage("no programs are cached: the driver has no program binaries\n");
    printMessage("drawn in %s ms (wall clock, first frame)\n", fixed(ms, 1).c_str());
    if (options.frames == 0 && options.path.empty() && remembers(renderer.plan()))
        printMessage("this is frame 1 of a config that accumulates: --frames %d draws its mean\n",
                     kGatheringFrames);
    for (const Picture& picture : pictures)
        if (picture.request.file.empty())
            print("%s is %s\n", picture.request.name.c_str(),
                  significant(picture.image.pixels[0], 3).c_str());
    for (const Picture& picture : pictures)
        if (!picture.request.file.empty())
            printMessage("wrote %s (%s%s)\n", printableLine(picture.request.file).c_str(),
                         printableLine(picture.request.name).c_str(),
                         otherSize(picture, view.extent).c_str());
}

void printJson(const RenderOptions& options, const Session& session, const SceneView& view,
               const std::vector<Picture>& pictures, double ms, const Diagnostics& warnings)
{
    const Renderer& renderer = *session.renderer;
    nlohmann::json files = nlohmann::json::array(), textures = nlohmann::json::object();
    for (const HostTextures::Picture& each : session.host->pictures())
        textures[each.name] = each.file;
    nlohmann::json values = nlohmann::json::object();
    for (const Picture& picture : pictures)
        if (picture.request.file.empty())
            values[picture.request.name] = picture.image.pixels[0];
        else
            files.push_back({{"name", picture.request.name}, {"file", picture.request.file}});
    nlohmann::json json = {
        {"config", nameOf(options, session)},
        {"scene", view.scene.name},
        {"triangles", triangleCount(view.scene)},
        {"width", view.extent.width},
        {"height", view.extent.height},
        {"passes", renderer.plan().passes.size()},
        {"device", session.open.context->description()},
        {"lengths", session.lengths},
        {"camera", session.pictures ? "" : cameraText(view.camera, view.bounds)},
        {"textures", std::move(textures)},
        {"read_ms", options.read_ms},
        {"plan_ms", session.plan_ms},
        {"create_ms", session.create_ms},
        {"first_frame_ms", ms},
        {"files", files},
        {"values", std::move(values)},
        {"diagnostics", nlohmann::json::parse(toJson(warnings))},
    };
    if (options.warm) json["warm_ms"] = session.warm_ms;
    if (const ProgramFolder* programs = session.open.programs.get())
        json["program_cache"] = {{"asked", programs->asked()}, {"found", programs->found()}};
    printAsJson(json);
}

/// Whether nobody knows the units of what is drawn, and the length to take then.
bool isUnfitted(const RenderOptions& options)
{
    return !options.pictures.files.empty() || isFileScene(options.scene.scene);
}
const char* lengthOf(const RenderOptions& options)
{
    return options.pictures.files.empty() ? kShareOfScene : "40px";
}

/// Loads the config, and adds the files that it is made of to those watched, whole or broken.
Result<Description> loadWatched(const RenderOptions& options, const SourceSet& sources,
                                WatchedFiles& files)
{
    const ConfigOptions& config = options.config;
    files.add(config.config);
    if (namesBaked(config)) return loadDescription(config, sources);
    const Result<Node> document = loadConfig(sources, requestOf(config));
    files.add(document.diagnostics());
    if (!document) return document.diagnostics();
    files.add(*document);
    Result<Description> description = decode(*document, sources, config.limits);
    files.add(description.diagnostics());
    if (!description) return description;
    files.add(*description);
    if (isUnfitted(options)) fitLengths(*description, *document, lengthOf(options));
    return description;
}

/// All or nothing: after an error the renderer, the pictures and their files are as they were.
Result<double> redraw(const RenderOptions& options, Session& session, Description description,
                      std::vector<Picture>& pictures)
{
    std::vector<Picture> next = pictures;
    if (const auto lengths = fitToView(session, description); !lengths)
        return lengths.diagnostics();
    const Result<std::vector<std::string>> outputs = exposeAll(next, description);
    if (!outputs) return outputs.diagnostics();
    CompileOptions compile_options = session.options;
    compile_options.outputs = *outputs;
    Result<HostTextures> host = HostTextures::make(
        *session.open.device, description, compile_options.extent, session.frame, options.textures);
    if (!host) return host.diagnostics();
    if (const Status right = checkShaders(session, description, compile_options); !right)
        return right.diagnostics();
    const Status reloaded = session.renderer->reload(std::move(description), compile_options);
    if (!reloaded) return reloaded.diagnostics();
    session.host = std::move(*host);
    const Result<double> ms = draw(options, session, next);
    if (!ms) return ms;
    const Status written = writePictures(next);
    if (!written) return written.diagnostics();
    session.options = compile_options;
    pictures = std::move(next);
    Diagnostics warnings = reloaded.diagnostics();
    append(warnings, ms.diagnostics());
    return {*ms, std::move(warnings)};
}

/// Draws again whenever a file of the config was saved, until it is interrupted.
int watch(const RenderOptions& options, const SourceSet& sources, Session& session,
          std::vector<Picture>& pictures)
{
    constexpr std::chrono::milliseconds kPause(100);  // below what a person notices after a save
    catchInterrupts();
    WatchedFiles files;
    (void)loadWatched(options, sources, files);
    printMessage("watching %s; interrupt to end\n", counted(files.size(), "file").c_str());
    for (; !interrupted(); std::this_thread::sleep_for(kPause)) {
        if (!files.changed()) continue;
        Result<Description> description = loadWatched(options, sources, files);
        const Result<double> ms = description
                                      ? redraw(options, session, std::move(*description), pictures)
                                      : description.diagnostics();
        report(description.diagnostics(), false);
        if (description) report(ms.diagnostics(), false);
        if (ms)
            printMessage("drawn again in %s ms\n", fixed(*ms, 1).c_str());
        else
            printMessage("the last pictures stay\n");
    }
    return kExitOk;
}

/// Whether the picture shows ambient occlusion.
Diagnostics checkPicture(Session& session, const SceneView& view,
                         const std::vector<Picture>& pictures)
{
    const auto ao = std::find_if(pictures.begin(), pictures.end(), [](const Picture& picture) {
        return picture.source.output == "ao";
    });
    const Renderer& renderer = *session.renderer;
    const Camera& camera = session.frame.camera;
    if (session.pictures) return {};
    const Result<Image> depth = drawDepth(*session.open.device, session.frame, view.extent);
    if (!depth) return {};
    return checkView(renderer.description(), renderer.plan(), view.scene, camera,
                     medianDistance(*depth, camera), ao == pictures.end() ? nullptr : &ao->image);
}

void showSummary(const RenderOptions& options, Session& session, const SceneView& view,
                 const std::vector<Picture>& pictures, double ms, Diagnostics warnings)
{
    const bool unfilled = anyOf(warnings, [](const Diagnostic& each) {
        return each.code == Code::unfilled_block;  // which explains the picture, as no radius does
    });
    if (!unfilled) append(warnings, checkPicture(session, view, pictures));
    if (session.open.programs) append(warnings, session.open.programs->warnings());
    if (options.json) return printJson(options, session, view, pictures, ms, warnings);
    report(warnings, false);
    printSummary(options, session, view, pictures, ms);
}

/// The patch alone was asked for, which needs no picture.
int saveAlone(const RenderOptions& options, const SourceSet& sources, Diagnostics diagnostics)
{
    append(diagnostics, savePatch(options.config, sources, options.save_patch).diagnostics());
    if (hasErrors(diagnostics)) return report(diagnostics, options.json);
    if (options.json) {
        printAsJson({{"config", options.config.config},
                     {"files", {options.save_patch}},
                     {"diagnostics", nlohmann::json::parse(toJson(diagnostics))}});
    } else {
        report(diagnostics, false);
        printMessage("wrote %s\n", printableLine(options.save_patch).c_str());
    }
    return kExitOk;
}

/// A scene without anything in it, seen as the pictures are.
Result<SceneView> loadView(const RenderOptions& options, const std::optional<HostPictures>& host)
{
    if (!host) return loadSceneView(options.scene);
    SceneView view = {{}, {}, {}, host->extent()};
    view.scene.name = "imported pictures";
    return view;
}

int render(RenderOptions options)
{
    Result<std::vector<Picture>> pictures = readRequests(options);
    if (!pictures) return report(pictures.diagnostics(), options.json);
    std::optional<HostPictures> host;
    if (!options.pictures.files.empty()) {
        Result<HostPictures> read = HostPictures::read(options.pictures, options.scene.camera);
        if (!read) return report(read.diagnostics(), options.json);
        host = std::move(*read);
        options.config.overrides.push_back(std::string("+") + host->module());
    }
    const bool saves = !options.save_patch.empty();
    if (saves)
        if (const Status patch = checkPatchFile(options.config, options.save_patch); !patch)
            return report(patch.diagnostics(), options.json);
    const CheckoutSources sources(options.config.checkout, options.config.roots);
    const double start_s = clockSeconds();
    Result<Description> description =
        loadDescription(options.config, sources, isUnfitted(options), lengthOf(options));
    options.read_ms = (clockSeconds() - start_s) * 1e3;
    if (!description) return report(description.diagnostics(), options.json);
    if (pictures->empty()) return saveAlone(options, sources, description.diagnostics());
    const Result<std::vector<std::string>> outputs = exposeAll(*pictures, *description);
    if (!outputs) return report(outputs.diagnostics(), options.json);

    Progress progress;
    progress.begin("loading " + options.scene.scene);
    const Result<SceneView> view = loadView(options, host);
    Result<Session> session =
        view ? openSession(options, *view, std::move(host), *description, *outputs, progress)
             : view.diagnostics();
    progress.begin("drawing");
    const bool moves = !options.path.empty();
    const Result<double> ms = !session ? session.diagnostics()
                              : moves  ? drawPath(options, *view, *session, *pictures)
                                       : draw(options, *session, *pictures);
    progress.wipe();
    if (!ms) return report(ms.diagnostics(), options.json);

    const Status written = moves ? Status() : writePictures(*pictures);
    if (!written) return report(written.diagnostics(), options.json);
    if (saves)
        if (const Status patch = savePatch(options.config, sources, options.save_patch); !patch)
            return report(patch.diagnostics(), options.json);
    Diagnostics warnings = description.diagnostics();
    for (const Diagnostics* more :
         {&view.diagnostics(), &session.diagnostics(), &ms.diagnostics(), &written.diagnostics()})
        append(warnings, *more);
    showSummary(options, *session, *view, *pictures, *ms, std::move(warnings));
    return options.watch ? watch(options, sources, *session, *pictures) : kExitOk;
}

void addPictureImports(CLI::App& app, HostPictureOptions& options)
{
    addList(app, "--import", options.files, "NAME=FILE",
            "Take another engine's pictures in place of a scene: depth, linear_depth or log_depth, "
            "and normal; or position and normal; from .exr, .pfm or .png, row 0 at the bottom of "
            "the view; may be repeated")
        ->excludes("--scene")
        ->excludes("--host-depth")
        ->excludes("--size");
    addText(
        app, "--projection", options.projection, "PROJECTION",
        "How they were projected: fov=DEGREES;near=D;far=D (or ortho=HEIGHT; shift=X,Y), or the "
        "16 numbers of the matrix by columns")
        ->needs("--import");
    app.add_flag("--zero-to-one", options.zero_to_one,
                 "Depth in their clip space runs from 0 to 1, as in Direct3D, Vulkan and Metal, "
                 "and not from -1")
        ->needs("--import");
}

void addPictureOptions(CLI::App& app, RenderOptions& options)
{
    addList(app, "--texture", options.textures, "NAME=FILE",
            "A picture for a texture that the config imports, such as environment=sky.hdr of "
            "lighting/metallic_roughness; may be repeated");
    addList(
        app, "--out", options.out, "NAME=FILE",
        "What to write where: an output, a debug view or a target (target.NAME where an output "
        "has that name), to .png, .pfm or .exr; a name alone, such as doubt_rmse, prints what is "
        "one number; may be repeated; with --host-depth ao=ao.png unless told")
        ->capture_default_str();
    app.add_option("--frames", options.frames,
                   "Number of frames to draw; the last one is written. Configs that accumulate "
                   "over frames need several. Default: 1, or 32 with --path")
        ->check(CLI::Range(1, 100000));
    std::string paths = "Move the camera, and write every frame to a file such as frame_%03d.png:";
    for (const CameraPath& path : kCameraPaths)
        paths +=
            std::string(&path == kCameraPaths ? " " : ", ") + path.name + " (" + path.what + ")";
    addText(app, "--path", options.path, "NAME", paths + ". The last frame is that of --camera");
    addText(app, "--save-patch", options.save_patch, "FILE.json",
            "Write a config that extends CONFIG and says what --variant and --set changed; draws "
            "nothing without --out");
}

}  // namespace

void addRenderCommand(CLI::App& app, int& exit_code)
{
    CLI::App* command = app.add_subcommand("render", "Draw a scene through a config");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("CONFIG", options->config.config, "A shipped config's name, or a file")
        ->required();
    addSceneOptions(*command, options->scene);
    addConfigOptions(*command, options->config);
    addPictureImports(*command, options->pictures);
    addDisableOption(*command, options->disable);
    addBackendOption(*command, options->backend);
    addPrecisionOption(*command, options->precision);
    addProgramCacheOption(*command, options->program_cache);
    command->add_flag("--warm", options->warm,
                      "Have the driver compile before the first frame what that would wait for");
    addPictureOptions(*command, *options);
    CLI::Option* json =
        command->add_flag("--json", options->json, "Print the summary and diagnostics as JSON");
    command
        ->add_flag(
            "--watch", options->watch,
            "Draw again whenever a file of the config is saved, until interrupted; after a bad "
            "edit the last pictures stay")
        ->excludes(json)
        ->excludes("--path");
    command->footer(
        "Examples:\n"
        "  crevice render learnopengl\n"
        "  crevice render learnopengl --scene model.glb --size 1920x1080 --set radius=0.8 \\\n"
        "      --out color=lit.png --out ao=ao.pfm\n"
        "  crevice render my.json --watch\n"
        "  crevice render gtao_temporal --path pan --out 'ao=frame_%03d.png'\n"
        "  crevice render gtao --import depth=a.exr --projection 'fov=50;near=0.1;far=100'\n"
        "  crevice render my.json --scene room --camera 'eye=4,2,6;at=0,1,0;fov=50'");
    command->callback([options, command, &exit_code] {
        const bool bare = command->count("--host-depth") + command->count("--import") > 0;
        const std::string name = bare ? "ao" : "color";
        if (command->count("--out") == 0) options->out.clear();
        if (options->out.empty() && options->save_patch.empty())
            options->out = {name + "=" + name + (options->path.empty() ? ".png" : "_%03d.png")};
        exit_code = render(*options);
    });
}

}  // namespace crevice
