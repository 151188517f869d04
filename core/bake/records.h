// SPDX-License-Identifier: MIT
// What a baked effect's file holds, and `fields`, the list of members of each record of it. What
// fitPlan finds again (sizes, formats, textures) is not in it, nor are places and GLSL files.
//
//   8 bytes  kMagic              4 bytes  size of the records as they are
//   8 bytes  vocabulary()        8 bytes  hash over the rest
//   the records of BakedFile, packed (core/bake/pack.h)
#pragma once

#include <crevice/baked.h>

#include "core/bake/archive.h"
#include "core/base/content_hash.h"
#include "core/frame/frame_math.h"

namespace crevice {

constexpr char kMagic[8] = {'c', 'r', 'e', 'v', 'b', 'k', '0', '1'};
constexpr std::size_t kHeaderBytes = 28;
constexpr std::uint32_t kMostBakedBytes = 1u << 24;  ///< Of the records, unpacked.

/// A hash over all words that the records have numbers for: files of a library with others are of
/// another version.
inline std::uint64_t vocabulary()
{
    ContentHash hash;
    for (const FrameValueInfo& each : kFrameValues) hash.addText(each.name);
    for (const TraitInfo& each : kTraits) hash.addText(each.name);
    for (const MaterialMapInfo& each : kMaterialMaps) hash.addText(each.name);
    for (const FormatInfo& each : allFormats()) hash.addText(each.name);
    return hash.value();
}

/// A text that runs, once its #defines are before it: "300 es", and what follows.
struct BakedText {
    std::string version;
    std::vector<std::string> steps;   ///< Textures whose TEXTURE_STEP it has,
    std::vector<std::string> values;  ///< ... and params that are a #define in it.
    std::string body;
};

/// Texts of BakedFile.
struct BakedProgram {
    std::string label;
    int vertex = 0, fragment = 0;
};

/// What decides which of a config's plans is taken: a number, of the description or the scene.
struct BakedAxis {
    enum class Kind { feature, param, trait, no_op };
    /// Targets of which a no-op gives the second for the first: it holds where both store alike.
    struct Given {
        std::string replaced, by;
    };

    Kind kind = Kind::feature;
    std::string name;
    float at = 0;                   ///< Of a no-op: the param's value; the number is then 0 or 1.
    std::vector<Given> given = {};  ///< Likewise.
};

/// A plan for these numbers, in the order of the axes.
struct BakedChoice {
    std::vector<float> numbers;
    int plan = 0;
};

struct BakedEntry {
    BakedConfig config;
    std::vector<BakedProgram> programs;
    std::vector<BakedAxis> axes;
    std::vector<BakedChoice> choices;
    std::vector<std::string> plans;  ///< The records of each, read when it is wanted.
};

struct BakedFile {
    std::vector<BakedText> texts;
    std::vector<BakedEntry> entries;
};

template <class A>
void fields(A& a, Reference& x)
{
    a(x.name);
}
template <class A>
void fields(A& a, ParamDesc& x)
{
    a(x.name, upTo(x.type, ParamType::vec4), x.value, x.min, x.max, x.soft_max, x.step, x.unit,
      x.label, x.group, upTo(x.bind, Bind::define), upTo(x.semantic, ParamSemantic::margin));
}
template <class A>
void fields(A& a, FeatureDesc::Setting& x)
{
    a(x.name, x.value);
}
template <class A>
void fields(A& a, FeatureDesc::Level& x)
{
    a(x.name, x.settings);
}
template <class A>
void fields(A& a, FeatureDesc& x)
{
    a(x.name, x.values, x.boolean, x.value, x.label, x.sets);
}
template <class A>
void fields(A& a, ImportDesc& x)
{
    a(x.name, upTo(x.type, ImportType::texture), x.optional, x.format);
}
template <class A>
void fields(A& a, GeneratorDesc& x)
{
    a(x.name, x.generator, x.count, x.shape, x.lengths, x.seed);
}
template <class A>
void fields(A& a, GeneratedDesc& x)
{
    fields(a, static_cast<GeneratorDesc&>(x));
    a(x.count_param);
}
template <class A>
void fields(A& a, ProductDesc& x)
{
    a(x.factor, x.params);
}
template <class A>
void fields(A& a, SizeDesc& x)
{
    a(x.width, x.height, x.depth, x.of, x.scale_param, x.scale, x.border);
}
struct FormatField {
    Format format = Format::none;
};
template <class A>
void fields(A& a, FormatField& x)
{
    a(upTo(x.format, Format::depth32f));
}
template <class A>
void fields(A& a, TargetDesc& x)
{
    std::vector<FormatField> formats;
    for (const Format each : x.formats) formats.push_back({each});
    a(x.name, formats, upTo(x.semantic, Semantic::mask), x.size, x.history, x.mips, x.samples_param,
      x.samples);
    x.formats.clear();
    for (const FormatField& each : formats) x.formats.push_back(each.format);
}
template <class A>
void fields(A& a, NoOpDesc& x)
{
    a(x.name, x.at);
}
template <class A>
void fields(A& a, InputDesc& x)
{
    a(x.name, x.from, upTo(x.filter, Filter::trilinear), x.has_filter);
}
template <class A>
void fields(A& a, PassDesc& x)
{
    a(x.name, upTo(x.type, PassType::fullscreen), x.depth, x.inputs, x.no_op, x.frustum_scale_param,
      x.frustum_scale);
}
template <class A>
void fields(A& a, OutputDesc& x)
{
    a(x.name);
}
template <class A>
void fields(A& a, Description& x)
{
    a(x.name, x.text, x.params, x.features, x.imports, x.generated, x.targets, x.passes, x.outputs);
}
template <class A>
void fields(A& a, BakedText& x)
{
    a(x.version, x.steps, x.values, x.body);
}
template <class A>
void fields(A& a, BakedProgram& x)
{
    a(x.label, x.vertex, x.fragment);
}
template <class A>
void fields(A& a, BakedAxis::Given& x)
{
    a(x.replaced, x.by);
}
template <class A>
void fields(A& a, BakedAxis& x)
{
    a(upTo(x.kind, BakedAxis::Kind::no_op), x.name, x.at, x.given);
}
template <class A>
void fields(A& a, BakedChoice& x)
{
    a(x.numbers, x.plan);
}
template <class A>
void fields(A& a, BakedEntry& x)
{
    BakedConfig& config = x.config;
    a(config.name, config.set, config.ms, config.error, config.description, x.programs, x.axes,
      x.choices, x.plans);
}
template <class A>
void fields(A& a, BakedFile& x)
{
    a(x.texts, x.entries);
}

// A plan; its programs are numbers into BakedEntry::programs.

template <class A>
void fields(A& a, PlanTarget& x)
{
    a(x.name, x.first_pass, x.last_pass, x.history_texture);
}
template <class A>
void fields(A& a, SamplerDesc& x)
{
    a(upTo(x.filter, Filter::trilinear), upTo(x.wrap, Wrap::repeat));
}
template <class A>
void fields(A& a, PlanInput& x)
{
    a(x.name, upTo(x.kind, InputKind::constant), x.index, x.sampling);
}
template <class A>
void fields(A& a, PlanAttachment& x)
{
    a(x.target, x.name, upTo(x.load, LoadOp::discard), upTo(x.store, StoreOp::discard), x.clear);
}
template <class A>
void fields(A& a, PlanParam& x)
{
    a(x.name, upTo(x.type, GlslType::int_));
}
template <class A>
void fields(A& a, PlanBox& x)
{
    a(x.name, x.factor, x.params, x.steps);
}
template <class A>
void fields(A& a, PlanUniform& x)
{
    a(x.name, upTo(x.type, GlslType::mat4), x.count, upTo(x.source, UniformSource::box), x.index);
}
template <class A>
void fields(A& a, StateDesc& x)
{
    a(upTo(x.depth_test, Compare::equal), x.depth_write, upTo(x.cull, Cull::front),
      upTo(x.blend, Blend::max));
}
template <class A>
void fields(A& a, PlanPass& x)
{
    a(x.name, upTo(x.type, PassType::fullscreen), x.program, x.color, x.has_depth, x.depth, x.box,
      x.layers_at_once, x.over, x.blended, x.state, x.scissor, x.cull_below_pixel, x.inputs,
      x.uniforms);
}
template <class A>
void fields(A& a, PlanOutput& x)
{
    a(x.name, x.target, x.constant);
}
template <class A>
void fields(A& a, Elided& x)
{
    a(x.what, x.optimization, x.reason);
}
template <class A>
void fields(A& a, Plan& x)
{
    a(x.passes, x.targets, x.constants, x.boxes, x.params, x.generated, x.imports, x.outputs,
      x.elided);
}

/// The number of an axis, of a description as it is now in such a scene on a device.
float numberOf(const BakedAxis& axis, const Description& description, const SceneTraits& traits,
               const DeviceCaps& caps, int height);

}  // namespace crevice
