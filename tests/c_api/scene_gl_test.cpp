// SPDX-License-Identifier: MIT
// A host's scene by the C API beside the C++ facade, in one context: the same pictures, bit for
// bit, from meshes that are copied, from buffers of the host's and from its own draw calls.
#include <crevice/effect.h>
#include <crevice/frame.h>

#include "tests/c_api/c_api.h"
#include "tests/support/gl_fixture.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstddef>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};
constexpr const char* kConfig = "baked";  // reads all maps, and is lit

/// A floor and a wall.
const std::vector<Vertex>& vertices()
{
    static const std::vector<Vertex> made = {
        {{-2, -1, 1}, {0, 1, 0}, {0, 0}},  {{2, -1, 1}, {0, 1, 0}, {3, 0}},
        {{2, -1, -1}, {0, 1, 0}, {3, 2}},  {{-2, -1, -1}, {0, 1, 0}, {0, 2}},
        {{-2, -1, -1}, {0, 0, 1}, {0, 0}}, {{2, -1, -1}, {0, 0, 1}, {3, 0}},
        {{2, 1, -1}, {0, 0, 1}, {3, 2}},   {{-2, 1, -1}, {0, 0, 1}, {0, 2}}};
    return made;
}

const std::vector<std::uint32_t> kIndices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};

void* find(const char* name, void* context)
{
    return static_cast<Context*>(context)->loader()(name);
}

struct Host : GlFixture {
    Host()
    {
        auto desc = sized<crevice_device_desc>();
        desc.loader = find;
        desc.user = &testContext();
        need(crevice_device_create(&desc, &c_device));
        c_effect = makeEffect();
        for (int i = 0; i < 3; ++i) maps[i] = makeTexture(i);
    }
    ~Host()
    {
        for (crevice_mesh* each : meshes) crevice_mesh_destroy(each);
        crevice_effect_destroy(c_effect);
        crevice_device_destroy(c_device);
        gl.DeleteTextures(3, maps);
        for (const GLuint each : buffers) gl.DeleteBuffers(1, &each);
    }

    crevice_effect* makeEffect() const
    {
        auto desc = sized<crevice_effect_desc>();
        desc.config = kConfig;
        desc.width = kExtent.width;
        desc.height = kExtent.height;
        crevice_effect* made = nullptr;
        need(crevice_effect_create(c_device, &desc, &made));
        need(crevice_effect_set_projection(made, glm::value_ptr(projection)));
        need(crevice_effect_set_view(made, glm::value_ptr(view)));
        return made;
    }

    /// A pattern of 4 by 4 pixels, another for each seed.
    GLuint makeTexture(int seed)
    {
        std::array<unsigned char, 64> pixels;
        for (std::size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = static_cast<unsigned char>(255 - (i * 37 + seed * 101) % 200);
        GLuint name = 0;
        gl.GenTextures(1, &name);
        gl.BindTexture(GL_TEXTURE_2D, name);
        gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 4);
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        gl.BindTexture(GL_TEXTURE_2D, 0);
        return name;
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

    /// Copied from arrays, moved along x.
    crevice_mesh* copied(float x = 0)
    {
        std::vector<float> positions, normals, uvs;
        for (const Vertex& vertex : vertices()) {
            positions.insert(positions.end(), vertex.position, vertex.position + 3);
            positions[positions.size() - 3] += x;
            normals.insert(normals.end(), vertex.normal, vertex.normal + 3);
            uvs.insert(uvs.end(), vertex.uv, vertex.uv + 2);
        }
        auto desc = sized<crevice_mesh_desc>();
        desc.positions = positions.data();
        desc.normals = normals.data();
        desc.uvs = uvs.data();
        desc.vertex_count = static_cast<std::uint32_t>(vertices().size());
        desc.indices = kIndices.data();
        desc.index_count = static_cast<std::uint32_t>(kIndices.size());
        meshes.emplace_back();
        need(crevice_mesh_create(c_device, &desc, &meshes.back()));
        return meshes.back();
    }

    /// In buffers of the host's: shorts, behind two others, for indices.
    crevice_mesh* adopted()
    {
        const GLuint name = buffer(vertices());
        std::vector<std::uint16_t> shorts = {9, 9};
        shorts.insert(shorts.end(), kIndices.begin(), kIndices.end());
        auto host = sized<crevice_host_mesh>();
        host.position = {name, CREVICE_FLOAT32, 0, sizeof(Vertex)};
        host.normal = {name, CREVICE_FLOAT32, offsetof(Vertex, normal), sizeof(Vertex)};
        host.uv = {name, CREVICE_FLOAT32, offsetof(Vertex, uv), sizeof(Vertex)};
        host.vertex_count = static_cast<std::uint32_t>(vertices().size());
        host.index_buffer = buffer(shorts);
        host.index_type = CREVICE_UINT16;
        host.index_offset = 4;
        host.index_count = static_cast<std::uint32_t>(kIndices.size());
        meshes.emplace_back();
        need(crevice_mesh_adopt(c_device, &host, &meshes.back()));
        return meshes.back();
    }

    static crevice_draw drawOf(const crevice_mesh* mesh)
    {
        auto draw = sized<crevice_draw>();
        draw.mesh = mesh;
        return draw;
    }

    static crevice_texture textureOf(GLuint name)
    {
        auto texture = sized<crevice_texture>();
        texture.name = name;
        texture.format = "rgba8";
        texture.width = texture.height = 4;
        return texture;
    }

    void setMaterial()
    {
        const crevice_texture color = textureOf(maps[0]);
        const crevice_texture normals = textureOf(maps[1]);
        const crevice_texture open = textureOf(maps[2]);
        auto material = sized<crevice_material>();
        material.base_color_map = &color;
        material.normal_map = &normals;
        material.occlusion_map = &open;
        std::fill_n(material.specular, 3, 0.4f);
        material.ambient_dimming = 0.25f;
        material.normal_scale = 0.5f;
        need(crevice_effect_set_materials(c_effect, &material, 1));
    }

    void setLights()
    {
        auto light = sized<crevice_light>();
        light.kind = CREVICE_SPOT;
        std::copy_n(glm::value_ptr(spot.position), 3, light.position);
        std::copy_n(glm::value_ptr(spot.direction), 3, light.direction);
        std::fill_n(light.color, 3, 1.0f);
        need(crevice_effect_set_lights(c_effect, &light, 1));
        need(crevice_effect_set_ambient_light(c_effect, glm::value_ptr(ambient)));
    }

    std::vector<float> draw(const crevice_draw& draw)
    {
        need(crevice_effect_set_draws(c_effect, &draw, 1));
        return rendered();
    }

    std::vector<float> rendered()
    {
        need(crevice_effect_render(c_effect));
        INFO(crevice_error_text(crevice_effect_warnings(c_effect)));
        CHECK(crevice_error_code(crevice_effect_warnings(c_effect)) == warns);
        std::vector<float> pixels(kExtent.width * kExtent.height * 4);
        need(crevice_effect_read_output(c_effect, "color", pixels.data(), pixels.size()));
        return pixels;
    }

    TextureId adopt(GLuint name)
    {
        HostTexture host;
        host.name = name;
        host.format = Format::rgba8;
        host.extent = {4, 4};
        return need(device->adoptTexture(host));
    }

    /// The same scene by the C++ facade.
    std::vector<float> drawByFacade()
    {
        Effect effect = need(Effect::create(*device, kConfig, kExtent));
        effect.setProjection(glm::value_ptr(projection));
        effect.setView(glm::value_ptr(view));
        Frame& frame = effect.frame();
        frame.materials.resize(1);
        Material& material = frame.materials[0];
        material.base_color_map = adopt(maps[0]);
        material.normal_map = adopt(maps[1]);
        material.occlusion_map = adopt(maps[2]);
        material.specular = glm::vec3(0.4f);
        material.ambient = 0.75f;
        material.normal_scale = 0.5f;
        frame.lights = {spot};
        frame.ambient_light = ambient;
        const MeshId mesh = need(device->createMesh({"own", vertices(), kIndices}));
        frame.draws = {{mesh, 0, static_cast<std::uint32_t>(kIndices.size())}};
        need(effect.render());
        std::vector<float> pixels = read(effect.output("color")).pixels;
        device->destroy(mesh);
        return pixels;
    }

    static Light makeSpot()
    {
        Light light;
        light.spot = true;
        light.position = {0.5, 1, 1.5};
        light.direction = {0, -1, -1};
        return light;
    }

    glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
    glm::dmat4 view = glm::lookAt(glm::dvec3(1, 1, 3), {0, -0.5, 0}, {0, 1, 0});
    Light spot = makeSpot();
    glm::vec3 ambient = {0.9f, 0.8f, 0.7f};
    GLuint maps[3] = {};
    crevice_device* c_device = nullptr;
    crevice_effect* c_effect = nullptr;
    std::vector<crevice_mesh*> meshes;
    int warns = 0;  // the code of what each frame warns of
    std::vector<GLuint> buffers;
};

/// Draws the host's own buffers in a vertex array of its own.
struct OwnDraws {
    const GlApi& gl;
    GLuint vertices;
    GLuint indices;
    GLuint array = 0;
    int calls = 0;

    static void draw(const crevice_draw_call* call, void* user)
    {
        OwnDraws& self = *static_cast<OwnDraws*>(user);
        const GlApi& gl = self.gl;
        self.calls += call->program != 0;
        if (self.array == 0) gl.GenVertexArrays(1, &self.array);
        gl.BindVertexArray(self.array);
        gl.BindBuffer(GL_ARRAY_BUFFER, self.vertices);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, self.indices);
        const std::size_t offsets[] = {offsetof(Vertex, position), offsetof(Vertex, normal),
                                       offsetof(Vertex, uv)};
        for (GLuint i = 0; i < 3; ++i) {
            gl.EnableVertexAttribArray(i);
            gl.VertexAttribPointer(i, i == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                   reinterpret_cast<const void*>(offsets[i]));
        }
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(kIndices.size()), GL_UNSIGNED_INT,
                        nullptr);
    }
};

}  // namespace

TEST_CASE_METHOD(Host, "The C API draws a scene as the C++ facade does, from wherever it lies")
{
    const std::vector<float> wanted = drawByFacade();
    const auto [least, most] = std::minmax_element(wanted.begin(), wanted.end());
    CHECK(*most - *least > 0.5f);
    setMaterial();
    setLights();
    CHECK(draw(drawOf(copied())) == wanted);
    CHECK(draw(drawOf(adopted())) == wanted);

    OwnDraws own{gl, buffer(vertices()), buffer(kIndices)};
    auto call = sized<crevice_draw>();
    call.callback = OwnDraws::draw;
    call.user = &own;
    CHECK(draw(call) == wanted);
    CHECK(own.calls > 0);
    gl.DeleteVertexArrays(1, &own.array);
    CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(Host,
                 "A mesh or map that takes the place of a destroyed one is drawn, by the C API")
{
    const std::vector<float> before = draw(drawOf(copied()));
    need(crevice_effect_set_draws(c_effect, nullptr, 0));
    crevice_mesh_destroy(meshes.back());
    meshes.back() = nullptr;
    const std::vector<float> moved = draw(drawOf(copied(0.5f)));
    CHECK(moved != before);

    const auto replace_map = [this](GLuint name) {
        need(crevice_effect_set_materials(c_effect, nullptr, 0));
        const crevice_texture map = textureOf(name);
        auto material = sized<crevice_material>();
        material.base_color_map = &map;
        need(crevice_effect_set_materials(c_effect, &material, 1));
        return rendered();
    };
    replace_map(maps[0]);  // makes a new plan, which gives ids back
    const std::vector<float> textured = replace_map(maps[0]);
    CHECK(replace_map(maps[1]) != textured);
}

TEST_CASE_METHOD(Host,
                 "A mesh without indices or normals is drawn by the C API in its vertices' order")
{
    const std::vector<float> empty = rendered();
    std::vector<float> positions;
    for (const std::uint32_t index : kIndices) {
        const float* at = vertices()[index].position;
        positions.insert(positions.end(), at, at + 3);
    }
    auto desc = sized<crevice_mesh_desc>();
    desc.positions = positions.data();
    desc.vertex_count = static_cast<std::uint32_t>(kIndices.size());
    meshes.resize(2);
    need(crevice_mesh_create(c_device, &desc, &meshes[0]));
    auto host = sized<crevice_host_mesh>();
    host.position.buffer = buffer(positions);
    host.vertex_count = desc.vertex_count;
    need(crevice_mesh_adopt(c_device, &host, &meshes[1]));
    const std::vector<float> drawn = draw(drawOf(meshes[0]));
    CHECK(drawn != empty);
    warns = 6019;  // a pass reads normals of the host's buffers
    CHECK(draw(drawOf(meshes[1])) == drawn);
}
