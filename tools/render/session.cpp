// SPDX-License-Identifier: MIT
#include "tools/render/session.h"

#include "tools/commands/cli/output.h"
#include "tools/render/glsl/glsl_check.h"
#include "tools/render/image/image_file.h"
#include "tools/render/view_diagnosis.h"
#include "tools/show/plan/print.h"

namespace crevice {
namespace {

double millisecondsSince(double start_s) { return (clockSeconds() - start_s) * 1e3; }

/// Gives the milliseconds by the wall clock, the wait for the GPU included.
Result<double> timeFirst(Session& session, const Frame& frame)
{
    Device& device = *session.open.device;
    device.finish();
    const double start_s = clockSeconds();
    const Status drawn = session.renderer->render(frame);
    if (!drawn) return drawn.diagnostics();
    device.finish();
    return {millisecondsSince(start_s), drawn.diagnostics()};
}

Status readPicture(Device& device, const Renderer& renderer, Picture& picture)
{
    Result<Image> image = readOutput(device, renderer, picture.source.output);
    if (!image) return image.diagnostics();
    picture.image = std::move(*image);
    applyView(picture.image, picture.source);
    if (!picture.request.file.empty() || picture.image.extent == Extent{1, 1}) return {};
    const std::string& name = picture.request.name;
    return Diagnostic{Code::usage,
                      "'" + name + "' is a picture of " + sizeText(picture.image.extent) +
                          ", and --out names no file for it",
                      "write --out " + name + "=" + name + ".png"};
}

}  // namespace

Result<std::vector<Picture>> readRequests(const RenderOptions& options)
{
    const bool frames = !options.path.empty();
    if (frames)
        if (const auto path = findCameraPath(options.path); !path) return path.diagnostics();
    std::vector<Picture> pictures;
    for (const std::string& text : options.out) {
        const Result<NamedFile> request = parseOutputRequest(text);
        if (!request) return request.diagnostics();
        if (request->file.empty() && !frames) {  // a number, to be printed
            pictures.push_back({*request, {}});
            continue;
        }
        if (frames)
            if (const Status known = checkFramePattern(request->file); !known)
                return known.diagnostics();
        const Status writable = checkWritable(request->file);
        if (!writable) return writable.diagnostics();
        const auto whole = [](const std::string& file) {
            return std::filesystem::absolute(file).lexically_normal();
        };
        for (const Picture& other : pictures)
            if (!other.request.file.empty() && whole(other.request.file) == whole(request->file))
                return Diagnostic{Code::usage, "two --out write '" + request->file + "'",
                                  "give each a file of its own"};
        pictures.push_back({*request, {}});
    }
    return pictures;
}

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

Status checkShaders(Session& session, const Description& description, const CompileOptions& options)
{
    if (description.files.empty()) return {};  // baked, and without places to tell
    Device& device = *session.open.device;
    const Result<Plan> plan = compile(description, traitsOf(session.frame), device.caps(), options);
    GlslCheck shaders;
    if (plan) shaders.add(*plan);
    return shaders.check(description, &device);
}

Result<std::string> fitToView(Session& session, Description& description)
{
    if (session.pictures) {
        session.pictures->fitFormats(description);
        return resolveLengths(description, *session.pictures);
    }
    const Extent extent = session.options.extent;
    return resolveLengths(
        description, session.frame.camera, extent, session.scene->bounds().diagonal(),
        [&] { return medianDistance(*session.open.device, session.frame, extent); });
}

Result<Session> openSession(const RenderOptions& options, const SceneView& view,
                            std::optional<HostPictures> pictures, Description description,
                            const std::vector<std::string>& outputs, Progress& progress)
{
    Session session;
    session.options.extent = view.extent;
    session.options.outputs = outputs;
    session.options.disable = options.disable;
    Result<OpenDevice> open = openDevice(options.backend, options.precision, options.program_cache);
    if (!open) return open.diagnostics();
    session.open = std::move(*open);
    Device& device = *session.open.device;
    progress.begin("uploading the scene");
    Result<UploadedScene> scene = UploadedScene::upload(device, view.scene);
    if (!scene) return scene.diagnostics();
    session.scene = std::move(*scene);
    session.frame = makeFrame(*session.scene, view.camera, view.extent);
    session.pictures = std::move(pictures);
    if (session.pictures)
        if (Status there = session.pictures->upload(device, session.frame); !there)
            return there.diagnostics();
    const Result<std::string> lengths = fitToView(session, description);
    if (!lengths) return lengths.diagnostics();
    session.lengths = *lengths;
    Result<HostTextures> host =
        HostTextures::make(device, description, view.extent, session.frame, options.textures);
    if (!host) return host.diagnostics();
    session.host = std::move(*host);
    const Result<Frame> frame = session.host->frameOf(session.frame);
    if (!frame) return frame.diagnostics();
    progress.begin("compiling shaders");
    if (const Status right = checkShaders(session, description, session.options); !right)
        return right.diagnostics();
    const double plan_s = clockSeconds();
    (void)compile(description, traitsOf(*frame), device.caps(), session.options).ok();
    session.plan_ms = millisecondsSince(plan_s);
    const double start_s = clockSeconds();
    Result<std::unique_ptr<Renderer>> created =
        Renderer::create(device, std::move(description), session.options, traitsOf(*frame));
    if (!created) return created.diagnostics();
    session.create_ms = millisecondsSince(start_s);
    session.renderer = std::move(*created);
    if (options.warm) {
        const double warm_s = clockSeconds();
        for (Result<bool> ready = false; !*ready;) {
            ready = session.renderer->warm(*frame);
            if (!ready) return ready.diagnostics();
        }
        device.finish();
        session.warm_ms = millisecondsSince(warm_s);
    }
    Diagnostics warnings = open.diagnostics();
    append(warnings, created.diagnostics());
    return {std::move(session), std::move(warnings)};
}

Result<double> draw(const RenderOptions& options, Session& session, std::vector<Picture>& pictures)
{
    const Result<Frame> frame = session.host->frameOf(session.frame);
    if (!frame) return frame.diagnostics();
    const Result<double> first = timeFirst(session, *frame);
    if (!first) return first;
    for (int i = 1; i < options.frames; ++i)
        if (const Status again = session.renderer->render(*frame); !again)
            return again.diagnostics();
    for (Picture& picture : pictures) {
        const Status read = readPicture(*session.open.device, *session.renderer, picture);
        if (!read) return read.diagnostics();
    }
    return first;
}

Result<double> drawPath(const RenderOptions& options, const SceneView& view, Session& session,
                        std::vector<Picture>& pictures)
{
    const Result<CameraPath> path = findCameraPath(options.path);
    if (!path) return path.diagnostics();
    const Result<Image> depth = drawDepth(*session.open.device, session.frame, view.extent);
    if (!depth) return depth.diagnostics();
    const double distance = medianDistance(*depth, session.frame.camera).value_or(1.0);
    const PathView end = {view.camera, view.extent, distance};
    const int frames = options.frames > 0 ? options.frames : kPathFrames;
    RenderOptions one = options;
    one.frames = 1;
    Result<double> first = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        const SceneCamera camera = cameraAt(*path, end, frame, frames);
        session.frame = makeFrame(*session.scene, camera, view.extent);
        const Result<double> ms = draw(one, session, pictures);
        if (!ms) return ms;
        if (frame == 0) first = ms;
        std::vector<Picture> named = pictures;
        for (Picture& picture : named)
            picture.request.file = frameFile(picture.request.file, frame);
        if (const Status written = writePictures(named); !written) return written.diagnostics();
    }
    return first;
}

Status writePictures(const std::vector<Picture>& pictures)
{
    Diagnostics all;
    for (const Picture& picture : pictures)
        if (!picture.request.file.empty())
            append(all, writeImage(picture.request.file, picture.image).diagnostics());
    return all;
}

}  // namespace crevice
