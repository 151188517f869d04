// SPDX-License-Identifier: MIT
// crevice in a web page, on WebGL 2: the page calls `draw` whenever its controls change. Its
// configs are baked, so that the page downloads what draws alone.
#include "scene.h"

#include <crevice/baked.h>
#include <crevice/effect.h>
#include <crevice/gl_device.h>

#include <emscripten.h>
#include <emscripten/html5.h>
#include <web_configs.h>

#include <optional>

using namespace crevice;

namespace {

/// Lives as long as the page.
struct Page {
    std::unique_ptr<Device> device;
    Frame scene;
    std::string config;
    std::optional<Effect> effect;
    std::string message;
};

Page page;

Status openDevice()
{
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.antialias = wanted.depth = false;  // the effect brings its own depth
    emscripten_webgl_make_context_current(emscripten_webgl_create_context("#canvas", &wanted));
    auto device = makeGlDevice(emscripten_webgl_get_proc_address);
    if (!device) return device.diagnostics();
    page.device = std::move(*device);
    return example::addScene(*page.device, page.scene);
}

Status show(const std::string& config, float radius, float turn_rad, Extent extent)
{
    if (!page.device)
        if (Status status = openDevice(); !status) return status;
    if (config != page.config) {
        auto all = readBaked(web_configs, web_configs_size);
        auto one = all ? bakedConfig(std::move(*all), config) : all.diagnostics();
        if (!one) return one.diagnostics();
        auto effect = Effect::create(*page.device, *one, extent);
        if (!effect) return effect.diagnostics();
        page.effect.emplace(std::move(*effect));
        page.config = config;
        page.effect->frame() = page.scene;
    }
    page.effect->frame().camera = example::cameraAt(turn_rad, extent);
    Status status = page.effect->setParam("radius", radius);
    if (status) status = page.effect->render();
    if (!status) return status;
    return page.device->present(page.effect->output("color"), {0, 0, 0, extent});
}

}  // namespace

/// Draws into the page's canvas, of that size; "" or what went wrong. Radius in metres.
extern "C" EMSCRIPTEN_KEEPALIVE const char* draw(const char* config, float radius, float turn_rad,
                                                 int width, int height)
{
    page.message = toText(show(config, radius, turn_rad, {width, height}).diagnostics());
    return page.message.c_str();
}
