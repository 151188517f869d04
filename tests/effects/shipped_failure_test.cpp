// SPDX-License-Identifier: MIT
// Shipped configs on a device without memory: nothing is left behind, what worked works on,
// and the next try is as good as if nothing had failed.
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "tests/support/failing_changes.h"
#include "tests/support/shipped_subjects.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};

struct Bench {
    RecordingDevice device;
    Frame frame;

    Bench()
    {
        const MeshDesc mesh = {"mesh", std::vector<Vertex>(3), {0, 1, 2}};
        frame.draws = {{need(device.createMesh(mesh)), 0, 3, glm::dmat4(1.0), 0}};
        frame.materials.resize(1);
        frame.lights.resize(1);
    }

    std::string draw(Renderer& renderer, const Frame& shown)
    {
        device.clearLog();
        need(renderer.render(shown));
        return device.log();
    }

    Result<std::unique_ptr<Renderer>> make(const Description& description)
    {
        return Renderer::create(device, description, {kExtent}, traitsOf(frame));
    }
};

}  // namespace

TEST_CASE(
    "Shipped configs and variants that lack any object leave none behind, and draw with the next "
    "try")
{
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << " " << subject.variant);
        const Description description = descriptionOf(subject);
        Bench bench, other;
        std::unique_ptr<Renderer> renderer;
        const auto create = [&]() -> Status {
            auto made = bench.make(description);
            if (made) renderer = std::move(*made);
            return made.diagnostics();
        };
        CHECK(failEachObject(bench.device, create, [] {}) > 5);
        auto never_failed = need(other.make(description));
        CHECK(bench.draw(*renderer, bench.frame) == other.draw(*never_failed, other.frame));
        CHECK(bench.device.misuse().empty());
    }
}
