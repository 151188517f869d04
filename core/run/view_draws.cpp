// SPDX-License-Identifier: MIT
#include "core/run/view_draws.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace crevice {
namespace {

// Frames in a row that no moving camera makes by chance, and how much nearer that of two ago is.
constexpr int kTurns = 4;
constexpr double kNearer = 4;

/// How far two cameras are apart, in a number that grows with it. Jitter of a projection is no way.
double wayBetween(const CameraMatrices& a, const CameraMatrices& b)
{
    double way = 0;
    for (int i = 0; i < 4; ++i) way += glm::distance(a.view_from_world[i], b.view_from_world[i]);
    for (int i = 0; i < 2; ++i) way += std::abs(a.clip_from_view[i][i] - b.clip_from_view[i][i]);
    return way;
}

/// The first uniform block of a program, or null.
const GlslUniform* blockOf(const PlanProgram& program)
{
    for (const GlslStage* stage : {&program.vertex, &program.fragment})
        if (!stage->blocks.empty()) return &stage->blocks.front();
    return nullptr;
}

}  // namespace

void ViewDraws::begin(const CameraMatrices& camera)
{
    camera_ = &camera;
    is_placed_ = false;
    reached_.clear();
}

const std::vector<PlacedDraw>& ViewDraws::placed()
{
    if (std::exchange(is_placed_, true)) return placed_;
    const std::size_t count = drawn_.draws.size();
    placed_.resize(count);
    areas_.clear();
    areas_.reserve(count);
    volume_ = viewVolume(*camera_, 1.0);
    const bool view_mirrors = mirrors(camera_->view_from_world);
    for (std::size_t i = 0; i < count; ++i) {
        const DrawItem& item = drawn_.draws[i];
        if (!drawsSomething(item)) continue;
        PlacedDraw& placed = placed_[i];
        placed.view_from_model = camera_->view_from_world * item.world_from_model;
        placed.sphere = boundsInView(item, placed.view_from_model);
        placed.blended = drawn_.materials[item.material].blended;
        placed.mirrored = mirrors(item.world_from_model) != view_mirrors;
        placed.valued = false;
    }
    return placed_;
}

const std::vector<std::size_t>& ViewDraws::drawnBy(const PlanPass& pass)
{
    const std::vector<PlacedDraw>& all = placed();
    order_.clear();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (drawsSomething(drawn_.draws[i]) && all[i].blended == pass.blended) order_.push_back(i);
    const auto farther = [&all](std::size_t a, std::size_t b) {
        const double far = all[a].sphere.center.z, other = all[b].sphere.center.z;
        return far != other ? far < other : a < b;
    };
    if (pass.blended) std::sort(order_.begin(), order_.end(), farther);
    return order_;
}

const std::uint32_t* ViewDraws::values(std::size_t draw, ValueTable& table)
{
    const std::size_t words = table.drawWords();
    values_.resize(drawn_.draws.size() * words);
    std::uint32_t* const own = &values_[draw * words];
    if (placed_[draw].valued) return own;
    const DrawItem& item = drawn_.draws[draw];
    const MeshOrigin& origin = drawn_.origins[draw];
    table.setDraw(
        glm::translate(placed_[draw].view_from_model, glm::dvec3(origin.x, origin.y, origin.z)),
        drawn_.materials[item.material], *camera_, normals_ || item.callback);
    table.keepDraw(own);
    placed_[draw].valued = true;
    return own;
}

ViewArea ViewDraws::area(const Extent& extent, double length)
{
    const double reach = pixelReach(camera_->clip_from_view, extent, length);
    for (const auto& [known, area] : reached_)
        if (known == reach) return area;
    ViewArea area = kNoArea;
    const std::vector<PlacedDraw>& all = placed();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ViewArea& own = areaOfDraw(i);
        if (!isBelowPixel(all[i].sphere, camera_->clip_from_view, reach)) area = united(area, own);
        if (area.left > 0 || area.bottom > 0 || area.right < 1 || area.top < 1) continue;
        area = {};
        break;
    }
    return reached_.emplace_back(reach, area).second;
}

/// Requires that those before it were asked for.
const ViewArea& ViewDraws::areaOfDraw(std::size_t draw)
{
    if (draw < areas_.size()) return areas_[draw];
    const ViewSphere& sphere = placed_[draw].sphere;
    if (!drawsSomething(drawn_.draws[draw]) || placed_[draw].blended || isOutside(sphere, volume_))
        return areas_.emplace_back(kNoArea);
    return areas_.emplace_back(sphere.radius < 0.0 ? ViewArea()
                                                   : areaOf(sphere, camera_->clip_from_view));
}

void DrawWarnings::look(const FrameHistory& two_ago, const FrameHistory& last,
                        const CameraMatrices& now, int& turns)
{
    if (!remembers_) return;
    const bool turned = two_ago.valid && last.valid &&
                        wayBetween(two_ago.camera, now) * kNearer < wayBetween(last.camera, now);
    turns = turned ? turns + 1 : 0;
    if (turns < kTurns) return;
    remembers_ = false;
    found_.push_back(
        asWarning({Code::bad_input,
                   "two cameras take turns with the history of '" + plan_.config +
                       "', so that each sees some of the other's occlusion",
                   "make an effect for each camera, or draw them as views of one frame, by "
                   "Frame::other_views"}));
}

void DrawWarnings::add(const PlanPass& pass, const std::vector<UniformInfo>& active)
{
    if (pass.type != PassType::draw) return;
    const auto note = [&pass](Reader& reader) { reader = reader ? reader : &pass; };
    for (const UniformInfo& uniform : active) {
        if (uniform.name == kFrameValues[view_normal_from_model].name) note(normals_);
        if (const int map = indexOf(kMaterialMaps, uniform.name); map >= 0) note(maps_[map]);
    }
    if (blockOf(plan_.programs[pass.program])) note(blocks_);
}

void DrawWarnings::look(const DrawItem& item, const ObjectInfo& mesh, const Material& material)
{
    if (item.callback) return;
    if (normals_ && !mesh.normals)
        warnOfLack(normals_, mesh, "normals, and each counts as (0, 0, 1)",
                   "set HostMesh::normal, or take a config that draws depth alone, such as mobile");
    for (std::size_t i = 0; i < std::size(kMaterialMaps) && !mesh.uv; ++i)
        if (maps_[i] && material.*kMaterialMaps[i].texture)
            warnOfLack(maps_[i], mesh, "uv, and its material's texture is read at (0, 0)",
                       "set HostMesh::uv, or give its material no texture");
    if (!blocks_) return;
    const PlanProgram& program = plan_.programs[blocks_->program];
    const GlslUniform& block = *blockOf(program);
    Diagnostic& made = warn(blocks_, Code::unfilled_block,
                            "pass '" + blocks_->name + "' draws mesh '" + std::string(mesh.label) +
                                "' with the uniform block '" + block.name +
                                "', which only a host's own draw fills",
                            "draw it by DrawItem::callback, and bind the block's buffer there");
    blame(made, block.place, "in shader '" + program.label + "'");
}

void DrawWarnings::warnOfLack(Reader& reader, const ObjectInfo& mesh, const char* lacks,
                              const char* help)
{
    warn(reader, Code::mesh_lacks,
         "pass '" + reader->name + "' of '" + plan_.config + "' reads of mesh '" +
             std::string(mesh.label) + "' what it has none of: " + lacks,
         help);
}

/// Of what `reader` reads, which is not told again.
Diagnostic& DrawWarnings::warn(Reader& reader, Code code, std::string message, const char* help)
{
    const PlanProgram& program = plan_.programs[std::exchange(reader, nullptr)->program];
    return found_.emplace_back(
        asWarning({code, std::move(message), help, program.place, program.pointer}));
}

}  // namespace crevice
