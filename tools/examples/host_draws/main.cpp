// SPDX-License-Identifier: MIT
// A host that draws its own geometry: tubes that two bones bend, three by one instanced call, on a
// floor that the library draws. Prints the mean of AO.
//
//     host_draws tools/examples/host_draws/skinned.json
#include <crevice/context.h>
#include <crevice/effect.h>
#include <crevice/frame.h>
#include <crevice/gl_device.h>
#include <crevice/renderer.h>

#include <GLES3/gl3.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cstdio>
#include <cstdlib>
#include <numeric>

using namespace crevice;

namespace {

constexpr Extent kSize = {256, 144};
constexpr int kSides = 16, kRings = 12, kTubes = 3;

/// Ends the program where something failed, and says why.
template <class T>
T need(T result)
{
    if (!result) std::fputs(toText(result.diagnostics()).c_str(), stderr), std::exit(EXIT_FAILURE);
    return result;
}

struct SkinnedVertex {
    glm::vec3 point, normal;
    float weight;
};

/// The host's own object, in its own layout. What it draws crevice never keeps.
struct Tubes {
    GLuint array = 0, bones = 0;
    GLsizei count = 0;

    void make()
    {
        std::vector<SkinnedVertex> made;
        const auto add = [&made](int side, int ring) {
            const float angle = glm::radians(360.0f * side / kSides), up = 1.0f * ring / kRings;
            const glm::vec3 normal(std::cos(angle), 0, -std::sin(angle));
            made.push_back({normal * 0.2f + glm::vec3(0, 1.5f * up, 0), normal, up});
        };
        for (int ring = 0; ring < kRings; ++ring)
            for (int side = 0; side < kSides; ++side)
                for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
                    add(side + x, ring + y);
        count = static_cast<GLsizei>(made.size());
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
        GLuint vertices = 0;
        glGenBuffers(1, &vertices);
        glBindBuffer(GL_ARRAY_BUFFER, vertices);
        glBufferData(GL_ARRAY_BUFFER, made.size() * sizeof made[0], made.data(), GL_STATIC_DRAW);
        const auto attribute = [](GLuint location, int components, std::size_t offset) {
            glEnableVertexAttribArray(location);
            glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(SkinnedVertex),
                                  reinterpret_cast<const void*>(offset));
        };
        attribute(0, 3, offsetof(SkinnedVertex, point));
        attribute(1, 3, offsetof(SkinnedVertex, normal));
        attribute(3, 1, offsetof(SkinnedVertex, weight));
        glGenBuffers(1, &bones);
    }

    /// The upper bone leans over. Blocks are at binding 0 unless the host says otherwise.
    void bend(float angle) const
    {
        const glm::mat4 both[] = {glm::mat4(1.0f), glm::rotate(glm::mat4(1.0f), angle, {0, 0, 1})};
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, bones);
        glBufferData(GL_UNIFORM_BUFFER, sizeof both, both, GL_DYNAMIC_DRAW);
    }

    static void draw(const DrawCall&, void* host)
    {
        const auto& self = *static_cast<const Tubes*>(host);
        glBindVertexArray(self.array);
        glDrawArraysInstanced(GL_TRIANGLES, 0, self.count, kTubes);
    }
};

}  // namespace

int main(int count, char** arguments)
{
    const auto context = std::move(*need(makeEglContext()));
    const auto device = std::move(*need(makeGlDevice(context->loader())));
    Tubes tubes;
    tubes.make();
    Effect effect =
        std::move(*need(Effect::create(*device, count > 1 ? arguments[1] : "skinned.json", kSize)));
    const auto clip = glm::perspective(0.9f, 1.0f * kSize.width / kSize.height, 0.1f, 50.0f);
    effect.setProjection(glm::value_ptr(clip));
    effect.setView(glm::value_ptr(glm::lookAt(glm::dvec3(1, 2, 4), {1, 0.5, 0}, {0, 1, 0})));
    const Vertex floor[] = {
        {{-9, 0, 9}, {0, 1, 0}}, {{9, 0, 9}, {0, 1, 0}}, {{0, 0, -9}, {0, 1, 0}}};
    const MeshId mesh = *need(device->createMesh({"floor", {floor, floor + 3}, {0, 1, 2}}));
    Frame& frame = effect.frame();
    frame.materials.resize(1);
    frame.draws = {{mesh, 0, 3}, {}};
    frame.draws[1].callback = Tubes::draw;
    frame.draws[1].host = &tubes;
    tubes.bend(0.5f);
    (void)need(effect.render());
    const Image ao = *need(device->readTexture(effect.output("ao")));
    std::printf("mean AO %.4f\n",
                std::accumulate(ao.pixels.begin(), ao.pixels.end(), 0.0) / ao.pixels.size());
    device->destroy(mesh);
    return EXIT_SUCCESS;
}
