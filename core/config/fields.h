// SPDX-License-Identifier: MIT
// The config format as a table: every key of every struct of a Description, once.
//
// `fields(visitor, target)` calls a visitor for each key in turn: its JSON spelling, the member
// that it fills (whose type is the JSON type and whose initial value is the default), one sentence
// for people, and what the value must satisfy. Decoding is one visitor
// (core/config/decode_reader.h); whatever lists or documents the format is another. A visitor has
//
//   bool field(key, member, doc, rule)      a key; false when it is there but unusable
//   bool shorthand(key, member, doc, rule)  as field, and its value may stand for the whole object
//   bool itself(member, doc, rule)          there are no keys: the value is this
//   bool has(key)                           whether the key is there
//   void refuse(key, code, reason)          an error if the key is there
//   void ordered(min_key, min, max_key, max)  an error unless min <= max
#pragma once

#include "core/config/field_types.h"
#include "core/config/values.h"
#include "core/sampling/generators.h"

#include <algorithm>

namespace crevice::table {

template <class V>
void fields(V& v, ParamDesc& p)
{
    const Rule bounds = range(-kMaxParam, kMaxParam);
    const bool known = v.field("type", p.type, "What GLSL declares.");
    v.field("unit", p.unit, "\"scene units\", \"pixels\", ...; \"1\" for a plain number.");
    v.field("min", p.min, "The least that each component may be.", bounds);
    v.field("max", p.max, "The most that each component may be.", bounds);
    v.ordered("min", p.min, "max", p.max);
    v.field("bind", p.bind,
            "`define` for a #define in upper case: another value then compiles the shaders again.");
    v.field(
        "semantic", p.semantic,
        "`length` for a distance in scene units, or \"5%\" or \"40px\" (docs/tuning.md), within "
        "which an estimator takes samples: formats of depth and positions are chosen to resolve a "
        "tenth of it. `margin` for the share of the length by which something must lie in front of "
        "an offset to occlude: no smaller steps are warned of.");
    v.field("default",
            Numbers{p.value, known ? componentCount(p.type) : 0, p.type == ParamType::int_},
            "The initial value: a number such as 0.5, or a list for a vector, such as [1, 0, 0].",
            required(range(p.min, p.max, p.unit, isLength(p))));
    v.field("soft_max", p.soft_max, "The upper end of a slider; 0 for `max`.",
            range(std::min(p.min, 0.0), p.max, p.unit));
    v.field("step", p.step, "The step of a slider; 0 for none.", range(0, kMaxParam));
    v.field("label", p.label, "The name in a user interface; the key when absent.");
    v.field("tooltip", p.tooltip, "One sentence: what it does, and what a higher value costs.");
    v.field("group", p.group, "The heading in a user interface under which it stands.");
    if (componentCount(p.type) > 1) v.refuse("semantic", Code::bad_enum, "a vector is no length");
    if (componentCount(p.type) > 1 && p.bind == Bind::define)
        v.refuse("bind", Code::bad_enum, "a vector cannot be a define");
}

template <class V>
void fields(V& v, FeatureDesc::Setting&)
{
    v.itself(Later(), "The value that it then has.");
}

// Entries that are written as one value.
#define CREVICE_VALUE(Desc, value, doc) \
    template <class V> \
    void fields(V& v, Desc& entry) \
    { \
        v.itself(value, doc); \
    }
CREVICE_VALUE(FeatureDesc::Level, entry.settings, "Params and other features by name.")
CREVICE_VALUE(InterfaceDesc, entry.file, "The GLSL file that #include <name> stands for.")
CREVICE_VALUE(ClearDesc, (Numbers{entry.value, 4, false, true}),
              "One number for all channels or for depth, or a list of four numbers.")
CREVICE_VALUE(Condition, Scalars{entry.values},
              "The value that it must have, or a list of allowed values.")
CREVICE_VALUE(BypassDesc, entry.input, "The input that replaces this output when the pass is off.")
CREVICE_VALUE(PreservesConstantDesc, entry.sampler,
              "The sampler that this output is filtered from.")
#undef CREVICE_VALUE

template <class V>
void fields(V& v, FeatureDesc& f)
{
    std::string type = "bool";
    const bool known = v.field("type", OneOf{type, {"bool", "enum"}},
                               "`bool` for a switch, `enum` for one of several words.");
    f.boolean = known && type == "bool";
    const bool torn = f.boolean && v.has("values");  // its default then goes with one of the two
    v.field("values", Words{f.values}, "The words of an enum, at least two.",
            known && !f.boolean ? required() : Rule{});
    if (f.boolean) {
        v.refuse("values", Code::unknown_key,
                 "a feature without \"type\": \"enum\" is a bool and has no list of values");
        f.values = {"false", "true"};
    }
    const std::vector<std::string> anything;
    v.field("default", Choice{f.value, torn ? anything : f.values, f.boolean && !torn},
            "The initial value: true, false, or a word of an enum. When absent: false, or the "
            "first word.");
    v.field("sets", f.sets,
            "By word, values that it gives params and other features: a level of quality. What one "
            "word sets has its default at the others.");
    v.field("label", f.label, "The name in a user interface; the key when absent.");
    v.field("tooltip", f.tooltip, "One sentence: what it does, and what it costs.");
}

template <class V>
void fields(V& v, ImportDesc& i)
{
    v.field("type", i.type, "What the host supplies; a texture is a sampler of this name.",
            required());
    v.field(
        "optional", i.optional,
        "Whether the host may leave it out. Textures then read 0; there are no lights, no draws.");
    v.field("format", OneOf{i.format, formatNames()},
            "The format of the host's texture. Shaders allow for its resolution.");
}

template <class V>
void fields(V& v, GeneratedDesc& g)
{
    v.field("generator", OneOf{g.generator, kGeneratorNames}, "What makes the numbers.",
            required());
    v.field("count", NumberOrName<int>{g.count, g.count_param},
            "How many offsets a kernel has, or pixels a side of the noise; or the name of an int "
            "param.",
            range(1, mostCount(g.generator)));
    v.field(
        "shape", OneOf{g.shape, kShapeNames},
        "Where the offsets of a kernel lie: uniformly in a ball or a cube, or on rays, at random "
        "lengths.");
    v.field("lengths", OneOf{g.lengths, kLengthsNames},
            "What offset i of n is multiplied by: 1, or from 0.1 to 1 by i / n or its square.");
    v.field("seed", g.seed, "The same seed gives the same numbers on every platform.");
}

template <class V>
void fields(V& v, BoxDesc& b)
{
    v.field("edge", b.edge,
            "The length of an edge in scene units: a number, a param, or a list of them that are "
            "multiplied.",
            required(range(1e-12, kMaxParam)));
    v.field("steps", b.steps,
            "Steps that an edge has. The box follows the camera by whole ones, so that voxels stay "
            "where they are.",
            range(1, 64));
}

template <class V>
void fields(V& v, SizeDesc& s)
{
    v.field(
        "of", s.of,
        "The target whose size this follows; the output's when absent, and where a texture of the "
        "host has that name.");
    v.field("border", s.border,
            "Whether what `scale` adds is a border, of as many whole pixels on either side: a "
            "`scale` of at least 1 then gives followed + 2 * ceil(followed * (scale - 1) / 2).");
    v.field("scale", NumberOrName<float>{s.scale, s.scale_param},
            "Factor in each direction, 0.5 for half resolution; or the name of a float param.",
            range(smallestScale(s), kLargestScale));
    v.field("optional", s.optional,
            "Whether the param that `scale` names may be lacking: the scale then is 1.");
    v.field("width", s.width,
            "Texels across, whatever the size of the output: a number, an int param, or a list of "
            "them that are multiplied.",
            range(1, 16384));
    v.field("height", s.height, "Texels from bottom to top, likewise.", range(1, 16384));
    v.field(
        "depth", s.depth,
        "Layers, likewise. The target then is a volume: shaders read it as a sampler3D, and its "
        "pass is drawn once a layer, whose index is the uniform int first_layer; or once for so "
        "many layers as `color` names it times.",
        range(1, 16384));
    if (!v.has("width")) {
        v.refuse("depth", Code::missing_key, "there is no 'width'");
        s.depth = {};
    }
    if (!v.has("height")) v.refuse("width", Code::missing_key, "there is no 'height'");
    if (!v.has("width")) v.refuse("height", Code::missing_key, "there is no 'width'");
    if (!v.has("scale"))
        v.refuse("border", Code::bad_enum, "there is no 'scale' that adds a border");
}

template <class V>
void fields(V& v, TargetDesc& t)
{
    v.field("format", t.formats,
            "Preference list: the first that the device renders to and that resolves depth finely "
            "enough.",
            required());
    v.field(
        "semantic", t.semantic,
        "What the target holds, so that its format is chosen to resolve lengths. When absent, a "
        "depth format holds window depth.");
    v.field("size", t.size, "The size: max(1, ceil(followed * scale)) in each direction.");
    v.field("history", t.history, "Passes may read what it held last frame, as NAME_history.");
    v.field(
        "mips", t.mips,
        "Smaller levels, each texel the mean of those below it, made as its pass ends; read them "
        "by textureLod.");
    v.field("samples", NumberOrName<int>{t.samples, t.samples_param},
            "Samples per pixel (MSAA), or the name of an int param; readers get their mean.",
            range(1, kMaxSamples));
    const bool multisampled = t.samples > 1 || !t.samples_param.empty();
    if (multisampled && t.history)
        v.refuse("history", Code::bad_enum,
                 "a mean over samples of several surfaces matches none of the next frame");
    if (multisampled && t.mips)
        v.refuse("mips", Code::bad_enum, "what has several samples is resolved into one level");
    if (isVolume(t) && multisampled)
        v.refuse("samples", Code::bad_enum, "a volume has one sample a texel");
    if (isVolume(t) && t.history)
        v.refuse("history", Code::bad_enum, "a volume is drawn when what it shows has changed");
}

template <class V>
void fields(V& v, ShaderDesc& s)
{
    v.field("vertex", s.vertex, "GLSL file of the vertex stage.", required());
    v.field("fragment", s.fragment, "GLSL file of the fragment stage.", required());
    v.field("defines", s.defines, "Macros for these stages alone: numbers, booleans or text.");
}

template <class V>
void fields(V& v, NoOpDesc::Gives& g)
{
    v.itself(NumberOrName<float>{g.value, g.input},
             "A number, or the name of the input that the output equals.");
    g.constant = g.input.empty();
}

template <class V>
void fields(V& v, NoOpDesc& i)
{
    v.field("at", i.at, "The value of the param at which the outputs are known.", required());
    v.field("gives", i.gives, "What each output then is: a number or the name of an input.",
            required());
}

template <class V>
void fields(V& v, InputDesc& i)
{
    v.shorthand(
        "from", i.from,
        "What the sampler reads: a target, import or noise. When absent: the one of its own name.");
    v.field("filter", i.filter,
            "How texels are filtered. When absent: `trilinear` for a target with mips, else "
            "`nearest`.");
    v.field("wrap", i.wrap,
            "Addressing past the edge. When absent: `repeat` for a generated noise, else `clamp`.");
    i.has_filter = v.has("filter");
    i.has_wrap = v.has("wrap");
}

template <class V>
void fields(V& v, StateDesc& s)
{
    v.field("depth_test", s.depth_test,
            "When absent: `less` for a draw pass with depth. `less` is nearer, also with reversed "
            "depth.");
    v.field("depth_write", s.depth_write, "When absent: true for a draw pass with depth.");
    v.field("cull", s.cull, "Which faces of triangles are culled.");
    v.field(
        "blend", s.blend,
        "How what is drawn joins what is there: `over` it by its alpha, which its colour has been "
        "multiplied by, or the smaller (`min`) or larger (`max`) of the two, channel by channel.");
}

/// The keys by which a pass says what need not be drawn.
template <class V>
void workSaving(V& v, PassDesc& p)
{
    v.field("no_op", p.no_op, "Values of params at which the outputs are known without the pass.");
    v.field(
        "preserves_constant", p.preserves_constant,
        "Filtered outputs and their samplers: where the sampler's texture is one constant, so is "
        "the output, except in the background.");
    v.field(
        "frustum_scale", NumberOrName<float>{p.frustum_scale, p.frustum_scale_param},
        "The view that a draw pass shows, as a multiple of the camera's, or a param: draws whose "
        "bounds are outside are culled. 0 culls nothing: where the shader moves vertices.",
        range(0, kLargestScale));
    if (p.type != PassType::draw)
        v.refuse("frustum_scale", Code::bad_enum, "a fullscreen pass has no geometry");
    v.field("mask", p.mask,
            "A target in a depth format: where it is 0 the pass does not draw, and outputs keep "
            "the value of `clear`, which must be what the shader would write. It must have the "
            "size of the outputs.");
    if (p.type == PassType::draw)
        v.refuse("mask", Code::bad_enum, "a draw pass has a depth test of its own");
    else if (!p.depth.empty())
        v.refuse("mask", Code::bad_enum, "the pass writes depth");
    v.field("scissor", p.scissor,
            "Draws only within the bounds of the draw list on the screen; elsewhere outputs keep "
            "the value of `clear`. The pass must cover the view, without a guard band.");
    v.field("cull_below_pixel", p.cull_below_pixel,
            "A param in scene units: the scissor culls draws so far away that it is less than "
            "a pixel.");
    if (p.type == PassType::draw)
        v.refuse("scissor", Code::bad_enum, "a draw pass draws geometry alone");
    if (!v.has("scissor"))
        v.refuse("cull_below_pixel", Code::bad_enum, "the pass has no 'scissor'");
}

template <class V>
void fields(V& v, PassDesc& p)
{
    v.field("type", p.type,
            "`draw` for the draw list, `fullscreen` for one triangle over the target.");
    v.field("shader", p.shader, "The shader that runs.", required());
    v.field("color", p.color, "Targets in the order of the shader's outputs, or just one.");
    v.field("depth", p.depth, "The target for depth.");
    v.field(
        "over", p.over,
        "The pass on whose outputs this one goes on to draw: where it draws nothing, they stay. "
        "Readers of them get what this pass leaves.");
    v.field("box", p.box,
            "The box by whose view the pass draws or that its picture is of. It is drawn when what "
            "lies there changes or the box moves, and then one such pass a frame in turn, "
            "with no more than 20 draws of the scene.");
    v.field("blended", p.blended,
            "Draws what materials say is seen through, from far to near; other draw passes draw "
            "all but that.");
    if (p.type != PassType::draw)
        v.refuse("blended", Code::bad_enum, "a fullscreen pass has no geometry");
    v.field("clear", p.clear, "Values that attachments are cleared to before the pass draws.");
    v.field("when", p.when, "Features and traits that must hold for the pass to run.");
    v.field("bypass", p.bypass, "Which input replaces an output when the pass is off.");
    workSaving(v, p);
    v.field("inputs", p.inputs, "Samplers whose names differ from what they read.");
    if (p.type == PassType::draw && !p.depth.empty()) p.state = {Compare::less, true};
    v.field("state", p.state, "Fixed-function state.");
}

template <class V>
void fields(V& v, OutputDesc& o)
{
    v.shorthand("target", o.target, "The target behind the exported name.", required());
    v.field("on_request", o.on_request,
            "Draws it, and what it alone needs, where it is asked for by name.");
}

template <class V>
void fields(V& v, ViewDesc& view)
{
    v.field("target", view.target, "The target to look at.", required());
    v.field("scale", view.scale, "The view shows value * scale + offset.");
    v.field("offset", view.offset, "The view shows value * scale + offset.");
}

template <class V>
void fields(V& v, Description& d)
{
    v.field("format", d.format, "Version of the format.", required(range(1, 1)));
    v.field("name", d.name, "The config's name.");
    v.field("description", d.text, "What it is for, in a sentence or two.");
    v.field("params", d.params,
            "Continuous tunables. A bare number or list is the `default` of one that a module "
            "declares.");
    v.field("features", d.features,
            "Switches and choices: `when` tests them, GLSL has them as #defines. A bare value is a "
            "`default` here too.");
    v.field("imports", d.imports, "What the host supplies.");
    v.field("generated", d.generated, "Arrays and small textures computed on load.");
    v.field("boxes", d.boxes,
            "Cubes around the camera, as views. GLSL sees a box as a mat4 of its name, from view "
            "space to [0, 1] along each edge, as it was when it was drawn.");
    v.field("targets", d.targets, "Textures that passes write.");
    v.field("shaders", d.shaders, "Programs by name.");
    v.field("interfaces", d.interfaces, "GLSL that one module provides and others include.");
    v.field("passes", d.passes, "The passes; their order follows from what they read and write.");
    v.field("outputs", d.outputs,
            "Exported targets by name; passes that none of them needs are culled.");
    v.field("views", d.views, "Debug views of targets.");
}

}  // namespace crevice::table
