// SPDX-License-Identifier: MIT
// A quick answer on a real device: within the limits, with a bench's figures, and in time.
#include "tools/measure/bench/quick.h"

#include "tests/support/gl_fixture.h"
#include "tools/commands/cli/load_config.h"
#include "tools/render/image/image_metrics.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"

#include <crevice/shipped.h>

#include "core/base/text.h"

using namespace crevice;

namespace {

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
