// SPDX-License-Identifier: MIT
// A whole bench on a real device: figures, pictures, a config that fails, and the same errors
// twice.
// A quick answer on a real device: within the limits, with a bench's figures, and in time.
#include "tools/measure/bench/measure.h"

#include "core/base/text.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"
#include "tools/commands/cli/load_config.h"
#include "tools/measure/bench/quick.h"
#include "tools/measure/bench/run.h"
#include "tools/render/camera_path.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"
#include "tools/render/scene_upload.h"

#include <crevice/shipped.h>

using namespace crevice;

namespace {

BenchOptions smallOptions()
{
    BenchOptions options;
    options.scenes = {"spheres"};
    options.sizes = {"64x36"};
    options.configs = {"hemisphere_box"};
    options.rays = 16;
    return options;
}

/// Plans, measures all samples into the folder and reads them back.
std::vector<BenchSample> bench(const BenchOptions& options, const SourceSet& sources,
                               const TemporaryFolder& folder)
{
    GlFixture gl;
    const BenchPlan plan = need(planBench(options, sources));
    MeasureOptions measure;
    measure.rays = options.rays;
    measure.repeats = 3;
    measure.motion = options.motion;
    if (options.motion) measure.cache_folder = (folder.path / "cache").string();
    measure.out_folder = folder.path.string();
    BenchMeter meter(*gl.device, plan, sources, measure);
    BenchFile file = need(openBench(folder.path.string()));
    MeasureWorld world;
    world.device = gl.device->caps().name;
    world.measure = [&meter](const BenchTask& task) { return meter.measure(task); };
    world.seconds = [] { return 0.0; };
    world.interrupted = [] { return false; };
    world.begin = world.say = [](const std::string&) {};
    need(measureAll(plan, file, world).written);
    return need(readBenchSamples({(folder.path / "results.jsonl").string()}));
}

void checkErrors(const BenchSample& sample)
{
    CHECK(sample.failure.empty());
    CHECK(sample.error.pixels > 0);
    CHECK(sample.error.rmse > 0.01);
    CHECK(sample.error.rmse < 0.3);
    CHECK(sample.error.rmse_fit <= sample.error.rmse);
    CHECK(sample.error_without_ao > 0.01);
    CHECK(sample.repeats >= 3);
}

void checkMotion(const MotionFigures& motion)
{
    REQUIRE(motion.paths.size() == std::size(kCameraPaths));
    for (const auto& [path, figures] : motion.paths) {
        INFO(path);
        CHECK(figures.changes > 1000);
        CHECK(figures.rmse > 0.01);
        CHECK(figures.rmse < 0.3);
        CHECK(figures.p99 <= figures.p999);
    }
    REQUIRE(motion.uncovered.size() == 5);
    CHECK(motion.uncovered.front().frames == 1);
    CHECK(motion.uncovered.back().frames == 16);
    CHECK(motion.uncovered_pixels > 0);
}

BenchView spheres(Extent extent)
{
    Scene scene = need(builtinScene("spheres"));
    const Bounds bounds = scene.bounds();
    const double aspect = double(extent.width) / extent.height;
    const SceneCamera camera = need(chooseCamera(scene, bounds, "", aspect));
    return {std::make_shared<Scene>(std::move(scene)), bounds, camera, extent};
}

QuickOptions quickOptions()
{
    QuickOptions options;
    options.scene = "spheres";
    options.configs = {"mobile_low", "gtao"};
    options.overrides = {"radius=1"};
    options.limits = {{ChoiceLimit::Kind::error, 0.06}};
    options.time_s = 30;
    return options;
}

}  // namespace

TEST_CASE("A bench measures error, times and bytes, and goes on past a config that fails")
{
    MemorySources mine;
    mine.add("configs/broken.json", R"({
        "format": 1, "extends": ["hemisphere_box"], "shaders": {"ssao": {"fragment": "broken.frag"}}})");
    mine.add("broken.frag",
             "#version 300 es\nlayout(location = 0) out mediump float ao;\n"
             "void main() { ao = nothing; }\n");
    const LayeredSources sources({&mine, &shippedSources()});
    const TemporaryFolder folder("bench_gl");
    BenchOptions options = smallOptions();
    options.configs = {"broken", "hemisphere_box"};
    const std::vector<BenchSample> samples = bench(options, sources, folder);
    REQUIRE(samples.size() == 2);
    CHECK(!samples[0].failure.empty());

    const BenchSample& sample = samples[1];
    checkErrors(sample);
    REQUIRE(sample.passes.size() == 4);
    CHECK(sample.passes[0].name == "geometry");
    CHECK(sample.total.median > 0.0);
    CHECK(sample.total.q1 <= sample.total.q3);
    CHECK(sample.cost.median > 0.0);
    CHECK(sample.cost.median < sample.total.median);
    CHECK(sample.clock == (sample.software ? "cpu" : "query"));
    CHECK(sample.cost_with_geometry.median == sample.cost.median);  // deferred, one layer
    CHECK(sample.ratio_with_geometry == sample.ratio_learnopengl);
    CHECK(sample.ratio_learnopengl > 0.0);
    CHECK(sample.radius_px > 1.0);
    CHECK(sample.bytes_read > 0.0);
    CHECK(sample.texture_bytes > 0.0);
    for (const std::string& picture :
         {sample.ao_picture, sample.ground_truth_picture, sample.difference_picture})
        CHECK(need(readImage(picture)).extent == Extent{64, 36});
}

TEST_CASE("A bench of whole frames times the lighting too, and has the errors of ao")
{
    const TemporaryFolder folder("bench_gl_color");
    BenchOptions options = smallOptions();
    const BenchSample ao = bench(options, shippedSources(), folder).at(0);
    options.output = "color";
    options.overrides = {"lighting/blinn_phong=lighting/forward"};
    const BenchSample forward = bench(options, shippedSources(), folder).at(1);
    CHECK(forward.error.rmse == ao.error.rmse);
    CHECK(forward.passes.size() == ao.passes.size() + 1);
    CHECK(forward.passes.back().name == "lighting");
    const double drawn = forward.passes.front().ms.median;
    CHECK(forward.cost_with_geometry.median > forward.cost.median + 0.5 * drawn);
}

TEST_CASE("A bench measures motion: open pictures change as the truth alone, taps flicker")
{
    const TemporaryFolder folder("bench_gl_motion");
    BenchOptions options = smallOptions();
    options.motion = true;
    options.configs = {"gtao", "gtao_temporal"};
    options.radii = {0.5};
    const std::vector<BenchSample> samples = bench(options, shippedSources(), folder);
    REQUIRE(samples.size() == 2);
    const MotionFigures gtao = samples[0].motion, temporal = samples[1].motion;
    checkMotion(gtao);
    CHECK(gtao.settled_after == 1);
    CHECK(gtao.paths.at("still").p999 == 0.0);
    CHECK(gtao.paths.at("pan").rms > gtao.paths.at("sub-pixel").rms);
    CHECK(gtao.paths.at("still").rmse < samples[0].error.rmse);  // whose few rays are noise
    // Without a history, what was uncovered is as it is at rest.
    for (const UncoveredFigures& each : gtao.uncovered) CHECK(each.rmse == gtao.uncovered_rest);
    checkMotion(temporal);
    CHECK(temporal.paths.at("still").rms < temporal.paths.at("sub-pixel").rms);
    CHECK(temporal.paths.at("disocclusion").rms > temporal.paths.at("still").rms);
    CHECK(temporal.uncovered.front().rmse != temporal.uncovered.back().rmse);

    options.overrides = {"intensity=0"};
    options.configs = {"gtao"};
    const BenchSample open = bench(options, shippedSources(), folder).at(2);
    checkMotion(open.motion);
    for (const auto& [path, figures] : open.motion.paths) {
        INFO(path);
        CHECK(figures.rms == Approx(figures.truth));
        CHECK((figures.truth > 0.0) == (path != "still" && path != "disocclusion"));
    }
}

TEST_CASE("A quick answer says what a bench would say, within its margins")
{
    GlFixture gl;
    const BenchView view = spheres({192, 108});
    QuickOptions options = quickOptions();
    std::vector<std::string> said;
    options.say = [&said](const std::string& line) { said.push_back(line); };
    QuickBench bench(*gl.device, view, shippedSources(), options);
    need(bench.run());
    REQUIRE(!said.empty());
    CHECK(has(said[0], "a first look, in a picture of 192x108: "));

    const std::vector<BenchSample> samples = bench.samples();
    const Candidates candidates = need(findCandidates(samples, {}));
    const BenchSample& best =
        samples[candidates.list[need(choose(candidates, options.limits)).within[0]].sample];
    CHECK(best.error.rmse <= 0.06);
    CHECK(has(said.back(), sampleLabel(best)));
    CHECK(std::count_if(samples.begin(), samples.end(), [](const BenchSample& each) {
              return each.config == "mobile_low" && each.overrides.size() > 1;
          }) > 0);  // neighbours

    const Image truth = need(traceAmbientOcclusion(*view.scene, view.matrices(), view.extent, {1}));
    const Description description =
        need(loadDescription({best.config, {}, best.overrides, {}}, shippedSources()));
    const UploadedScene scene = need(UploadedScene::upload(*gl.device, *view.scene));
    const Frame frame = makeFrame(scene, view.camera, view.extent);
    const auto renderer =
        need(Renderer::create(*gl.device, description, {view.extent, {"ao"}, {}}, traitsOf(frame)));
    const Image ao = need(drawSettled(*gl.device, *renderer, frame, "ao"));
    const QuickDetails details = bench.detailsOf(best);
    CHECK(std::abs(need(compareImages(ao, truth)).rmse - best.error.rmse) <= details.error_margin);
    CHECK(details.error_margin < 0.1 * best.error.rmse);
    CHECK(details.sure > 0.0);
    CHECK(details.sure <= 1.0);
    CHECK(!details.neighbours.empty());
    CHECK(details.frame.occlusion > 0.0);
    CHECK(details.frame.geometry + details.frame.own_geometry > 0.0);
    CHECK(details.frame.lighting > 0.0);
    CHECK(best.ratio_learnopengl > 0.0);
    CHECK(best.texture_bytes > 0.0);
}

TEST_CASE("Flicker counts where it is asked for, and what cannot be drawn is named")
{
    GlFixture gl;
    const BenchView view = spheres({96, 54});
    QuickOptions options = quickOptions();
    options.motion = true;
    options.configs = {"gtao", "command/depth", "nothing"};
    options.limits = {{ChoiceLimit::Kind::time_ms, 1e6}};
    options.time_s = 20;
    QuickBench bench(*gl.device, view, shippedSources(), options);
    const Status done = bench.run();
    REQUIRE(done.ok());
    REQUIRE(done.diagnostics().size() == 2);
    CHECK(has(done.diagnostics()[1].message, "nothing"));
    const std::vector<BenchSample> samples = bench.samples();
    REQUIRE(!samples.empty());
    CHECK(flickerOf(samples[0].motion) > 0.0);
    CHECK(samples[0].motion.paths.size() == std::size(kFlickerPaths));
    const double still = need(findCandidates(samples, {})).list.at(0).error;
    CHECK(need(findCandidates(samples, {{}, {}, {}, true})).list.at(0).error > still);
}

TEST_CASE("Where nothing can be within the limits, the nearest is measured")
{
    GlFixture gl;
    const BenchView view = spheres({96, 54});
    QuickOptions options = quickOptions();
    options.limits = {{ChoiceLimit::Kind::error, 1e-6}};
    QuickBench bench(*gl.device, view, shippedSources(), options);
    need(bench.run());
    REQUIRE(bench.samples().size() == 1);
    CHECK(bench.samples()[0].config == "gtao");
}

TEST_CASE("A quick answer that is interrupted has what was measured until then")
{
    GlFixture gl;
    const BenchView view = spheres({96, 54});
    QuickOptions options = quickOptions();
    int asked = 0;
    options.interrupted = [&asked] { return ++asked > 2; };
    QuickBench bench(*gl.device, view, shippedSources(), options);
    CHECK(bench.run().ok());
    CHECK(bench.samples().size() < 3);
}
