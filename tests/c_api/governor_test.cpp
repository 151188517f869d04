// SPDX-License-Identifier: MIT
// The C API's governor: what it is given, what it says, and what it refuses.
#include "tests/c_api/c_scene.h"

using namespace crevice;

namespace {

const char* const kFront = R"({"format": "crevice-front-1", "levels": [
    {"config": "mobile_low", "set": ["radius=2", "slices=3"], "ms": 0.5, "error": 0.1},
    {"config": "balanced", "set": [], "ms": 1.5, "error": 0.05}]})";

struct CGovernor : CScene {
    int govern(const std::string& front = kFront, double budget_ms = 2)
    {
        auto desc = sized<crevice_governor_desc>();
        desc.front = front.empty() ? nullptr : front.c_str();
        desc.budget_ms = budget_ms;
        return codeOf(crevice_effect_govern(effect, &desc));
    }

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
};

}  // namespace

TEST_CASE_METHOD(CGovernor, "C API: a governor draws the level that fits, and says which")
{
    REQUIRE(govern() == 0);
    CHECK(crevice_error_code(crevice_effect_warnings(effect)) == 6018);
    CHECK(report().level == 1);
    CHECK(std::string(report().config) == "balanced");
    int calls = 0;
    for (bool ready = false; !ready; ++calls) need(crevice_effect_warm(effect, &ready));
    const int passes = static_cast<int>(rendererOf(*effect).plan().passes.size());
    CHECK(calls > passes + 1);  // those of the other level too
    recording->clearLog();
    need(crevice_effect_render(effect));
    CHECK(recording->log().find("createTexture") == std::string::npos);  // no other level is drawn
    need(crevice_effect_add_time(effect, 1, 0));                         // of another level
    CHECK(report().milliseconds == 0);
    for (int i = 0; i < 2; ++i) need(crevice_effect_add_time(effect, 4, -1));
    need(crevice_effect_render(effect));
    CHECK(report().level == 0);
    CHECK(report().error == 0.1);
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
    REQUIRE(govern() == 0);  // again
    need(crevice_effect_render(effect));
    CHECK(value("radius") == 0.25f);
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
    const std::string front = kFront;
    const auto with = [&front](const char* part, const char* other) {
        return std::string(front).replace(front.find(part), std::strlen(part), other);
    };
    CHECK(govern(front, 0) == 4001);
    CHECK(govern("") == 6011);
    CHECK(govern("{}") == 3003);
    CHECK(govern(with("radius=2", "radios=2")) == 4004);
    CHECK(govern(with("balanced", "nothing")) == 1201);
    CHECK(govern() == 0);
    CHECK(codeOf(crevice_effect_set_budget(effect, 0)) == 4001);
}
