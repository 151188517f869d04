// SPDX-License-Identifier: MIT
// Combinations of shipped modules that make no sense: one error each, with a place and the way out.
// Draws that lack what a pass reads: a warning, once, and none where no pass reads it.
#include <crevice/compile.h>
#include <crevice/recording_device.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/modules.h"
#include "tests/support/need.h"
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

using Names = std::vector<std::string>;

/// The diagnostics of a config that extends these modules; empty when it can be planned.
Diagnostics refusal(const Names& modules, const std::string& more = "")
{
    const GivenConfig config(modules, more);
    const Result<Node> document = loadConfig(config.sources(), {"given"});
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, config.sources());
    if (!description) return description.diagnostics();
    SceneTraits traits;
    traits.lights = 1;
    traits.specular = true;
    const RecordingDevice device;
    return compile(*description, traits, device.caps(), {{256, 144}, {}, {}}).diagnostics();
}

void checkRefused(const Names& modules, Code code, const char* named, const std::string& more = "")
{
    const Diagnostics diagnostics = refusal(modules, more);
    INFO(modules.back());
    const Diagnostic error = onlyError(diagnostics, code);
    CHECK(error.place.line > 0);
    CHECK_FALSE(error.help.empty());
    CHECK_THAT(error.message, Catch::Contains(named));
}

/// All of `modules` two by two, either one first.
template <class Check>
void forPairs(const std::vector<Module>& modules, Check&& check)
{
    for (const Module& one : modules)
        for (const Module& other : modules)
            if (&one != &other) check(one, other);
}

/// Itself or through others of `all`.
bool extends(const Module& module, const Module& base, const std::vector<Module>& all)
{
    const std::string& text = shippedSources().find(module.name + ".json")->text;
    const auto names = [&text](const Module& other) {
        return text.find("\"" + other.name + "\"") != std::string::npos;
    };
    return names(base) || anyOf(all, [&](const Module& between) {
               return between.name != module.name && names(between) && extends(between, base, all);
           });
}

/// One extends the other, or both add to a third, and then they may go together.
bool related(const Module& one, const Module& other, const std::vector<Module>& all)
{
    return extends(one, other, all) || extends(other, one, all) ||
           anyOf(all, [&](const Module& base) {
               return extends(one, base, all) && extends(other, base, all);
           });
}

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

TEST_CASE("Two estimators in one config are refused, whichever they are")
{
    forPairs(shippedEstimators(), [](const Module& one, const Module& other) {
        if (related(one, other, shippedEstimators())) return;
        const Names modules = {"geometry/depth_normal", one.name, other.name, "filter/box"};
        checkRefused(modules, Code::module_clash, "both make ");
    });
}

TEST_CASE("Two inputs in one config are refused, unless the second takes the place of the first")
{
    forPairs(shippedInputs(), [](const Module& one, const Module& other) {
        if (related(one, other, shippedInputs())) return;
        const Names modules = {one.name, other.name, "ssao/gtao", "filter/box"};
        INFO(one.name << ", then " << other.name);
        if (startsWith(other.name, "geometry/host_"))
            CHECK(toText(refusal(modules)) ==
                  toText(refusal({other.name, "ssao/gtao", "filter/box"})));
        else
            checkRefused(modules, Code::module_clash, "interface 'surface'");
    });
}

TEST_CASE("Two ways of lighting in one config are refused")
{
    checkRefused({"geometry/depth_normal", "ssao/gtao", "filter/box", "lighting/deferred",
                  "lighting/forward"},
                 Code::module_clash, "shader 'lighting'");
}

TEST_CASE("Bent normals are refused on an estimator that has none")
{
    for (const Module& estimator : shippedEstimators()) {
        const Names modules = {"geometry/depth_normal", estimator.name, "ssao/bent_normals"};
        const SourceRef shader =
            shippedSources().find("ssao/shaders" + estimator.name.substr(4) + ".glsl");
        const bool has = shader && shader->text.find("BENT_NORMALS") != std::string::npos;
        if (has)
            CHECK(refusal(modules).empty());
        else if (estimator.targets.size() > 1)
            CHECK(hasErrors(refusal(modules)));
        else
            checkRefused(modules, Code::output_mismatch, "'bent_normal'");
    }
}

TEST_CASE("Layers behind the first one go with any surface, drawn or of a host")
{
    for (const char* surface : {"geometry/host_position_normal", "geometry/position_normal"})
        CHECK(refusal({surface, "ssao/bitmask", "geometry/second_layer", "filter/box"}).empty());
}

TEST_CASE("Of a mesh without normals a pass that reads them is warned of, once for each plan")
{
    HostRig rig;
    CHECK(rig.warnings().empty());
    rig.host.normal = {};
    const Diagnostic found = onlyWarning(rig.warnings(), Code::mesh_lacks);
    CHECK(startsWith(found.message, "pass 'geometry' of 'rig' reads of mesh 'statue'"));
    CHECK(has(found.message, "normals"));
    CHECK(has(found.help, "depth alone"));
    CHECK(has(textAt(found.place), "geometry"));
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
    CHECK(has(onlyWarning(found, Code::mesh_lacks).message,
              "of mesh 'statue' what it has none of: uv"));
    CHECK(rig.warnings().empty());
}

TEST_CASE("Of a uniform block that a mesh is drawn with its place is told, once, and the way out")
{
    HostRig rig("layout(std140) uniform Bones { mat4 bones[2]; };\n");
    rig.frame.draws[0].callback = drawNothing;
    CHECK(rig.warnings().empty());
    rig.frame.draws[0].callback = nullptr;
    const Diagnostic found = onlyWarning(rig.warnings(), Code::unfilled_block);
    CHECK(startsWith(found.message,
                     "pass 'geometry' draws mesh 'statue' with the uniform block 'Bones'"));
    CHECK(has(found.help, "DrawItem::callback"));
    CHECK(startsWith(placeName(found.place), "mesh.vert:3"));
    CHECK(rig.warnings().empty());
}
