// SPDX-License-Identifier: MIT
// What `--out NAME=FILE` and `--size WxH` accept, and what they are turned into.
// Which exit code a list of diagnostics stands for.
// Work in a process of its own, and other programs: what comes back, and every way in which they
// can go wrong.
#include "tests/support/need.h"

#include "tests/support/temporary_folder.h"
#include "tools/commands/cli/child_process.h"
#include "tools/commands/cli/output.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/options.h"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <new>

using namespace crevice;

namespace {

/// Output ao -> ao_filtered; a view of normal; targets ao, ao_filtered, normal.
Description smallDescription()
{
    Description description;
    description.name = "small";
    for (const char* name : {"ao", "ao_filtered", "normal"}) {
        TargetDesc target;
        target.name = name;
        description.targets.push_back(target);
    }
    OutputDesc output;
    output.name = "ao";
    output.target.name = "ao_filtered";
    description.outputs.push_back(output);
    ViewDesc view;
    view.name = "view_normal";
    view.target.name = "normal";
    view.scale = 0.5f;
    view.offset = 0.25f;
    description.views.push_back(view);
    return description;
}

/// The target of the output that a name exposes.
std::string exposed(Description& description, const std::string& name)
{
    const OutputSource source = need(exposeOutput(description, name));
    const OutputDesc* found = findNamed(description.outputs, source.output);
    return found ? found->target.name : "";
}

/// That each text is refused with that code.
template <class Read>
void checkRefused(const Read& read, Code code, const std::vector<const char*>& texts)
{
    for (const char* text : texts) {
        INFO(text);
        CHECK_FALSE(onlyError(read(text), code).help.empty());
    }
}

Diagnostic warningOf(Code code)
{
    Diagnostic warning{code, "something"};
    warning.severity = Severity::warning;
    return warning;
}

ChildEnd endOf(const ChildLimits& limits, const std::function<void(Sender&)>& work)
{
    std::string answer;
    return runInChild(limits, work, answer);
}

/// Runs a shell script of these lines.
ProgramRun runScript(const std::string& lines, const std::string& input = {}, double time_s = 20)
{
    const TemporaryFolder folder("run_program");
    const std::string path = folder.write("script", "#!/bin/sh\n" + lines + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return runProgram(path, {"CREVICE_WORD=said so"}, input, time_s);
}

}  // namespace

TEST_CASE("an output request is a name, the first equals sign and a file of a known extension")
{
    const auto request = need(parseOutputRequest("color=a=b.PNG"));
    CHECK(request.name == "color");
    CHECK(request.file == "a=b.PNG");
    CHECK(need(parseOutputRequest("doubt_rmse")).file.empty());
    checkRefused(parseOutputRequest, Code::usage,
                 {"lit.png", "=lit.png", "color=", "", "color=lit", "color=lit.jpg",
                  "color=folder.png/lit"});
}

TEST_CASE("a name is an output before it is a target, and target.NAME reaches the hidden one")
{
    Description description = smallDescription();
    CHECK(exposed(description, "ao") == "ao_filtered");
    CHECK(description.outputs.size() == 1);
    CHECK(exposed(description, "target.ao") == "ao");
    CHECK(exposed(description, "normal") == "normal");
    CHECK(description.outputs.size() == 3);
    CHECK(exposed(description, "view_normal") == "normal");
    CHECK(description.outputs.size() == 3);  // asked for twice, exported once
}

TEST_CASE("a file pattern has one place for a frame's number, padded where it says so")
{
    CHECK(frameFile("frame_%03d.png", 7) == "frame_007.png");
    CHECK(frameFile("frame_%03d.png", 1234) == "frame_1234.png");
    CHECK(frameFile("a/%d.pfm", 12) == "a/12.pfm");
    for (const char* file : {"frame_%03d.png", "%d.pfm", "a/%09d.png"})
        CHECK(checkFramePattern(file).ok());
    checkRefused(checkFramePattern, Code::usage,
                 {"a.png", "%.png", "%3d.png", "%0d.png", "%00d.png", "%03x.png", "%s.png",
                  "%d%d.png", "100%_%d.png", "%03"});
}

TEST_CASE("a view scales and shifts what its target holds")
{
    Description description = smallDescription();
    Image image({1, 1}, 2);
    image.pixels = {1.0f, -0.5f};
    applyView(image, need(exposeOutput(description, "view_normal")));
    CHECK(image.pixels == std::vector<float>{0.75f, 0.0f});
}

TEST_CASE("a size is two whole numbers of at least one")
{
    CHECK(need(parseSize("640x480")) == Extent{640, 480});
    checkRefused(parseSize, Code::bad_size,
                 {"", "x", "640", "640x", "x480", "0x480", "640x-1", "-5x3", "640x480x2",
                  "640 x 480", "6e2x480", "99999999999x2", "640X480"});
}

TEST_CASE("the first error chooses the exit code, whatever warnings stand before it")
{
    const Diagnostic input{Code::unknown_key, "a"};
    const Diagnostic machine{Code::no_egl, "b"};
    CHECK(exitCodeOf({}) == kExitOk);
    CHECK(exitCodeOf({warningOf(Code::no_format)}) == kExitOk);
    CHECK(exitCodeOf({warningOf(Code::no_egl), input, machine}) == kExitBadInput);
    CHECK(exitCodeOf({machine, input}) == kExitMachine);
    CHECK(exitCodeOf({{Code::usage, "x"}}) == kExitUsage);
    CHECK(exitCodeOf({{Code::cannot_write, "x"}}) == kExitOutput);
}

TEST_CASE("what a child sends arrives as it was, small and large")
{
    std::vector<int> numbers(300000);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<int>(i * 7);
    const std::size_t size = numbers.size() * sizeof(int);
    std::string answer;
    const ChildEnd end = runInChild(
        {},
        [&](Sender& sender) {
            sender.bytes("first", 5);
            sender.bytes(numbers.data(), size);
        },
        answer);
    CHECK(end == ChildEnd::done);
    CHECK(answer == "first" + std::string(reinterpret_cast<const char*>(numbers.data()), size));
}

TEST_CASE("a child that crashes, ends, throws or hangs is distinguished from one that is done")
{
    void (*const crashes[])(Sender&) = {[](Sender&) { std::abort(); },
                                        [](Sender&) { std::_Exit(0); }, [](Sender&) { throw 1; }};
    for (const auto& work : crashes) CHECK(endOf({}, work) == ChildEnd::crashed);
    ChildLimits limits;
    limits.time_s = 0.2;
    const auto hang = [](Sender&) {
        for (;;) pause();
    };
    const auto begin = std::chrono::steady_clock::now();
    CHECK(endOf(limits, hang) == ChildEnd::too_long);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    CHECK(taken.count() < 5);
}

TEST_CASE("a child is ended at its limit of the processor's time, and may give itself more")
{
    ChildLimits limits;
    limits.time_s = 300;
    limits.cpu_s = 1;
    const auto work = [](double seconds) {
        while (static_cast<double>(std::clock()) / CLOCKS_PER_SEC < seconds) {
        }
    };
    CHECK(endOf(limits, [&](Sender&) { work(100); }) == ChildEnd::too_long);
    const auto more = [&](Sender&) {
        ChildLimits larger = limits;
        larger.cpu_s = 100;
        limitSelf(larger);
        work(1.5);
    };
    CHECK(endOf(limits, more) == ChildEnd::done);
}

TEST_CASE("a child that sends more than it may is not listened to")
{
    ChildLimits limits;
    limits.answer = 1000;
    for (const std::size_t size : {1000u, 1001u}) {
        const std::string sent(size, 'x');
        const ChildEnd end =
            endOf(limits, [&](Sender& sender) { sender.bytes(sent.data(), size); });
        CHECK(end == (size <= limits.answer ? ChildEnd::done : ChildEnd::crashed));
    }
}

TEST_CASE("what a child sends before it crashes arrives")
{
    std::string answer;
    const auto half = [](Sender& sender) {
        sender.bytes("half", 4);
        sender.flush();
        std::abort();
    };
    CHECK(runInChild({}, half, answer) == ChildEnd::crashed);
    CHECK(answer == "half");
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("a child that wants more memory than it may have is refused it")
{
    ChildLimits limits;
    limits.memory = 64 << 20;
    std::string refused;
    const ChildEnd end = runInChild(
        limits,
        [](Sender& sender) {
            char answer = 'n';
            try {
                std::vector<char> much(std::size_t{1} << 30);  // more than the heap has free
                if (much.back() == 1) answer = 'o';
            } catch (const std::bad_alloc&) {
                answer = 'y';
            }
            sender.bytes(&answer, 1);
        },
        refused);
    CHECK(end == ChildEnd::done);
    CHECK(refused == "y");
}
#endif

TEST_CASE("A program gets its input and variables, and what it prints comes back in order")
{
    const ProgramRun run = runScript(
        "cat; echo \"$CREVICE_WORD\" >&2; echo \"${PATH:+a path}\"; exit 3", "some\ntext\n");
    CHECK(run.ended);
    CHECK(run.exit_code == 3);
    CHECK(run.output == "some\ntext\nsaid so\na path\n");
}

TEST_CASE("A program that prints much before it reads blocks nobody")
{
    const std::string input(1 << 20, 'x');
    const ProgramRun run = runScript("head -c 1000000 /dev/zero | tr '\\0' y; cat", input);
    CHECK(run.ended);
    CHECK(run.output.size() == 1000000 + input.size());
}

TEST_CASE("A program that hangs, crashes or is not there is told from one that ends")
{
    const ProgramRun late = runScript("exec sleep 60", "", 0.2);
    CHECK_FALSE(late.ended);
    CHECK(late.failure == "it ran for more than 0.2 s");
    const ProgramRun crashed = runScript("echo so far; kill -9 $$");
    CHECK_FALSE(crashed.ended);
    CHECK(crashed.failure == "it was ended by signal 9");
    CHECK(crashed.output == "so far\n");
    const ProgramRun missing = runProgram("/nowhere/at all", {}, "", 5);
    CHECK_FALSE(missing.ended);
    CHECK(missing.failure == "it cannot be started: No such file or directory");
}
