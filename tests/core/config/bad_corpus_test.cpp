// SPDX-License-Identifier: MIT
// Malformed configs: one mistake gives one error, at its place, with a way out.
#include "tests/support/bad_corpus.h"

using namespace crevice;

TEST_CASE("Every config of the corpus gets one error, with its place and the way out")
{
    for (const CorpusCase& config : corpus().cases()) {
        if (config.options.find("driver")) continue;  // no text shows it: bad_corpus_gl_test.cpp
        RecordingDevice device(capsOf(config));
        Diagnostics reported = diagnosticsOf(config, device);
        const auto warning = [](const Diagnostic& each) {
            return each.severity != Severity::error;
        };
        eraseIf(reported, warning);
        INFO(config.name);
        checkReported(config, reported);
        CHECK_FALSE(reported[0].help.empty());
        const bool needs_device = config.name.rfind("run_time/", 0) == 0;
        CHECK((needs_device || device.log().empty()));
    }
}
