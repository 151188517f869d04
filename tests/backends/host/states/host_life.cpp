// SPDX-License-Identifier: MIT
#include "tests/backends/host/states/host_life.h"

#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace crevice {

namespace {

struct Kind {
    const char* config;
    bool draws;
    const char* compiled;  ///< A param whose change compiles a shader.
    const char* feature;
    const char* value;
    const char* import = "depth";
};

/// The last is for contexts that read samples.
constexpr Kind kKinds[] = {
    {R"({"format": 1, "name": "whole", "params": {"samples": 4}, "extends":
        ["geometry/host_depth", "ssao/hemisphere", "filter/box"]})",
     false, "samples", "power_of", "occlusion"},
    {R"({"format": 1, "name": "drawn", "params": {"samples": 4, "msaa": 4}, "extends":
        ["geometry/position_normal", "ssao/hemisphere", "filter/box", "lighting/forward"]})",
     true, "samples", "display", "ao_only"},
    {R"({"format": 1, "name": "history", "params": {"samples": 4}, "extends":
        ["geometry/host_depth", "ssao/hemisphere", "filter/temporal"]})",
     false, "samples", "history_clamp", "false"},
    {R"({"format": 1, "name": "half", "params": {"samples": 4}, "extends":
        ["geometry/host_depth", "ssao/hemisphere", "filter/upsample"]})",
     false, "samples", "power_of", "occlusion"},
    {R"({"format": 1, "name": "sampled", "params": {"samples": 4}, "extends":
        ["geometry/host_depth_msaa", "ssao/hemisphere", "filter/box"]})",
     false, "samples", "power_of", "occlusion", "depth_samples"},
};

}  // namespace

HostLife::HostLife(Context& context, const GlDeviceOptions& options)
    : calls_(context.loader()),
      options_(options)
{
    options_.program_cache = programs_.cache();
    need(context.makeCurrent());
    load_ = context.loader();
    gl = need(loadGlApi(load_));
    info_ = need(readInfo(gl, false));
    settleOptional(gl, info_, load_);  // nothing that the context lacks
    makeDepths();
    makeTargets();
    makeBuffers();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
    REQUIRE(quiet(gl) == GL_NO_ERROR);
}

HostLife::~HostLife() { quiet(gl); }

int HostLife::kinds() const { return kConfigs * places() + (info_.version >= 310 ? 1 : 0); }

void HostLife::watch(RandomHost& host) const
{
    for (const auto& [target, texture] : textures_) host.watchTexture(target, texture.name());
    for (const GlFramebuffer& each : framebuffers_) host.watchFramebuffer(each.name());
    host.watchRenderbuffer(renderbuffer_.name());
}

/// One host's life: what it holds between its steps.
struct HostLife::Run {
    HostLife& host;
    const Kind& kind;
    HostTexture depth;
    const std::function<void(const char*)>& after;
    std::unique_ptr<Device> device = {};
    std::optional<Effect> effect = {};
    MeshId mesh = {};
    std::vector<Image> images = {};

    void create()
    {
        device = need(makeGlDevice(host.load_, host.options_));
        after("making a device");
        effect.emplace(need(Effect::create(*device, kind.config, kHostSize)));
        after("making an effect");
        // Near and far plane cut the scene, so that depth that is clamped would show.
        const glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 2.5f, 4.0f);
        effect->setProjection(glm::value_ptr(projection));
        effect->setClipControl({});
        effect->setDepthRange({});
        if (kind.draws) return addDraws();
        need(effect->setTexture(kind.import, depth));
        after("setting a texture");
    }

    /// The host's buffer once by adoption and once by its own draw calls, which leave a disorder.
    void addDraws()
    {
        const GLuint name = host.vertices_.name();
        HostMesh own;
        own.label = "corner";
        own.position = {name, VertexType::float32, 0, sizeof(Vertex)};
        own.normal = {name, VertexType::float32, 12, sizeof(Vertex)};
        own.vertex_count = own.index_count = 18;
        mesh = need(device->adoptMesh(own));
        after("adopting a mesh");
        const glm::dmat4 view = glm::lookAt(glm::dvec3(1, 1.5, 2.5), {0, -0.5, 0}, {0, 1, 0});
        effect->setView(glm::value_ptr(view));
        Frame& frame = effect->frame();
        frame.materials.resize(1);
        frame.lights.resize(1);  // near, so that the samples of a pixel differ
        frame.lights[0].position = {0.25, -0.5, 0.5};
        frame.lights[0].attenuation = {0, 0, 16};
        frame.draws.resize(2);
        frame.draws[0].callback = &drawByHost;
        frame.draws[0].host = this;
        frame.draws[1].mesh = mesh;
        frame.draws[1].count = 18;
        frame.draws[1].world_from_model = glm::translate(glm::dmat4(1.0), {0.5, 0.25, 0.125});
    }

    static void drawByHost(const DrawCall&, void* run)
    {
        const HostLife& self = static_cast<Run*>(run)->host;
        const GlApi& gl = self.gl;
        gl.BindVertexArray(self.array_.name());
        gl.DrawArrays(GL_TRIANGLES, 0, 18);
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.Enable(GL_STENCIL_TEST);
        gl.Enable(GL_BLEND);
        gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
        gl.FrontFace(GL_CW);
    }

    void draw(const char* step)
    {
        (void)effect->value("ao");
        after("taking a value");
        (void)need(effect->warm());
        after("warming");
        need(effect->render());
        after(step);
        images.push_back(need(device->readTexture(effect->output("ao"))));
        after("reading");
        if (!kind.draws) return;
        images.push_back(need(device->readTexture(effect->output("color"))));
    }

    void show()
    {
        need(effect->present("ao", {host.drawn_into_[0], 0, 0, kHostSize}));
        after("presenting into a framebuffer");
        HostFramebuffer texture{0, 0, 0, kHostSize};
        texture.texture = host.shown_[1];
        need(effect->present("ao", texture));
        after("presenting into a texture");
        const TextureId id =
            need(device->adoptTexture({host.shown_[0], "shown", Format::rgba8, kHostSize}));
        after("adopting what was presented");
        images.push_back(need(device->readTexture(id)));
        device->destroy(id);
    }

    void change()
    {
        need(effect->setParam("radius", 0.75f));
        need(effect->setParam(kind.compiled, 3.0f));
        after("compiling");
        draw("rendering what was compiled");
        need(effect->setFeature(kind.feature, kind.value));
        draw("rendering with a feature");
        need(effect->resize({16, 10}));
        after("resizing");
        draw("rendering after a new size");
        Renderer& renderer = effect->renderer();
        need(renderer.reload(renderer.description(), {{20, 12}}));
        after("reloading");
        draw("rendering what was reloaded");
    }

    void destroy()
    {
        effect.reset();
        after("destroying an effect");
        if (mesh) device->destroy(mesh);
        device.reset();
        after("destroying a device");
    }
};

std::vector<Image> HostLife::live(int kind, const std::function<void(const char*)>& after)
{
    static_assert(std::size(kKinds) == kConfigs + 1);
    const bool sampled = kind == kConfigs * places();
    Run run{*this, kKinds[sampled ? kConfigs : kind % kConfigs],
            sampled ? depths_.back() : depths_[kind / kConfigs], after};
    if (sampled) run.depth.part = false;
    run.create();
    run.draw("rendering");
    run.draw("rendering again");
    run.show();
    run.change();
    run.destroy();
    for (const int target : {0, 1}) run.images.push_back(readShown(target));
    return std::move(run.images);
}

}  // namespace crevice
