// SPDX-License-Identifier: MIT
// What `--out NAME=FILE` and `--size WxH` accept, and what they are turned into.
#include "tests/support/catch.h"

#include "tools/cli/output_request.h"
#include "tools/render/output_source.h"
#include "tools/scene/options.h"

#include <filesystem>

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

std::string targetOf(const Description& description, const std::string& output)
{
    const OutputDesc* found = findNamed(description.outputs, output);
    return found ? found->target.name : "";
}

}  // namespace

TEST_CASE("an output request splits at the first equals sign")
{
    const auto request = parseOutputRequest("color=a=b.PNG");
    REQUIRE(request);
    CHECK(request->name == "color");
    CHECK(request->file == "a=b.PNG");
}

TEST_CASE("an output request without a name, a file or a known extension is a usage error")
{
    for (const char* text : {"lit.png", "=lit.png", "color=", "", "color=lit", "color=lit.jpg",
                             "color=folder.png/lit"}) {
        INFO(text);
        const auto request = parseOutputRequest(text);
        REQUIRE_FALSE(request);
        CHECK(request.diagnostics().front().code == Code::usage);
        CHECK_FALSE(request.diagnostics().front().help.empty());
    }
}

TEST_CASE("a name is an output before it is a target, and target.NAME reaches the hidden one")
{
    Description description = smallDescription();
    const auto output = exposeOutput(description, "ao");
    REQUIRE(output);
    CHECK(targetOf(description, output->output) == "ao_filtered");
    CHECK(description.outputs.size() == 1);

    const auto hidden = exposeOutput(description, "target.ao");
    REQUIRE(hidden);
    CHECK(targetOf(description, hidden->output) == "ao");

    const auto plain = exposeOutput(description, "normal");
    REQUIRE(plain);
    CHECK(targetOf(description, plain->output) == "normal");
}

TEST_CASE("a file pattern has one place for a frame's number, padded where it says so")
{
    CHECK(frameFile("frame_%03d.png", 7) == "frame_007.png");
    CHECK(frameFile("frame_%03d.png", 1234) == "frame_1234.png");
    CHECK(frameFile("a/%d.pfm", 12) == "a/12.pfm");
    for (const char* file : {"frame_%03d.png", "%d.pfm", "a/%09d.png"})
        CHECK(checkFramePattern(file).ok());
    for (const char* file : {"a.png", "%.png", "%3d.png", "%0d.png", "%00d.png", "%03x.png",
                             "%s.png", "%d%d.png", "100%_%d.png", "%03"}) {
        INFO(file);
        const Status known = checkFramePattern(file);
        REQUIRE_FALSE(known.ok());
        CHECK(known.diagnostics().front().code == Code::usage);
        CHECK(known.diagnostics().front().help.find("frame_%03d.png") != std::string::npos);
    }
}

TEST_CASE("asking twice for one target exports it once")
{
    Description description = smallDescription();
    REQUIRE(exposeOutput(description, "normal"));
    REQUIRE(exposeOutput(description, "view_normal"));
    CHECK(description.outputs.size() == 2);
}

TEST_CASE("a view scales and shifts what its target holds")
{
    Description description = smallDescription();
    const auto view = exposeOutput(description, "view_normal");
    REQUIRE(view);
    Image image({1, 1}, 2);
    image.pixels = {1.0f, -0.5f};
    applyView(image, *view);
    CHECK(image.pixels == std::vector<float>{0.75f, 0.0f});
}

TEST_CASE("an unknown output is reported with the names that would do")
{
    Description description = smallDescription();
    const auto source = exposeOutput(description, "normla");
    REQUIRE_FALSE(source);
    const Diagnostic& error = source.diagnostics().front();
    CHECK(error.code == Code::output_missing);
    CHECK(error.help.find("did you mean 'normal'") != std::string::npos);
    CHECK(error.help.find("target.ao") != std::string::npos);
    CHECK(description.outputs.size() == 1);
}

TEST_CASE("a size is two whole numbers of at least one")
{
    const auto size = parseSize("640x480");
    REQUIRE(size);
    CHECK(*size == Extent{640, 480});
    for (const char* text : {"", "x", "640", "640x", "x480", "0x480", "640x-1", "-5x3", "640x480x2",
                             "640 x 480", "6e2x480", "99999999999x2", "640X480"}) {
        INFO(text);
        const auto wrong = parseSize(text);
        REQUIRE_FALSE(wrong);
        CHECK(wrong.diagnostics().front().code == Code::bad_size);
    }
}

TEST_CASE("a file whose folder is missing, or that is a folder, is known to be unwritable")
{
    namespace fs = std::filesystem;
    const std::string folder = fs::temp_directory_path().string();
    CHECK(checkWritable(folder + "/crevice_never_written.png"));
    for (const std::string& file : {folder + "/no_such_folder/a.png", folder}) {
        const Status status = checkWritable(file);
        REQUIRE_FALSE(status);
        CHECK(status.diagnostics().front().code == Code::cannot_write);
    }
    CHECK_FALSE(fs::exists(folder + "/crevice_never_written.png"));
}
