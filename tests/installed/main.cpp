// SPDX-License-Identifier: MIT
// The least that a host does: a context, a mesh, a config, a frame. Draws a corner of
// a room and checks its ambient occlusion. Exits with 0, 1 (wrong), or 77 (no GL on this machine).
#include <crevice/config.h>
#include <crevice/context.h>
#include <crevice/effect.h>
#include <crevice/gl_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace crevice;

/// The example of the README.
extern std::unique_ptr<Device> device;
extern std::unique_ptr<Effect> effect;
Status createAo(const GlLoader& loader, Extent size);
Status drawAo(unsigned depth, Extent size, const float* projection, unsigned& ao);

namespace {

constexpr int kSkip = 77;
constexpr Extent kExtent = {160, 120};

int fail(const Diagnostics& diagnostics)
{
    std::fputs(toText(diagnostics).c_str(), stderr);
    return 1;
}

/// One face: a square around `center`, spanned by two half edges.
void addSquare(MeshDesc& mesh, glm::vec3 center, glm::vec3 u, glm::vec3 v)
{
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::vec3 p : {center - u - v, center + u - v, center + u + v, center - u + v})
        mesh.vertices.push_back({{p.x, p.y, p.z}, {normal.x, normal.y, normal.z}, {0, 0}});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

MeshDesc floorAndWalls()
{
    MeshDesc mesh;
    mesh.label = "floor and walls";
    const glm::vec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    addSquare(mesh, {0, 0, 0}, z, x);
    addSquare(mesh, {-2, 2, 0}, y, z);
    addSquare(mesh, {0, 2, -2}, x, y);
    return mesh;
}

Frame frameOf(MeshId mesh, const MeshDesc& desc)
{
    Frame frame;
    frame.camera.view_from_world =
        glm::lookAt(glm::vec3(0, 1.5f, 0.5f), glm::vec3(-2, 0.5f, -2), glm::vec3(0, 1, 0));
    const float aspect = static_cast<float>(kExtent.width) / kExtent.height;
    frame.camera.clip_from_view = glm::perspective(glm::radians(50.0f), aspect, 0.1f, 50.0f);
    frame.materials.resize(1);
    frame.draws.push_back({mesh, 0, static_cast<std::uint32_t>(desc.indices.size())});
    Light light;
    light.position = {3, 6, 2};
    frame.lights.push_back(light);
    return frame;
}

/// Finite, in [0, 1], somewhere darkened and somewhere open.
int judge(const Image& ao)
{
    float least = 1.0f, most = 0.0f;
    for (int y = 0; y < ao.extent.height; ++y) {
        for (int x = 0; x < ao.extent.width; ++x) {
            const float value = ao.at(x, y);
            if (!std::isfinite(value) || value < 0.0f || value > 1.0f) {
                std::fprintf(stderr, "ao is %g at %d, %d\n", value, x, y);
                return 1;
            }
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    std::printf("ao is between %g and %g\n", least, most);
    return least < 0.9f && most > 0.95f ? 0 : 1;
}

int draw(Device& owner)
{
    const auto document = loadConfig(shippedSources(), {"learnopengl"});
    if (!document) return fail(document.diagnostics());
    const auto description = decode(*document, shippedSources());
    if (!description) return fail(description.diagnostics());

    const MeshDesc desc = floorAndWalls();
    const auto mesh = owner.createMesh(desc);
    if (!mesh) return fail(mesh.diagnostics());
    const Frame frame = frameOf(*mesh, desc);
    CompileOptions options;
    options.extent = kExtent;
    const auto renderer = Renderer::create(owner, *description, options, traitsOf(frame));
    if (!renderer) return fail(renderer.diagnostics());
    const Status drawn = (*renderer)->render(frame);
    if (!drawn) return fail(drawn.diagnostics());
    const auto ao = owner.readTexture((*renderer)->output("ao"));
    if (!ao) return fail(ao.diagnostics());
    if (owner.nativeName((*renderer)->output("ao")) == 0) {
        std::fputs("the output has no native name\n", stderr);
        return 1;
    }
    owner.destroy(*mesh);
    return judge(*ao);
}

/// Runs the example of the README on a texture for depth of `owner`.
int drawExample(Device& owner, const GlLoader& loader)
{
    TextureDesc desc;
    desc.format = Format::depth24;
    desc.extent = {1920, 1080};
    const auto depth = owner.createTexture(desc);
    if (!depth) return fail(depth.diagnostics());
    const glm::mat4 projection = glm::perspective(glm::radians(50.0f), 16.0f / 9.0f, 0.1f, 50.0f);
    unsigned name = 0;
    Status status = createAo(loader, desc.extent);
    if (status) status = drawAo(owner.nativeName(*depth), desc.extent, &projection[0][0], name);
    effect.reset();
    device.reset();
    owner.destroy(*depth);
    return status && name != 0 ? 0 : fail(status.diagnostics());
}

}  // namespace

int main()
{
    auto context = makeEglContext();
    if (!context) context = makeOsmesaContext();
    if (!context) {
        fail(context.diagnostics());
        return kSkip;
    }
    const auto made = makeGlDevice((*context)->loader());
    if (!made) return fail(made.diagnostics());
    const int drawn = draw(**made);
    return drawn == 0 ? drawExample(**made, (*context)->loader()) : drawn;
}
