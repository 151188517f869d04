// SPDX-License-Identifier: MIT
// Benches without GL: their samples, keys and figures, failures and what comes first.

#include <crevice/recording_device.h>
#include <crevice/shipped.h>

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/measure/bench/fixture.h"
#include "tools/measure/bench/choice.h"
#include "tools/measure/bench/measure.h"
#include "tools/measure/bench/run.h"
#include "tools/render/view_diagnosis.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

BenchOptions smallOptions()
{
    BenchOptions options;
    options.configs = {"learnopengl", "thesis"};
    options.scenes = {"plane", "spheres"};
    options.sizes = {"64x36"};
    options.samples = {4, 16};
    return options;
}

BenchPlan plan(const BenchOptions& options)
{
    const Result<BenchPlan> made = planBench(options, shippedSources());
    INFO(toText(made.diagnostics()));
    REQUIRE(made.ok());
    return *made;
}

std::vector<std::string> keys(const BenchOptions& options)
{
    std::vector<std::string> all;
    for (const BenchTask& task : plan(options).tasks) all.push_back(task.sample.key);
    return all;
}

/// The first sample of a plan with an option changed.
template <class Change>
BenchSample changed(const Change& change)
{
    BenchOptions options = smallOptions();
    change(options);
    return plan(options).tasks.at(0).sample;
}

/// On a device on which one config fails.
MeasureSummary run(const TemporaryFolder& folder, const BenchPlan& plan,
                   const std::string& fails = "")
{
    BenchFile file = need(openBench(folder.path.string()));
    MeasureWorld world;
    world.device = "fake";
    world.seconds = [] { return 0.0; };
    world.interrupted = [] { return false; };
    world.begin = world.say = [](const std::string&) {};
    world.measure = [&](const BenchTask& task) -> Result<BenchSample> {
        if (task.sample.config == fails) return Diagnostic{Code::gl_error, "it broke"};
        BenchSample sample = task.sample;
        sample.error.rmse = 0.125;
        return sample;
    };
    return measureAll(plan, file, world);
}

}  // namespace

TEST_CASE("A bench crosses scenes, sizes, radii, configs and samples")
{
    BenchOptions options = smallOptions();
    options.sizes = {"64x36", "32x18"};
    options.radii = {0.25, 1};
    const BenchPlan planned = plan(options);
    CHECK(planned.tasks.size() == 2 * 2 * 2 * 2 * 2);
    CHECK(planned.views.size() == 4);
    const BenchSample& sample = planned.tasks[1].sample;
    CHECK(sampleTitle(sample) == "learnopengl radius=0.25 samples=16, plane, 64x36");
    CHECK(sample.family == "learnopengl");
    CHECK(sample.samples == 16);
    CHECK(sample.radius == 0.25);
    CHECK(sample.triangles > 0);
}

TEST_CASE("The key of a sample is the same in every plan and changes with what decides its figures")
{
    const BenchOptions options = smallOptions();
    const std::vector<std::string> first = keys(options);
    CHECK(std::set<std::string>(first.begin(), first.end()).size() == first.size());
    CHECK(keys(options) == first);
    void (*const changes[])(BenchOptions&) = {
        [](BenchOptions& other) { other.rays = 64; },
        [](BenchOptions& other) { other.version = "next"; },
        [](BenchOptions& other) { other.overrides = {"intensity=2"}; },
        [](BenchOptions& other) { other.output = "color"; },
        [](BenchOptions& other) { other.disable = {"no_op"}; },
        [](BenchOptions& other) { other.motion = true; }};
    for (const auto change : changes) CHECK(changed(change).key != first.front());
    // The same sample with more figures: measured again, compared with both.
    CHECK(identityOf(changed(changes[5])) == identityOf(plan(options).tasks[0].sample));
}

TEST_CASE("What is timed and what is switched off are in ids, labels, titles and curves")
{
    const BenchSample ao = changed([](BenchOptions&) {});
    const BenchSample color = changed([](BenchOptions& other) { other.output = "color"; });
    const BenchSample bare = changed([](BenchOptions& other) { other.disable = {"no_op"}; });
    CHECK(identityOf(ao) == R"(["learnopengl",["samples=4"],"plane","main",)"
                            R"({"height":36,"width":64},0.5,256])");
    CHECK(ao.family == "learnopengl");
    for (const auto& [sample, suffix] :
         {std::pair(color, " output=color"), {bare, " without no_op"}}) {
        CHECK(identityOf(sample) != identityOf(ao));
        CHECK(sample.family == std::string("learnopengl") + suffix);
        CHECK(sampleLabel(sample) == std::string("learnopengl samples=4") + suffix);
        CHECK(sampleTitle(sample) == sampleLabel(sample) + ", plane, 64x36");
    }
    CHECK(questionOf(bare) == questionOf(ao));  // so that a bench shows what it was worth
    BenchOptions options = smallOptions();
    options.output = "colour";
    CHECK(plan(options).tasks[0].sample.failure ==
          "CV2209: 'learnopengl' exports no output 'colour': give --output ao or color");
}

TEST_CASE("An edited shader is another sample")
{
    const std::string text = shippedSources().find("ssao/shaders/hemisphere.frag")->text;
    MemorySources edited;
    edited.add("ssao/shaders/hemisphere.frag", text + "// edited\n");
    const LayeredSources sources({&edited, &shippedSources()});
    const BenchOptions options = smallOptions();
    const Result<BenchPlan> other = planBench(options, sources);
    REQUIRE(other.ok());
    CHECK(other->tasks[0].sample.key != keys(options)[0]);
}

TEST_CASE("Sample counts that a config cannot take are left out with a warning")
{
    BenchOptions options = smallOptions();
    options.scenes = {"plane"};
    options.configs = {"learnopengl"};
    options.samples = {4, 1000};
    const BenchPlan planned = plan(options);
    CHECK(planned.tasks.size() == 1);
    REQUIRE(planned.diagnostics.size() == 1);
    CHECK(planned.diagnostics[0].severity == Severity::warning);
}

TEST_CASE("What is unusable fails, the rest is measured, and a second run tries failures again")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane"};
    const BenchPlan planned = plan(options);
    const TemporaryFolder folder("bench_broken");
    const MeasureSummary summary = run(folder, planned, "thesis");
    CHECK(summary.measured == 2);
    REQUIRE(summary.failures.size() == 6);
    CHECK(summary.failures[0].find("learnopengl samples=4, nowhere, 64x36: CV7001: ") == 0);
    const std::vector<BenchSample> samples = need(readBenchSamples({folder.path.string()}));
    CHECK(samples.size() == 8);
    CHECK(samples[0].device == "fake");
    const MeasureSummary again = run(folder, planned);
    CHECK(again.kept == 2);
    CHECK(again.measured == 2);
}

TEST_CASE("Presets are measured first, in all scenes, unless configs were named")
{
    BenchOptions options = smallOptions();
    options.configs = {};
    options.samples = {};
    const std::set<std::string> presets = {"mobile_low", "mobile", "balanced", "high"};
    std::set<std::string> first;
    const std::vector<BenchTask> tasks = plan(options).tasks;
    for (std::size_t i = 0; i < 2 * presets.size(); ++i) {
        CHECK(presets.count(tasks[i].sample.config) == 1);
        first.insert(tasks[i].sample.config + tasks[i].sample.scene);
    }
    CHECK(first.size() == 2 * presets.size());
    options.configs = {"thesis", "mobile"};
    CHECK(plan(options).tasks[0].sample.config == "thesis");
}

TEST_CASE("Scenes, cameras and configs that are unusable become failures")
{
    BenchOptions options = smallOptions();
    options.scenes = {"nowhere", "plane", "spheres"};
    options.camera = "grazing";  // which spheres has not
    options.configs = {"nothing", "learnopengl"};
    const BenchPlan planned = plan(options);
    CHECK(planned.diagnostics.size() == 2);
    CHECK(hasErrors(planned.diagnostics));
    REQUIRE(planned.tasks.size() == 9);
    const auto failureOf = [&planned](std::size_t task) {
        return planned.tasks[task].sample.failure.substr(0, 7);
    };
    CHECK(failureOf(0) == "CV7001:");
    CHECK(failureOf(1) == "CV7001:");
    CHECK(planned.tasks[1].sample.samples == 4);
    CHECK(failureOf(3) == "CV1201:");
    CHECK(failureOf(4).empty());
    CHECK(failureOf(7) == "CV7004:");
}

TEST_CASE("Medians and quartiles lie between neighbours")
{
    const TimeFigures five = timeFigures({5, 1, 4, 2, 3});
    CHECK(five.median == 3);
    CHECK(five.q1 == 2);
    CHECK(five.q3 == 4);
    CHECK(timeFigures({1, 2}).median == 1.5);
    CHECK(timeFigures({7}).q3 == 7);
}

TEST_CASE("The cost is that of every pass but the draw passes, and of those that are the own ones")
{
    Plan made;
    made.passes.resize(3);
    made.passes[0].type = made.passes[1].type = PassType::draw;
    FrameTimes times;
    times.pass_ms = {100, 20, 3};
    CHECK(occlusionCost(made, times) == 3);
    CHECK(costWithGeometry(made, times, {false, true, false}) == 23);
    CHECK(costWithGeometry(made, times, {}) == 3);
}

TEST_CASE("Samples by different clocks are in different views")
{
    std::vector<BenchSample> samples(3, benchSample("a", 4, 1, 0.1));
    samples[1].clock = "cpu";
    const std::vector<ResultView> views = benchViews(samples);
    REQUIRE(views.size() == 2);
    CHECK(views[0].clock == "query");
    CHECK(views[0].samples == std::vector<std::size_t>{0, 2});
    CHECK(views[1].clock == "cpu");
}

TEST_CASE("The radius on screen is that of the median depth, for both kinds of projection")
{
    Image depth({101, 100}, 1, 1.0f);
    Camera camera;
    camera.clip_from_view = glm::perspective(1.0f, 1.01f, 0.1f, 100.0f);
    CHECK_FALSE(medianDistance(depth, camera));
    const auto window = [&camera](float z) {
        const glm::vec4 clip = camera.clip_from_view * glm::vec4(0, 0, z, 1);
        return clip.z / clip.w * 0.5f + 0.5f;
    };
    depth.at(0, 0) = window(-2);
    depth.at(1, 0) = window(-4);
    depth.at(2, 0) = window(-50);
    CHECK(pixelsOf(1, *medianDistance(depth, camera), camera, depth.extent) ==
          Approx(50 / std::tan(0.5) / 4).epsilon(1e-3));

    camera.clip_from_view = glm::ortho(-3.0f, 3.0f, -2.5f, 2.5f, 0.0f, 10.0f);
    CHECK(pixelsOf(1, *medianDistance(depth, camera), camera, depth.extent) == Approx(20));
}

TEST_CASE("A ratio is taken turn by turn, so that moments which slow both sides cancel")
{
    const std::vector<double> unit = {99, 10, 30, 10, 10};  // the first turn was another sample's
    const TimeFigures ratio = ratioFigures({5, 15, 5, 6}, unit);
    CHECK(ratio.median == 0.5);
    CHECK(ratio.q1 == 0.5);
    CHECK(ratioFigures({1, 2}, {0, 0}).median == 0.0);
    CHECK(ratioFigures({}, unit).median == 0.0);
}

TEST_CASE(
    "Turns go on one after the other until the ratio is settled, and first frames do not count")
{
    RecordingDevice device;
    const auto make = [&device] {
        auto description = need(loadDescription({"learnopengl", {}, {}, {}}, shippedSources()));
        return need(Renderer::create(device, std::move(description), {{8, 8}, {"ao"}}, {}));
    };
    const auto renderer = make(), other = make();
    const Frame frame;
    const auto took = [&](double ms) {
        const std::size_t passes = renderer->plan().passes.size();
        FrameTimes times{TimingMethod::processor_time, std::vector<double>(passes), ms, 1};
        times.pass_ms.back() = ms;
        return times;
    };
    const auto run = [&](double rest, int least) {
        TurnTaker one(*renderer, frame), unit(*other, frame);
        Turns turns(one, &unit, least, 5);
        std::string order;
        for (int k = 0; const TurnTaker* next = turns.next(); ++k) {
            order += next == &one ? "a" : "u";
            const bool restless = one.costs().size() % 2 == 1;
            turns.add(took(k < 1 ? 9999 : (next == &one ? 50 : 100) * (restless ? rest : 1)));
        }
        return std::pair(order, turns.ratios());
    };
    CHECK(run(1, 2) == std::pair(std::string("aauuau"), std::vector<double>{0.5, 0.5}));
    CHECK(run(2, 2).first == "aauuauauauau");  // never settled: five of each
    CHECK(run(1, 3).second.size() == 3);

    TurnTaker alone(*renderer, frame);
    Turns turns(alone, nullptr, 1, 1);
    CHECK(turns.take([] { return true; }).ok());
    CHECK(alone.costs().empty());
    for (const double ms : {9.0, 30.0, 12.0}) turns.add(took(ms));
    CHECK(turns.next() == nullptr);
    CHECK(alone.costs() == std::vector<double>{21});
}

TEST_CASE("A median is settled by more turns or by steadier ones")
{
    const TimeFigures steady{1.0, 0.99, 1.01}, restless{1.0, 0.8, 1.2};
    CHECK(medianMargin(steady, 4) <= kSettledMargin);
    CHECK(medianMargin(restless, 7) > kSettledMargin);
    CHECK(medianMargin(restless, 1000) <= kSettledMargin);
    // The interval that its count leaves is 3 % of the median: 1.57 * 0.1 / 0.03 is the root
    // of 27.4.
    const TimeFigures between{1.0, 0.95, 1.05};
    CHECK(medianMargin(between, 27) > kSettledMargin);
    CHECK(medianMargin(between, 28) <= kSettledMargin);
}
