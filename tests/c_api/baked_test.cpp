// SPDX-License-Identifier: MIT
// The C API on baked effects: the same as on configs, but for what reads files.
#include "tests/support/baked.h"
#include "tests/c_api/c_scene.h"
#include "tests/support/shipped_subjects.h"

using namespace crevice;

namespace {

/// Two levels of AO of the host's depth.
std::string levels()
{
    const auto request = [](const char* name, double ms, double error) {
        return BakeRequest{name, {}, ms, error, descriptionOf({name}, {"+geometry/host_depth"})};
    };
    BakeOptions options;
    options.outputs = {"ao"};
    return need(bake({request("mobile_low", 0.5, 0.1), request("balanced", 1.5, 0.05)}, options));
}

struct CBaked {
    CBaked()
    {
        desc.baked = bytes.data();
        desc.baked_size = bytes.size();
        desc.width = 64;
        desc.height = 36;
    }
    ~CBaked()
    {
        crevice_effect_destroy(effect);
        for (const std::string& each : recording->misuse()) FAIL_CHECK(each);
        CHECK(recording->live() == 0);
    }

    int create() { return codeOf(crevice_effect_create(&device, &desc, &effect)); }

    /// As a host draws it.
    std::string render()
    {
        const glm::mat4 projection = glm::perspective(1.0f, 16.0f / 9.0f, 0.1f, 20.0f);
        need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
        auto depth = sized<crevice_texture>();
        depth.name = 5;
        depth.format = "depth24";
        depth.width = 64;
        depth.height = 36;
        need(crevice_effect_set_texture(effect, "depth", &depth));
        recording->clearLog();
        need(crevice_effect_render(effect));
        return recording->log();
    }

    std::string bytes = levels();
    std::shared_ptr<RecordingDevice> recording = std::make_shared<RecordingDevice>();
    crevice_device device{recording};
    crevice_effect_desc desc = sized<crevice_effect_desc>();
    crevice_effect* effect = nullptr;
};

}  // namespace

TEST_CASE_METHOD(CBaked, "C API: a baked effect draws, and has its config's params")
{
    REQUIRE(create() == 0);
    std::fill(bytes.begin(), bytes.end(), '\0');  // which it has copied
    CHECK(has(render(), "draw"));
    CHECK(crevice_effect_param_count(effect) ==
          static_cast<int>(descriptionOf({"mobile_low"}, {"+geometry/host_depth"}).params.size()));
    auto param = sized<crevice_param>();
    need(crevice_effect_get_param(effect, 0, &param));
    CHECK(std::string(param.label).size() > 0);
    const float radius = 2, no = -1;
    need(crevice_effect_set_param(effect, "radius", &radius, 1));
    CHECK(codeOf(crevice_effect_set_param(effect, "radius", &no, 1)) == 4001);
    CHECK(codeOf(crevice_effect_set_param(effect, "raduis", &radius, 1)) == 4004);
    need(crevice_effect_resize(effect, 33, 65));
    CHECK(has(render(), "draw"));
    auto ao = sized<crevice_output>();
    need(crevice_effect_get_output(effect, "ao", &ao));
    CHECK((ao.width == 33 && ao.height == 65));
    const char* patch = nullptr;
    CHECK(codeOf(crevice_effect_get_patch(effect, &patch)) == 2301);
    need(crevice_effect_reload(effect, "balanced"));
    CHECK(std::string(rendererOf(*effect).description().name) == "balanced");
    CHECK(codeOf(crevice_effect_reload(effect, "high")) == 2301);
}

TEST_CASE_METHOD(CBaked, "C API: the configs of a baked effect are the levels of a governor")
{
    REQUIRE(create() == 0);
    render();
    auto governor = sized<crevice_governor_desc>();
    governor.budget_ms = 2;
    need(crevice_effect_govern(effect, &governor));
    render();
    auto report = sized<crevice_governor_report>();
    need(crevice_effect_get_governor(effect, &report));
    CHECK(report.level == 1);
    for (int i = 0; i < 2; ++i) need(crevice_effect_add_time(effect, 4, -1));
    render();
    need(crevice_effect_get_governor(effect, &report));
    CHECK(report.level == 0);
    CHECK(std::string(report.config) == "mobile_low");
}

TEST_CASE_METHOD(CBaked, "C API: what is no baked effect, or not in one, is refused")
{
    desc.config = "high";
    CHECK(create() == 2301);
    desc.config = nullptr;
    desc.patch = "{}";
    CHECK(create() == 2301);
    desc.patch = nullptr;
    desc.baked_size = bytes.size() - 1;
    CHECK(create() == 1301);
    desc.baked_size = 0;
    CHECK(create() == 1301);
    desc.baked_size = bytes.size();
    bytes[6] = '7';
    CHECK(create() == 1302);
    bytes[6] = '0';
    const char* color = "color";
    desc.outputs = &color;
    desc.output_count = 1;
    CHECK(create() == 2301);
    CHECK(effect == nullptr);
}
