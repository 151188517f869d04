// SPDX-License-Identifier: MIT
// Decoding: names that lead nowhere or collide, beyond those of tests/data/bad.
#include "tests/core/config/decode_fixture.h"

using namespace crevice;

namespace {

// A pass that writes `ao`, with more keys.
BadConfig inPass(const std::string& more, const char* errors)
{
    return {"passes", R"({"p": {"shader": "ao", "color": ["ao"], )" + more + "}}", errors};
}

// The targets of the base config, of which some say more.
BadConfig inTargets(const std::string& depth, const std::string& ao, const char* errors,
                    const std::string& more = "")
{
    return {"targets",
            R"({"depth": {"format": "depth24")" + depth + R"(}, "ao": {"format": "r8")" + ao +
                R"(}, "ao_filtered": {"format": "r8"})" + more + "}",
            errors};
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
    CHECK_THAT(underlined(error), Catch::Contains("ao_filterd"));
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
    checkEach({
        inPass(R"("bypass": {"aoo": "depth"})", "CV2103 /passes/p/bypass/aoo"),
        inPass(R"("no_op": {"radius": {"at": 0, "gives": {"ao": "one"}}})",
               "CV2103 /passes/p/no_op/radius/gives/ao"),
        inPass(R"("inputs": {"photos": {}})", "CV2103 /passes/p/inputs/photos"),
        inPass(R"("inputs": {"tile": {"from": "nose"}})", "CV2103 /passes/p/inputs/tile/from"),
        inPass(R"("inputs": {"tile": "kernel"})", "CV2103 /passes/p/inputs/tile"),
        inPass(R"("inputs": {"tile": "camera"})", "CV2103 /passes/p/inputs/tile"),
        inPass(R"("inputs": {"tile": "base_color_map"})", "CV2103 /passes/p/inputs/tile"),
        inPass(R"("depth": "")", "CV2103 /passes/p/depth"),
        // A sampler may read targets, noise, textures and a material's map.
        inPass(R"("inputs": {"a": "depth", "b": "noise", "c": "photo"})", ""),
        inPass(R"("type": "draw", "inputs": {"map": "base_color_map"})", ""),
        // What a pass says of its outputs it says of those that it has.
        inPass(R"("clear": {"depth": 1})", "CV2102 /passes/p/clear/depth"),
        inPass(R"("bypass": {"ao_filtered": "depth"})", "CV2102 /passes/p/bypass/ao_filtered"),
        inPass(R"("no_op": {"radius": {"at": 0, "gives": {"depth": 1}}})",
               "CV2102 /passes/p/no_op/radius/gives/depth"),
        inPass(R"("clear": {"ao": 1}, "bypass": {"ao": "depth"})", ""),
        // And it has each of them once.
        {"passes", R"({"p": {"shader": "ao", "color": ["ao", "ao"]}})", "CV2201 /passes/p/color/1"},
        {"passes", R"({"p": {"shader": "ao", "color": "depth", "depth": "depth"}})",
         "CV2201 /passes/p/depth"},
    });
}

TEST_CASE("a condition wants values that its subject can have", "[decode]")
{
    checkEach({
        inPass(R"("when": {"fast": "yes"})", "CV2106 /passes/p/when/fast"),
        inPass(R"("when": {"check": ["hard", "sooth"]})", "CV2106 /passes/p/when/check/1"),
        inPass(R"("when": {"scene.specular": 1})", "CV2106 /passes/p/when/scene.specular"),
        inPass(R"("when": {"scene.lights": -1})", "CV2106 /passes/p/when/scene.lights"),
        inPass(R"("when": {"scene.lights": 1.5})", "CV2106 /passes/p/when/scene.lights"),
        inPass(R"("when": {"scene.lights": [true, 0, 3], "camera.orthographic": false,
                           "scene.alpha_tested": true, "scene.textured": true})",
               ""),
    });
}

TEST_CASE("a count or a scale comes from a param whose value can be one", "[decode]")
{
    checkEach({
        {"generated", R"({"k": {"generator": "sphere_kernel", "count": "radius"}})",
         "CV2102 /generated/k/count"},
        {"generated", R"({"n": {"generator": "rotation_noise", "count": 65}})",
         "CV4001 /generated/n/count"},
        {"params", R"({"samples": {"type": "int", "default": 257}})",
         "CV4001 /params/samples/default"},
        inTargets("", R"(, "size": {"scale": "radius"})", ""),
        inTargets("", R"(, "size": {"scale": "samples"})", "CV4001 /params/samples/default"),
        inTargets("", R"(, "size": {"scale": 5})", "CV4001 /targets/ao/size/scale"),
    });
}

TEST_CASE("targets that follow each other's size are one error", "[decode]")
{
    checkEach({
        {"targets", R"({"depth": {"format": "depth24", "size": {"of": "ao_filtered"}},
                        "ao": {"format": "r8", "size": {"of": "depth"}},
                        "ao_filtered": {"format": "r8", "size": {"of": "ao"}}})",
         "CV2204 /targets/depth/size/of"},
        inTargets(R"(, "size": {"of": "ao"})", R"(, "size": {"of": "ao"})",
                  "CV2204 /targets/ao/size/of"),
        inTargets("", "", "CV3004 /targets/", R"(, "": {"format": "r8"})"),
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
        // Nor may anything have the name of a history that there is.
        inTargets("", R"(, "history": true)", "", R"(, "ao_before": {"format": "r8"})"),
        inTargets("", R"(, "history": true)", "", R"(, "depth_history": {"format": "r8"})"),
        inTargets("", R"(, "history": true)", "CV2107 /targets/ao",
                  R"(, "ao_history": {"format": "r8"})"),
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
    // A misspelt section is one error too.
    const std::string targets = R"({"depth": {"format": "depth24"}, "ao": {"format": "r8"},
                                    "ao_filtered": {"format": "r8"}})";
    CHECK(errorsOf(decodeWith({{"targets", ""}, {"targts", targets}})) == "CV3001 /targts");
    CHECK(errorsOf(decodeWith(
              {{"interfaces", ""}, {"interface", R"({"surface": "geometry/a.surface.glsl"})"}})) ==
          "CV3001 /interface");
}
