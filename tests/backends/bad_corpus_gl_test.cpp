// SPDX-License-Identifier: MIT
// The configs of the corpus whose mistake only a driver sees: GLSL that does not compile.
#include "tests/support/bad_corpus.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

TEST_CASE_METHOD(GlFixture,
                 "GLSL of the corpus that does not compile is reported in its author's line")
{
    int checked = 0;
    for (const CorpusCase& config : corpusCases()) {
        if (!config.expected.find("driver")) continue;
        const Diagnostics reported = diagnosticsOf(config, *device);
        INFO(config.name << "\n" << toText(reported));
        REQUIRE(reported.size() == 1);
        CHECK(codeName(reported[0].code) == config.text("code"));
        CHECK(placeInCorpus(reported[0].place) == config.text("at"));
        CHECK(reported[0].pointer == config.text("pointer"));
        CHECK_THAT(reported[0].help, Catch::Contains(config.text("help")));
        ++checked;
    }
    CHECK(checked >= 3);
}
