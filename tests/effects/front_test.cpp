// SPDX-License-Identifier: MIT
// Fronts: what is read of one, what is wrong with it and where; and effects that are governed by
// one, on a device that draws nothing.
#include <crevice/effect.h>
#include <crevice/governor.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <limits>

using namespace crevice;

namespace {

std::string frontOf(const std::string& levels)
{
    return "{\"format\": \"crevice-front-1\", \"scene\": \"room\", \"size\": [960, 540],\n"
           "\"device\": \"some\",\n\"levels\": " +
           levels + "}";
}

const char* const kMobile = "\"mobile\"";

std::string many(int count, const std::string& part)
{
    std::string all;
    while (count-- > 0) all += part;
    return all;
}

/// A front of one level, of those values.
std::string one(const std::string& config, const std::string& set, const std::string& ms,
                const std::string& error)
{
    return frontOf("[{\"config\": " + config + ", \"set\": " + set + ", \"ms\": " + ms +
                   ", \"error\": " + error + "}]");
}

const char* const kTwo = R"([{"config": "mobile_low", "set": ["radius=1"], "ms": 0.8, "error": 0.1},
{"config": "mobile", "ms": 1.5, "error": 0.05}])";

}  // namespace

TEST_CASE("A front is read from a file or from text")
{
    TemporaryFolder folder("front");
    const std::string file = folder.write("front.json", frontOf(kTwo));
    for (const std::string& front : {file, frontOf(kTwo)}) {
        const std::vector<FrontLevel> levels = need(readFront(front));
        REQUIRE(levels.size() == 2);
        CHECK(levels[0].name == "mobile_low");
        CHECK(levels[0].set == std::vector<std::string>{"radius=1"});
        CHECK(levels[1].ms == 1.5);
        CHECK(levels[1].error == 0.05);
        CHECK(levels[1].place.line == 4);
    }
}

TEST_CASE("What is no front gets one message, with a place and a way out")
{
    const std::string level = R"("config": "mobile", "set": [], "ms": 1, "error": 0.1)";
    const struct {
        std::string front;
        Code code;
        const char* pointer;
        int line;
    } rows[] = {
        {"nowhere.json", Code::module_missing, "", 0},
        {"{\"format\": \"crevice-front-1\"", Code::syntax, "", 1},
        {"{\"levels\": [{" + level + "}]}", Code::missing_key, "", 1},
        {"{\"format\": \"front\", \"levels\": [{" + level + "}]}", Code::bad_enum, "/format", 1},
        {"{\"format\": \"crevice-front-1\"}", Code::missing_key, "", 1},
        {"{\"format\": \"crevice-front-1\", \"levles\": [], \"levels\": [{" + level + "}]}",
         Code::unknown_key, "/levles", 1},
        {frontOf("{}"), Code::wrong_type, "/levels", 3},
        {frontOf("[]"), Code::bad_length, "", 3},
        {frontOf("[{" + level + "}" + many(5000, ",{" + level + "}") + "]"), Code::bad_length, "",
         3},
        {frontOf(many(5000, "[")), Code::too_deep, "", 3},
        {frontOf("[1]"), Code::wrong_type, "/levels/0", 3},
        {frontOf("[{" + level + ", \"mz\": 2}]"), Code::unknown_key, "/levels/0/mz", 3},
        {frontOf(R"([{"set": [], "ms": 1, "error": 0.1}])"), Code::missing_key, "/levels/0", 3},
        {frontOf(R"([{"config": "mobile", "set": [], "ms": 1}])"), Code::missing_key, "/levels/0",
         3},
        {one("3", "[]", "1", "0.1"), Code::wrong_type, "/levels/0/config", 3},
        {one(kMobile, "\"radius=1\"", "1", "0.1"), Code::wrong_type, "/levels/0/set", 3},
        {one(kMobile, "[1]", "1", "0.1"), Code::wrong_type, "/levels/0/set/0", 3},
        {one(kMobile, "[]", "\"1\"", "0.1"), Code::wrong_type, "/levels/0/ms", 3},
        {one(kMobile, "[]", "1e999", "0.1"), Code::number_range, "/levels/0/ms", 3},
        {one(kMobile, "[]", "0", "0.1"), Code::out_of_range, "/levels/0", 3},
        {one(kMobile, "[]", "1", "-1"), Code::out_of_range, "/levels/0", 3},
        {frontOf("[{" + level + "},\n{" + level + "}]"), Code::out_of_range, "/levels/1", 4},
    };
    for (const auto& row : rows) {
        INFO(row.front);
        const Diagnostic error = onlyError(readFront(row.front), row.code);
        CHECK(error.pointer == row.pointer);
        CHECK(error.place.line == row.line);
        CHECK_FALSE(error.help.empty());
    }
}

TEST_CASE("Options and levels that make no sense are refused")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<FrontLevel> one = {{{"mobile"}, {}, 1}};
    const struct {
        std::vector<FrontLevel> levels;
        GovernorOptions options;
        Code code;
    } rows[] = {
        {{}, {1}, Code::bad_length},
        {{{{"mobile"}, {}, nan}}, {1}, Code::not_finite},
        {{{{"mobile"}, {}, 2}, {{"high"}, {}, 2}}, {1}, Code::out_of_range},
        {one, {}, Code::out_of_range},
        {one, {nan}, Code::out_of_range},
        {one, {1, -1}, Code::out_of_range},
        {one, {1, 0.5}, Code::out_of_range},  // of no known error
        {one, {1, 0, 1.5}, Code::out_of_range},
        {one, {1, 0, 0.9, 0}, Code::out_of_range},
    };
    for (const auto& row : rows) onlyError(Governor::create(row.levels, row.options), row.code);
    Governor governor = need(Governor::create(one, {1}));
    CHECK_FALSE(governor.setBudget(0).ok());
    for (const double ms : {nan, 0.0, -1.0, std::numeric_limits<double>::infinity()})
        governor.addTime(ms);
    Governor tiny = need(Governor::create({{{"mobile"}, {}, 1e-300}, {{"high"}, {}, 1e300}}, {1}));
    for (int i = 0; i < 100; ++i) tiny.addTime(i % 2 ? 1e300 : 1e-300);
    CHECK(tiny.report().predicted_ms >= 0);
    CHECK(governor.report().ms == 0);
    governor.addTime(0.5, 3);  // of no level that is drawn
    CHECK(governor.report().ms == 0);
    governor.addTime(0.5);
    CHECK(governor.report().ms == 0.5);
    CHECK(governor.report().predicted_ms == 0.5);
}

TEST_CASE("An effect that is governed draws the level that fits, by the GPU's times of before")
{
    RecordingDevice device;
    device.setTimers({0.1});
    Effect effect = need(Effect::create(device, "mobile", {64, 36}, {"ao"}));
    Camera& camera = effect.frame().camera;
    camera.clip_from_view[3][3] = 1.5f;
    CHECK(effect.governor() == nullptr);
    need(effect.govern(need(readFront(frontOf(kTwo))), {2.0}));
    REQUIRE(effect.governor());
    CHECK(effect.governor()->level() == 1);
    const auto show = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            ++effect.frame().revision;
            camera.clip_from_view[3][3] += 0.001f;  // what it draws is another, so all passes run
            need(effect.render());
        }
        return effect.renderer().level();
    };
    CHECK(show(1) == 1);  // having drawn each once
    device.clearLog();
    CHECK(show(20) == 1);
    CHECK(effect.governor()->report().ms > 0);
    device.setTimers({4.0});
    CHECK(show(3) == 0);  // two of them above the budget
    CHECK(effect.renderer().description().name == "mobile_low");
    device.setTimers({0.1});
    CHECK(show(60) == 1);
    CHECK(device.log().find("createProgram") == std::string::npos);
    // Times of the host's.
    for (int i = 0; i < 2; ++i) effect.governor()->addTime(50);
    CHECK(effect.governor()->level() == 0);
    CHECK(show(1) == 0);
    // A level that cannot be drawn is a warning, and the old one goes on.
    for (int i = 0; i < 200 && effect.governor()->level() == 0; ++i)
        effect.governor()->addTime(0.1);
    REQUIRE(effect.governor()->level() == 1);
    device.failAt(1);
    ++effect.frame().revision;
    CHECK(onlyCode(effect.render()) == Code::out_of_memory);
    CHECK(effect.renderer().level() == 0);
    CHECK(effect.governor()->level() == 0);
    // So is one of those that are drawn once.
    need(effect.govern(need(readFront(frontOf(kTwo))), {2.0}));
    device.failAt(1);
    CHECK(onlyCode(effect.render()) == Code::out_of_memory);
    CHECK(effect.renderer().level() == 1);
    CHECK(effect.render().diagnostics().empty());
    need(effect.renderer().reload(effect.renderer().description(), {{64, 36}, {"ao"}}));
    CHECK(effect.governor() == nullptr);
    need(effect.render());
    need(effect.govern(need(readFront(frontOf(kTwo))), {2.0}));
    need(effect.render());
    for (int i = 0; i < 2; ++i) effect.governor()->addTime(50);
    device.loseContext();
    onlyError(effect.render(), Code::context_lost);
    CHECK(effect.renderer().level() == 1);
    CHECK(device.misuse().empty());
}

TEST_CASE("An effect takes no levels that are wrong, and says of which level what is wrong")
{
    RecordingDevice device;
    Effect effect = need(Effect::create(device, "mobile", {64, 36}, {"ao"}));
    const auto said = [&](std::vector<FrontLevel> levels) {
        const Status status = effect.govern(std::move(levels), {1});
        CHECK_FALSE(status.ok());
        CHECK(effect.governor() == nullptr);
        return toText(status.diagnostics());
    };
    CHECK_THAT(said({{{"mobil"}, {}, 1}}), Catch::Contains("CV1201"));
    CHECK_THAT(said({{{"mobile"}, {"radios=1"}, 1}}),
               Catch::Contains("CV4004") && Catch::Contains("in level 'mobile'"));
    CHECK_THAT(said({{{"mobile"}, {}, 1}, {{"mobile+geometry/host_depth"}, {}, 2}}),
               Catch::Contains("CV2102") && Catch::Contains("geometry/host_depth"));
    const auto unknown =
        need(readFront(frontOf(R"([{"config": "mobil", "set": [], "ms": 1, "error": 0.1}])")));
    CHECK_THAT(said(unknown), Catch::Contains("(JSON text):3:") && Catch::Contains("mobile"));
    const Status software = effect.govern({{{"mobile"}, {}, 1}}, {1});
    CHECK_THAT(onlyWarning(software, Code::no_timers).help, Catch::Contains("addTime"));
}
