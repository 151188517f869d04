// SPDX-License-Identifier: MIT
// Malformed configs: one mistake gives one error, at its place, with a way out.
#include "tests/support/bad_corpus.h"

#include <algorithm>
#include <map>
#include <set>

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
        reported.erase(std::remove_if(reported.begin(), reported.end(), warning), reported.end());
        INFO(config.name);
        checkReported(config, reported);
        CHECK_FALSE(reported[0].help.empty());
        const bool needs_device = config.name.rfind("run_time/", 0) == 0;
        CHECK((needs_device || device.log().empty()));
    }
}

TEST_CASE("What shipped modules do together is reported in the config, with a note in the module")
{
    const std::map<std::string, std::string> kModules = {
        {"graph/two_modules_write", "effects/filter/bilateral.json:39:61"},
        {"graph/writer_deleted", "effects/lighting/deferred.json:42:33"},
        {"references/filter_missing", "effects/lighting/deferred.json:42:33"},
        {"references/target_deleted", "effects/ssao/foreground.json:6:91"}};
    std::size_t seen = 0;
    for (const CorpusCase& config : corpus().cases()) {
        const auto module = kModules.find(config.name);
        if (module == kModules.end()) continue;
        RecordingDevice device(capsOf(config));
        const Diagnostics reported = diagnosticsOf(config, device);
        INFO(config.name << "\n" << toText(reported));
        REQUIRE(reported.size() == 1);
        REQUIRE_FALSE(reported[0].notes.empty());
        CHECK(placeName(reported[0].notes[0].place) == module->second);
        ++seen;
    }
    CHECK(seen == kModules.size());
}

TEST_CASE("No two configs of the corpus have one name")
{
    std::set<std::string> names;
    for (const CorpusCase& config : corpus().cases()) CHECK(names.insert(config.name).second);
    CHECK(names.size() >= 235);
}

TEST_CASE("A config of two MiB is refused unread")
{
    const std::string head = "{\"format\": 1, \"description\": \"";
    MemorySources sources;
    sources.add("configs/huge.json", head + std::string(2u << 20, '.') + "\"}");
    const Result<Node> document = loadConfig(sources, {"huge"});
    REQUIRE(document.diagnostics().size() == 1);
    const Diagnostic& error = document.diagnostics().front();
    CHECK(error.code == Code::too_large);
    CHECK(placeName(error.place) == "configs/huge.json:1:1");
    CHECK_FALSE(error.help.empty());
}
