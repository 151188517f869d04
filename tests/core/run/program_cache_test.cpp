// SPDX-License-Identifier: MIT
// Programs that a host keeps between runs, on a driver that is none.
#include "backends/gl/caps.h"
#include "tests/support/failing_changes.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

constexpr int kOwn = 2;  // programs of the device itself

ProgramDesc program(const std::string& vertex = "a", const std::string& fragment = "b")
{
    ProgramDesc desc;
    desc.label = "program";
    desc.vertex.text = vertex;
    desc.fragment.text = fragment;
    return desc;
}

/// A run of an application that makes one program beside the device's own.
struct Run {
    explicit Run(const GlDeviceOptions& options, const FakeDriver& driver = {},
                 const ProgramDesc& desc = program())
        : gl(driver)
    {
        {
            auto device = need(makeGlDevice(gl.loader(), options));
            device->destroy(need(device->createProgram(desc)));
        }
        CHECK(gl.names() == 0);
        CHECK_FALSE(gl.errorPends());
    }

    WatchedGl gl;
};

/// Programs that a run compiles over what is kept.
int compiledBy(KeptPrograms& kept, const FakeDriver& driver = {})
{
    const int compiles = Run(kept.options(), driver).gl.compiles();
    CHECK(compiles % 2 == 0);
    return compiles / 2;
}

}  // namespace

TEST_CASE("A host that keeps programs has each compiled once, whatever the device")
{
    KeptPrograms kept;
    CHECK(compiledBy(kept) == kOwn + 1);
    CHECK(kept.stores == kOwn + 1);
    CHECK(compiledBy(kept) == 0);
    CHECK(kept.stores == kOwn + 1);
    CHECK(kept.entries.size() == kOwn + 1);
    for (const auto& entry : kept.entries) {
        CHECK(entry.first.size() == 16);
        CHECK(entry.first.find_first_not_of("0123456789abcdef") == std::string::npos);
    }
}

TEST_CASE("Programs are kept apart by both stages and by the driver")
{
    KeptPrograms kept;
    const ProgramDesc descs[] = {program("a", "b"), program("a", "c"), program("c", "b"),
                                 program("ab", ""), program("b", "a")};
    for (const ProgramDesc& desc : descs) Run(kept.options(), {}, desc);
    CHECK(kept.entries.size() == kOwn + std::size(descs));
    CHECK(compiledBy(kept, {"another test"}) == kOwn + 1);
    FakeDriver updated;
    updated.version = "OpenGL ES 3.2 of a newer test";
    CHECK(compiledBy(kept, updated) == kOwn + 1);
    CHECK(compiledBy(kept) == 0);
    ProgramDesc renamed = program();
    renamed.label = "another name";
    CHECK(Run(kept.options(), {}, renamed).gl.compiles() == 0);
}

TEST_CASE("A driver without program binaries asks the host nothing")
{
    KeptPrograms kept;
    FakeDriver driver;
    driver.binary_formats = 0;
    CHECK(compiledBy(kept, driver) == kOwn + 1);
    for (const char* missing : {"glGetProgramBinary", "glProgramBinary", "glProgramParameteri"}) {
        WatchedGl gl;
        const GlLoader all = gl.loader();
        const auto device = need(makeGlDevice(
            [&](const char* name) { return std::string(name) == missing ? nullptr : all(name); },
            kept.options()));
        need(device->createProgram(program()));
        CHECK(gl.compiles() == 2 * (kOwn + 1));
    }
    CHECK(kept.loads == 0);
    CHECK(kept.stores == 0);
}

TEST_CASE("Desktop contexts have program binaries from 4.1 on, or by their extension")
{
    const auto has = [](bool desktop, int version, std::vector<std::string> extensions) {
        WatchedGl watched;
        GlApi gl = need(loadGlApi(watched.loader()));
        GlInfo info;
        info.desktop = desktop;
        info.native_version = version;
        info.extensions = std::move(extensions);
        settleOptional(gl, info, watched.loader());
        CHECK((gl.GetProgramBinary != nullptr) == (gl.ProgramBinary != nullptr));
        CHECK((gl.GetProgramBinary != nullptr) == (gl.ProgramParameteri != nullptr));
        return gl.ProgramBinary != nullptr;
    };
    CHECK(has(false, 300, {}));
    CHECK(has(true, 410, {}));
    CHECK(has(true, 330, {"GL_ARB_get_program_binary"}));
    CHECK_FALSE(has(true, 330, {}));
}

TEST_CASE("Kept bytes that are not whole never reach the driver, and are stored again")
{
    KeptPrograms kept;
    compiledBy(kept);
    const auto whole = kept.entries;
    const auto refuses = [&](const std::vector<std::uint8_t>& bytes) {
        for (auto& entry : kept.entries) entry.second = bytes;
        const Run run(kept.options());
        CHECK(run.gl.binaries() == 0);
        CHECK(run.gl.compiles() == 2 * (kOwn + 1));
        CHECK((kept.entries == whole));
    };
    const std::vector<std::uint8_t> bytes = whole.begin()->second;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        refuses({bytes.begin(), bytes.begin() + size});
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::vector<std::uint8_t> damaged = bytes;
        damaged[i] ^= 1;
        refuses(damaged);
    }
    std::vector<std::uint8_t> longer = bytes;
    longer.push_back(0);
    refuses(longer);
    refuses(std::vector<std::uint8_t>(1000, 'x'));
}

TEST_CASE("Bytes of another key never reach the driver")
{
    KeptPrograms kept;
    compiledBy(kept);
    const auto first = kept.entries.begin()->second;
    for (auto& entry : kept.entries) entry.second = first;
    const Run run(kept.options());
    CHECK(run.gl.binaries() == 1);
    CHECK(run.gl.compiles() == 2 * kOwn);
}

TEST_CASE("Memory that runs out over a binary costs no more than a compilation")
{
    KeptPrograms kept;
    WatchedGl gl;
    {
        const auto device = need(makeGlDevice(gl.loader(), kept.options()));
        int made = 0;
        for (const bool warm : {false, true}) {
            const int names = gl.names();
            const auto make = [&]() -> Status {
                if (!warm) kept.entries.clear();
                const Result<ProgramId> program_id = device->createProgram(program());
                if (program_id) device->destroy(*program_id);
                return program_id.diagnostics();
            };
            failEachAttempt(gl, make, [&](const Status& status) {
                CHECK_FALSE(gl.errorPends());
                CHECK(gl.names() == names);
                CHECK((status.ok() || (!warm && onlyCode(status) == Code::out_of_memory)));
                made += status.ok();
            });
            need(device->createProgram(program()));
            CHECK(kept.entries.size() == 1);
        }
        CHECK(made == 3);  // without glGetProgramBinary, glCreateProgram and glProgramBinary
    }
    CHECK(gl.names() == 0);
}
