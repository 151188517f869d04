// SPDX-License-Identifier: MIT
// Shipped configs at the ends of their counts, on real GL.
#include <crevice/renderer.h>

#include "tests/backends/stage.h"
#include "tests/support/picture.h"

using namespace crevice;

TEST_CASE("Shipped configs draw visibility with the least and the most of every count")
{
    GlFixture gl;
    Stage stage(*gl.device, {16, 9});
    for (const Subject& subject : sampledSubjects()) {
        for (const bool most : {false, true}) {
            INFO(subject.config << " " << subject.variant << (most ? " most" : " least"));
            const auto renderer = stage.make(withCounts(descriptionOf(subject), most), {"ao"});
            need(renderer->render(stage.frame));
            CHECK(allVisibility(gl.read(renderer->output("ao"))));
        }
    }
}
