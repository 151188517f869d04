// SPDX-License-Identifier: MIT
// What `--out NAME=FILE` and `--size WxH` accept, and what they are turned into.
#include "tests/support/need.h"

#include "tools/commands/cli/output_request.h"
#include "tools/render/output_source.h"
#include "tools/render/scene/options.h"

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
        const auto result = read(text);
        REQUIRE_FALSE(result);
        CHECK(result.diagnostics().front().code == code);
        CHECK_FALSE(result.diagnostics().front().help.empty());
    }
}

}  // namespace

TEST_CASE("an output request is a name, the first equals sign and a file of a known extension")
{
    const auto request = need(parseOutputRequest("color=a=b.PNG"));
    CHECK(request.name == "color");
    CHECK(request.file == "a=b.PNG");
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
