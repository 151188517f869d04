// SPDX-License-Identifier: MIT
#include <crevice/plan.h>

namespace crevice {

bool isMasked(const PlanPass& pass) { return pass.has_depth && pass.depth.load == LoadOp::load; }

double textureBytes(const PlanTexture& texture)
{
    return double(texture.extent.width) * texture.extent.height * texture.samples *
           formatInfo(texture.format).bytes * texture.copies;
}

}  // namespace crevice
