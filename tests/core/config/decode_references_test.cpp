// SPDX-License-Identifier: MIT
// Decoding: names that lead nowhere or collide.
#include "tests/support/decode_fixture.h"

using namespace crevice;

namespace {

// A pass that writes `ao`, with more keys.
std::string pass(const std::string& more)
{
    return R"({"p": {"shader": "ao", "color": ["ao"], )" + more + "}}";
}

void checkPass(const std::string& more, const std::string& errors)
{
    const auto result = decodeWith({{"passes", pass(more)}});
    INFO(more << "\n" << toText(result.diagnostics()));
    CHECK(errorsOf(result) == errors);
}

}  // namespace

TEST_CASE("a pass that reads a missing target is reported as the design says", "[decode]")
{
    const std::string text = R"({ "format": 1,
  "targets": { "ao_filtered": { "format": "r8" }, "color": { "format": "rgba8" } },
  "shaders": { "s": { "vertex": "common/fullscreen.vert", "fragment": "geometry/normal.glsl" } },
  "passes": { "lighting": { "shader": "s", "color": "color",
    "inputs": { "ao": "ao_filterd" } } } })";
    Node document = parsed(text);
    Node* input = document.find("passes")->find("lighting")->find("inputs")->find("ao");
    input->origins.push_back({input->place.source, 2, 3, 4});
    const auto result = decode(document, glslSources());
    REQUIRE(errorsOf(result) == "CV2103 /passes/lighting/inputs/ao");
    const Diagnostic& error = result.diagnostics().at(0);
    CHECK(error.message == "pass 'lighting' reads target 'ao_filterd', which does not exist");
    CHECK(error.help == "did you mean 'ao_filtered'? targets: ao_filtered, color");
    CHECK(error.place.line == 5);
    CHECK(underlined(error).find("ao_filterd") != std::string::npos);
    REQUIRE(error.notes.size() == 1);
    CHECK(error.notes[0].place.line == 2);
}

TEST_CASE("a pass that writes a missing target says so", "[decode]")
{
    const auto result = decodeWith({{"passes", R"({"p": {"shader": "ao", "color": ["ao", "aoo"],
        "depth": "dept"}})"}});
    REQUIRE(errorsOf(result) == "CV2103 /passes/p/color/1; CV2103 /passes/p/depth");
    CHECK(result.diagnostics()[0].message == "pass 'p' writes target 'aoo', which does not exist");
}

TEST_CASE("each reference of a pass is checked", "[decode]")
{
    checkPass(R"("when": {"fats": true})", "CV2105 /passes/p/when/fats");
    checkPass(R"("when": {"scene.sky": true})", "CV2105 /passes/p/when/scene.sky");
    checkPass(R"("bypass": {"ao": "ao_raw"})", "CV2103 /passes/p/bypass/ao");
    checkPass(R"("bypass": {"aoo": "depth"})", "CV2103 /passes/p/bypass/aoo");
    checkPass(R"("no_op": {"radios": {"at": 0, "gives": {"ao": 1}}})",
              "CV2102 /passes/p/no_op/radios");
    checkPass(R"("no_op": {"radius": {"at": 0, "gives": {"ao": "one"}}})",
              "CV2103 /passes/p/no_op/radius/gives/ao");
    checkPass(R"("inputs": {"photos": {}})", "CV2103 /passes/p/inputs/photos");
    checkPass(R"("inputs": {"tile": {"from": "nose"}})", "CV2103 /passes/p/inputs/tile/from");
    checkPass(R"("inputs": {"tile": "kernel"})", "CV2103 /passes/p/inputs/tile");
    checkPass(R"("inputs": {"tile": "camera"})", "CV2103 /passes/p/inputs/tile");
    checkPass(R"("inputs": {"tile": "base_color_map"})", "CV2103 /passes/p/inputs/tile");
    checkPass(R"("depth": "")", "CV2103 /passes/p/depth");
}

TEST_CASE("a sampler may read targets, noise, textures and a material's map", "[decode]")
{
    checkPass(R"("inputs": {"a": "depth", "b": "noise", "c": "photo"})", "");
    checkPass(R"("type": "draw", "inputs": {"map": "base_color_map"})", "");
}

TEST_CASE("shaders, outputs, views and sizes are checked", "[decode]")
{
    checkEach({
        {"passes", R"({"p": {"shader": "oa", "color": "ao"}})", "CV2101 /passes/p/shader"},
        {"outputs", R"({"ao": "ao_filterd"})", "CV2103 /outputs/ao"},
        {"views", R"({"v": {"target": "oa"}})", "CV2103 /views/v/target"},
        {"targets", R"({"depth": {"format": "depth24", "size": {"of": "screen"}},
                        "ao": {"format": "r8"}, "ao_filtered": {"format": "r8"}})",
         "CV2103 /targets/depth/size/of"},
    });
}

TEST_CASE("clear, bypass and no_op speak only of what the pass writes", "[decode]")
{
    checkPass(R"("clear": {"depth": 1})", "CV2102 /passes/p/clear/depth");
    checkPass(R"("bypass": {"ao_filtered": "depth"})", "CV2102 /passes/p/bypass/ao_filtered");
    checkPass(R"("no_op": {"radius": {"at": 0, "gives": {"depth": 1}}})",
              "CV2102 /passes/p/no_op/radius/gives/depth");
    checkPass(R"("clear": {"ao": 1}, "bypass": {"ao": "depth"})", "");
}

TEST_CASE("a pass cannot write one target twice", "[decode]")
{
    checkEach({
        {"passes", R"({"p": {"shader": "ao", "color": ["ao", "ao"]}})", "CV2201 /passes/p/color/1"},
        {"passes", R"({"p": {"shader": "ao", "color": "depth", "depth": "depth"}})",
         "CV2201 /passes/p/depth"},
    });
}

TEST_CASE("a condition wants values that its subject can have", "[decode]")
{
    checkPass(R"("when": {"fast": "yes"})", "CV2106 /passes/p/when/fast");
    checkPass(R"("when": {"check": ["hard", "sooth"]})", "CV2106 /passes/p/when/check/1");
    checkPass(R"("when": {"scene.specular": 1})", "CV2106 /passes/p/when/scene.specular");
    checkPass(R"("when": {"scene.lights": -1})", "CV2106 /passes/p/when/scene.lights");
    checkPass(R"("when": {"scene.lights": 1.5})", "CV2106 /passes/p/when/scene.lights");
    checkPass(R"("when": {"scene.lights": [true, 0, 3], "camera.orthographic": false,
                          "scene.alpha_tested": true, "scene.textured": true})",
              "");
}

TEST_CASE("a count comes from an int param whose value the generator can make", "[decode]")
{
    checkEach({
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": "sampels"}})",
         "CV2102 /generated/k/count"},
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": "radius"}})",
         "CV2102 /generated/k/count"},
        {"generated", R"({"n": {"generator": "rotation_noise", "count": 65}})",
         "CV4001 /generated/n/count"},
        {"params", R"({"samples": {"type": "int", "default": 257}})",
         "CV4001 /params/samples/default"},
    });
}

TEST_CASE("a scale comes from a number param whose value a size can have", "[decode]")
{
    checkEach({
        {"targets", R"({"ao": {"format": "r8", "size": {"scale": "radius"}},
                        "ao_filtered": {"format": "r8"}, "depth": {"format": "depth24"}})",
         ""},
        {"targets", R"({"ao": {"format": "r8", "size": {"scale": "raduis"}},
                        "ao_filtered": {"format": "r8"}, "depth": {"format": "depth24"}})",
         "CV2102 /targets/ao/size/scale"},
        {"targets", R"({"ao": {"format": "r8", "size": {"scale": "samples"}},
                        "ao_filtered": {"format": "r8"}, "depth": {"format": "depth24"}})",
         "CV4001 /params/samples/default"},
        {"targets", R"({"ao": {"format": "r8", "size": {"scale": 5}},
                        "ao_filtered": {"format": "r8"}, "depth": {"format": "depth24"}})",
         "CV4001 /targets/ao/size/scale"},
    });
}

TEST_CASE("nothing may have the name of a history", "[decode]")
{
    const auto errorsWith = [](const std::string& name) {
        return errorsOf(decodeWith({{"targets", R"({"ao": {"format": "r8", "history": true},
            "ao_filtered": {"format": "r8"}, "depth": {"format": "depth24"}, ")" +
                                                    name + R"(": {"format": "r8"}})"}}));
    };
    CHECK(errorsWith("ao_before") == "");
    CHECK(errorsWith("depth_history") == "");
    CHECK(errorsWith("ao_history") == "CV2107 /targets/ao");
}

TEST_CASE("targets that follow each other's size are one error", "[decode]")
{
    checkEach({
        {"targets", R"({"depth": {"format": "depth24", "size": {"of": "ao_filtered"}},
                        "ao": {"format": "r8", "size": {"of": "depth"}},
                        "ao_filtered": {"format": "r8", "size": {"of": "ao"}}})",
         "CV2204 /targets/depth/size/of"},
        {"targets", R"({"depth": {"format": "depth24", "size": {"of": "ao"}},
                        "ao": {"format": "r8", "size": {"of": "ao"}},
                        "ao_filtered": {"format": "r8", "size": {"of": "ao"}}})",
         "CV2204 /targets/ao/size/of"},
        {"targets", R"({"depth": {"format": "depth24"}, "": {"format": "r8"},
                        "ao": {"format": "r8"}, "ao_filtered": {"format": "r8"}})",
         "CV3004 /targets/"},
    });
}

TEST_CASE("one name cannot stand for two objects that GLSL or an override would see", "[decode]")
{
    checkEach({
        {"imports", R"({"photo": {"type": "texture"}, "depth": {"type": "texture"}})",
         "CV2107 /imports/depth"},
        {"generated", R"({"noise": {"generator": "rotation_noise"},
                          "radius": {"generator": "sphere_kernel"}})",
         "CV2107 /generated/radius"},
        {"features", R"({"samples": {}})", "CV2107 /features/samples"},
        {"params", R"({"samples": {"type": "int", "default": 1}, "shininess": {"default": 1}})",
         "CV2107 /params/shininess"},
        {"imports", R"({"photo": {"type": "texture"}, "depth": {"type": "camera"}})", ""},
        {"features", R"({"ao": {}, "fast": {}})", ""},
    });
}

TEST_CASE("a name misspelt where it is declared is one error with notes", "[decode]")
{
    const auto result = decodeWith({{"targets", R"({"depth": {"format": "depth24"},
        "ao": {"format": "r8"}, "ao_filterd": {"format": "r8"}})"}});
    REQUIRE(errorsOf(result) == "CV2103 /outputs/ao");  // sections are in alphabetical order here
    CHECK(result.diagnostics().at(0).notes.size() == 2);
}

TEST_CASE("what refers to something broken is not reported as well", "[decode]")
{
    checkEach({
        {"targets", R"({"depth": {"format": "depth24"}, "ao": {"format": 3},
                        "ao_filtered": []})",
         "CV3002 /targets/ao/format; CV3002 /targets/ao_filtered"},
        {"targets", "3", "CV3002 /targets"},
        {"shaders", R"({"ao": "ao.frag"})", "CV3002 /shaders/ao"},
        {"params", R"({"samples": {"type": "int", "default": "many"}})",
         "CV3002 /params/samples/default"},
        {"generated", R"({"noise": {"generator": "rotate"}})", "CV3005 /generated/noise/generator"},
        {"interfaces", "[]", "CV3002 /interfaces"},
    });
}

TEST_CASE("a misspelt section is one error", "[decode]")
{
    const std::string targets = R"({"depth": {"format": "depth24"}, "ao": {"format": "r8"},
                                    "ao_filtered": {"format": "r8"}})";
    CHECK(errorsOf(decodeWith({{"targets", ""}, {"targts", targets}})) == "CV3001 /targts");
    CHECK(errorsOf(decodeWith(
              {{"interfaces", ""}, {"interface", R"({"surface": "geometry/a.surface.glsl"})"}})) ==
          "CV3001 /interface");
}
