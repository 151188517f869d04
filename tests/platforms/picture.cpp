// SPDX-License-Identifier: MIT
// Draws the scene of tools/examples/web, to be held against the same on another platform:
//   picture CONFIG WIDTH HEIGHT FILE   RGBA, 8 bits each, the lowest row first
// Exits with 0, 1 (wrong), or 77 (no GL on this machine).
#include "tools/examples/web/scene.h"

#include <crevice/context.h>
#include <crevice/effect.h>
#include <crevice/gl_device.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace crevice;

namespace {

int fail(const Diagnostics& diagnostics, int code = 1)
{
    std::fputs(toText(diagnostics).c_str(), stderr);
    return code;
}

int write(const Image& image, const char* file)
{
    std::string bytes;
    for (const float value : image.pixels)
        bytes += static_cast<char>(std::lround(std::fmin(std::fmax(value, 0.0f), 1.0f) * 255.0f));
    std::FILE* const out = std::fopen(file, "wb");
    if (!out) return 1;
    const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
    return std::fclose(out) == 0 && whole ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments)
{
    if (count != 5) return 2;
    const Extent extent = {std::atoi(arguments[2]), std::atoi(arguments[3])};
    const auto context = makeEglContext();
    if (!context) return fail(context.diagnostics(), 77);
    const auto device = makeGlDevice((*context)->loader());
    if (!device) return fail(device.diagnostics());
    auto effect = Effect::create(**device, arguments[1], extent, {"color"});
    if (!effect) return fail(effect.diagnostics());
    Status status = example::addScene(**device, effect->frame());
    effect->frame().camera = example::cameraAt(0.0f, extent);
    if (status) status = effect->setParam("radius", 0.5f);
    if (status) status = effect->render();
    if (!status) return fail(status.diagnostics());
    const Result<Image> image = (*device)->readTexture(effect->output("color"));
    return image ? write(*image, arguments[4]) : fail(image.diagnostics());
}
