// SPDX-License-Identifier: MIT
// Planning without a device.
#include "tools/planning.h"

namespace crevice {

DeviceCaps usualCaps()
{
    DeviceCaps caps = minimumCaps();
    caps.name = "OpenGL ES 3.0 with float targets";
    caps.max_texture_size = 8192;  // as GPUs with float targets have at least; the standard's 2048 is below 1080p
    for (const FormatInfo& info : allFormats()) {
        caps.renderable[static_cast<int>(info.format)] = true;
        caps.sample_counts[static_cast<int>(info.format)] = 1u << 1 | 1u << 3;
    }
    return caps;
}

SceneTraits fullTraits()
{
    SceneTraits traits;
    traits.lights = 1;
    traits.alpha_tested = true;
    traits.specular = true;
    traits.textured = true;
    return traits;
}

Result<Plan> planWithoutDevice(const ConfigOptions& options, const SourceSet& sources)
{
    const Result<Description> description = loadDescription(options, sources);
    if (!description) return description.diagnostics();
    CompileOptions compile_options;
    compile_options.extent = {960, 540};
    return compile(*description, fullTraits(), usualCaps(), compile_options);
}

}  // namespace crevice
