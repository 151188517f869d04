// SPDX-License-Identifier: MIT
// Entry of the tests that need GL. CREVICE_BACKEND chooses the context, egl when unset. Without a
// context they are skipped, exit code 77; with CREVICE_REQUIRE_GL=1 that is a failure.
#define CATCH_CONFIG_RUNNER
#include "tests/support/gl_fixture.h"

#include <cstdio>
#include <cstdlib>

namespace crevice {

namespace {

constexpr int kSkipped = 77;

std::unique_ptr<Context> context;

std::string environment(const char* name, const char* fallback)
{
    const char* value = std::getenv(name);
    return value && *value ? value : fallback;
}

int runTests(Catch::Session& session)
{
    Result<std::unique_ptr<Context>> made = makeContext(testBackend());
    if (!made) {
        std::fputs(toText(made.diagnostics()).c_str(), stderr);
        return environment("CREVICE_REQUIRE_GL", "0") == "1" ? EXIT_FAILURE : kSkipped;
    }
    context = std::move(*made);
    std::printf("%s\n", context->description().c_str());
    const int failures = session.run();
    context.reset();
    return failures;
}

}  // namespace

std::string testBackend() { return environment("CREVICE_BACKEND", "egl"); }

Context& testContext() { return *context; }

}  // namespace crevice

// For the leak sanitizer: OSMesa of Mesa 22.3.6 frees no buffer that it makes in OSMesaMakeCurrent.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }

int main(int argc, char** argv)
{
    Catch::Session session;
    if (const int code = session.applyCommandLine(argc, argv)) return code;
    const Catch::ConfigData& config = session.configData();
    const bool lists = config.showHelp || config.listTests || config.listTestNamesOnly ||
                       config.listTags || config.listReporters;
    return lists ? session.run() : crevice::runTests(session);
}
