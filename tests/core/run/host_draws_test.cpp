// SPDX-License-Identifier: MIT
// Draws that the host does by itself: when it is called, what it is given, and when not again.
#include <crevice/renderer.h>

#include "core/frame/frame_math.h"
#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

struct Host {
    int calls = 0;
    std::string pass;
    std::uint32_t program = 0;
    glm::mat4 clip_from_model = glm::mat4(0.0f);
    bool unknown_is_null = false;

    static void draw(const DrawCall& call, void* host)
    {
        Host& self = *static_cast<Host*>(host);
        ++self.calls;
        self.pass = call.pass;
        self.program = call.program;
        std::copy_n(call.matrix("clip_from_model"), 16, &self.clip_from_model[0][0]);
        self.unknown_is_null = !call.matrix("no_such") && !call.matrix("base_color");
    }
};

/// A rig whose one draw is the host's own.
struct HostRig : Rig {
    HostRig()
    {
        DrawItem& item = frame.draws[0];
        item = {};
        item.callback = Host::draw;
        item.host = &host;
    }
    void render()
    {
        need(renderer->render(frame));
        for (const std::string& each : device.misuse()) FAIL_CHECK(each);
    }
    Host host;
};

}  // namespace

TEST_CASE("The host draws in the mesh's place, in each pass that draws, with its matrices by name")
{
    HostRig rig;
    rig.frame.camera.clip_from_view = glm::perspective(1.0f, 2.0f, 0.1f, 10.0f);
    rig.frame.draws[0].world_from_model = glm::translate(glm::dmat4(1.0), {0.5, 0, -3});
    rig.render();
    CHECK(rig.host.calls == 1);
    CHECK(rig.host.pass == "geometry");
    CHECK(rig.host.program != 0);
    CHECK(rig.host.unknown_is_null);
    const glm::mat4 wanted =
        glm::dmat4(rig.frame.camera.clip_from_view) * rig.frame.draws[0].world_from_model;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            CHECK(rig.host.clip_from_model[i][j] == Approx(wanted[i][j]).margin(1e-6));
}

TEST_CASE("What the host draws may change with every frame, unless its revision says otherwise")
{
    HostRig rig;
    for (int i = 0; i < 3; ++i) rig.render();
    CHECK(rig.host.calls == 3);
    rig.frame.draws[0].revision = 7;
    for (int i = 0; i < 3; ++i) rig.render();
    CHECK(rig.host.calls == 4);
    rig.frame.draws[0].revision = 8;
    rig.render();
    CHECK(rig.host.calls == 5);
}

TEST_CASE("A mesh whose revision changes is drawn again")
{
    Rig rig;
    const auto draws = [&rig] {
        rig.device.clearLog();
        need(rig.renderer->render(rig.frame));
        return rig.device.log().find("draw mesh") != std::string::npos;
    };
    CHECK(draws());
    CHECK_FALSE(draws());
    rig.frame.draws[0].revision = 1;
    CHECK(draws());
}

TEST_CASE("After the host's draw the pass's program and textures are set again for the next")
{
    HostRig rig;
    DrawItem own;
    own.mesh = rig.mesh;
    own.count = 6;
    rig.frame.draws.push_back(own);
    rig.render();
    CHECK(rig.device.log().find("drawByHost") < rig.device.log().find("draw mesh"));
}

TEST_CASE("A mesh of a host's buffers is drawn as one of the device's own")
{
    Rig rig;
    HostMesh host;
    host.label = "host's";
    host.position.buffer = 3;
    host.vertex_count = 3;
    host.index_count = 3;
    rig.frame.draws[0].mesh = need(rig.device.adoptMesh(host));
    rig.frame.draws[0].count = 3;
    need(rig.renderer->render(rig.frame));
    CHECK(rig.device.log().find("draw mesh 'host's' 0..3") != std::string::npos);
}

TEST_CASE("A layout that cannot be is refused with the reason")
{
    RecordingDevice device;
    HostMesh host;
    host.label = "m";
    const auto reason = [&] {
        const auto made = device.adoptMesh(host);
        return made ? std::string() : made.diagnostics()[0].message;
    };
    CHECK(reason() == "mesh 'm' has no positions");
    host.position.buffer = 1;
    host.vertex_count = 3;
    host.index_count = 6;
    CHECK(reason() == "mesh 'm' has 3 vertices and draws 6");
    host.index_buffer = 2;
    host.index_offset = 6;
    CHECK(reason() == "mesh 'm' has its first index at byte 6, and one takes 4 bytes");
    host.index_type = IndexType::uint16;
    CHECK(reason().empty());
}

TEST_CASE("A mesh far beside its origin is kept about its own middle, and drawn where it was")
{
    RecordingDevice device;
    std::vector<Vertex> vertices(3);
    const float x[] = {1000000, 1000001, 1000000};
    for (int i = 0; i < 3; ++i) vertices[i].position[0] = x[i];
    vertices[2].position[1] = 1;
    const MeshOrigin origin = originOf({"far", vertices, {0, 1, 2}});
    CHECK(origin.x == 1000000.5);
    CHECK(origin.y == 0.5);
    for (Vertex& vertex : vertices) vertex.position[0] -= 1000000;
    CHECK(originOf({"near", vertices, {0, 1, 2}}).x == 0);

    Rig rig;
    for (Vertex& vertex : vertices) vertex.position[0] += 1000000;
    rig.frame.draws[0].mesh = need(rig.device.createMesh({"far", vertices, {0, 1, 2}}));
    rig.frame.draws[0].count = 3;
    need(rig.renderer->render(rig.frame));
    CHECK(rig.device.lastUniform("view_from_model")[12] == 1000000.5f);
}
