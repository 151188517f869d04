// SPDX-License-Identifier: MIT
// What commands say of a config that reads a host's textures: following it draws the config.
#include "tools/render/missing_texture.h"

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tools/show/plan/planning.h"

#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

using namespace crevice;

namespace {

/// The errors of drawing a config without a host.
Diagnostics drawn(const std::string& config, const std::vector<std::string>& overrides = {})
{
    MemorySources mine;
    mine.add("configs/mine.json", config);
    mine.add("mask.frag",
             "#version 300 es\nprecision highp float;\nuniform highp sampler2D mask;\nin vec2 uv;\n"
             "layout(location = 0) out highp float ao;\n"
             "void main() { ao = texture(mask, uv).r; }\n");
    const LayeredSources sources({&mine, &shippedSources()});
    const Description description =
        need(decode(need(loadConfig(sources, {"mine", {}, overrides})), sources));
    RecordingDevice device;
    Frame frame;
    auto renderer = need(Renderer::create(device, description, {{16, 9}}, traitsOf(frame)));
    return withoutHost(renderer->render(frame).diagnostics(), description);
}

/// "filter/temporal=filter/box" of "...: --set filter/temporal=filter/box draws ...".
std::string settingIn(const std::string& help)
{
    const std::size_t begin = help.find("--set ") + 6;
    return help.substr(begin, help.find(' ', begin) - begin);
}

}  // namespace

TEST_CASE("Each module that reads a host's depth names the setting that draws without a host")
{
    int modules = 0;
    for (const std::string& path : shippedSources().list()) {
        const bool provides =
            shippedSources().find(path)->text.find("\"interfaces\"") != std::string::npos;
        if (!startsWith(path, "geometry/host_") || !provides) continue;
        const std::string module = path.substr(0, path.size() - 5);
        const std::string config = R"({"format": 1, "extends": [")" + module +
                                   R"(", "ssao/gtao", "filter/bilateral_normal"]})";
        const Diagnostics errors = drawn(config);
        INFO(module << ": " << toText(errors));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].code == Code::missing_import);
        CHECK(drawn(config, {settingIn(errors[0].help)}).empty());
        ++modules;
    }
    CHECK(modules > 5);
}

TEST_CASE("A texture that a feature reads names that feature")
{
    const char* const config = R"({"format": 1, "extends": ["gtao_temporal"]})";
    const Diagnostics errors = drawn(config, {"host_velocity=true"});
    REQUIRE(errors.size() == 1);
    CHECK(settingIn(errors[0].help) == "host_velocity=false");
    CHECK(drawn(config, {"host_velocity=false"}).empty());
}

TEST_CASE("A texture of a config's own has no way out but a program")
{
    const Diagnostics errors = drawn(R"({"format": 1,
        "imports": {"mask": {"type": "texture"}},
        "targets": {"ao": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "common/fullscreen.vert", "fragment": "mask.frag"}},
        "passes": {"p": {"shader": "s", "color": "ao"}},
        "outputs": {"ao": "ao"}})");
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].help.find("Effect::setTexture") != std::string::npos);
}
