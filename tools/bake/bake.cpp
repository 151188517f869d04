// SPDX-License-Identifier: MIT
// From configs to plans for each combination of what is listed, and from these to bytes.
#include "tools/bake/bake.h"

#include "core/bake/records.h"
#include "core/base/text.h"
#include "core/config/values.h"
#include "core/plan/sizes.h"

#include <crevice/compile.h>

#include <cmath>
#include <map>
#include <set>

namespace crevice {
namespace {

constexpr Extent kExtent = {960, 540};  ///< Any will do: plans do not depend on it.

Diagnostic usage(std::string message, std::string help)
{
    return {Code::usage, std::move(message), std::move(help)};
}

template <class T>
std::string bytesOf(const T& record)
{
    ArchiveWriter writer;
    writer.member(record);
    return std::move(writer.bytes);
}

/// Where the list has it; where it has not, it is added.
template <class T>
int indexIn(std::vector<T>& list, T record)
{
    const std::string bytes = bytesOf(record);
    const auto known = std::find_if(list.begin(), list.end(),
                                    [&](const T& each) { return bytesOf(each) == bytes; });
    const auto index = static_cast<int>(known - list.begin());
    if (known == list.end()) list.push_back(std::move(record));
    return index;
}

/// A device that has all that configs ask for: what one lacks is seen where the effect runs.
DeviceCaps ampleCaps()
{
    DeviceCaps caps = minimumCaps();
    caps.version = 320;
    caps.max_texture_size = 16384;
    caps.max_volume_size = 2048;
    for (const FormatInfo& info : allFormats()) {
        caps.renderable[static_cast<int>(info.format)] = true;
        caps.sample_counts[static_cast<int>(info.format)] = ~0u;
    }
    return caps;
}

/// Something that has several values among the plans, and sets one of them.
struct Choice {
    std::string name;
    std::vector<double> numbers;
    BakedAxis::Kind kind;
};

/// The words of a feature, the numbers of a param, or what a trait can be.
Result<Choice> readFeature(const FeatureDesc& feature, const BakeValues& listed)
{
    Choice choice{feature.name, {}, BakedAxis::Kind::feature};
    for (const std::string& word : listed.values) {
        const auto found = std::find(feature.values.begin(), feature.values.end(), word);
        if (found == feature.values.end())
            return usage("feature '" + feature.name + "' has no value '" + word + "'",
                         suggestName(word, feature.values, feature.name));
        choice.numbers.push_back(double(found - feature.values.begin()));
    }
    return choice;
}

Result<Choice> readParam(const ParamDesc& param, const BakeValues& listed)
{
    Choice choice{param.name, {}, BakedAxis::Kind::param};
    for (const std::string& text : listed.values) {
        const std::optional<double> number = parseNumber(text);
        const float value = static_cast<float>(number.value_or(0));
        const Status fits = checkValue(param, &value, 1);
        if (!number || componentCount(param.type) != 1)
            return usage("'" + text + "' is no value of param '" + param.name + "'",
                         "write --values " + param.name + "=" + shortest(param.value[0]));
        if (!fits) return fits.diagnostics();
        choice.numbers.push_back(value);
    }
    return choice;
}

Result<Choice> readTrait(const BakeValues& listed)
{
    const TraitInfo* const trait = findNamed(kTraits, listed.name);
    if (!trait)
        return usage("there is no trait '" + listed.name + "'",
                     suggestName(listed.name, namesOf(kTraits), "traits"));
    Choice choice{listed.name, {}, BakedAxis::Kind::trait};
    for (const std::string& text : listed.values) {
        const std::optional<double> number = text == "true"    ? 1
                                             : text == "false" ? 0
                                                               : parseNumber(text);
        const bool whole = number && *number == std::floor(*number);
        if (!whole || *number < 0 || *number > trait->most)
            return usage("'" + text + "' is no value of trait '" + listed.name + "'",
                         trait->flag ? "write true or false" : "write a whole number");
        choice.numbers.push_back(*number);
    }
    return choice;
}

void apply(const Choice& choice, double number, Description& description, SceneTraits& traits)
{
    switch (choice.kind) {
    case BakedAxis::Kind::feature: {
        const int at = indexOf(description.features, choice.name);
        description.features[static_cast<std::size_t>(at)].value = static_cast<int>(number);
        return applyLevel(description, choice.name);
    }
    case BakedAxis::Kind::trait: {
        const TraitInfo& trait = *findNamed(kTraits, choice.name);
        if (trait.flag)
            traits.*trait.flag = number != 0;
        else
            traits.*trait.count = static_cast<int>(number);
        return;
    }
    case BakedAxis::Kind::param:
    case BakedAxis::Kind::no_op: {
        const int at = indexOf(description.params, choice.name);
        ParamDesc& param = description.params[static_cast<std::size_t>(at)];
        param.value = {};
        std::fill_n(param.value.begin(), componentCount(param.type), static_cast<float>(number));
    }
    }
}

/// A value of the param at which no pass is a no-op, and those at which one is.
Choice noOpChoice(const ParamDesc& param, const std::set<float>& at)
{
    Choice choice{param.name, {at.begin(), at.end()}, BakedAxis::Kind::no_op};
    const bool whole = param.type == ParamType::int_;
    const double middle = (std::max(param.min, -1e6) + std::min(param.max, 1e6)) / 2;
    if (isRelative(param) || at.count(param.value[0]) == 0) return choice;
    for (const double other : {param.max, param.min, whole ? std::floor(middle) : middle}) {
        if (at.count(static_cast<float>(other)) > 0) continue;
        choice.numbers.insert(choice.numbers.begin(), other);
        break;
    }
    return choice;
}

/// One config on its way into the file.
class Baker {
public:
    Baker(const BakeRequest& request, const BakeOptions& options, BakedFile& file)
        : request_(request),
          options_(options),
          file_(file),
          base_(request.description)
    {
        entry_.config.name = request.name;
        entry_.config.set = request.set;
        entry_.config.ms = request.ms;
        entry_.config.error = request.error;
        base_.limits.bytes = std::numeric_limits<double>::infinity();
        compile_.extent = kExtent;
        compile_.outputs = options.outputs;
    }

    Result<BakedEntry> run()
    {
        if (const Status read = readChoices(); !read) return read.diagnostics();
        if (const Status planned = planAll(0, base_, options_.scene); !planned)
            return planned.diagnostics();
        findAxes();
        choosePlans();
        keepWhatRuns();
        for (const Choice& choice : choices_) {
            const FeatureDesc* const feature = findNamed(base_.features, choice.name);
            const auto decides_it = [&](const BakedAxis& axis) {
                return axis.name == choice.name && axis.kind == choice.kind;
            };
            if (choice.kind == BakedAxis::Kind::no_op || anyOf(entry_.axes, decides_it) ||
                (feature && !feature->sets.empty()))
                continue;
            warnings_.push_back(
                asWarning(usage("'" + choice.name + "' decides no plan of '" + request_.name + "'",
                                "leave it out: each value of it can be set at run time")));
        }
        return {std::move(entry_), std::move(warnings_)};
    }

private:
    /// What was planned for one combination.
    struct Planned {
        Values values;
        SceneTraits traits;
        int plan;
    };

    Status readChoices()
    {
        for (const bool sets : {true, false})  // what sets others comes first
            for (const BakeValues& listed : options_.values) {
                const FeatureDesc* const feature = findNamed(base_.features, listed.name);
                if (feature && feature->sets.empty() == sets) continue;
                const ParamDesc* const param = findNamed(base_.params, listed.name);
                if (!feature && (!param || sets)) continue;
                const auto read =
                    feature ? readFeature(*feature, listed) : readParam(*param, listed);
                if (!read) return read.diagnostics();
                choices_.push_back(*read);
            }
        std::map<std::string, std::set<float>> no_ops;
        for (const PassDesc& pass : base_.passes)
            for (const NoOpDesc& no_op : pass.no_op) no_ops[no_op.name].insert(no_op.at);
        for (const auto& [name, at] : no_ops)
            if (const ParamDesc* const param = findNamed(base_.params, name))
                choices_.push_back(noOpChoice(*param, at));
        for (const BakeValues& listed : options_.traits) {
            const auto read = readTrait(listed);
            if (!read) return read.diagnostics();
            choices_.push_back(*read);
        }
        return {};
    }

    Status planAll(std::size_t index, const Description& description, const SceneTraits& traits)
    {
        if (index == choices_.size()) return planOne(description, traits);
        const Choice& choice = choices_[index];
        if (choice.kind == BakedAxis::Kind::no_op)  // as it is, relative to the scene perhaps
            if (const Status as_is = planAll(index + 1, description, traits); !as_is) return as_is;
        for (const double number : choice.numbers) {
            Description set = description;
            SceneTraits scene = traits;
            apply(choice, number, set, scene);
            if (const Status planned = planAll(index + 1, set, scene); !planned) return planned;
        }
        return {};
    }

    Status planOne(const Description& description, const SceneTraits& traits)
    {
        if (planned_.size() == kMostBakedPlans * 4)
            return usage("'" + request_.name + "' needs more than " +
                             std::to_string(kMostBakedPlans) + " plans",
                         "list fewer values, or bake two effects");
        Result<Plan> plan = compile(description, traits, ampleCaps(), compile_);
        if (!plan) return plan.diagnostics();
        if (planned_.empty()) warnings_ = plan.diagnostics();
        for (PlanPass& pass : plan->passes) {
            const PlanProgram& program = plan->programs[static_cast<std::size_t>(pass.program)];
            const Result<int> index = addProgram(program);
            if (!index) return index.diagnostics();
            pass.program = *index;
            used_.insert(pass.name);
            for (const PlanAttachment& color : pass.color) used_.insert(color.name);
            for (PlanUniform& uniform : pass.uniforms)
                if (uniform.source == UniformSource::kernel) uniform.count = 1;
        }
        for (PlanTarget& target : plan->targets) {
            used_.insert(target.name);
            target.history_texture = std::min(target.history_texture, 0);
        }
        for (GeneratorDesc& each : plan->generated) each.count = 1;
        for (ImportDesc& each : plan->imports) each.format = ImportDesc().format;
        outputs_ = namesOf(plan->outputs);
        const std::string record = bytesOf(*plan);
        const auto known = plans_.try_emplace(record, int(entry_.plans.size()));
        if (known.second) entry_.plans.push_back(record);
        planned_.push_back({valuesOf(description), traits, known.first->second});
        return {};
    }

    Result<int> addProgram(const PlanProgram& program)
    {
        const ShaderDesc& shader = *findNamed(base_.shaders, program.label);
        const Result<int> vertex = addText(program.vertex, shader);
        const Result<int> fragment = addText(program.fragment, shader);
        if (!vertex) return vertex.diagnostics();
        if (!fragment) return fragment.diagnostics();
        return indexIn(entry_.programs, {program.label, *vertex, *fragment});
    }

    /// The index of a stage's text, which is added where it is new.
    Result<int> addText(const GlslStage& stage, const ShaderDesc& shader)
    {
        const auto known = stages_.find({shader.name, stage.text});
        if (known != stages_.end()) return known->second;
        std::vector<std::string> given;  // by the config, and not for all time by the shader itself
        for (const std::string& name : stage.defines_used)
            if (shader.defines.count(name) == 0) given.push_back(name);
        BakedText text;
        const std::size_t version = stage.text.find(' ') + 1;
        text.version = stage.text.substr(version, stage.text.find('\n') - version);
        std::vector<std::string> late;
        for (const std::string& name : lateMacros(stage.text, given)) {
            for (const std::string& texture : textureNames(base_))
                if (stepDefine(texture) == name)
                    text.steps.push_back(texture), late.push_back(name);
            for (const ParamDesc& param : base_.params)
                if (param.bind == Bind::define && upperCase(param.name) == name)
                    text.values.push_back(param.name), late.push_back(name);
        }
        used_.insert(text.steps.begin(), text.steps.end());
        for (const std::string& name : given)
            if (!contains(late, name)) deciding_.insert(name);
        Result<std::string> body = stripped(stage.text, late);
        if (!body) return body.diagnostics();
        text.body = std::move(*body);
        return stages_[{shader.name, stage.text}] = indexIn(file_.texts, std::move(text));
    }

    bool decides(const std::string& name, const std::string& define) const
    {
        const auto tested = [&](const PassDesc& pass) { return findNamed(pass.when, name); };
        const auto mentioned = [&](const std::string& each) {
            return each == define || startsWith(each, define + "_");
        };
        return anyOf(base_.passes, tested) || anyOf(deciding_, mentioned);
    }

    /// What texts or conditions mention; the direction of depth, which states depend on; no-ops.
    void findAxes()
    {
        for (const FeatureDesc& each : base_.features)
            if (decides(each.name, upperCase(each.name)))
                entry_.axes.push_back({BakedAxis::Kind::feature, each.name});
        for (const ParamDesc& each : base_.params)
            if (each.bind == Bind::define && deciding_.count(upperCase(each.name)) > 0)
                entry_.axes.push_back({BakedAxis::Kind::param, each.name});
        for (const TraitInfo& each : kTraits)
            if (decides(each.name, each.define) || each.flag == &SceneTraits::reversed_depth)
                entry_.axes.push_back({BakedAxis::Kind::trait, each.name});
        for (const PassDesc& pass : base_.passes)
            for (const NoOpDesc& no_op : pass.no_op) {
                BakedAxis axis{BakedAxis::Kind::no_op, no_op.name, no_op.at};
                for (const NoOpDesc::Gives& each : no_op.gives)
                    if (!each.constant) axis.given.push_back({each.name, each.input.name});
                indexIn(entry_.axes, std::move(axis));
            }
    }

    void choosePlans()
    {
        std::set<std::vector<float>> known;
        Description description = base_;
        for (const Planned& each : planned_) {
            for (std::size_t i = 0; i < each.values.params.size(); ++i)
                description.params[i].value = each.values.params[i];
            for (std::size_t i = 0; i < each.values.features.size(); ++i)
                description.features[i].value = each.values.features[i];
            BakedChoice choice{{}, each.plan};
            for (const BakedAxis& axis : entry_.axes)
                choice.numbers.push_back(
                    numberOf(axis, description, each.traits, ampleCaps(), kExtent.height));
            if (known.insert(choice.numbers).second) entry_.choices.push_back(std::move(choice));
        }
    }

    /// The description without what no plan needs, and what its choice of formats looks at.
    void keepWhatRuns()
    {
        Description& kept = entry_.config.description;
        kept = base_;
        for (bool more = true; more;) {  // sizes follow those of others
            more = false;
            for (const TargetDesc& each : base_.targets)
                if (used_.count(each.name) > 0 && !each.size.of.empty())
                    more = used_.insert(each.size.of.name).second || more;
            for (const BakedAxis& axis : entry_.axes)
                for (const BakedAxis::Given& each : axis.given)
                    for (const std::string& name : {each.replaced, each.by})
                        more = used_.insert(name).second || more;
        }
        const auto named = [this](const Named& each) { return used_.count(each.name) > 0; };
        eraseIf(kept.targets, [&](const TargetDesc& each) { return !named(each); });
        for (TargetDesc& each : kept.targets)  // an import's size is the view's
            if (!findNamed(kept.targets, each.size.of.name)) each.size.of = {};
        eraseIf(kept.passes, [&](const PassDesc& each) {
            const bool draws =
                each.type == PassType::draw && findNamed(kept.targets, each.depth.name);
            return !named(each) && !draws && !anyOf(each.inputs, [](const InputDesc& input) {
                return input.has_filter && input.filter == Filter::linear;
            });
        });
        eraseIf(kept.outputs,
                [this](const OutputDesc& each) { return !contains(outputs_, each.name); });
    }

    const BakeRequest& request_;
    const BakeOptions& options_;
    BakedFile& file_;
    Description base_;
    CompileOptions compile_;
    std::vector<Choice> choices_;
    std::vector<Planned> planned_;
    std::map<std::string, int> plans_;                           // by their records
    std::map<std::pair<std::string, std::string>, int> stages_;  // by shader and whole text
    std::set<std::string> used_;                                 // passes and targets
    std::set<std::string> deciding_;  // macros that texts mention, but for those that are late
    std::vector<std::string> outputs_;
    BakedEntry entry_;
    Diagnostics warnings_;
};

/// Values of what no config has.
Status checkListed(const std::vector<BakeRequest>& requests, const BakeOptions& options)
{
    for (const BakeValues& listed : options.values) {
        std::vector<std::string> names;
        for (const BakeRequest& each : requests) {
            for (const FeatureDesc& feature : each.description.features)
                names.push_back(feature.name);
            for (const ParamDesc& param : each.description.params) names.push_back(param.name);
        }
        if (!contains(names, listed.name))
            return usage("there is no feature or param '" + listed.name + "'",
                         suggestName(listed.name, names, "features and params"));
    }
    return {};
}

}  // namespace

Result<std::string> bake(const std::vector<BakeRequest>& requests, const BakeOptions& options)
{
    if (const Status known = checkListed(requests, options); !known) return known.diagnostics();
    BakedFile file;
    Diagnostics warnings;
    for (const BakeRequest& each : requests) {
        Result<BakedEntry> entry = Baker(each, options, file).run();
        append(warnings, entry.diagnostics());
        if (!entry) return warnings;
        file.entries.push_back(std::move(*entry));
    }
    const std::string records = bytesOf(file);
    if (records.size() > kMostBakedBytes)
        return usage("the effect would have " + std::to_string(records.size()) + " bytes",
                     "list fewer values, or bake two effects");
    const std::string packed = pack(records);
    ContentHash hash;
    hash.addBytes(packed.data(), packed.size());
    const auto count = static_cast<std::uint32_t>(records.size());
    const std::uint64_t words = vocabulary(), checksum = hash.value();
    std::string bytes(kMagic, sizeof kMagic);
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(&words), sizeof words);
    bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    return {bytes + packed, std::move(warnings)};
}

}  // namespace crevice
