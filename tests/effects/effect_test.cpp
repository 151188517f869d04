// SPDX-License-Identifier: MIT
// The facade, on a device that draws nothing: what it makes of names, texts and textures.
#include <crevice/effect.h>
#include <crevice/renderer.h>

#include <crevice/recording_device.h>

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

/// An effect on a host's depth, or of another config, on a device that draws nothing.
struct Rig {
    RecordingDevice device;
    Effect effect = need(Effect::create(device, kHostDepth, kExtent));

    explicit Rig(Format depth = Format::depth24)
    {
        need(effect.setTexture("depth", 7, depth, kExtent));
    }

    /// The uniform of a frame with that projection, by columns.
    std::vector<float> viewFromWindow(const glm::mat4& projection)
    {
        effect.setProjection(glm::value_ptr(projection));
        need(effect.render());
        const std::vector<float> uniform = device.lastUniform("view_from_window");
        REQUIRE(uniform.size() == 16);
        return uniform;
    }
};

/// The projection that gives the same picture under that clip control.
glm::mat4 under(const ClipControl& control, const glm::mat4& lens)
{
    glm::mat4 rows = glm::transpose(lens);
    if (control.zero_to_one) rows[2] = 0.5f * (rows[2] + rows[3]);
    if (control.upper_left) rows[1] = -rows[1];
    return glm::transpose(rows);
}

/// What a failure or warning says.
std::string said(const Status& status) { return toText(status.diagnostics()); }

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

TEST_CASE("An effect without a view takes projections of either hand, and a view must fit its own")
{
    Rig rig;
    const glm::mat4 left_handed = glm::perspectiveLH(1.0f, 1.5f, 0.1f, 10.0f);
    for (const glm::mat4& projection : {left_handed, glm::make_mat4(kProjection), left_handed})
        rig.viewFromWindow(projection);
    rig.effect.setView(glm::value_ptr(glm::dmat4(1.0)));
    CHECK_THAT(said(rig.effect.render()), Catch::Contains("along +z"));
}

TEST_CASE("Without a view a left-handed box is looked at along +z, under any clip control")
{
    const bool told = GENERATE(false, true);
    const bool reversed = GENERATE(false, true);
    for (const ClipControl control : {ClipControl{false, false}, ClipControl{true, false}}) {
        Rig rig;
        glm::mat4 rows = glm::transpose(glm::orthoLH_NO(-2.0f, 2.0f, -1.0f, 1.0f, 1.0f, 9.0f));
        if (reversed) rows[2] = -rows[2];
        if (told) rig.effect.setClipControl(control);
        if (!told) rig.device.setClipControl(control);
        const std::vector<float> uniform = rig.viewFromWindow(under(control, glm::transpose(rows)));
        const glm::vec4 nearest =
            glm::make_mat4(uniform.data()) * glm::vec4(1, 0.5f, reversed ? 1 : 0, 1);
        CHECK(nearest.x == Approx(2));
        CHECK(nearest.z == Approx(-1));
    }
}

TEST_CASE("An effect adopts a texture once, and another in its place")
{
    Rig rig;
    const int live = rig.device.live();
    const int attempts = rig.device.attempts();
    need(rig.effect.setTexture("depth", 7, Format::depth24, kExtent));
    CHECK(rig.device.attempts() == attempts);
    need(rig.effect.setTexture("depth", 8, Format::depth24, {128, 72}));
    CHECK(rig.device.live() == live);
    REQUIRE(rig.effect.frame().textures.size() == 1);
    CHECK(rig.device.nativeName(rig.effect.frame().textures[0].texture) == 8);
    need(rig.effect.render());
}

TEST_CASE("Under any clip control the same view is computed from the same window depth")
{
    for (const glm::mat4& lens :
         {glm::perspective(1.0f, 1.5f, 0.1f, 10.0f), glm::perspective(1.0f, 1.5f, 10.0f, 0.1f),
          glm::infinitePerspective(1.0f, 1.5f, 0.1f),
          glm::frustum(-0.1f, 0.3f, -0.2f, 0.1f, 0.1f, 9.0f),
          glm::ortho(-3.0f, 2.0f, -1.0f, 2.0f, 0.1f, 10.0f)}) {
        Rig rig;
        const std::vector<float> plain = rig.viewFromWindow(lens);
        for (const ClipControl control :
             {ClipControl{true, false}, ClipControl{false, true}, ClipControl{true, true}}) {
            INFO(control.zero_to_one << control.upper_left);
            rig.device.setClipControl(control);
            const std::vector<float> same = rig.viewFromWindow(under(control, lens));
            for (int i = 0; i < 16; ++i) CHECK(same[i] == Approx(plain[i]).margin(2e-5));
        }
        // What the host says goes before what its context is set to.
        rig.effect.setClipControl({});
        CHECK(rig.viewFromWindow(lens) == plain);
    }
}

TEST_CASE("Under any depth range the window's near and far depth show the same planes")
{
    const glm::mat4 lens = glm::perspective(1.0f, 1.5f, 0.1f, 10.0f);
    for (const DepthRange range : {DepthRange{0, 0.5f}, {1, 0}, {0, 0.1f}, {0.9f, 0.2f}}) {
        INFO(range.near_depth << " " << range.far_depth);
        Rig rig;
        const bool told = GENERATE(false, true);
        if (told) rig.effect.setDepthRange(range);
        rig.device.setDepthRange(told ? DepthRange{0.3f, 0.6f} : range);
        const glm::mat4 view = glm::make_mat4(rig.viewFromWindow(lens).data());
        const auto z = [&view](float depth) {
            const glm::vec4 at = view * glm::vec4(0.5f, 0.5f, depth, 1);
            return at.z / at.w;
        };
        CHECK(z(range.near_depth) == Approx(-0.1));
        CHECK(z(range.far_depth) == Approx(-10).epsilon(1e-3));
    }
}

TEST_CASE("A depth range of no extent is refused, and means nothing to what draws its own depth")
{
    Rig rig;
    rig.device.setDepthRange({1, 1});
    const Diagnostic refused = onlyError(rig.effect.render(), Code::bad_input);
    CHECK_THAT(toText(refused), Catch::Contains("depth range") && Catch::Contains("glDepthRange"));
    Effect drawn = need(Effect::create(rig.device, "mobile", kExtent));
    drawn.setProjection(kProjection);
    need(drawn.render());
}

TEST_CASE("Two cameras that take turns with one history are warned of once, and one that moves not")
{
    enum class Kind { moving, turning, cut, jittered, still };
    for (const Kind kind : {Kind::moving, Kind::turning, Kind::cut, Kind::jittered, Kind::still}) {
        for (const char* config : {"balanced_temporal", "mobile"}) {
            INFO(config << " " << static_cast<int>(kind));
            RecordingDevice device;
            Effect effect = need(Effect::create(device, config, kExtent));
            int warnings = 0;
            for (int i = 0; i < 12; ++i) {
                float lens[16];
                std::copy(std::begin(kProjection), std::end(kProjection), lens);
                if (kind == Kind::jittered) lens[12] = i % 2 * 0.01f;
                effect.setProjection(lens);
                glm::dmat4 view(1.0);
                view[3].x = kind == Kind::moving ? 0.1 * i : 0.001 * i;
                if (kind == Kind::still) view[3].x = 0;
                if (kind == Kind::turning || kind == Kind::cut) view[3].x += i % 2 * 0.06;
                effect.setView(glm::value_ptr(view));
                effect.frame().camera_cut = kind == Kind::cut;
                const Status status = effect.render();
                REQUIRE(status.ok());
                warnings += said(status).find("take turns") != std::string::npos;
            }
            CHECK(warnings == (kind == Kind::turning && config != std::string("mobile")));
        }
    }
}

TEST_CASE("An effect hands out what an output is drawn into, and copies what no shader reads")
{
    Rig rig;
    HostTexture layer{7, "", Format::depth16, kExtent};
    layer.kind = HostTexture::Kind::layer;
    layer.layer = 2;
    need(rig.effect.setTexture("depth", layer));
    rig.device.clearLog();
    need(rig.effect.render());
    need(rig.effect.render());
    const std::string log = rig.device.log();
    CHECK(log.find("refresh 'depth'") != log.rfind("refresh 'depth'"));
    const OutputTexture ao = rig.effect.outputTexture("ao");
    CHECK(ao.native_name == rig.effect.nativeName("ao"));
    CHECK(ao.format == Format::r8);
    CHECK(ao.extent == kExtent);
    CHECK(rig.effect.outputTexture("colour").native_name == 0);
    HostFramebuffer target;
    target.extent = kExtent;
    need(rig.effect.present("ao", target));
    CHECK_THAT(onlyError(rig.effect.present("oa", target), Code::output_missing).help,
               Catch::Contains("did you mean 'ao'"));
    need(rig.effect.setParam("intensity", 0));
    CHECK(rig.effect.outputTexture("ao").extent == Extent{1, 1});
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("A host's depth of another format plans again, for its own steps")
{
    Rig rig;
    const auto formatOf = [&] {
        return findNamed(rig.effect.renderer().description().imports, "depth")->format;
    };
    CHECK(formatOf() == "depth24");
    need(rig.effect.setTexture("depth", 7, Format::depth16, kExtent));
    CHECK(formatOf() == "depth16");
    need(rig.effect.render());
    CHECK(!rig.effect.renderer().setImportFormat("dept", Format::depth16));
}

TEST_CASE("An effect whose projection was never set warns once")
{
    Rig rig, told;
    const auto warns = [](Rig& of) {
        const Status status = of.effect.render();
        CHECK(status.ok());
        return said(status).find("setProjection") != std::string::npos;
    };
    CHECK(warns(rig));
    CHECK_FALSE(warns(rig));
    told.effect.setProjection(kProjection);
    CHECK_FALSE(warns(told));
}

TEST_CASE("An effect refuses a texture that its config does not import, with a way out")
{
    Rig rig;
    const Status unknown = rig.effect.setTexture("dept", 7, Format::depth24, kExtent);
    CHECK_THAT(onlyError(unknown, Code::reference_missing).help,
               Catch::Contains("did you mean 'depth'"));
    CHECK(rig.effect.frame().textures.size() == 1);
    Effect drawn = need(Effect::create(rig.device, "mobile", kExtent));
    CHECK_THAT(said(drawn.setTexture("depth", 7, Format::depth24, kExtent)),
               Catch::Contains("+geometry/host_depth"));
}

TEST_CASE("A radius relative to the scene follows the scale of each frame, and is nothing without")
{
    Rig rig;
    rig.effect.setProjection(kProjection);
    const float share[] = {0, 5, 0}, pixels[] = {0, 0, 9};
    const auto drawn = [&rig](double diagonal) {
        rig.effect.setScale(diagonal, 0);
        need(rig.effect.render());
        return rig.device.lastUniform("radius").at(0);
    };
    need(rig.effect.setParam("radius", share, 3));
    CHECK(said(rig.effect.render()).find("CV6010: radius") != std::string::npos);
    CHECK(drawn(20) == 1);
    CHECK(drawn(40) == 2);
    need(rig.effect.setParam("radius", pixels, 3));
    CHECK(drawn(0) == 0.5f);
    const float both[] = {1, 5, 0};
    CHECK(said(rig.effect.setParam("radius", both, 3)).find("CV3006") != std::string::npos);
    CHECK(said(rig.effect.setParam("power", share, 3)).find("CV3006") != std::string::npos);
}
