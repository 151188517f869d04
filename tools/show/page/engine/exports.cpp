// SPDX-License-Identifier: MIT
// The engine as functions that JavaScript calls: numbers and text in, JSON out.
// src/engine/engine.js is its other side, and documents them.
//
// What is returned is good until the next call. An answer has "ok" and "diagnostics".
#include "tools/show/page/engine/answers.h"
#include "tools/show/page/engine/engine.h"

#include <crevice/shipped.h>

#include "tools/render/image/image_metrics.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/scene_bytes.h"
#include "tools/show/plan/print.h"
#include "tools/show/schema/schema.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace crevice::page {

Engine engine;

namespace {

constexpr double kHeatRange = 0.25;  // of visibility: an error of that is full colour

std::string scene_bytes;
Image read_image;

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
    switch (method) {
    case TimingMethod::gpu_timer: return "timer queries";
    case TimingMethod::processor_time: return "the processor's time";
    default: return "a clock around each pass";
    }
}

Json timesJson(int slot, const FrameTimes& times)
{
    const Plan& plan = engine.slot(slot).renderer().plan();
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
    Json json = answer(engine.open(canvas, config, shader, {width, height}));
    if (json["ok"]) json["timer"] = engine.device().caps().timers;
    return say(json);
}

/// The text in force, or the shipped one; null where there is none.
EXPORT const char* page_source(const char* path, int shipped)
{
    const SourceRef source =
        shipped ? shippedSources().find(path) : engine.texts().sources().find(path);
    return say(source ? Json(source->text) : Json(nullptr));
}

EXPORT void page_set_source(const char* path, const char* text)
{
    if (text)
        engine.texts().set(path, text);
    else
        engine.texts().reset(path);
}

EXPORT const char* page_edited_paths() { return say(Json(engine.texts().edited())); }

EXPORT const char* page_configs() { return say(engine.texts().configs()); }

EXPORT const char* page_schema() { return say(schemaJson(engine.texts().sources())); }

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
    return say(scene ? answer(engine.stage().show(std::move(*scene))) : answer(scene));
}

EXPORT const char* page_show_scene_bytes(const char* data, int size, const char* name)
{
    Result<Scene> scene = sceneFromBytes({data, static_cast<std::size_t>(size)});
    if (!scene) return say(answer(scene));
    scene->name = name;
    return say(answer(engine.stage().show(std::move(*scene))));
}

EXPORT const char* page_scene() { return say(engine.stage().state()); }

EXPORT int page_scene_bytes()
{
    scene_bytes = sceneBytes(engine.stage().scene());
    return static_cast<int>(scene_bytes.size());
}

EXPORT const char* page_bytes() { return scene_bytes.data(); }

// ---- Cameras

EXPORT const char* page_resolve_camera(const char* text, double aspect)
{
    const Extent extent = {static_cast<int>(std::lround(1000 * aspect)), 1000};
    const Result<Json> camera = engine.stage().resolve(text, extent);
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
    request.without_occlusion = json.value("without_occlusion", false);
    return say(measured([&] { return engine.load(slot, request); }));
}

EXPORT const char* page_state(int slot)
{
    return say(engine.slot(slot).loaded() ? engine.slot(slot).state() : Json(nullptr));
}

EXPORT const char* page_plan(int slot) { return say(toJson(engine.slot(slot).renderer().plan())); }

EXPORT const char* page_plan_text(int slot)
{
    return say(toText(engine.slot(slot).renderer().plan()));
}

EXPORT const char* page_set_param(int slot, const char* name, const char* values)
{
    const auto numbers = Json::parse(values).get<std::vector<float>>();
    return say(measured([&] { return engine.slot(slot).setParam(name, numbers); }));
}

EXPORT const char* page_set_feature(int slot, const char* name, const char* word)
{
    return say(measured([&] { return engine.slot(slot).setFeature(name, word); }));
}

EXPORT const char* page_patch(int slot)
{
    const Result<std::string> patch = engine.slot(slot).patch(engine.texts().sources());
    Json json = answer(patch);
    if (patch) json["text"] = *patch;
    return say(json);
}

// ---- Drawing

EXPORT const char* page_resize(int width, int height)
{
    return say(answer(engine.resize({width, height})));
}

EXPORT const char* page_draw(const char* text)
{
    const Json json = Json::parse(text);
    DrawRequest request;
    request.camera = json.value("camera", "");
    request.left = sideOf(json["left"]);
    if (json.contains("right") && json["right"].is_object()) {
        request.right = sideOf(json["right"]);
        request.split = json.value("split", 0.5f);
    }
    return say(measured([&] { return engine.draw(request); }));
}

EXPORT const char* page_timed(int slot)
{
    const Result<FrameTimes> times = engine.timed(slot);
    Json json = answer(times);
    if (times) json.update(timesJson(slot, *times));
    return say(json);
}

EXPORT const char* page_start_timing(int slot, int on)
{
    return say(answer(engine.slot(slot).renderer().setTiming(on != 0)));
}

EXPORT const char* page_again(int slot) { return say(answer(engine.again(slot))); }

/// What the latest frames took that were measured without a wait; null before there are any.
EXPORT const char* page_times(int slot)
{
    const FrameTimes* times =
        engine.slot(slot).loaded() ? engine.slot(slot).renderer().times() : nullptr;
    return say(times ? timesJson(slot, *times) : Json(nullptr));
}

/// Reads what a slot shows into page_pixels: {"extent", "channels", "format"}.
EXPORT const char* page_read(int slot, const char* show)
{
    Result<Image> read = engine.read({slot, show});
    Json json = answer(read);
    if (!read) return say(json);
    read_image = std::move(*read);
    json["extent"] = {read_image.extent.width, read_image.extent.height};
    json["channels"] = read_image.channels;
    return say(json);
}

EXPORT const float* page_pixels() { return read_image.pixels.data(); }

/// Reads a slot's "ao" and compares it with `truth`, of the canvas's size; `heat`, where it is not
/// null, becomes the difference as 4 bytes a pixel, highest row first.
EXPORT const char* page_compare(int slot, const float* truth, std::uint8_t* heat)
{
    const Result<Image> ao = engine.read({slot, "ao"});
    if (!ao) return say(answer(ao));
    Image ground_truth(engine.extent(), 1);
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
