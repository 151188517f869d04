// SPDX-License-Identifier: MIT
// The facade, on a device that draws nothing: what it makes of names, texts and textures.
#include <crevice/effect.h>
#include <crevice/renderer.h>

#include <crevice/recording_device.h>

#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};
const char* const kHostDepth = R"({ "format": 1, "name": "ao",
    "extends": ["geometry/host_depth", "ssao/hemisphere", "filter/box"] })";
// An orthographic view of the cube [-1, 1].
const float kProjection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};

std::string messagesOf(const Diagnostics& diagnostics) { return toText(diagnostics); }

}  // namespace

TEST_CASE("An effect is made of a config's name, of JSON text or of a file")
{
    RecordingDevice device;
    TemporaryFolder folder("effect");
    const std::string file = folder.write("mine.json", kHostDepth);
    for (const std::string& config :
         {std::string("balanced"), std::string("mobile+geometry/host_depth"),
          std::string(kHostDepth), file}) {
        INFO(config);
        Effect effect = need(Effect::create(device, config, kExtent, {"ao"}));
        CHECK(effect.renderer().plan().outputs.size() == 1);
    }
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
}

TEST_CASE("An effect draws a host's depth and hands out the texture of its output")
{
    RecordingDevice device;
    {
        Effect effect = need(Effect::create(device, kHostDepth, kExtent));
        effect.setProjection(kProjection);
        need(effect.setTexture("depth", 7, Format::depth24, kExtent));
        need(effect.setParam("radius", 0.5f));
        need(effect.render());
        CHECK(effect.nativeName("ao") == device.nativeName(effect.output("ao")));
        CHECK(effect.output("ao"));
        CHECK(effect.nativeName("colour") == 0);
        CHECK(device.lastUniform("radius") == std::vector<float>{0.5f});
        need(effect.resize({32, 18}));
        need(effect.render());
    }
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
}

TEST_CASE("An effect without a view takes projections of either hand, and a view must fit its own")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    effect.setProjection(glm::value_ptr(glm::perspectiveLH(1.0f, 1.5f, 0.1f, 10.0f)));
    need(effect.render());
    effect.setProjection(kProjection);
    need(effect.render());
    effect.setProjection(glm::value_ptr(glm::perspectiveLH(1.0f, 1.5f, 0.1f, 10.0f)));
    effect.setView(glm::value_ptr(glm::dmat4(1.0)));
    const Status refused = effect.render();
    REQUIRE(!refused);
    CHECK(messagesOf(refused.diagnostics()).find("along +z") != std::string::npos);
}

TEST_CASE("Without a view a left-handed box is looked at along +z, under any clip control")
{
    const bool told = GENERATE(false, true);
    const bool reversed = GENERATE(false, true);
    for (const ClipControl control : {ClipControl{false, false}, ClipControl{true, false}}) {
        RecordingDevice device;
        Effect effect = need(Effect::create(device, kHostDepth, kExtent));
        need(effect.setTexture("depth", 7, Format::depth24, kExtent));
        glm::mat4 rows = glm::transpose(glm::orthoLH_NO(-2.0f, 2.0f, -1.0f, 1.0f, 1.0f, 9.0f));
        if (reversed) rows[2] = -rows[2];
        if (control.zero_to_one) rows[2] = 0.5f * (rows[2] + rows[3]);
        effect.setProjection(glm::value_ptr(glm::transpose(rows)));
        if (told) effect.setClipControl(control);
        if (!told) device.setClipControl(control);
        need(effect.render());
        const std::vector<float> uniform = device.lastUniform("view_from_window");
        REQUIRE(uniform.size() == 16);
        const glm::vec4 nearest =
            glm::make_mat4(uniform.data()) * glm::vec4(1, 0.5f, reversed ? 1 : 0, 1);
        CHECK(nearest.x == Approx(2));
        CHECK(nearest.z == Approx(-1));
    }
}

TEST_CASE("An effect adopts a texture once, and another in its place")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    const int live = device.live();
    const int attempts = device.attempts();
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    CHECK(device.attempts() == attempts);
    need(effect.setTexture("depth", 8, Format::depth24, {128, 72}));
    CHECK(device.live() == live);
    REQUIRE(effect.frame().textures.size() == 1);
    CHECK(device.nativeName(effect.frame().textures[0].texture) == 8);
    need(effect.render());
}

TEST_CASE("Under any clip control the same view is computed from the same window depth")
{
    const glm::mat4 lenses[] = {glm::perspective(1.0f, 1.5f, 0.1f, 10.0f),
                                glm::perspective(1.0f, 1.5f, 10.0f, 0.1f),
                                glm::infinitePerspective(1.0f, 1.5f, 0.1f),
                                glm::frustum(-0.1f, 0.3f, -0.2f, 0.1f, 0.1f, 9.0f),
                                glm::ortho(-3.0f, 2.0f, -1.0f, 2.0f, 0.1f, 10.0f)};
    for (const glm::mat4& lens : lenses) {
        RecordingDevice device;
        Effect effect = need(Effect::create(device, kHostDepth, kExtent));
        need(effect.setTexture("depth", 7, Format::depth24, kExtent));
        effect.setProjection(glm::value_ptr(lens));
        need(effect.render());
        const std::vector<float> plain = device.lastUniform("view_from_window");
        REQUIRE(plain.size() == 16);
        for (const ClipControl control :
             {ClipControl{true, false}, ClipControl{false, true}, ClipControl{true, true}}) {
            INFO(control.zero_to_one << control.upper_left);
            glm::mat4 rows = glm::transpose(lens);
            if (control.zero_to_one) rows[2] = 0.5f * (rows[2] + rows[3]);
            if (control.upper_left) rows[1] = -rows[1];
            effect.setProjection(glm::value_ptr(glm::transpose(rows)));
            device.setClipControl(control);
            need(effect.render());
            const std::vector<float> same = device.lastUniform("view_from_window");
            REQUIRE(same.size() == 16);
            for (int i = 0; i < 16; ++i) CHECK(same[i] == Approx(plain[i]).margin(2e-5));
        }
        // What the host says goes before what its context is set to.
        effect.setClipControl({});
        effect.setProjection(glm::value_ptr(lens));
        need(effect.render());
        CHECK(device.lastUniform("view_from_window") == plain);
    }
}

TEST_CASE("A reversed infinite view keeps its far depths under a clip control from 0 to 1")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    need(effect.setTexture("depth", 7, Format::depth32f, kExtent));
    const float near = 0.1f, far = 1e5f;
    glm::mat4 lens(0.0f);
    lens[0][0] = 1.0f;
    lens[1][1] = 1.5f;
    lens[2][2] = near / (far - near);
    lens[2][3] = -1.0f;
    lens[3][2] = near * far / (far - near);
    effect.setProjection(glm::value_ptr(lens));
    effect.setClipControl({true, false});
    need(effect.render());
    const std::vector<float> uniform = device.lastUniform("view_from_window");
    REQUIRE(uniform.size() == 16);
    const glm::mat4 view_from_window = glm::make_mat4(uniform.data());
    for (const float distance : {0.5f, 100.0f, 5e4f}) {
        const glm::vec4 clip = lens * glm::vec4(0, 0, -distance, 1);
        const glm::vec4 view = view_from_window * glm::vec4(0.5f, 0.5f, clip.z / clip.w, 1);
        CHECK(-view.z / view.w == Approx(distance).epsilon(1e-4));
    }
}

TEST_CASE("An effect hands out what an output is drawn into, and copies what no shader reads")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    HostTexture layer{7, "", Format::depth16, kExtent};
    layer.kind = HostTexture::Kind::layer;
    layer.layer = 2;
    need(effect.setTexture("depth", layer));
    device.clearLog();
    need(effect.render());
    need(effect.render());
    const std::string log = device.log();
    CHECK(log.find("refresh 'depth'") != log.rfind("refresh 'depth'"));
    const OutputTexture ao = effect.outputTexture("ao");
    CHECK(ao.native_name == effect.nativeName("ao"));
    CHECK(ao.format == Format::r8);
    CHECK(ao.extent == kExtent);
    CHECK(effect.outputTexture("colour").native_name == 0);
    HostFramebuffer target;
    target.extent = kExtent;
    need(effect.present("ao", target));
    const Status unknown = effect.present("oa", target);
    REQUIRE(!unknown);
    CHECK(unknown.diagnostics()[0].code == Code::output_missing);
    CHECK(messagesOf(unknown.diagnostics()).find("did you mean 'ao'") != std::string::npos);
    need(effect.setParam("intensity", 0));
    CHECK(effect.outputTexture("ao").extent == Extent{1, 1});
    CHECK(device.misuse().empty());
}

TEST_CASE("A host's depth of another format plans again, for its own steps")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    const auto formatOf = [&] {
        for (const ImportDesc& import : effect.renderer().description().imports)
            if (import.name == "depth") return import.format;
        return std::string();
    };
    CHECK(formatOf() == "depth24");
    need(effect.setTexture("depth", 7, Format::depth16, kExtent));
    CHECK(formatOf() == "depth16");
    need(effect.render());
    CHECK(!effect.renderer().setImportFormat("dept", Format::depth16));
}

TEST_CASE("An effect whose projection was never set warns once")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    const auto warnings = [&] {
        const Status status = effect.render();
        CHECK(status.ok());
        return messagesOf(status.diagnostics());
    };
    CHECK(warnings().find("setProjection") != std::string::npos);
    CHECK(warnings().find("setProjection") == std::string::npos);

    Effect told = need(Effect::create(device, kHostDepth, kExtent));
    told.setProjection(kProjection);
    need(told.setTexture("depth", 7, Format::depth24, kExtent));
    CHECK(messagesOf(told.render().diagnostics()).find("setProjection") == std::string::npos);
}

TEST_CASE("An effect refuses what its config does not know, with a way out")
{
    RecordingDevice device;
    const auto unknown = Effect::create(device, "balancd", kExtent);
    REQUIRE(!unknown);
    CHECK(messagesOf(unknown.diagnostics()).find("did you mean 'balanced'") != std::string::npos);
    const auto text = Effect::create(
        device, "{ \"format\": 1,\n  \"extends\": [\"geometry/host_dept\"] }", kExtent);
    REQUIRE(!text);
    CHECK(text.diagnostics()[0].place.line == 2);
    CHECK(messagesOf(text.diagnostics()).find("(JSON text)") != std::string::npos);

    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    const Status texture = effect.setTexture("dept", 7, Format::depth24, kExtent);
    REQUIRE(!texture);
    CHECK(texture.diagnostics()[0].code == Code::reference_missing);
    CHECK(messagesOf(texture.diagnostics()).find("did you mean 'depth'") != std::string::npos);
    Effect drawn = need(Effect::create(device, "mobile", kExtent));
    const Status no_import = drawn.setTexture("depth", 7, Format::depth24, kExtent);
    CHECK(messagesOf(no_import.diagnostics()).find("+geometry/host_depth") != std::string::npos);
    CHECK(!effect.setParam("radiuss", 1));
    CHECK(!effect.setFeature("no_such", "true"));
    CHECK(effect.frame().textures.empty());
}
