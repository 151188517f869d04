// SPDX-License-Identifier: MIT
// Reading baked effects, and their plans.
#include <crevice/baked.h>

#include "core/bake/pack.h"
#include "core/bake/records.h"
#include "core/base/text.h"
#include "core/config/values.h"
#include "core/plan/depth_precision.h"
#include "core/plan/sizes.h"
#include "core/sampling/generators.h"

namespace crevice {
namespace {

Diagnostic broken(std::string why)
{
    return {Code::baked_broken, "these bytes are no baked effect: " + std::move(why),
            "bake it again, and hand over all bytes of the file as they are"};
}

Diagnostic notBaked(std::string message, std::string help)
{
    return {Code::not_baked, std::move(message), std::move(help)};
}

// Checks of what was read. Numbers that no writer wrote would lead out of lists.

template <class List>
bool holds(const List& list, int index)
{
    return index >= 0 && index < static_cast<int>(list.size());
}

template <class List>
bool holdsOrNone(const List& list, int index)
{
    return index == -1 || holds(list, index);
}

// Whether all names of one list are in the other.
template <class List, class Other>
bool known(const List& list, const Other& other)
{
    return allOf(list, [&](const auto& each) { return findNamed(other, each.name); });
}

bool hasFormats(const TargetDesc& target)
{
    return !target.formats.empty() &&
           allOf(target.formats, [](Format each) { return each != Format::none; });
}

bool holdsWord(const FeatureDesc& feature, float word)
{
    return word >= 0 && word < static_cast<float>(feature.values.size());
}

// Whether an int can have it, where the param is one.
bool fitsType(const ParamDesc& param, const std::array<float, 4>& value)
{
    return param.type != ParamType::int_ || std::abs(value[0]) <= 1e9f;
}

bool isWhole(const Description& description)
{
    const auto fits = [&](const FeatureDesc& feature) {
        const auto level = [&](const FeatureDesc::Level& each) {
            return contains(feature.values, each.name) &&
                   allOf(each.settings, [&](const FeatureDesc::Setting& setting) {
                       const FeatureDesc* other = findNamed(description.features, setting.name);
                       if (other) return holdsWord(*other, setting.value[0]);
                       const ParamDesc* param = findNamed(description.params, setting.name);
                       return param && fitsType(*param, setting.value);
                   });
        };
        return holds(feature.values, feature.value) && allOf(feature.sets, level);
    };
    const auto ends = [&](const TargetDesc& target) {
        std::size_t steps = 0;
        for (const TargetDesc* at = &target; at && steps <= description.targets.size(); ++steps)
            at = findNamed(description.targets, at->size.of.name);
        return steps <= description.targets.size();
    };
    const auto sound = [&](const TargetDesc& target) {
        const SizeDesc& size = target.size;
        return hasFormats(target) && ends(target) && target.samples >= 1 &&
               target.samples <= kMaxSamples && size.scale >= kSmallestScale &&
               size.scale <= kLargestScale;
    };
    const auto typed = [](const ParamDesc& param) { return fitsType(param, param.value); };
    return allOf(description.params, typed) && allOf(description.features, fits) &&
           allOf(description.targets, sound);
}

// What a uniform is fed from, as a type and elements; nothing where the index leads nowhere.
struct Fed {
    GlslType type;
    int count;
};

std::optional<Fed> fedFrom(const Plan& plan, const PlanUniform& uniform)
{
    const int at = uniform.index;
    const bool of_draw = uniform.source == UniformSource::draw;
    switch (uniform.source) {
    case UniformSource::param:
        if (holds(plan.params, at)) return Fed{plan.params[at].type, 1};
        break;
    case UniformSource::kernel:
        if (holds(plan.generated, at) && !generatesTexture(plan.generated[at].generator))
            return Fed{GlslType::vec3, kMaxKernelSize};
        break;
    case UniformSource::box:
        if (holds(plan.boxes, at)) return Fed{GlslType::mat4, 1};
        break;
    case UniformSource::frame:
    case UniformSource::draw:
        if (at < 0 || at >= int{std::size(kFrameValues)}) break;
        if (const FrameValueInfo& value = kFrameValues[at];
            of_draw == (value.import == ImportType::draw_list))
            return Fed{value.type, value.count};
    }
    return std::nullopt;
}

bool isWhole(const Plan& plan, const PlanInput& input)
{
    switch (input.kind) {
    case InputKind::target: return holds(plan.targets, input.index);
    case InputKind::history:
        return holds(plan.targets, input.index) && plan.targets[input.index].history_texture >= 0;
    case InputKind::generated:
        return holds(plan.generated, input.index) &&
               generatesTexture(plan.generated[input.index].generator);
    case InputKind::imported:
        return holds(plan.imports, input.index) &&
               plan.imports[input.index].type == ImportType::texture;
    case InputKind::material:
        return input.index >= 0 && input.index < int{std::size(kMaterialMaps)};
    case InputKind::constant: return holds(plan.constants, input.index);
    }
    return false;
}

bool isWhole(const Plan& plan, std::size_t index, const std::vector<BakedProgram>& programs)
{
    const PlanPass& pass = plan.passes[index];
    const auto attached = [&](const PlanAttachment& each) {
        return holdsOrNone(plan.targets, each.target);
    };
    const auto fed = [&](const PlanUniform& each) {
        const std::optional<Fed> from = fedFrom(plan, each);
        return from && from->type == each.type && each.count >= 1 && each.count <= from->count;
    };
    return holds(programs, pass.program) && pass.color.size() <= kMaxColorAttachments &&
           pass.inputs.size() <= 16 && allOf(pass.color, attached) && attached(pass.depth) &&
           holdsOrNone(plan.boxes, pass.box) && holdsOrNone(plan.params, pass.cull_below_pixel) &&
           pass.layers_at_once >= 1 && pass.over >= -1 && pass.over < static_cast<int>(index) &&
           allOf(pass.inputs, [&](const PlanInput& each) { return isWhole(plan, each); }) &&
           allOf(pass.uniforms, fed);
}

bool isWhole(const Plan& plan, const Description& description,
             const std::vector<BakedProgram>& programs)
{
    const int end = static_cast<int>(plan.passes.size());
    for (std::size_t i = 0; i < plan.passes.size(); ++i)
        if (!isWhole(plan, i, programs)) return false;
    const auto lives = [&](const PlanTarget& each) {
        return each.first_pass >= 0 && each.first_pass < end && each.last_pass >= each.first_pass &&
               each.last_pass <= end;
    };
    const auto given = [&](const PlanOutput& each) {
        return each.target == -1 ? holds(plan.constants, each.constant)
                                 : holds(plan.targets, each.target) && each.constant == -1;
    };
    const auto placed = [&](const PlanBox& each) {
        return each.steps >= 1 && each.steps <= 64 &&
               allOf(each.params, [&](int param) { return holds(plan.params, param); });
    };
    const auto typed = [&](const PlanParam& each) {
        const ParamDesc* const param = findNamed(description.params, each.name);
        return param && glslTypeOf(param->type) == each.type;
    };
    return known(plan.passes, description.passes) && known(plan.targets, description.targets) &&
           known(plan.generated, description.generated) &&
           known(plan.imports, description.imports) && allOf(plan.params, typed) &&
           allOf(plan.targets, lives) && allOf(plan.outputs, given) && allOf(plan.boxes, placed) &&
           !plan.passes.empty() == !plan.targets.empty();
}

// "radius 0.5", "'high'", "false": a number of an axis as one writes it.
std::string wordOf(const BakedAxis& axis, const Description& description, float number)
{
    const FeatureDesc* const feature = findNamed(description.features, axis.name);
    if (axis.kind == BakedAxis::Kind::feature && feature)
        return feature->values[static_cast<std::size_t>(number)];
    const TraitInfo* const trait = findNamed(kTraits, axis.name);
    if (axis.kind == BakedAxis::Kind::trait && trait && trait->flag)
        return number != 0 ? "true" : "false";
    return shortest(number);
}

void setTrait(const TraitInfo& trait, float number, SceneTraits& traits)
{
    if (trait.flag)
        traits.*trait.flag = number != 0;
    else
        traits.*trait.count = static_cast<int>(std::clamp(number, 0.0f, 64.0f));
}

class BakedPlans : public PlanMaker {
public:
    BakedPlans(std::shared_ptr<const BakedFile> file, std::size_t entry)
        : file_(std::move(file)),
          entry_(file_->entries[entry])
    {
    }

    Result<Plan> plan(const Description& given, const SceneTraits& traits, const DeviceCaps& caps,
                      const CompileOptions& options) const override
    {
        if (const Status asked = checkOptions(options); !asked) return asked.diagnostics();
        std::vector<Elided> elided;
        const std::optional<Description> fitted = fitBorders(given, options, caps, elided);
        const Description& description = fitted ? *fitted : given;
        const Result<int> index = choose(description, traits, caps, options.extent.height);
        if (!index) return index.diagnostics();
        Plan plan;
        ArchiveReader reader(entry_.plans[static_cast<std::size_t>(*index)]);
        reader.member(plan);
        if (!reader.ok() || !reader.atEnd() || !isWhole(plan, description, entry_.programs))
            return broken("a plan in it cannot be read");
        plan.config = description.name;
        plan.elided.insert(plan.elided.begin(), elided.begin(), elided.end());
        addPrograms(plan, description, traits, caps, options.extent.height);
        fitPlan(plan, description, traits, caps, options);
        if (const Status fits = checkDevice(plan, caps); !fits) return fits.diagnostics();
        if (const Status fits = checkBytes(plan, description); !fits) return fits.diagnostics();
        return plan;
    }

private:
    Status checkOptions(const CompileOptions& options) const
    {
        if (!options.disable.empty())
            return notBaked("optimizations cannot be switched off in a baked effect",
                            "take the config itself");
        const std::vector<std::string> baked = namesOf(entry_.config.description.outputs);
        const auto asked = [&](const std::string& each) {
            return options.outputs.empty() || contains(options.outputs, each);
        };
        const auto known = [&](const std::string& each) { return contains(baked, each); };
        if (allOf(options.outputs, known) && allOf(baked, asked)) return {};
        std::string help = "bake it with";
        for (const std::string& each : options.outputs) help += " --output " + each;
        return notBaked("'" + entry_.config.name + "' was baked for the outputs " + joined(baked) +
                            ", and asked for " + joined(options.outputs),
                        std::move(help));
    }

    Result<int> choose(const Description& description, const SceneTraits& traits,
                       const DeviceCaps& caps, int height) const
    {
        std::vector<float> now;
        for (const BakedAxis& axis : entry_.axes)
            now.push_back(numberOf(axis, description, traits, caps, height));
        const BakedChoice* nearest = nullptr;
        for (const bool runs_all : {false, true}) {
            // Where formats let only some no-ops hold, none need: those passes change nothing.
            for (std::size_t i = 0; runs_all && i < now.size(); ++i)
                if (entry_.axes[i].kind == BakedAxis::Kind::no_op) now[i] = 0;
            std::ptrdiff_t least = 0;
            for (const BakedChoice& each : entry_.choices) {
                std::ptrdiff_t differ = 0;
                for (std::size_t i = 0; i < now.size(); ++i) differ += now[i] != each.numbers[i];
                if (differ == 0) return each.plan;
                if (least == 0 || differ < least) nearest = &each, least = differ;
            }
        }
        return missing(description, now, *nearest);
    }

    // Names what differs from the nearest that is there, and what to bake: that, and all there was.
    Diagnostic missing(const Description& description, const std::vector<float>& now,
                       const BakedChoice& nearest) const
    {
        std::string has, wanted, help;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const BakedAxis& axis = entry_.axes[i];
            const bool differs = now[i] != nearest.numbers[i];
            if (axis.kind == BakedAxis::Kind::no_op) continue;
            std::vector<std::string> words;
            for (const BakedChoice& each : entry_.choices)
                if (std::string word = wordOf(axis, description, each.numbers[i]);
                    !contains(words, word))
                    words.push_back(std::move(word));
            const std::string word = wordOf(axis, description, now[i]);
            if (differs) {
                wanted += (wanted.empty() ? "" : ", ") + axis.name + " " + word;
                has += (has.empty() ? "" : ", ") + axis.name + " " + joined(words, " or ");
                if (!contains(words, word)) words.push_back(word);
            }
            if (words.size() > 1)
                help += (axis.kind == BakedAxis::Kind::trait ? " --trait " : " --values ") +
                        axis.name + "=" + joined(words, ",");
        }
        return notBaked(
            "'" + entry_.config.name + "' was not baked for " + wanted + ", but for " + has,
            "bake it with" + help);
    }

    // Programs of the plan alone, with what their texts lack.
    void addPrograms(Plan& plan, const Description& description, const SceneTraits& traits,
                     const DeviceCaps& caps, int height) const
    {
        std::vector<int> added;
        const auto text = [&](int index) {
            const BakedText& baked = file_->texts[static_cast<std::size_t>(index)];
            std::string whole = "#version " + baked.version + "\n";
            const auto define = [&](const std::string& name, const std::string& value) {
                whole += "#define " + name + " " + value + "\n";
            };
            for (const std::string& name : baked.steps)
                define(stepDefine(name),
                       stepsOf(formatOf(name, description, traits, caps, height)));
            for (const std::string& name : baked.values)
                if (const ParamDesc* const param = findNamed(description.params, name))
                    define(upperCase(name), literal(*param));
            GlslStage stage;
            stage.text = whole + baked.body;
            return stage;
        };
        for (PlanPass& pass : plan.passes) {
            const auto known = std::find(added.begin(), added.end(), pass.program);
            const BakedProgram& baked = entry_.programs[static_cast<std::size_t>(pass.program)];
            if (known == added.end()) {
                PlanProgram program;
                program.label = baked.label;
                program.vertex = text(baked.vertex);
                program.fragment = text(baked.fragment);
                ContentHash hash;
                hash.addText(program.vertex.text);
                hash.addText(program.fragment.text);
                program.key = hash.hex();
                plan.programs.push_back(std::move(program));
            }
            const auto index = static_cast<int>(known - added.begin());
            if (known == added.end()) added.push_back(pass.program);
            pass.program = index;
        }
    }

    static Format formatOf(const std::string& texture, const Description& description,
                           const SceneTraits& traits, const DeviceCaps& caps, int height)
    {
        if (const TargetDesc* const target = findNamed(description.targets, texture))
            return chooseFormat(description, *target, traits, caps, height);
        const ImportDesc* const import = findNamed(description.imports, texture);
        return import ? formatFromName(import->format) : Format::none;
    }

    static Status checkDevice(const Plan& plan, const DeviceCaps& caps)
    {
        for (const PlanProgram& each : plan.programs)
            if (caps.version < 310 && startsWith(each.fragment.text, "#version 310"))
                return Diagnostic{
                    Code::sampler_version,
                    "shader '" + each.label + "' needs OpenGL ES 3.1, and the device has 3.0",
                    "take another config on this device"};
        for (const PlanTexture& each : plan.textures) {
            const std::string name = "target '" + each.targets.front() + "'";
            const Extent& size = each.extent;
            if (std::max(size.width, size.height) > caps.max_texture_size ||
                each.depth > caps.max_volume_size)
                return Diagnostic{Code::too_big_for_device,
                                  name + " would be " + text(size) + ", and " + endsAt(caps),
                                  "ask for a smaller size"};
            if (!caps.canRender(each.format))
                return Diagnostic{Code::no_format, "the device can render to no format of " + name,
                                  "take another config on this device"};
        }
        return {};
    }

    std::shared_ptr<const BakedFile> file_;
    const BakedEntry& entry_;
};

std::string_view takeBytes(std::string_view& bytes, std::size_t count)
{
    const std::string_view taken = bytes.substr(0, count);
    bytes.remove_prefix(count);
    return taken;
}

template <class T>
T numberIn(std::string_view bytes)
{
    T value = {};
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

bool isWhole(const BakedFile& file)
{
    const auto texts = [&](const BakedProgram& each) {
        return holds(file.texts, each.vertex) && holds(file.texts, each.fragment);
    };
    return !file.entries.empty() && allOf(file.entries, [&](const BakedEntry& entry) {
        const Description& description = entry.config.description;
        const auto axis = [&](const BakedAxis& each) {
            switch (each.kind) {
            case BakedAxis::Kind::feature:
                return findNamed(description.features, each.name) != nullptr;
            case BakedAxis::Kind::trait: return findNamed(kTraits, each.name) != nullptr;
            default: return findNamed(description.params, each.name) != nullptr;
            }
        };
        const auto choice = [&](const BakedChoice& each) {
            for (std::size_t i = 0; i < entry.axes.size() && i < each.numbers.size(); ++i)
                if (const BakedAxis& by = entry.axes[i];
                    by.kind == BakedAxis::Kind::feature &&
                    !holdsWord(*findNamed(description.features, by.name), each.numbers[i]))
                    return false;
            return each.numbers.size() == entry.axes.size() && holds(entry.plans, each.plan);
        };
        return isWhole(description) && allOf(entry.programs, texts) && allOf(entry.axes, axis) &&
               !entry.choices.empty() && allOf(entry.choices, choice);
    });
}

}  // namespace

float numberOf(const BakedAxis& axis, const Description& description, const SceneTraits& traits,
               const DeviceCaps& caps, int height)
{
    const auto formatOf = [&](const std::string& target) {
        const TargetDesc* const found = findNamed(description.targets, target);
        return found ? chooseFormat(description, *found, traits, caps, height) : Format::none;
    };
    switch (axis.kind) {
    case BakedAxis::Kind::feature: {
        const FeatureDesc* const feature = findNamed(description.features, axis.name);
        return feature ? static_cast<float>(feature->value) : -1.0f;
    }
    case BakedAxis::Kind::trait:
        return static_cast<float>(findNamed(kTraits, axis.name)->value(traits));
    case BakedAxis::Kind::param:
    case BakedAxis::Kind::no_op: break;
    }
    const ParamDesc* const param = findNamed(description.params, axis.name);
    if (!param) return -1.0f;
    const std::array<float, 4> value = sceneUnits(*param, traits, height);
    if (axis.kind == BakedAxis::Kind::param) return value[0];
    const auto alike = [&](const BakedAxis::Given& each) {
        return storedAlike(formatOf(each.replaced), formatOf(each.by));
    };
    return isAll(value, param->type, axis.at) && allOf(axis.given, alike) ? 1.0f : 0.0f;
}

std::optional<std::string> unpack(std::string_view packed, std::size_t size)
{
    std::string bytes;
    bytes.reserve(size);
    ArchiveReader reader(packed);
    while (reader.ok() && bytes.size() < size) {
        const std::uint32_t plain = reader.number();
        if (plain > size - bytes.size()) return std::nullopt;
        bytes.append(reader.take(plain));
        if (reader.ok() && bytes.size() == size) break;
        const std::uint32_t repeated = reader.number(), back = reader.number();
        if (!reader.ok() || repeated > size - bytes.size() || back == 0 || back > bytes.size() ||
            plain + repeated == 0)
            return std::nullopt;
        for (std::uint32_t i = 0; i < repeated; ++i) bytes += bytes[bytes.size() - back];
    }
    if (!reader.ok() || !reader.atEnd()) return std::nullopt;
    return bytes;
}

bool isBaked(const void* data, std::size_t size)
{
    return size >= sizeof kMagic && std::memcmp(data, kMagic, sizeof kMagic - 2) == 0;
}

Result<std::vector<BakedConfig>> readBaked(const void* data, std::size_t size)
{
    std::string_view bytes(static_cast<const char*>(data), data ? size : 0);
    if (!isBaked(data, bytes.size())) return broken("they do not begin as one does");
    if (size < kHeaderBytes) return broken("they end in its head");
    const bool format = takeBytes(bytes, sizeof kMagic) == std::string_view(kMagic, sizeof kMagic);
    const auto count = numberIn<std::uint32_t>(takeBytes(bytes, 4));
    const auto words = numberIn<std::uint64_t>(takeBytes(bytes, 8));
    const auto checksum = numberIn<std::uint64_t>(takeBytes(bytes, 8));
    if (!format || words != vocabulary())
        return Diagnostic{Code::baked_version,
                          "this effect was baked by another version of crevice",
                          "bake it again by the crevice that the program is built with"};
    ContentHash hash;
    hash.addBytes(bytes.data(), bytes.size());
    if (hash.value() != checksum) return broken("they are cut short, or damaged");
    if (count > kMostBakedBytes)
        return broken("it has more than " + std::to_string(kMostBakedBytes) + " bytes");
    const std::optional<std::string> records = unpack(bytes, count);
    if (!records) return broken("they cannot be unpacked");
    auto file = std::make_shared<BakedFile>();
    ArchiveReader reader(*records);
    reader.member(*file);
    if (!reader.ok() || !reader.atEnd() || !isWhole(*file)) return broken("they cannot be read");
    std::vector<BakedConfig> baked;
    for (std::size_t i = 0; i < file->entries.size(); ++i) {
        const BakedEntry& entry = file->entries[i];
        baked.push_back(entry.config);
        baked.back().description.planner = std::make_shared<BakedPlans>(file, i);
        for (std::size_t at = 0; at < entry.axes.size(); ++at)
            if (entry.axes[at].kind == BakedAxis::Kind::trait)
                setTrait(*findNamed(kTraits, entry.axes[at].name),
                         entry.choices.front().numbers[at], baked.back().scene);
        baked.back().plan_count = entry.plans.size();
        baked.back().program_count = entry.programs.size();
    }
    return baked;
}

Result<BakedConfig> bakedConfig(std::vector<BakedConfig> baked, std::string_view name)
{
    for (BakedConfig& each : baked)
        if (name.empty() || each.name == name) return std::move(each);
    return notBaked("'" + std::string(name) + "' is not in the baked effect",
                    suggestName(name, namesOf(baked), "it has"));
}

}  // namespace crevice
