// SPDX-License-Identifier: MIT
// What a surface is read from: stored, rebuilt from depth, or the host's own textures.
#include "tests/picture.h"

#include "core/load.h"
#include "core/renderer.h"
#include "effects/catalog.h"
#include "tools/camera_framing.h"
#include "tools/scene_upload.h"

#include <glm/geometric.hpp>

using namespace crevice;

namespace {

const char* const kShowNormals = R"(#version 300 es
precision highp float;
#include <surface>
in vec2 uv;
layout(location = 0) out vec4 color;
void main()
{
    vec3 point;
    color = pointAt(uv, point) ? vec4(normalAt(uv) * 0.5 + 0.5, 1.0) : vec4(0.0);
}
)";

const char* const kShow = R"({
    "format": 1,
    "targets": {"color": {"format": ["rgba16f", "rgba8"]}},
    "shaders": {"show": {"vertex": "common/fullscreen.vert", "fragment": "mine/show.frag"}},
    "passes": {"show": {"type": "fullscreen", "shader": "show", "color": ["color"]}},
    "outputs": {"color": "color"}})";

/// Normals in view space as a geometry module finds them; alpha 0 in the background.
Image normals(const std::string& geometry, const std::string& scene, const std::string& camera,
              Extent extent = {128, 72})
{
    MemorySources mine;
    mine.add("mine/show.frag", kShowNormals);
    mine.add("mine/show.json", kShow);
    mine.add("configs/show.json",
             R"({"format": 1, "extends": ["geometry/)" + geometry + R"(", "mine/show"]})");
    const LayeredSources sources({&mine, &shippedSources()});
    PictureRequest request;
    request.config = "show";
    request.scene = scene;
    request.camera = camera;
    request.extent = extent;
    request.output = "color";
    request.sources = &sources;
    return picture(request);
}

glm::vec3 normalOf(const Image& image, int x, int y)
{
    return glm::vec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) * 2.0f - 1.0f;
}

/// The share of the seen surface whose normals are less than that many degrees apart.
double shareWithin(const Image& a, const Image& b, double degrees)
{
    int seen = 0, near = 0;
    for (int y = 0; y < a.extent.height; ++y)
        for (int x = 0; x < a.extent.width; ++x) {
            REQUIRE(a.at(x, y, 3) == b.at(x, y, 3));
            if (a.at(x, y, 3) == 0.0f) continue;
            const glm::vec3 u = normalOf(a, x, y), v = normalOf(b, x, y);
            CHECK(glm::length(u) == Approx(1.0).margin(0.01));
            ++seen;
            near += glm::dot(u, v) > std::cos(degrees * 0.0174533) * glm::length(u) * glm::length(v);
        }
    REQUIRE(seen > 0);
    return double(near) / seen;
}

Description describeText(const std::string& config)
{
    MemorySources mine;
    mine.add("configs/host.json", config);
    const LayeredSources sources({&mine, &shippedSources()});
    return need(decode(need(loadConfig(sources, {"host"})), sources));
}

const char* const kDrawn = R"({"format": 1,
    "extends": ["geometry/depth_normal", "ssao/hemisphere", "filter/bilateral_normal"],
    "outputs": {"depth": "depth", "normal": "normal"}})";

std::string hostConfig(const std::string& geometry)
{
    return R"({"format": 1, "extends": ["geometry/)" + geometry +
           R"(", "ssao/hemisphere", "filter/bilateral_normal"]})";
}

/// A host that has drawn depth and normals itself.
struct Host {
    GlFixture gl;
    Scene scene = need(loadScene("spheres"));
    UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    CompileOptions options;
    Frame frame;
    std::unique_ptr<Renderer> drawn;

    Host()
    {
        options.extent = {128, 72};
        const double aspect = 128.0 / 72.0;
        const SceneCamera camera = need(chooseCamera(scene, uploaded.bounds(), "", aspect));
        frame = makeFrame(uploaded, camera, options.extent);
        drawn = need(Renderer::create(*gl.device, describeText(kDrawn), options, traitsOf(frame)));
        need(drawn->render(frame));
    }

    /// The occlusion by a config that draws no scene.
    Image occlusion(const std::string& geometry, const std::vector<std::string>& textures)
    {
        Frame bare;
        bare.camera = frame.camera;
        for (const std::string& name : textures)
            bare.textures.push_back({name, drawn->output(name)});
        auto renderer = need(Renderer::create(*gl.device, describeText(hostConfig(geometry)),
                                              options, traitsOf(bare)));
        need(renderer->render(bare));
        return gl.read(renderer->output("ao"));
    }
};

}  // namespace

TEST_CASE("Normals rebuilt from depth are those of the mesh on flat things, edges included")
{
    for (const char* camera : {"", "eye=3,2,4;at=0,0,0;ortho=4", "eye=0,1.5,4;at=0,0,0;fov=100"}) {
        INFO(camera);
        const Image stored = normals("depth_normal", "corner", camera);
        CHECK(shareWithin(normals("depth_only", "corner", camera), stored, 2) > 0.97);
    }
}

TEST_CASE("Normals rebuilt from depth follow round things")
{
    const Image stored = normals("depth_normal", "spheres", "", {256, 144});
    const Image rebuilt = normals("depth_only", "spheres", "", {256, 144});
    CHECK(shareWithin(rebuilt, stored, 10) > 0.9);
}

TEST_CASE("Normals rebuilt from depth have unit length in pictures of any size")
{
    for (const Extent extent : {Extent{1, 1}, Extent{2, 1}, Extent{1, 37}, Extent{3, 2}}) {
        const Image stored = normals("depth_normal", "plane", "", extent);
        shareWithin(normals("depth_only", "plane", "", extent), stored, 90);
    }
}

TEST_CASE("The host's own depth and normals give the occlusion that ours give")
{
    Host host;
    const Image ours = host.gl.read(host.drawn->output("ao"));
    CHECK(mean(ours) < 0.99);
    CHECK(meanChange(host.occlusion("host_depth_normal", {"depth", "normal"}), ours) == 0.0);
    CHECK(meanChange(host.occlusion("host_depth", {"depth"}), ours) < 0.02);
}

TEST_CASE("A host that forgets its depth is told so")
{
    Host host;
    Frame bare;
    bare.camera = host.frame.camera;
    auto renderer = need(Renderer::create(*host.gl.device, describeText(hostConfig("host_depth")),
                                          host.options, traitsOf(bare)));
    const Status status = renderer->render(bare);
    REQUIRE_FALSE(status.ok());
    CHECK(status.diagnostics().front().code == Code::missing_import);
}
