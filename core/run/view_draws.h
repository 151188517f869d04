// SPDX-License-Identifier: MIT
// What a frame draws, and where each draw lies in a view: computed once a view, for all passes.
//
// Private to core/run. Memory grows with the count of draws and is kept from frame to frame.
#pragma once

#include "core/run/uniform_values.h"

namespace crevice {

/// Indices in a row.
struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// What draw passes draw; nothing in the place of what cannot be drawn.
struct DrawnList {
    std::vector<DrawItem> draws;
    std::vector<MeshOrigin> origins;  ///< Of the draws' meshes.
    std::vector<Material> materials;
    std::uint64_t revision = 0, draws_revision = 0;  ///< Of the frame.
    bool elided = false;                             ///< Something of the frame.
    bool steady = false;  ///< Taken, all of it, and no callback draws something else each time.
    std::vector<IndexRange> sheets = {};  ///< Of the draws, what they draw once more.
};

/// A draw in a view.
struct PlacedDraw {
    glm::dmat4 view_from_model;
    ViewSphere sphere;
    bool blended;   ///< Its material is: passes that are not leave it out.
    bool mirrored;  ///< Front faces come out as back faces: the item, view or projection mirrors.
    bool valued;    ///< Its values are computed.
};

class ViewDraws {
public:
    /// The list must outlive it.
    explicit ViewDraws(const DrawnList& drawn) : drawn_(drawn) {}

    /// From now on normals are turned for all draws, not for those alone that the host makes.
    void readNormals() { normals_ = true; }

    /// Goes to another view, or to another state of the list. The camera must outlive its use.
    void begin(const CameraMatrices& camera);

    /// By draw. Of an item that draws nothing there is nothing in its place.
    const std::vector<PlacedDraw>& placed();

    /// What a pass draws, by index: what is blended from far to near, or all else as it stands.
    const std::vector<std::size_t>& drawnBy(const PlanPass& pass);

    /// The values of a draw, as ValueTable::keepDraw has them, until `begin`: computed, in that
    /// table, for the first pass that asks. Requires `placed`.
    const std::uint32_t* values(std::size_t draw, ValueTable& table);

    /// The part in which draws can show: those at which a `length` in scene units comes to a pixel
    /// of a view of `extent`, or all where it is infinite. The whole view where bounds are unknown.
    ViewArea area(const Extent& extent, double length);

private:
    const ViewArea& areaOfDraw(std::size_t draw);

    const DrawnList& drawn_;
    const CameraMatrices* camera_ = nullptr;
    bool normals_ = false;
    bool is_placed_ = false;
    ViewVolume volume_ = {};
    std::vector<PlacedDraw> placed_;
    std::vector<std::size_t> order_;
    std::vector<std::pair<double, ViewArea>> reached_;  // what `area` has answered, by reach
    std::vector<ViewArea> areas_;        // of the first draws, as far as anyone asked
    std::vector<std::uint32_t> values_;  // of all draws, one after the other
};

/// What passes read of a draw and nobody gives them, and of a history that is another camera's:
/// told once for a plan, in the frame that first draws so.
class DrawWarnings {
public:
    /// The plan must outlive it.
    explicit DrawWarnings(const Plan& plan) : plan_(plan) {}

    /// Takes note of what a pass of the plan reads: `active` is what its program really has.
    void add(const PlanPass& pass, const std::vector<UniformInfo>& active);

    /// Looks at what is drawn, with its mesh. Allocates only where there is something to say.
    void look(const DrawItem& item, const ObjectInfo& mesh, const Material& material);

    /// Looks whether two cameras take turns with one history: `turns` counts the frames in which a
    /// view's camera is nearer to that of two frames ago than to the last one.
    void look(const FrameHistory& two_ago, const FrameHistory& last, const CameraMatrices& now,
              int& turns);

    /// What is new since the last call.
    Diagnostics take() { return std::exchange(found_, {}); }

private:
    using Reader = const PlanPass*;

    void warnOfLack(Reader& reader, const ObjectInfo& mesh, const char* lacks, const char* help);
    Diagnostic& warn(Reader& reader, Code code, std::string message, const char* help);

    const Plan& plan_;
    bool remembers_ =  // whether it has a history, and that is not told
        anyOf(plan_.targets, [](const auto& target) { return target.history_texture >= 0; });
    // The first pass that reads each; null where none does, or that was told.
    Reader normals_ = nullptr, maps_[std::size(kMaterialMaps)] = {}, blocks_ = nullptr;
    Diagnostics found_;
};

}  // namespace crevice
