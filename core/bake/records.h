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

/// The members of a record, in the order in which they are written.
#define CREVICE_FIELDS(Type, ...) \
    template <class A> \
    void fields(A& a, Type& x) \
    { \
        a(__VA_ARGS__); \
    }

CREVICE_FIELDS(Reference, x.name)
CREVICE_FIELDS(ParamDesc, x.name, upTo(x.type, ParamType::vec4), x.value, x.min, x.max, x.soft_max,
               x.step, x.unit, x.label, x.group, upTo(x.bind, Bind::define),
               upTo(x.semantic, ParamSemantic::margin))
CREVICE_FIELDS(FeatureDesc::Setting, x.name, x.value)
CREVICE_FIELDS(FeatureDesc::Level, x.name, x.settings)
CREVICE_FIELDS(FeatureDesc, x.name, x.values, x.boolean, x.value, x.label, x.sets)
CREVICE_FIELDS(ImportDesc, x.name, upTo(x.type, ImportType::texture), x.optional, x.format)
CREVICE_FIELDS(GeneratorDesc, x.name, x.generator, x.count, x.shape, x.lengths, x.seed)
template <class A>
void fields(A& a, GeneratedDesc& x)
{
    fields(a, static_cast<GeneratorDesc&>(x));
    a(x.count_param);
}
CREVICE_FIELDS(ProductDesc, x.factor, x.params)
CREVICE_FIELDS(SizeDesc, x.width, x.height, x.depth, x.of, x.scale_param, x.scale, x.border)
struct FormatField {
    Format format = Format::none;
};
CREVICE_FIELDS(FormatField, upTo(x.format, Format::depth32f))
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
CREVICE_FIELDS(NoOpDesc, x.name, x.at)
CREVICE_FIELDS(InputDesc, x.name, x.from, upTo(x.filter, Filter::trilinear), x.has_filter)
CREVICE_FIELDS(PassDesc, x.name, upTo(x.type, PassType::fullscreen), x.depth, x.inputs, x.no_op,
               x.frustum_scale_param, x.frustum_scale)
CREVICE_FIELDS(OutputDesc, x.name)
CREVICE_FIELDS(Description, x.name, x.text, x.params, x.features, x.imports, x.generated, x.targets,
               x.passes, x.outputs)
CREVICE_FIELDS(BakedText, x.version, x.steps, x.values, x.body)
CREVICE_FIELDS(BakedProgram, x.label, x.vertex, x.fragment)
CREVICE_FIELDS(BakedAxis::Given, x.replaced, x.by)
CREVICE_FIELDS(BakedAxis, upTo(x.kind, BakedAxis::Kind::no_op), x.name, x.at, x.given)
CREVICE_FIELDS(BakedChoice, x.numbers, x.plan)
template <class A>
void fields(A& a, BakedEntry& x)
{
    BakedConfig& config = x.config;
    a(config.name, config.set, config.ms, config.error, config.description, x.programs, x.axes,
      x.choices, x.plans);
}
CREVICE_FIELDS(BakedFile, x.texts, x.entries)

// A plan; its programs are numbers into BakedEntry::programs.

CREVICE_FIELDS(PlanTarget, x.name, x.first_pass, x.last_pass, x.history_texture)
CREVICE_FIELDS(SamplerDesc, upTo(x.filter, Filter::trilinear), upTo(x.wrap, Wrap::repeat))
CREVICE_FIELDS(PlanInput, x.name, upTo(x.kind, InputKind::constant), x.index, x.sampling)
CREVICE_FIELDS(PlanAttachment, x.target, x.name, upTo(x.load, LoadOp::discard),
               upTo(x.store, StoreOp::discard), x.clear)
CREVICE_FIELDS(PlanParam, x.name, upTo(x.type, GlslType::int_))
CREVICE_FIELDS(PlanBox, x.name, x.factor, x.params, x.steps)
CREVICE_FIELDS(PlanUniform, x.name, upTo(x.type, GlslType::mat4), x.count,
               upTo(x.source, UniformSource::box), x.index)
CREVICE_FIELDS(StateDesc, upTo(x.depth_test, Compare::equal), x.depth_write,
               upTo(x.cull, Cull::front), upTo(x.blend, Blend::max))
CREVICE_FIELDS(PlanPass, x.name, upTo(x.type, PassType::fullscreen), x.program, x.color,
               x.has_depth, x.depth, x.box, x.layers_at_once, x.over, x.blended, x.state, x.scissor,
               x.cull_below_pixel, x.inputs, x.uniforms)
CREVICE_FIELDS(PlanOutput, x.name, x.target, x.constant)
CREVICE_FIELDS(Elided, x.what, x.optimization, x.reason)
CREVICE_FIELDS(Plan, x.passes, x.targets, x.constants, x.boxes, x.params, x.generated, x.imports,
               x.outputs, x.elided)

#undef CREVICE_FIELDS

/// The number of an axis, of a description as it is now in such a scene on a device.
float numberOf(const BakedAxis& axis, const Description& description, const SceneTraits& traits,
               const DeviceCaps& caps, int height);

}  // namespace crevice
