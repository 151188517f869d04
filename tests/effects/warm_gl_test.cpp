// SPDX-License-Identifier: MIT
// Warming for real: the driver has nothing left to compile in the first frame, which is the same.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <algorithm>
#include <fstream>
#include <set>

using namespace crevice;

namespace {

/// Where the process holds code that no file has: machine code that llvmpipe compiled. Nothing
/// where the system does not tell.
std::set<std::size_t> compiledPages()
{
    constexpr std::size_t kPage = 4096;
    std::ifstream maps("/proc/self/maps");
    std::set<std::size_t> pages;
    for (std::string line; std::getline(maps, line);) {
        std::size_t begin = 0, end = 0;
        char rights[5] = {};
        if (std::sscanf(line.c_str(), "%zx-%zx %4s", &begin, &end, rights) == 3 &&
            rights[2] == 'x' && line.find('/') == std::string::npos)
            for (; begin < end; begin += kPage) pages.insert(begin);
    }
    return pages;
}

struct FirstFrames {
    long compiled;  ///< Pages that came with the first one. Others may go meanwhile.
    std::vector<Image> pictures;
};

FirstFrames drawFirst(const char* config, bool warms)
{
    SceneRig rig("room");
    const Frame frame = rig.frame();
    const auto renderer = rig.renderer(descriptionOf({config}), frame, {"ao"});
    while (warms && !need(renderer->warm(frame))) {
    }
    const std::set<std::size_t> before = compiledPages();
    need(renderer->render(frame));
    const std::set<std::size_t> after = compiledPages();
    const auto is_new = [&](std::size_t page) { return before.count(page) == 0; };
    FirstFrames made = {std::count_if(after.begin(), after.end(), is_new),
                        {rig.read(renderer->output("ao"))}};
    need(renderer->render(frame));
    made.pictures.push_back(rig.read(renderer->output("ao")));
    return made;
}

}  // namespace

TEST_CASE("After warming the driver compiles nothing in the first frame, and pictures are the same")
{
    const bool tells = GlFixture().device->caps().name.find("llvmpipe") != std::string::npos &&
                       !compiledPages().empty();
    for (const char* config : {"mobile", "balanced_temporal"}) {
        INFO(config);
        const FirstFrames cold = drawFirst(config, false), warm = drawFirst(config, true);
        CHECK((cold.compiled > 0) == tells);
        CHECK(warm.compiled == 0);
        for (const int i : {0, 1}) CHECK((warm.pictures[i].pixels == cold.pictures[i].pixels));
    }
}
