// SPDX-License-Identifier: MIT
#include <crevice/plan.h>

namespace crevice {

const Optimization kOptimizations[7] = {
    {"dead_pass", "passes, attachments and shader outputs that no requested output needs"},
    {"no_op",
     "passes whose outputs are known without running them: by the value of a param, or a constant "
     "input"},
    {"aliasing", "separate textures for targets that are not alive at the same time"},
    {"depth_mask", "pixels of a pass that its mask excludes, by a depth test"},
    {"frustum_culling", "per frame, draws whose bounds are outside the view"},
    {"scissor", "per frame, pixels of a pass outside the bounds of all draws"},
    {"cached", "per frame, passes whose inputs have not changed"},
};

bool isMasked(const PlanPass& pass) { return pass.has_depth && pass.depth.load == LoadOp::load; }

double textureBytes(const PlanTexture& texture)
{
    return double(texture.extent.width) * texture.extent.height * texture.samples *
           formatInfo(texture.format).bytes * texture.copies;
}

}  // namespace crevice
