// SPDX-License-Identifier: MIT
// Levels of a renderer: what a switch compiles, which is nothing, and what it keeps.
#include "tests/support/renderer_rig.h"

using namespace crevice;

namespace {

/// The rig's description by another name, with a value of a param.
Description levelOf(const std::string& name, const char* param, float value, bool remembers = false)
{
    Description made = rigDescription(remembers);
    made.name = name;
    for (ParamDesc& each : made.params)
        if (each.name == param) each.value[0] = value;
    return made;
}

/// Levels of 2, 4 and 8 samples, each of which compiles a shader of its own.
struct LevelRig : Rig {
    explicit LevelRig(bool remembering = false) : Rig(remembering)
    {
        need(renderer->setLevels(
            {levelOf("low", "samples", 2, remembers), levelOf("middle", "samples", 4, remembers),
             levelOf("high", "samples", 8, remembers)},
            1));
    }

    /// Goes through all, and draws; whether a program was compiled.
    bool compiles()
    {
        bool compiled = false;
        for (const int level : {0, 2, 1, 0, 1, 2}) {
            device.clearLog();
            need(renderer->setLevel(level));
            compiled = compiled || logged("createProgram");
            draw();
            compiled = compiled || logged("createProgram");
            CHECK(renderer->level() == level);
        }
        return compiled;
    }

    float sent(const char* uniform) const { return device.lastUniform(uniform).at(0); }

    /// The texture that was written last is the one that the next frame remembers.
    void checkGoesOn(int level)
    {
        const TextureId written = renderer->output("ao");
        const float index = sent("frame_index");
        need(renderer->setLevel(level));
        draw();
        CHECK(sent("history_valid") == 1);
        CHECK(sent("frame_index") == index + 1);
        const TextureId now = renderer->output("ao");
        CHECK(now.value != written.value);
        draw();
        CHECK(renderer->output("ao").value == written.value);
        CHECK(sent("history_valid") == 1);
    }
};

}  // namespace

TEST_CASE("A switch between levels compiles nothing, whatever happened before")
{
    LevelRig rig;
    CHECK_FALSE(rig.compiles());
    need(rig.renderer->resize({32, 32}));
    CHECK_FALSE(rig.compiles());
    rig.frame.materials[0].alpha_cutoff = 0.5f;  // other traits, and so other shaders
    rig.draw();
    CHECK_FALSE(rig.compiles());
    for (int edge = 0; edge <= 40; ++edge)  // more programs than idle ones are kept
        need(rig.renderer->setParam("edge", static_cast<float>(edge) / 40));
    CHECK_FALSE(rig.compiles());
    need(rig.renderer->setFeature("look", "flat"));
    CHECK_FALSE(rig.compiles());
    rig.renderer.reset();
    CHECK(rig.device.live(ObjectId::Kind::program) == 0);
}

TEST_CASE("What is set holds for all levels")
{
    LevelRig rig;
    need(rig.renderer->setParam("radius", 2.0f));
    need(rig.renderer->setFeature("soft", "false"));
    need(rig.renderer->setParam("intensity", 0.0f));  // a no-op: another plan
    need(rig.renderer->setImportFormat("decal", Format::depth32f));
    need(rig.renderer->resize({32, 32}));
    for (const int level : {0, 2, 1}) {
        need(rig.renderer->setLevel(level));
        rig.draw();
        CHECK(rig.value("radius") == 2);
        CHECK(rig.feature("soft") == 0);
        CHECK_FALSE(rig.ranPass("occlusion"));
        CHECK(findNamed(rig.renderer->description().imports, "decal")->format == "depth32f");
    }
    CHECK(rig.value("samples") == 4);
    need(rig.renderer->setParam("intensity", 0.5f));
    need(rig.renderer->setParam("radius", 3.0f));
    need(rig.renderer->setLevel(0));
    rig.draw();
    CHECK(rig.sent("intensity") == 0.5f);
    CHECK(rig.sent("radius") == 3);
    // What was set before there were levels goes on, too.
    need(rig.renderer->setLevels({rigDescription()}, 0));
    CHECK(rig.value("radius") == 3);
}

TEST_CASE("What one level has already, lacks or refuses is set for all levels, or for none")
{
    Rig rig;
    Description other = levelOf("other", "radius", 2);
    other.params[indexOf(other.params, "intensity")].max = 2;
    other.params.push_back(ParamDesc(*findNamed(other.params, "radius")));
    other.params.back().name = "extra";
    other.features[indexOf(other.features, "soft")].value = 0;
    need(rig.renderer->setLevels({levelOf("first", "radius", 1), other}, 0));
    need(rig.renderer->setParam("radius", 1.0f));
    need(rig.renderer->setFeature("soft", "true"));
    need(rig.renderer->setParam("extra", 7.0f));
    CHECK(onlyCode(rig.renderer->setParam("intensity", 3.0f)) == Code::out_of_range);
    CHECK(rig.value("intensity") == 1);
    need(rig.renderer->setLevel(1));
    CHECK(rig.value("radius") == 1);
    CHECK(rig.feature("soft") == 1);
    CHECK(rig.value("extra") == 7);
    CHECK(rig.value("intensity") == 1);
    CHECK(onlyCode(rig.renderer->setParam("extras", 7.0f)) == Code::unknown_param);
}

TEST_CASE("Histories go on from level to level, and end at a cut")
{
    LevelRig rig(true);
    rig.draw();
    CHECK(rig.sent("history_valid") == 0);
    for (const int level : {2, 0, 1, 2}) rig.checkGoesOn(level);
    need(rig.renderer->setLevel(0));  // two at once
    rig.checkGoesOn(1);
    need(rig.renderer->setFeature("look", "flat"));
    rig.checkGoesOn(2);
    rig.frame.camera_cut = true;
    need(rig.renderer->setLevel(1));
    rig.draw();
    CHECK(rig.sent("history_valid") == 0);
}

TEST_CASE("A history of another shape, and one that was not drawn, begins anew")
{
    Rig rig(true);
    Description other = rigDescription(true);
    for (TargetDesc& target : other.targets)
        if (target.name == "smooth_ao") target.formats = {Format::rgba8};
    Description smaller = rigDescription(true);
    for (TargetDesc& target : smaller.targets)
        if (target.name == "smooth_ao") target.size.scale = 0.5f;
    rig.frame.camera_cut = false;
    need(rig.renderer->setLevels(
        {rigDescription(true), std::move(other), std::move(smaller), rigDescription(false)}, 0));
    const auto sent = [&rig] { return rig.device.lastUniform("history_valid").at(0); };
    for (const int level : {1, 2, 3}) {
        INFO(level);
        rig.draw();
        rig.draw();
        CHECK(sent() == 1);
        need(rig.renderer->setLevel(level));
        rig.draw();
        if (level < 3) CHECK(sent() == 0);
        need(rig.renderer->setLevel(0));
        rig.draw();
        CHECK(sent() == 0);
    }
    // A reload says that the config is another.
    rig.draw();
    need(rig.renderer->reload(rigDescription(true), {{64, 32}}));
    rig.draw();
    CHECK(sent() == 0);
}

TEST_CASE("Levels that take other things of the host are refused, and what was there stays")
{
    LevelRig rig;
    Description needy = rigDescription();
    needy.name = "needy";
    for (ImportDesc& import : needy.imports)
        if (import.name == "decal") import.optional = false;
    const Status refused = rig.renderer->setLevels({rigDescription(), needy}, 0);
    CHECK(codeOf(refused) == Code::reference_missing);
    CHECK_THAT(refused.diagnostics()[0].message, Catch::Contains("the texture 'decal'"));
    Description broken = rigDescription();
    broken.outputs.clear();
    CHECK(codeOf(rig.renderer->setLevels({rigDescription(), broken}, 0)) == Code::no_outputs);
    rig.device.failAt(2);  // the program of the second
    const Status failed =
        rig.renderer->setLevels({levelOf("a", "samples", 16), levelOf("b", "samples", 32)}, 0);
    CHECK(onlyCode(failed) == Code::out_of_memory);
    CHECK_THAT(failed.diagnostics()[0].message, Catch::Contains("level 1, 'b': "));
    CHECK(rig.renderer->level() == 1);
    CHECK_FALSE(rig.compiles());
    // One that lacks memory for its textures leaves the level that there is.
    rig.device.failAt(1);
    CHECK_FALSE(rig.renderer->setLevel(1).ok());
    CHECK(rig.renderer->level() == 2);
    rig.draw();
    rig.device.loseContext();
    CHECK(onlyCode(rig.renderer->setLevel(1)) == Code::context_lost);
    CHECK(rig.renderer->level() == 2);
}
