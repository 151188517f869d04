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
    for (const std::string& config : {std::string("balanced"), std::string(kHostDepth), file}) {
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

TEST_CASE("An effect adopts a texture once, and another in its place")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    const int live = device.live();
    const int attempts = device.attempts();
    need(effect.setTexture("depth", 7, Format::depth24, kExtent));
    CHECK(device.attempts() == attempts);
    need(effect.setTexture("depth", 8, Format::depth32f, {128, 72}));
    CHECK(device.live() == live);
    REQUIRE(effect.frame().textures.size() == 1);
    CHECK(device.nativeName(effect.frame().textures[0].texture) == 8);
    need(effect.render());
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
    CHECK(!effect.setParam("radiuss", 1));
    CHECK(!effect.setFeature("no_such", "true"));
    CHECK(effect.frame().textures.empty());
}
