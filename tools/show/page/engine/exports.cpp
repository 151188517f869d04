// SPDX-License-Identifier: MIT
// The page's library: a canvas, a scene in it, configs that draw it, and what is known of them; as
// functions that JavaScript calls, numbers and text in, JSON out.
// src/engine/engine.js is its other side, and documents them.
//
// What is returned is good until the next call. An answer has "ok" and "diagnostics".
#include "tools/show/page/engine/parts.h"

#include <crevice/gl_device.h>

#include "tools/render/image/image_metrics.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/show/plan/print.h"

#include <emscripten/html5.h>

#include <cmath>

namespace crevice::page {
namespace {

constexpr double kHeatRange = 0.25;  // of visibility: an error of that is full colour

/// Lives as long as the page.
struct {
    std::unique_ptr<Device> device;
    std::optional<Display> display;
    std::optional<Stage> stage;
    std::array<Slot, 4> slots;
    Chooser chooser;
    Frame frame;       // of the last draw
    FrameTimes times;  // of what was timed last for the chooser
    Extent extent;
    std::string scene_bytes;
    Image read_image;
} engine;

/// A slot, and which of its outputs, views or targets.
struct Side {
    int slot = 0;
    std::string show;
};

/// Makes a WebGL 2 context on the canvas that the selector names. Errors: those of makeGlDevice and
/// Display::create; CV6004 where the browser gives no context.
Status openCanvas(const std::string& canvas, const std::string& display_config,
                  const std::string& display_shader, Extent size)
{
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.antialias = wanted.depth = false;
    wanted.preserveDrawingBuffer = true;  // so that the picture can be saved at any time
    const auto context = emscripten_webgl_create_context(canvas.c_str(), &wanted);
    if (context <= 0)
        return Diagnostic{Code::gl_version, "this browser gives no WebGL 2 context",
                          "switch hardware acceleration on, or try another browser"};
    emscripten_webgl_make_context_current(context);
    GlDeviceOptions options;
    // The context is the page's alone, and to ask for its state takes 10 ms a frame.
    options.restore_state = false;
    auto made = makeGlDevice(emscripten_webgl_get_proc_address, options);
    if (!made) return made.diagnostics();
    Result<Display> shown = Display::create(**made, display_config, display_shader, size);
    if (!shown) return shown.diagnostics();
    engine.device = std::move(*made);
    engine.display = std::move(*shown);
    engine.stage.emplace(*engine.device);
    engine.extent = size;
    return {};
}

/// Of the display and of all slots. Errors: those of Renderer::resize.
Status resizeAll(Extent size)
{
    Status status = engine.display->resize(size);
    if (!status) return status;
    engine.extent = size;
    Diagnostics diagnostics;
    for (Slot& slot : engine.slots)
        if (slot.loaded()) append(diagnostics, slot.renderer().resize(size).diagnostics());
    return diagnostics;
}

/// What a slot shows under a name, as values. Errors: those of sourceOf and Device::readTexture.
Result<Image> readPicture(const Side& side)
{
    const Slot& slot = engine.slots[side.slot];
    const Result<OutputSource> source = slot.sourceOf(side.show);
    if (!source) return source.diagnostics();
    return readOutput(*engine.device, slot.renderer(), source->output);
}

Result<Shown> shownOf(const Side& side)
{
    const Slot& slot = engine.slots[side.slot];
    const Result<OutputSource> source = slot.sourceOf(side.show);
    if (!source) return source.diagnostics();
    const TextureId texture = slot.renderer().output(source->output);
    const FormatInfo& format = formatInfo(engine.device->info(texture).format);
    if (side.show == "doubt") return Shown{texture, float(1 / kHeatRange), 0, true, true};
    const bool plain = source->scale == 1.0f && source->offset == 0.0f;
    const bool bounded = format.format_class == FormatClass::unorm || side.show == "color";
    if (!plain || bounded)
        return Shown{texture, source->scale, source->offset, format.channels == 1};
    const Result<Image> image = engine.device->readTexture(texture);
    if (!image) return image.diagnostics();
    return stretched(texture, *image, format.format_class == FormatClass::depth);
}

/// Draws both sides' slots, and the canvas, of whose width `share` shows `left`. Errors: those of
/// chooseCamera, of Renderer::render and of sourceOf.
Status drawSides(const std::string& camera, const Side& left, const Side& right, float share)
{
    const Result<SceneCamera> chosen = engine.stage->camera(camera, engine.extent);
    if (!chosen) return chosen.diagnostics();
    engine.frame = engine.stage->frameOf(*chosen, engine.extent);
    const bool split = share < 1.0f;
    Diagnostics diagnostics;
    Status drawn = engine.slots[left.slot].renderer().render(engine.frame);
    append(diagnostics, drawn.diagnostics());
    if (drawn && split && right.slot != left.slot) {
        drawn = engine.slots[right.slot].renderer().render(engine.frame);
        append(diagnostics, drawn.diagnostics());
    }
    if (!drawn) return diagnostics;
    const Result<Shown> one = shownOf(left);
    if (!one) return one.diagnostics();
    const Result<Shown> other = split ? shownOf(right) : one;
    if (!other) return other.diagnostics();
    append(diagnostics, engine.display->draw(*one, *other, share).diagnostics());
    return diagnostics;
}

/// What was drawn, planned or compiled, and how long that took.
template <class Change>
Json measured(Change&& change)
{
    const double begin = emscripten_get_now();
    Json json = answer(change());
    json["ms"] = emscripten_get_now() - begin;
    return json;
}

Side sideOf(const Json& json) { return {json.value("slot", 0), json.value("show", "color")}; }

const char* methodOf(TimingMethod method)
{
    const char* const names[] = {"a clock around each pass", "timer queries",
                                 "the processor's time"};
    return names[static_cast<int>(method)];
}

/// The slot after all others: what is to be timed for the chooser.
bool isChoosers(int slot) { return slot == static_cast<int>(engine.slots.size()); }

Renderer& rendererOf(int slot)
{
    return isChoosers(slot) ? engine.chooser.due()->renderer() : engine.slots[slot].renderer();
}

Json timesJson(int slot, const FrameTimes& times)
{
    if (isChoosers(slot)) engine.times = times;
    const Plan& plan = rendererOf(slot).plan();
    Json json = {
        {"passes", Json::array()}, {"total_ms", times.total_ms}, {"by", methodOf(times.method)}};
    for (std::size_t i = 0; i < times.pass_ms.size(); ++i)
        json["passes"].push_back({{"name", plan.passes[i].name}, {"ms", times.pass_ms[i]}});
    return json;
}

}  // namespace

EXPORT const char* page_open(const char* canvas, const char* config, const char* shader, int width,
                             int height)
{
    Json json = answer(openCanvas(canvas, config, shader, {width, height}));
    if (json["ok"]) json["timer"] = engine.device->caps().timers;
    return say(json);
}

// ---- Scenes

EXPORT const char* page_builtin_scenes()
{
    auto names = Json::array();
    for (const std::string& name : builtinSceneNames())
        if (!needsFile(name)) names.push_back(name);
    return say(names);
}

EXPORT const char* page_show_builtin_scene(const char* name)
{
    Result<Scene> scene = builtinScene(name);
    return say(scene ? answer(engine.stage->show(std::move(*scene))) : answer(scene));
}

EXPORT const char* page_show_scene_bytes(const char* data, int size, const char* name)
{
    Result<Scene> scene = sceneFromBytes({data, static_cast<std::size_t>(size)});
    if (!scene) return say(answer(scene));
    scene->name = name;
    return say(answer(engine.stage->show(std::move(*scene))));
}

EXPORT const char* page_scene() { return say(engine.stage->state()); }

EXPORT int page_scene_bytes()
{
    engine.scene_bytes = sceneBytes(engine.stage->scene());
    return static_cast<int>(engine.scene_bytes.size());
}

EXPORT const char* page_bytes() { return engine.scene_bytes.data(); }

// ---- Cameras

EXPORT const char* page_resolve_camera(const char* text, double aspect)
{
    const Extent extent = {static_cast<int>(std::lround(1000 * aspect)), 1000};
    const Result<Json> camera = engine.stage->resolve(text, extent);
    Json json = answer(camera);
    if (camera) json.update(*camera);
    return say(json);
}

// ---- Slots

EXPORT const char* page_load(int slot, const char* text)
{
    const Json json = Json::parse(text);
    SlotRequest request;
    request.config = json.value("config", "");
    request.variant = json.value("variant", "");
    request.outputs = json.value("outputs", std::vector<std::string>{"color", "ao"});
    request.look = json.value("look", "");
    request.file_scene = isFileScene(engine.stage->scene().name);
    engine.frame.scale.diagonal = engine.stage->scene().bounds().diagonal();
    request.without_occlusion = json.value("without_occlusion", false);
    return say(measured([&] {
        return engine.slots[slot].load(*engine.device, sources(), request, engine.extent,
                                       engine.frame);
    }));
}

EXPORT const char* page_state(int slot)
{
    return say(engine.slots[slot].loaded() ? engine.slots[slot].state() : Json(nullptr));
}

EXPORT const char* page_plan(int slot) { return say(toJson(engine.slots[slot].renderer().plan())); }

EXPORT const char* page_plan_text(int slot)
{
    return say(toText(engine.slots[slot].renderer().plan()));
}

EXPORT const char* page_set_param(int slot, const char* name, const char* values)
{
    const auto numbers = Json::parse(values).get<std::vector<float>>();
    return say(measured([&] { return engine.slots[slot].setParam(name, numbers); }));
}

EXPORT const char* page_set_feature(int slot, const char* name, const char* word)
{
    return say(measured([&] { return engine.slots[slot].setFeature(name, word); }));
}

EXPORT const char* page_patch(int slot)
{
    const Result<std::string> patch = engine.slots[slot].patch(sources());
    Json json = answer(patch);
    if (patch) json["text"] = *patch;
    return say(json);
}

// ---- Drawing

EXPORT const char* page_resize(int width, int height)
{
    return say(answer(resizeAll({width, height})));
}

EXPORT const char* page_draw(const char* text)
{
    const Json json = Json::parse(text);
    const bool split = json.contains("right") && json["right"].is_object();
    const Side right = split ? sideOf(json["right"]) : Side();
    const float share = split ? json.value("split", 0.5f) : 1.0f;
    return say(measured(
        [&] { return drawSides(json.value("camera", ""), sideOf(json["left"]), right, share); }));
}

EXPORT const char* page_timed(int slot)
{
    const Frame& frame = isChoosers(slot) ? engine.chooser.due()->frame() : engine.frame;
    const Result<FrameTimes> times = rendererOf(slot).renderTimed(frame);
    Json json = answer(times);
    if (times) json.update(timesJson(slot, *times));
    return say(json);
}

EXPORT const char* page_start_timing(int slot, int on)
{
    return say(answer(rendererOf(slot).setTiming(on != 0)));
}

/// Draws every pass anew for the view that was drawn last, without a wait.
EXPORT const char* page_again(int slot)
{
    const auto revision = ++engine.frame.revision;
    Frame frame = isChoosers(slot) ? engine.chooser.due()->frame() : engine.frame;
    frame.revision = revision;
    return say(answer(rendererOf(slot).render(frame)));
}

/// What the latest frames took that were measured without a wait; null before there are any.
EXPORT const char* page_times(int slot)
{
    const bool loaded = isChoosers(slot) || engine.slots[slot].loaded();
    const FrameTimes* times = loaded ? rendererOf(slot).times() : nullptr;
    return say(times ? timesJson(slot, *times) : Json(nullptr));
}

// ---- Which config to take

/// {"camera", "budget", "error"}, of which the last two may lack.
EXPORT const char* page_choose(const char* text)
{
    return say(answer(
        engine.chooser.begin(*engine.device, *engine.stage, engine.extent, Json::parse(text))));
}

/// Adds "more", "due" (the slot after all others is to be timed next), "lines" and "found".
EXPORT const char* page_choose_step() { return say(engine.chooser.step()); }

/// As page_choose_step, once what was due is timed.
EXPORT const char* page_choose_timed() { return say(engine.chooser.add(engine.times)); }

/// Adds "text": a config that says what was found.
EXPORT const char* page_found(const char* text) { return say(Chooser::textOf(Json::parse(text))); }

// ---- Pixels

/// Reads what a slot shows into page_pixels: {"extent", "channels", "format"}.
EXPORT const char* page_read(int slot, const char* show)
{
    Result<Image> read = readPicture({slot, show});
    Json json = answer(read);
    if (!read) return say(json);
    engine.read_image = std::move(*read);
    json["extent"] = {engine.read_image.extent.width, engine.read_image.extent.height};
    json["channels"] = engine.read_image.channels;
    return say(json);
}

EXPORT const float* page_pixels() { return engine.read_image.pixels.data(); }

/// Reads a slot's "ao" and compares it with `truth`, of the canvas's size; `heat`, where it is not
/// null, becomes the difference as 4 bytes a pixel, highest row first.
EXPORT const char* page_compare(int slot, const float* truth, std::uint8_t* heat)
{
    const Result<Image> ao = readPicture({slot, "ao"});
    if (!ao) return say(answer(ao));
    Image ground_truth(engine.extent, 1);
    std::copy(truth, truth + ground_truth.pixels.size(), ground_truth.pixels.begin());
    const auto figures = compareImages(*ao, ground_truth, nullptr, 0.05, false);
    Json json = answer(figures);
    if (!figures) return say(json);
    json.update({{"rmse", figures->rmse},
                 {"bias", figures->bias},
                 {"p99", figures->p99},
                 {"range", kHeatRange}});
    const Result<Image> picture =
        heat ? differencePicture(*ao, ground_truth, nullptr, kHeatRange) : Result<Image>(Image());
    if (!heat || !picture) return say(json);
    const Extent extent = picture->extent;
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x, heat += 4) {
            for (int k = 0; k < 3; ++k)
                heat[k] = static_cast<std::uint8_t>(
                    std::lround(255 * picture->at(x, extent.height - 1 - y, k)));
            heat[3] = 255;
        }
    return say(json);
}

}  // namespace crevice::page
