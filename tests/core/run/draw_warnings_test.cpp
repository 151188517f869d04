// SPDX-License-Identifier: MIT
// Draws that lack what a pass reads: a warning, once, and none where no pass reads it.
#include "tests/support/need.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

/// A rig that draws a mesh of the host's, with another vertex shader.
struct HostRig : Rig {
    explicit HostRig(const std::string& declared = "uniform mat3 view_normal_from_model;\n")
    {
        std::vector<TestFile> sources = rigSources("");
        sources[0].text = "#version 300 es\nuniform mat4 clip_from_model;\n" + declared;
        renderer = need(
            Renderer::create(device, describe(kRigConfig, sources), {{64, 32}}, traitsOf(frame)));
        host.label = "statue";
        host.position.buffer = host.normal.buffer = host.uv.buffer = 7;
        host.vertex_count = host.index_count = 3;
    }

    Diagnostics warnings()
    {
        if (host.vertex_count > 0) {
            frame.draws[0].mesh = need(device.adoptMesh(host));
            frame.draws[0].count = 3;
        }
        const Status status = renderer->render(frame);
        CHECK(status.ok());
        return status.diagnostics();
    }

    HostMesh host;
};

void drawNothing(const DrawCall&, void*) {}

}  // namespace

TEST_CASE("Of a mesh without normals a pass that reads them is warned of, once for each plan")
{
    HostRig rig;
    CHECK(rig.warnings().empty());
    rig.host.normal = {};
    const Diagnostics found = rig.warnings();
    REQUIRE(found.size() == 1);
    CHECK(found[0].code == Code::mesh_lacks);
    CHECK(found[0].severity == Severity::warning);
    CHECK(found[0].message.find("pass 'geometry' of 'rig' reads of mesh 'statue'") == 0);
    CHECK(found[0].message.find("normals") != std::string::npos);
    CHECK(found[0].help.find("depth alone") != std::string::npos);
    CHECK(textAt(found[0].place).find("geometry") != std::string::npos);
    CHECK(rig.warnings().empty());
    need(rig.renderer->resize({32, 32}));
    CHECK(rig.warnings().size() == 1);
}

TEST_CASE("Of a mesh without uv only a texture that a pass reads is warned of")
{
    HostRig rig;
    rig.host.uv = {};
    CHECK(rig.warnings().empty());
    const auto map = GENERATE(&Material::base_color_map, &Material::normal_map);
    rig.frame.materials[0].*map = need(rig.device.createTexture({"map", Format::rgba8, {1, 1}}));
    need(rig.device.writeTexture(rig.frame.materials[0].*map, Image({1, 1}, 4)));
    const Diagnostics found = rig.warnings();
    if (map == &Material::normal_map) {  // which this config has no sampler for
        CHECK(found.empty());
        return;
    }
    REQUIRE(found.size() == 1);
    CHECK(found[0].code == Code::mesh_lacks);
    CHECK(found[0].message.find("of mesh 'statue' what it has none of: uv") != std::string::npos);
    CHECK(rig.warnings().empty());
}

TEST_CASE("Of a uniform block that a mesh is drawn with its place is told, once, and the way out")
{
    HostRig rig("layout(std140) uniform Bones { mat4 bones[2]; };\n");
    rig.frame.draws[0].callback = drawNothing;
    CHECK(rig.warnings().empty());
    rig.frame.draws[0].callback = nullptr;
    const Diagnostics found = rig.warnings();
    REQUIRE(found.size() == 1);
    CHECK(found[0].code == Code::unfilled_block);
    CHECK(found[0].severity == Severity::warning);
    CHECK(found[0].message.find("pass 'geometry' draws mesh 'statue' with the uniform block "
                                "'Bones'") == 0);
    CHECK(found[0].help.find("DrawItem::callback") != std::string::npos);
    CHECK(placeName(found[0].place).find("mesh.vert:3") == 0);
    CHECK(rig.warnings().empty());
}
