// SPDX-License-Identifier: MIT
// The GL device on a driver that runs out of memory or loses its context, at any call.
#include <crevice/gl_device.h>

#include "tests/support/failing_changes.h"
#include "tests/support/nightly.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/watched_gl.h"

using namespace crevice;

namespace {

constexpr Extent kSize = {64, 32};

/// What a host does from its first call on, a step at a time; a step that failed may be tried
/// again.
struct Host {
    explicit Host(WatchedGl& on, GlDeviceOptions with = {}) : gl(on), options(std::move(with)) {}

    Status makeDevice()
    {
        auto made = makeGlDevice(gl.loader(), options);
        if (made) device = std::move(*made);
        return made.diagnostics();
    }

    Status makeMesh()
    {
        const auto made =
            device->createMesh({"triangle", std::vector<Vertex>(3), std::vector<std::uint32_t>(3)});
        if (!made) return made.diagnostics();
        frame.draws = {{*made, 0, 3, glm::dmat4(1.0), 0}};
        frame.materials.resize(1);
        return {};
    }

    Status makeRenderer()
    {
        static const Description description = rigDescription();
        auto made = Renderer::create(*device, description, {kSize}, traitsOf(frame));
        if (made) renderer = std::move(*made);
        return made.diagnostics();
    }

    Status draw() { return renderer->render(frame); }
    Status follow()
    {
        renderer->follow("ao");
        return draw();
    }

    Status present() { return device->present(renderer->output("color"), {0, 0, 0, kSize}); }

    Status read() { return device->readTexture(renderer->output("ao")).diagnostics(); }
    Status resize() { return renderer->resize({30, 20}); }
    Status define() { return renderer->setParam("samples", 9.0f); }

    Status write()
    {
        const auto made = device->createTexture({"own", Format::r8, {2, 2}});
        if (!made) return made.diagnostics();
        const Status written = device->writeTexture(*made, Image({2, 2}, 1));
        device->destroy(*made);
        return written;
    }

    Status adopt()
    {
        const auto made = device->adoptTexture({1, "host", Format::r8, {2, 2}});
        if (made) device->destroy(*made);
        return made.diagnostics();
    }

    using Step = Status (Host::*)();

    WatchedGl& gl;
    GlDeviceOptions options;
    std::unique_ptr<Device> device;
    Frame frame;
    std::unique_ptr<Renderer> renderer;
};

const Host::Step kSteps[] = {&Host::makeDevice, &Host::makeMesh, &Host::makeRenderer, &Host::draw,
                             &Host::present,    &Host::read,     &Host::resize,       &Host::draw,
                             &Host::define,     &Host::write,    &Host::adopt,        &Host::follow,
                             &Host::draw};

constexpr std::size_t kMakesRenderer = 2;

Status doStep(Host& host, std::size_t index)
{
    const Host::Step step = kSteps[index];
    return (host.*step)();
}

/// Does the steps before that one; they must not fail.
void doStepsTo(Host& host, std::size_t end)
{
    for (std::size_t i = 0; i < end; ++i) need(doStep(host, i));
}

/// All that still can be done fails alike, and neither that nor the end reaches the driver.
void checkAbandoned(std::unique_ptr<Host> host)
{
    WatchedGl& gl = host->gl;
    const int calls = gl.calls();
    if (host->renderer)
        for (const Host::Step step :
             {&Host::draw, &Host::present, &Host::read, &Host::write, &Host::adopt})
            CHECK(onlyCode((*host.*step)()) == Code::context_lost);
    host.reset();
    CHECK(gl.calls() == calls);
}

}  // namespace

TEST_CASE("A context that is lost at any call ends in one CV6016, and no call of GL after it")
{
    const Loss loss = GENERATE(Loss::for_ever, Loss::by_commands);
    KeptPrograms kept;
    const GlDeviceOptions options = GENERATE(false, true) ? kept.options() : GlDeviceOptions();
    const int stride = nightly() ? 1 : 29;  // a step has up to thousands of calls
    for (std::size_t step = 0; step < std::size(kSteps); ++step)
        for (int n = 1;; n += stride) {
            WatchedGl gl;
            auto host = std::make_unique<Host>(gl, options);
            doStepsTo(*host, step);
            gl.loseAt(n, loss);
            const Status status = doStep(*host, step);
            INFO("step " << step << ", call " << n << "\n" << toText(status.diagnostics()));
            CHECK((n > 1 || !status));
            if (status) break;
            REQUIRE(onlyCode(status) == Code::context_lost);
            checkAbandoned(std::move(host));
        }
}

TEST_CASE(
    "A context whose loss only glGetGraphicsResetStatus reports ends in CV6016 with the next step")
{
    for (std::size_t next = kMakesRenderer; next < std::size(kSteps); ++next) {
        INFO("step " << next);
        WatchedGl gl;
        auto host = std::make_unique<Host>(gl);
        doStepsTo(*host, next);
        gl.loseAt(1, Loss::by_status);
        CHECK(onlyCode(doStep(*host, next)) == Code::context_lost);
        checkAbandoned(std::move(host));
    }
}

TEST_CASE("A device whose context the host destroyed calls no GL")
{
    WatchedGl gl;
    auto host = std::make_unique<Host>(gl);
    doStepsTo(*host, std::size(kSteps));
    abandonGlDevice(*host->device);
    checkAbandoned(std::move(host));
}

TEST_CASE(
    "A host without a current context gets CV6004 for each step, and after it goes on as before")
{
    WatchedGl gl;
    {
        Host host(gl);
        doStepsTo(host, kMakesRenderer + 1);
        for (std::size_t next = 1; next < std::size(kSteps); ++next) {
            INFO("step " << next);
            if (next == kMakesRenderer) continue;  // it would destroy the one that there is
            const int names = gl.names();
            gl.loseAt(1, Loss::by_nothing);
            CHECK(onlyCode(doStep(host, next)) == Code::gl_version);
            gl.regain();
            CHECK(gl.names() == names);
            need(doStep(host, next));
        }
        gl.loseAt(1, Loss::by_nothing);
        CHECK(
            onlyCode(Renderer::create(*host.device, rigDescription(), {kSize}, {}).diagnostics()) ==
            Code::gl_version);
        gl.regain();
    }
    CHECK(gl.names() == 0);
}

TEST_CASE("What is destroyed without a current context is deleted once it is back")
{
    WatchedGl gl;
    Host host(gl);
    doStepsTo(host, kMakesRenderer + 1);
    const int names = gl.names();
    gl.loseAt(1, Loss::by_nothing);
    host.device->destroy(host.frame.draws[0].mesh);
    CHECK_FALSE(host.device->info(host.frame.draws[0].mesh).exists);
    gl.regain();
    CHECK(gl.names() == names);
    need(host.draw());
    CHECK(gl.names() == names - 3);
}

TEST_CASE("A device that lacks memory as it is made leaves no name behind")
{
    WatchedGl gl;
    int failures = 0;
    const auto make = [&] { return Status(makeGlDevice(gl.loader()).diagnostics()); };
    failEachAttempt(gl, make, [&](const Status& status) {
        // A format that cannot be tried out counts as one that cannot be drawn into.
        if (!status) ++failures;
        if (!status) CHECK(onlyCode(status) == Code::out_of_memory);
        CHECK(gl.names() == 0);
    });
    CHECK(failures > 5);
}

TEST_CASE("A driver that is out of memory at any call is reported, and nothing stays behind")
{
    std::set<Code> codes;
    for (std::size_t step = 1; step < std::size(kSteps); ++step) {
        INFO("step " << step);
        WatchedGl gl;
        Host host(gl);
        doStepsTo(host, step);
        const int names = gl.names();
        failEachAttempt(
            gl, [&] { return doStep(host, step); },
            [&](const Status& status) {
                REQUIRE_FALSE(status.ok());
                CHECK(onlyCode(status) != Code::internal);
                codes.insert(onlyCode(status));
                CHECK(gl.names() == names);
                CHECK_FALSE(gl.errorPends());
            });
    }
    CHECK(codes == std::set<Code>{Code::gl_error, Code::out_of_memory});
}
