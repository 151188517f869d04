// SPDX-License-Identifier: MIT
#include "core/run/draw_warnings.h"

namespace crevice {
namespace {

Diagnostic warning(Code code, std::string message, const char* help)
{
    Diagnostic made{code, std::move(message), help};
    made.severity = Severity::warning;
    return made;
}

/// The first uniform block of a program, or null.
const GlslUniform* blockOf(const PlanProgram& program)
{
    for (const GlslStage* stage : {&program.vertex, &program.fragment})
        if (!stage->blocks.empty()) return &stage->blocks.front();
    return nullptr;
}

}  // namespace

void DrawWarnings::add(const Plan& plan, const PlanPass& pass,
                       const std::vector<UniformInfo>& active)
{
    if (pass.type != PassType::draw) return;
    const auto note = [&](Reader& reader) {
        if (!reader.plan) reader = {&plan, &pass};
    };
    for (const UniformInfo& uniform : active) {
        if (uniform.name == kFrameValues[view_normal_from_model].name) note(normals_);
        if (const int map = indexOf(kMaterialMaps, uniform.name); map >= 0) note(maps_[map]);
    }
    if (blockOf(plan.programs[pass.program])) note(blocks_);
}

void DrawWarnings::look(const DrawItem& item, const ObjectInfo& mesh, const Material& material)
{
    if (item.callback) return;
    if (normals_.plan && !mesh.normals)
        warn(normals_, mesh, "normals, and each counts as (0, 0, 1)",
             "set HostMesh::normal, or take a config that draws depth alone, such as mobile");
    for (std::size_t i = 0; i < std::size(kMaterialMaps) && !mesh.uv; ++i)
        if (maps_[i].plan && material.*kMaterialMaps[i].texture)
            warn(maps_[i], mesh, "uv, and its material's texture is read at (0, 0)",
                 "set HostMesh::uv, or give its material no texture");
    if (blocks_.plan) warnOfBlock(mesh);
}

void DrawWarnings::warn(Reader& reader, const ObjectInfo& mesh, const char* lacks, const char* help)
{
    const auto [plan, pass] = std::exchange(reader, {});
    const PlanProgram& program = plan->programs[pass->program];
    Diagnostic made =
        warning(Code::mesh_lacks,
                "pass '" + pass->name + "' of '" + plan->config + "' reads of mesh '" +
                    std::string(mesh.label) + "' what it has none of: " + lacks,
                help);
    made.place = program.place;
    made.pointer = program.pointer;
    found_.push_back(std::move(made));
}

void DrawWarnings::warnOfBlock(const ObjectInfo& mesh)
{
    const auto [plan, pass] = std::exchange(blocks_, {});
    const PlanProgram& program = plan->programs[pass->program];
    const GlslUniform& block = *blockOf(program);
    Diagnostic made = warning(Code::unfilled_block,
                              "pass '" + pass->name + "' draws mesh '" + std::string(mesh.label) +
                                  "' with the uniform block '" + block.name +
                                  "', which only a host's own draw fills",
                              "draw it by DrawItem::callback, and bind the block's buffer there");
    made.place = block.place;
    made.pointer = program.pointer;
    made.notes.push_back({program.place, "in shader '" + program.label + "'"});
    found_.push_back(std::move(made));
}

}  // namespace crevice
