// SPDX-License-Identifier: MIT
// Decoding: names that lead nowhere or collide, beyond those of tests/data/bad.
#include "tests/core/config/decode_fixture.h"

using namespace crevice;

namespace {

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
