// SPDX-License-Identifier: MIT
#include "core/plan/plan.h"

#include <algorithm>

namespace crevice {

bool isMasked(const PlanPass& pass) { return pass.has_depth && pass.depth.load == LoadOp::load; }

double textureBytes(const PlanTexture& texture)
{
    double texels = 0;
    for (int level = 0; level < texture.mips; ++level)
        texels += static_cast<double>(std::max(1, texture.extent.width >> level)) *
                  std::max(1, texture.extent.height >> level);
    return texels * texture.samples * formatInfo(texture.format).bytes * texture.copies;
}

}  // namespace crevice
