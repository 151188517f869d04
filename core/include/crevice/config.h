// SPDX-License-Identifier: MIT
// A description: what a merged document says, as plain structs.
//
// `decode` turns a document into one and reports every error in it, not the first. A description is
// whole: it carries the text of each GLSL file that it names, so that `compile` is a pure function.
// Every named object keeps the place of its key, for messages that come later.
#pragma once

#include <crevice/document.h>
#include <crevice/plan.h>

#include <array>

namespace crevice {

/// A name that refers to another object, with the place where it was written.
struct Reference : Named {
    std::vector<Place> origins = {};

    bool empty() const { return name.empty(); }
};

enum class ParamType { float_, int_, vec2, vec3, vec4 };
enum class Bind {
    uniform,  ///< A uniform: changes cost nothing.
    define,   ///< A #define in upper case: a change compiles the shader again.
};

/// What a param means to formats. A length, in scene units, is how far an estimator looks about:
/// formats of depth and positions are chosen to distinguish surfaces that are a tenth of it apart.
/// A margin, as a share of the length, is how far in front of an offset something must lie to
/// occlude: no smaller steps are seen.
enum class ParamSemantic { other, length, margin };

/// A tunable number or vector. All bounds hold for each component and are inclusive.
struct ParamDesc : Named {
    ParamType type = ParamType::float_;
    /// JSON "default"; the first `components` count. Of a length one of three: scene units,
    /// percents of SceneScale::diagonal, or pixels of the view's height at SceneScale::distance.
    std::array<float, 4> value = {0, 0, 0, 0};
    double min = -1e30;     ///< Hard: a value below is an error.
    double max = 1e30;      ///< Hard: a value above is an error.
    double soft_max = 0.0;  ///< Upper end of a slider; 0 for `max`.
    double step = 0.0;      ///< Step of a slider; 0 for none.
    std::string unit;       ///< "scene units", "pixels", "1" ...
    std::string label;      ///< For a user interface; the name when empty.
    std::string tooltip;    ///< One sentence: what it does, and what a higher value costs.
    std::string group;      ///< Heading in a user interface.
    Bind bind = Bind::uniform;
    ParamSemantic semantic = ParamSemantic::other;
};

/// Number of floats in a param of that type.
int componentCount(ParamType type);

/// What GLSL calls a param of that type.
GlslType glslTypeOf(ParamType type);

/// A finite switch; GLSL sees a #define. A bool `alpha_test` is ALPHA_TEST 0 or 1. An enum
/// `range_check` is RANGE_CHECK, equal to one of RANGE_CHECK_HARD, RANGE_CHECK_SMOOTHSTEP ...
struct FeatureDesc : Named {
    /// A value that a word gives a param, or another feature.
    struct Setting : Named {
        std::array<float, 4> value = {0, 0, 0, 0};  ///< Of a feature the first: its word's index.
    };
    /// What the word of that name sets: all that any word of the feature sets, else the default.
    struct Level : Reference {
        std::vector<Setting> settings = {};
    };

    std::vector<std::string> values;  ///< "false", "true" for a bool.
    bool boolean = false;
    int value = 0;                 ///< Index of the default.
    std::string label = {};        ///< For a user interface; the name when empty.
    std::string tooltip = {};      ///< One sentence: what it does, and what it costs.
    std::vector<Level> sets = {};  ///< One for each word, or none.
};

struct GeneratedDesc : GeneratorDesc {
    Reference count_param = {};  ///< The int param that gives the count; empty when `count` does.
};

constexpr double kSmallestScale = 1.0 / 64.0;
constexpr double kLargestScale = 4.0;

/// A number times the first components of params: 64, "resolution" or ["resolution", 0.75].
struct ProductDesc {
    double factor = 0;  ///< 0 where nothing is written.
    std::vector<Reference> params = {};
};

/// The product, of the description's values.
double valueOf(const ProductDesc& product, const std::vector<ParamDesc>& params);

/// A cube around the camera with edges along the world's axes, by whose parallel view passes draw.
/// It stays where it is while the camera moves by less than a step, which is its `edge` / `steps`.
/// Where a smaller one holds all that is drawn, it is that one.
struct BoxDesc : Named {
    ProductDesc edge = {};  ///< Scene units, > 0.
    int steps = 8;          ///< [1, 64]
};

/// How large a target is in each direction: max(1, ceil(followed * scale)); with `border`
/// followed + 2 * ceil(followed * (scale - 1) / 2); or so many texels. With a `depth` it is a
/// volume.
struct SizeDesc {
    ProductDesc width = {}, height = {}, depth = {};  ///< Texels, [1, 16384], in place of all that.
    Reference of = {};  ///< Another target; empty, or an imported texture, follows the output.
    Reference scale_param = {};  ///< The param that gives the scale; empty when `scale` does.
    bool optional = false;       ///< The param may be lacking: the scale then is 1.
    float scale = 1.0f;          ///< [kSmallestScale, kLargestScale].
    bool border = false;         ///< What `scale`, 1 or more, adds is whole pixels on either side.
    Place place = {};            ///< Of the value that was set last.
};

/// The least that its scale may be.
inline double smallestScale(const SizeDesc& size) { return size.border ? 1.0 : kSmallestScale; }

/// What a colour target holds to find surfaces by; depth formats hold window depth, or the mask.
enum class Semantic { other, view_position, view_depth, mask };

struct TargetDesc : Named {
    /// Preference list: taken is the first that the device renders to and that resolves `semantic`.
    std::vector<Format> formats;
    Place formats_place = {};
    Semantic semantic = Semantic::other;
    SizeDesc size = {};
    bool history = false;          ///< Last frame's content stays, under `historyName`.
    bool mips = false;             ///< Smaller levels, made as its pass ends.
    Reference samples_param = {};  ///< The param that gives the samples; empty when `samples` does.
    int samples = 1;  ///< Of a pixel, [1, kMaxSamples]; above 1 its pass resolves it for readers.
};

/// Under which name passes read what the target held in the last frame: "ao" gives "ao_history".
inline std::string historyName(const TargetDesc& target) { return target.name + "_history"; }

inline bool isVolume(const TargetDesc& target) { return target.size.depth.factor > 0; }

struct ShaderDesc : Named {
    Reference vertex = {};  ///< Path in the sources.
    Reference fragment = {};
    std::map<std::string, std::string> defines = {};
};

/// A GLSL file that others include as `#include <name>`.
struct InterfaceDesc : Named {
    Reference file = {};
};

/// Holds when the feature or trait of that name has one of the values.
struct Condition : Reference {
    std::vector<std::string> values;  ///< Of a count, true means at least one.
};

/// "At this value of the param of that name, this output is that constant or that input."
struct NoOpDesc : Reference {
    float at = 0.0f;
    struct Gives : Reference {
        bool constant = false;
        float value = 0.0f;    ///< In every channel, when constant.
        Reference input = {};  ///< Otherwise.
    };
    std::vector<Gives> gives = {};
};

/// What the sampler of that GLSL name reads, where that has another name or its sampling differs.
struct InputDesc : Reference {
    Reference from = {};  ///< Target, generated, import; empty means the same name.
    Filter filter = Filter::nearest;
    Wrap wrap = Wrap::clamp;  ///< A generated noise defaults to repeat.
    bool has_filter = false;
    bool has_wrap = false;
};

/// What the target of that name is cleared to.
struct ClearDesc : Reference {
    std::array<float, 4> value = {0, 0, 0, 0};
};

/// What the output of that name is while the pass is off.
struct BypassDesc : Reference {
    Reference input = {};
};

/// "Where all texels of that sampler are one constant, so are those of the output of that name."
struct PreservesConstantDesc : Reference {
    Reference sampler = {};  ///< The GLSL name.
};

struct PassDesc : Named {
    PassType type = PassType::fullscreen;
    Reference shader = {};
    std::vector<Reference> color = {};  ///< In the order of the shader's output locations.
    Reference depth = {};
    Reference over = {};   ///< The pass on whose outputs this one goes on to draw.
    Reference box = {};    ///< The box by whose view it draws, in place of the camera's.
    bool blended = false;  ///< Draws what is blended, from far to near; others draw all else.
    std::vector<ClearDesc> clear = {};
    std::vector<Condition> when = {};  ///< All of which must hold.
    std::vector<BypassDesc> bypass = {};
    std::vector<NoOpDesc> no_op = {};
    std::vector<PreservesConstantDesc> preserves_constant = {};
    Reference frustum_scale_param = {};  ///< The param that gives `frustum_scale`; else empty.
    float frustum_scale = 0.0f;          ///< View sizes; 0 is unknown.
    Reference mask = {};   ///< Drawn where that is above 0; elsewhere stands what `clear` says.
    bool scissor = false;  ///< That also holds where no draw covers the screen ...
    Reference cull_below_pixel = {};  ///< ... or at which this param, a length, is below a pixel.
    std::vector<InputDesc> inputs = {};
    StateDesc state = {};
};

/// An exported name and the target behind it.
struct OutputDesc : Named {
    Reference target = {};
    bool on_request = false;  ///< Drawn where it is asked for by name, and not with "all".
};

/// A debug view: a target shown as (value * scale + offset).
struct ViewDesc : Named {
    Reference target = {};
    float scale = 1.0f;
    float offset = 0.0f;
};

/// What a config may ask for; more is refused (CV1209): no stranger's file takes all memory.
struct Limits {
    int files = 1024;             ///< JSON files, and GLSL files.
    int passes = 512;             ///< Whether they run or not.
    int targets = 512;            ///< Whether they are used or not.
    double bytes = 2147483648.0;  ///< Of all textures at the size asked for, by textureBytes.
};

struct Description : Named {
    int format = 1;
    Limits limits;     ///< As given to `decode`; `compile` holds to `bytes`.
    std::string text;  ///< JSON "description".
    std::vector<ParamDesc> params;
    std::vector<FeatureDesc> features;
    std::vector<ImportDesc> imports;
    std::vector<GeneratedDesc> generated;
    std::vector<BoxDesc> boxes;
    std::vector<TargetDesc> targets;
    std::vector<ShaderDesc> shaders;
    std::vector<InterfaceDesc> interfaces;
    std::vector<PassDesc> passes;
    std::vector<OutputDesc> outputs;
    std::vector<ViewDesc> views;
    std::vector<Named> deleted;  ///< Entries that patches deleted, for notes.
    /// Modules that others took the place of (`replaces`).
    struct LeftOut {
        std::string module;
        std::string reason;  ///< Half a sentence: "it needs ..."
    };
    std::vector<LeftOut> left_out;
    /// About names that nothing uses: `compile` reports them where no other error might be why.
    Diagnostics unused;
    std::map<std::string, SourceRef> files;  ///< Every GLSL file, includes too, by path.
    /// What makes its plans: `compile` where it is null. One that was baked brings its own.
    std::shared_ptr<const PlanMaker> planner = nullptr;
};

/// Decodes a merged document and reads the GLSL files it names, with what they include, from
/// `sources`. Paths that begin with "./" are relative to the file that wrote them.
///
/// Errors: CV3xxx and CV4xxx for the keys and values, CV2101 to CV2107 for names that lead nowhere,
/// CV2104 and CV5005 for GLSL files; all of them, in the order of the document. CV1209 where it has
/// more than `limits` allow.
Result<Description> decode(const Node& document, const SourceSet& sources,
                           const Limits& limits = {});

constexpr int kMaxExtendsDepth = 8;

/// What to load and what to lay over it.
struct LoadRequest {
    /// A shipped config's name ("learnopengl"), or the path of a file that ends in ".json"; behind
    /// it modules to lay over it, each with a plus in front: "mobile+geometry/host_depth". Or the
    /// JSON text itself, from its '{' on, which names files as one in the current folder would.
    std::string config;
    std::string variant = {};  ///< A name under `variants`; empty for none.
    /// "radius=0.8": a param's default or a feature's, or a pointer, "/passes/blur/when=null", or a
    /// module that the config or a config that it extends names, and another:
    /// "filter/box=filter/median"; or one more at the end of its `extends`: "+geometry/host_depth".
    std::vector<std::string> overrides = {};
    /// Folders below which files may be named besides those below the config's own folder, and for
    /// an override's value those below the current one. A folder that is not there allows nothing.
    std::vector<std::string> roots = {};
    Limits limits = {};  ///< Of which `files` counts.
};

/// Finds the config and everything that it extends, and merges them: modules from left to right,
/// then the file, then the variant, then the overrides. The result has neither `extends` nor
/// `variants`, nor the `$schema` by which editors find what checks a file; its top keeps the file's
/// place, as an origin too where a variant or a pointer's override was laid over it. A name is
/// looked up as "configs/NAME.json" in `sources`; what ends in ".json" is a file on disk first.
/// `extends` entries are module names ("ssao/hemisphere", found as "ssao/hemisphere.json" in
/// `sources`), config names, or paths relative to the file ("./mine.json"), to what lies, once
/// links are resolved, below the config's own folder or one of `roots`; the same holds for the GLSL
/// files that `decode` reads. Two files, neither of which extends the other, may not make one
/// shader or interface: that is two filters or two estimators, of which a merge would keep halves.
///
/// A file that `needs` a word is left out where another that `replaces` the word is named later,
/// as are values that the files before that one give to what only left out files declare.
///
/// Errors: CV1xxx of any file, CV1201 to CV1209, CV3002, CV4004 for an override of nothing.
Result<Node> loadConfig(const SourceSet& sources, const LoadRequest& request);

/// The variants of a config and of all that it extends, sorted, whatever `variant` says; or none.
std::vector<std::string> variantNames(const SourceSet& sources, const LoadRequest& request);

/// The names of the configs in `sources`, sorted.
std::vector<std::string> configNames(const SourceSet& sources);

/// LoadRequest::config, taken apart: {"mobile", "geometry/host_depth"}.
std::vector<std::string> splitName(const std::string& name);

}  // namespace crevice
