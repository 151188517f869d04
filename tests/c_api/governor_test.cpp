// SPDX-License-Identifier: MIT
// The C API's governor: what it is given, what it says, and what it refuses.
#include "tests/c_api/c_scene.h"

using namespace crevice;

namespace {

crevice_level levelOf(const char* config, double milliseconds, double error)
{
    auto level = sized<crevice_level>();
    level.config = config;
    level.milliseconds = milliseconds;
    level.error = error;
    return level;
}

struct CGovernor : CScene {
    CGovernor()
    {
        levels[0].set = sets;
        levels[0].set_count = 2;
        desc.levels = levels;
        desc.level_count = 2;
        desc.budget_ms = 2;
    }

    int govern() { return codeOf(crevice_effect_govern(effect, &desc)); }

    crevice_governor_report report() const
    {
        auto made = sized<crevice_governor_report>();
        need(crevice_effect_get_governor(effect, &made));
        return made;
    }

    /// The value of a param as C sees it; -1 where there is none.
    float value(const std::string& name) const
    {
        for (int i = 0; i < crevice_effect_param_count(effect); ++i) {
            auto param = sized<crevice_param>();
            need(crevice_effect_get_param(effect, i, &param));
            if (param.name == name) return param.value[0];
        }
        return -1;
    }

    const char* sets[2] = {"radius=2", "slices=3"};
    crevice_level levels[2] = {levelOf("mobile_low", 0.5, 0.1), levelOf("balanced", 1.5, 0.05)};
    crevice_governor_desc desc = sized<crevice_governor_desc>();
};

}  // namespace

TEST_CASE_METHOD(CGovernor, "C API: a governor draws the level that fits, and says which")
{
    REQUIRE(govern() == 0);
    CHECK(crevice_error_code(crevice_effect_warnings(effect)) == 6018);
    CHECK(report().level == 1);
    CHECK(std::string(report().config) == "balanced");
    CHECK(report().estimate < 0);
    need(crevice_effect_render(effect));
    need(crevice_effect_add_time(effect, 1, 0));  // of another level
    CHECK(report().milliseconds == 0);
    for (int i = 0; i < 2; ++i) need(crevice_effect_add_time(effect, 4, -1));
    need(crevice_effect_set_estimate(effect, 0.04));
    need(crevice_effect_render(effect));
    CHECK(report().level == 0);
    CHECK(report().error == 0.1);
    CHECK(report().estimate == 0.04);
    CHECK(report().predicted_ms == Approx(4 * 0.5 / 1.5));
    // Params are those of the level that is drawn.
    CHECK(value("slices") == 3);
    CHECK(value("radius") == 2);
    const float radius = 0.25f;
    need(crevice_effect_set_param(effect, "radius", &radius, 1));
    need(crevice_effect_set_budget(effect, 20));
    for (int i = 0; i < 40; ++i) need(crevice_effect_add_time(effect, 0.5, 0));
    need(crevice_effect_render(effect));
    CHECK(report().level == 1);
    CHECK(value("radius") == 0.25f);
    const char* patch = nullptr;
    need(crevice_effect_get_patch(effect, &patch));
    CHECK(std::string(patch).find("0.25") != std::string::npos);
    need(crevice_effect_reload(effect, nullptr));
    auto none = sized<crevice_governor_report>();
    CHECK(codeOf(crevice_effect_get_governor(effect, &none)) == 6011);
    need(crevice_effect_render(effect));
}

TEST_CASE_METHOD(CGovernor, "C API: a governor is refused what makes no sense")
{
    auto none = sized<crevice_governor_report>();
    CHECK(codeOf(crevice_effect_get_governor(effect, &none)) == 6011);
    CHECK(codeOf(crevice_effect_add_time(effect, 1, 0)) == 6011);
    CHECK(codeOf(crevice_effect_set_budget(effect, 1)) == 6011);
    CHECK(codeOf(crevice_effect_set_estimate(effect, 1)) == 6011);
    desc.budget_ms = 0;
    CHECK(govern() == 4001);
    desc.budget_ms = 2;
    levels[0].set_count = -1;
    CHECK(govern() == 6011);
    levels[0].set_count = 1;
    levels[0].set = nullptr;
    CHECK(govern() == 6011);
    levels[0].set = sets;
    sets[0] = "radios=1";
    CHECK(govern() == 4004);
    sets[0] = nullptr;
    CHECK(govern() == 6011);
    sets[0] = "radius=1";
    levels[1].config = nullptr;
    CHECK(govern() == 6011);
    levels[1].config = "nothing";
    CHECK(govern() == 1201);
    levels[1].config = "high";
    desc.front = "{}";
    CHECK(govern() == 6011);  // and levels
    desc.level_count = 0;
    CHECK(govern() == 3003);
    desc.front = R"({"format": "crevice-front-1", "levels": [
        {"config": "mobile", "set": ["quality=low"], "ms": 1, "error": 0.1}]})";
    const int code = govern();
    INFO(code);
    CHECK((code == 0 || code == 4004));
    CHECK(govern() == code);
}
