// SPDX-License-Identifier: MIT
// What the command has and a page has not: files, a console's clock, and the time for flicker.
#include "tools/commands/cli/output.h"
#include "tools/measure/motion/measure.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/scene.h"

#include <emscripten.h>

namespace crevice {

Result<Scene> importScene(const std::string& path, const ImportOptions&)
{
    return Diagnostic{Code::scene_missing, "a page reads no file '" + path + "'",
                      "serve it by crevice view --scene FILE"};
}

Result<Image> readImage(const std::string& path, double)
{
    return Diagnostic{Code::image_broken, "a page reads no file '" + path + "'"};
}

double clockSeconds() { return 1e-3 * emscripten_get_now(); }

Result<MotionTruth> traceMotion(const MotionView&, const std::function<bool()>&,
                                const std::function<void(double)>&)
{
    return Diagnostic{Code::usage, "a page measures no flicker"};
}

Result<MotionFigures> measureMotion(const MotionStage&, const MotionView&, const MotionTruth&,
                                    const std::function<bool()>&)
{
    return Diagnostic{Code::usage, "a page measures no flicker"};
}

}  // namespace crevice
