// SPDX-License-Identifier: MIT
// Draws that the host does by itself, when it is called and when not again, and its meshes. What it
// is given is held in draw_values_test.cpp and by the C API.
#include <crevice/renderer.h>

#include "tests/support/renderer_rig.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

/// A rig whose one draw is the host's own.
struct HostRig : Rig {
    HostRig()
    {
        DrawItem& item = frame.draws[0];
        item = {};
        item.callback = [](const DrawCall&, void* count) { ++*static_cast<int*>(count); };
        item.host = &calls;
    }
    void render() { need(renderer->render(frame)); }
    int calls = 0;
};

}  // namespace

TEST_CASE("What the host draws may change with every frame, unless its revision says otherwise")
{
    HostRig rig;
    for (int i = 0; i < 3; ++i) rig.render();
    CHECK(rig.calls == 3);
    rig.frame.draws[0].revision = 7;
    for (int i = 0; i < 3; ++i) rig.render();
    CHECK(rig.calls == 4);
    rig.frame.draws[0].revision = 8;
    rig.render();
    CHECK(rig.calls == 5);
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
