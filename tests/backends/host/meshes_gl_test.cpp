// SPDX-License-Identifier: MIT
// Geometry that stays the host's: in its own buffers, and drawn by itself.
#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tests/support/gl_fixture.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>

#include <cstring>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};

const std::vector<Vertex>& vertices()
{
    static const std::vector<Vertex> made = step();
    return made;
}

struct HostScene : GlFixture {
    HostScene()
    {
        frame.materials.resize(1);
        frame.draws.resize(1);
        frame.camera.clip_from_view = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
        frame.camera.view_from_world =
            glm::lookAt(glm::dvec3(1, 1.5, 2.5), {0, -0.5, 0}, {0, 1, 0});
        frame.draws[0].count = static_cast<std::uint32_t>(vertices().size());
        for (std::uint32_t i = 0; i < vertices().size(); ++i) indices.push_back(i);
        renderer = make("balanced");
    }
    ~HostScene()
    {
        renderer.reset();
        for (const GLuint name : buffers) gl.DeleteBuffers(1, &name);
    }

    std::unique_ptr<Renderer> make(const std::string& config)
    {
        const Description description =
            need(decode(need(loadConfig(shippedSources(), {config})), shippedSources()));
        return need(Renderer::create(*device, description, {kExtent, {"ao"}, {}}, traitsOf(frame)));
    }

    Image drawn()
    {
        ++frame.revision;
        need(renderer->render(frame));
        return read(renderer->output("ao"));
    }

    Image own()
    {
        const MeshId mesh = need(device->createMesh({"own", vertices(), indices, false}));
        frame.draws[0].mesh = mesh;
        Image image = drawn();
        device->destroy(mesh);
        return image;
    }

    template <class T>
    GLuint buffer(const std::vector<T>& data)
    {
        GLuint name = 0;
        gl.GenBuffers(1, &name);
        buffers.push_back(name);
        gl.BindBuffer(GL_ARRAY_BUFFER, name);
        gl.BufferData(GL_ARRAY_BUFFER, data.size() * sizeof(T), data.data(), GL_STATIC_DRAW);
        gl.BindBuffer(GL_ARRAY_BUFFER, 0);
        return name;
    }

    /// The host's own vertex buffer in the layout of `Vertex`, without indices.
    HostMesh plain()
    {
        HostMesh mesh;
        mesh.label = "host";
        const GLuint name = buffer(vertices());
        mesh.position = {name, VertexType::float32, 0, sizeof(Vertex)};
        mesh.normal = {name, VertexType::float32, offsetof(Vertex, normal), sizeof(Vertex)};
        mesh.uv = {name, VertexType::float32, offsetof(Vertex, uv), sizeof(Vertex)};
        mesh.vertex_count = mesh.index_count = static_cast<std::uint32_t>(vertices().size());
        return mesh;
    }

    Image of(const HostMesh& host)
    {
        const MeshId mesh = need(device->adoptMesh(host));
        frame.draws[0].mesh = mesh;
        Image image = drawn();
        device->destroy(mesh);
        return image;
    }

    /// Positions or normals, encoded by `encode`, each padded to `stride` components.
    template <class T, class Encode>
    HostAttribute encoded(VertexType type, bool normals, int stride, Encode encode)
    {
        std::vector<T> data;
        for (const Vertex& vertex : vertices())
            for (int i = 0; i < stride; ++i)
                data.push_back(i < 3 ? encode(normals ? vertex.normal[i] : vertex.position[i])
                                     : T(0));
        return {buffer(data), type, 0, static_cast<std::uint32_t>(stride * sizeof(T))};
    }

    Frame frame;
    std::vector<std::uint32_t> indices;
    std::unique_ptr<Renderer> renderer;
    std::vector<GLuint> buffers;
};

bool same(const Image& a, const Image& b) { return a.pixels == b.pixels && !a.pixels.empty(); }

/// Draws the host's own buffer, and leaves the context in disorder.
struct RudeHost {
    const GlApi& gl;
    GLuint buffer;
    GLuint array;
    bool draws = true;
    int calls = 0;

    static void draw(const DrawCall& call, void* host)
    {
        RudeHost& self = *static_cast<RudeHost*>(host);
        ++self.calls;
        const GlApi& gl = self.gl;
        gl.BindVertexArray(self.array);
        gl.BindBuffer(GL_ARRAY_BUFFER, self.buffer);
        for (const auto& [location, offset] :
             {std::pair<GLuint, std::size_t>(0, offsetof(Vertex, position)),
              {1, offsetof(Vertex, normal)},
              {2, offsetof(Vertex, uv)}}) {
            gl.EnableVertexAttribArray(location);
            gl.VertexAttribPointer(location, location == 2 ? 2 : 3, GL_FLOAT, GL_FALSE,
                                   sizeof(Vertex), reinterpret_cast<const void*>(offset));
        }
        CHECK(call.program != 0);
        if (self.draws) gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices().size()));
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.UseProgram(0);
        gl.Viewport(3, 4, 5, 6);
        gl.Scissor(0, 0, 1, 1);
        for (const GLenum each : {GL_SCISSOR_TEST, GL_BLEND, GL_STENCIL_TEST, GL_CULL_FACE})
            gl.Enable(each);
        gl.Disable(GL_DEPTH_TEST);
        gl.DepthMask(GL_FALSE);
        gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        gl.FrontFace(GL_CW);
        gl.ActiveTexture(GL_TEXTURE3);
        for (int unit = 0; unit < 8; ++unit) gl.BindSampler(unit, 0);
    }
};

}  // namespace

TEST_CASE_METHOD(HostScene, "A host's buffers draw what a copy of them draws, in every type")
{
    const Image wanted = own();
    HostMesh mesh = plain();
    CHECK(same(of(mesh), wanted));

    mesh.index_buffer = buffer(indices);
    CHECK(same(of(mesh), wanted));
    std::vector<std::uint16_t> shorts = {9, 9};
    shorts.insert(shorts.end(), indices.begin(), indices.end());
    mesh.index_buffer = buffer(shorts);
    mesh.index_type = IndexType::uint16;
    mesh.index_offset = 4;
    CHECK(same(of(mesh), wanted));
    mesh.index_buffer = buffer(std::vector<std::uint8_t>(indices.begin(), indices.end()));
    mesh.index_type = IndexType::uint8;
    mesh.index_offset = 0;
    CHECK(same(of(mesh), wanted));

    const auto half = [](float x) { return glm::packHalf1x16(x); };
    const auto snorm16 = [](float x) { return static_cast<std::int16_t>(x * 32767); };
    const auto snorm8 = [](float x) { return static_cast<std::int8_t>(x * 127); };
    for (const bool normals : {false, true}) {
        INFO(normals);
        HostAttribute& attribute = normals ? mesh.normal : mesh.position;
        attribute = encoded<std::uint16_t>(VertexType::float16, normals, 4, half);
        CHECK(same(of(mesh), wanted));
        attribute = encoded<std::int16_t>(VertexType::snorm16, normals, 4, snorm16);
        CHECK(same(of(mesh), wanted));
        attribute = encoded<std::int8_t>(VertexType::snorm8, normals, 4, snorm8);
        CHECK(same(of(mesh), wanted));
    }
    std::vector<std::uint32_t> words;
    for (const Vertex& v : vertices()) {
        std::uint32_t word = 0;
        for (int i = 0; i < 3; ++i)
            word |= (static_cast<std::uint32_t>(static_cast<int>(v.normal[i] * 511)) & 1023)
                    << (10 * i);
        words.push_back(word);
    }
    mesh.normal = {buffer(words), VertexType::snorm10, 0, 0};
    CHECK(same(of(mesh), wanted));
    CHECK(gl.GetError() == GL_NO_ERROR);

    renderer = make("mobile");  // of depth alone
    const Image of_depth = own();
    mesh.normal = mesh.uv = {};
    CHECK(same(of(mesh), of_depth));
}

TEST_CASE_METHOD(HostScene, "Buffers that are none, or end too early, are refused with the reason")
{
    const std::string bytes = std::to_string(vertices().size() * sizeof(Vertex));
    HostMesh longer = plain(), indexed = plain(), none = plain();
    longer.vertex_count += 1;
    indexed.index_buffer = buffer(std::vector<std::uint16_t>(17));
    none.uv.buffer = 4711;
    for (const auto& [mesh, words] : {std::pair(longer, "which has " + bytes + " bytes"),
                                      {indexed, "its indices in buffer"},
                                      {none, "which is none of this context"}}) {
        CHECK_THAT(toText(device->adoptMesh(mesh).diagnostics()), Catch::Contains(words));
    }
    CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(HostScene,
                 "A host that draws by itself draws the same, however it leaves the state")
{
    const Image wanted = own();
    RudeHost host{gl, buffer(vertices()), 0};
    gl.GenVertexArrays(1, &host.array);
    frame.draws[0].mesh = {};
    frame.draws[0].callback = RudeHost::draw;
    frame.draws[0].host = &host;
    CHECK(same(drawn(), wanted));
    CHECK(host.calls >= 2);  // front faces and back faces

    host.draws = false;  // and leaves its disorder to a mesh of the device's own
    const MeshId mesh = need(device->createMesh({"own", vertices(), indices, false}));
    frame.draws.push_back({mesh, 0, static_cast<std::uint32_t>(vertices().size())});
    CHECK(same(drawn(), wanted));
    device->destroy(mesh);
    gl.DeleteVertexArrays(1, &host.array);
}
