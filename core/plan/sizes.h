// SPDX-License-Identifier: MIT
// How large a description's targets are in a view of so many pixels. Indices are into its lists.
#pragma once

#include <crevice/config.h>
#include <crevice/plan.h>

namespace crevice {

/// The sizes of all targets.
class TargetSizes {
public:
    TargetSizes(const Description& description, Extent view);

    /// Of a target; below 0 of the view.
    Extent of(int target) const { return target < 0 ? view_ : extents_[target]; }

    /// The target whose size it follows, or -1 for the view.
    int followed(int target) const { return followed_[target]; }

    /// How many views wide or high a target with a border, or one that follows such, is; else 0.
    float viewsOf(int target) const;

private:
    const Description& description_;
    Extent view_;
    std::vector<int> followed_;
    std::vector<Extent> extents_;
};

/// Layers of a volume; 0 of what is none.
int depthOf(const Description& description, int target);

/// Samples a pixel that the config asks for.
int askedSamples(const Description& description, int target);

/// Of the device's counts the least that is no less than was asked for, or else the most.
int nearestCount(std::uint32_t counts, int asked);

/// Count of a kernel or side of a noise, at the present value of its param.
int generatedCount(const Description& description, const GeneratedDesc& generated);

/// The description with borders that end where the device's textures do, if some would not.
std::optional<Description> fitBorders(const Description& description, const CompileOptions& options,
                                      const DeviceCaps& caps, std::vector<Elided>& elided);

/// Whether a texture of the format `given` reads as one of `wanted` that a pass has copied it into.
bool storedAlike(Format wanted, Format given);

/// "the device's textures end at 2048x2048".
std::string endsAt(const DeviceCaps& caps);

std::string text(const Extent& extent);

/// What a shader may mention: TEXTURE_STEP of a texture, for the steps of its format,
std::string stepDefine(const std::string& texture);
std::string stepsOf(Format format);

/// ... and of a param that is bound as a define its value, as GLSL reads it.
std::string literal(const ParamDesc& param);

/// Gives a plan all that depends on size, formats, params and views: of its targets and passes
/// what draws and what is drawn into, its textures, what params begin with, and bytes. `plan` has
/// all else; a target of it whose `history_texture` is 0 or more remembers.
void fitPlan(Plan& plan, const Description& description, const SceneTraits& traits,
             const DeviceCaps& caps, const CompileOptions& options);

/// Errors: CV1209 where its textures take more than the description's limits.
Status checkBytes(const Plan& plan, const Description& description);

}  // namespace crevice
