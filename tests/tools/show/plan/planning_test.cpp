// SPDX-License-Identifier: MIT
// What `crevice validate` calls ok plans in every scene and under every camera.
#include "tests/support/catch.h"

#include "tests/support/temporary_folder.h"
#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

// A config with one more pass, which runs where the trait has that value and reads what nobody
// supplies.
ConfigOptions brokenWhere(const TemporaryFolder& folder, const std::string& condition)
{
    folder.write("broken.frag",
                 "#version 300 es\nprecision highp float;\nuniform float nowhere;\n"
                 "layout(location = 0) out float extra;\n"
                 "void main() { extra = nowhere; }\n");
    ConfigOptions options;
    options.config = folder.write("broken.json", R"({"format": 1, "extends": ["learnopengl"],
        "targets": {"extra": {"format": ["r8"]}},
        "shaders": {"extra": {"vertex": "common/fullscreen.vert", "fragment": "./broken.frag"}},
        "passes": {"extra": {"type": "fullscreen", "shader": "extra", "color": ["extra"],
                             "when": {)" + condition +
                                                     R"(}, "bypass": {"extra": "ao"}}},
        "outputs": {"extra": "extra"}})");
    return options;
}

}  // namespace

TEST_CASE("A pass that fails in some scene or under some camera fails to validate")
{
    const TemporaryFolder folder("planning");
    for (const char* condition :
         {R"("scene.lights": false)", R"("scene.lights": true)", R"("scene.alpha_tested": false)",
          R"("scene.specular": false)", R"("scene.textured": false)",
          R"("camera.orthographic": true)", R"("camera.reversed_depth": true)",
          R"("camera.turned": true)", R"("camera.views": 2)", R"("scene.normal_mapped": true)",
          R"("scene.baked_occlusion": true)", R"("scene.material_ambient": true)",
          R"("scene.baked_occlusion": true, "scene.normal_mapped": true)"}) {
        INFO(condition);
        GlslCheck shaders;
        const Result<Plan> plan =
            planForEveryScene(loadDescription(brokenWhere(folder, condition), shippedSources()), "",
                              kUsualExtent, shaders);
        CHECK_FALSE(plan.ok());
        REQUIRE(plan.diagnostics().size() == 1);
        CHECK(plan.diagnostics()[0].code == Code::uniform_unbound);
    }
}
