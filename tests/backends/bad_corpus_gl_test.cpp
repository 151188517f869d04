// SPDX-License-Identifier: MIT
// The configs of the corpus whose mistake only a driver sees: GLSL that does not compile.
#include "tests/support/bad_corpus.h"
#include "tests/support/gl_fixture.h"

using namespace crevice;

TEST_CASE_METHOD(GlFixture,
                 "GLSL of the corpus that does not compile is reported in its author's line")
{
    int checked = 0;
    for (const CorpusCase& config : corpus().cases()) {
        if (!config.options.find("driver")) continue;
        const Diagnostics reported = diagnosticsOf(config, *device);
        checkReported(config, reported);
        ++checked;
    }
    CHECK(checked >= 3);
}
