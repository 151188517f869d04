// SPDX-License-Identifier: MIT
// What to do about a texture that no command supplies.
#include "tools/render/missing_texture.h"

#include "core/base/text.h"
#include "tools/show/plan/planning.h"

namespace crevice {
namespace {

/// The feature that is on and without which nothing reads the import; empty where there is none.
std::string featureBehind(const Description& description, const std::string& import)
{
    for (std::size_t i = 0; i < description.features.size(); ++i) {
        const FeatureDesc& feature = description.features[i];
        if (!feature.boolean || feature.value == 0) continue;
        Description off = description;
        off.features[i].value = 0;
        const Result<Plan> plan = compile(off, usualTraits(), usualCaps(), {{16, 9}});
        if (plan && !findNamed(plan->imports, import)) return feature.name;
    }
    return "";
}

/// "geometry/host_depth" of ".../effects/geometry/host_depth.json"; empty for other files.
std::string geometryModule(const Place& place)
{
    const std::string file = place.source ? place.source->name : "";
    const std::size_t begin = file.rfind("geometry/"), end = file.rfind(".json");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return "";
    return file.substr(begin, end - begin);
}

std::string helpFor(const Diagnostic& error, const Description& description)
{
    const std::string import = error.pointer.substr(error.pointer.rfind('/') + 1);
    if (const std::string feature = featureBehind(description, import); !feature.empty())
        return "--set " + feature + "=false draws without it";
    // The module that the config extends is the one that provides the surface.
    const InterfaceDesc* surface = findNamed(description.interfaces, "surface");
    const std::string module = surface ? geometryModule(surface->file.place) : "";
    if (!module.empty() && !geometryModule(error.place).empty())
        return "--set " + module + "=geometry/depth_normal draws the scene's own";
    return "draw it in a program, with Effect::setTexture";
}

}  // namespace

Diagnostics withoutHost(Diagnostics errors, const Description& description)
{
    for (Diagnostic& error : errors)
        if (error.code == Code::missing_import)
            error.help = "no command supplies textures: " + helpFor(error, description);
    return errors;
}

}  // namespace crevice
