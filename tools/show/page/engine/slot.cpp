// SPDX-License-Identifier: MIT
// Loading, changing and describing a config that runs.
#include "tools/show/page/engine/parts.h"

#include <crevice/shipped.h>

#include "core/base/text.h"
#include "core/config/field_types.h"
#include "core/config/values.h"
#include "core/json/merge.h"
#include "tools/commands/cli/load_config.h"
#include "tools/show/plan/print.h"

#include <set>

namespace crevice::page {

namespace {

std::string configPath(const std::string& name) { return "configs/" + name + ".json"; }

void collectFiles(const Node& node, std::set<std::string>& paths)
{
    const auto add = [&paths](const Place& place) {
        if (place.source && !place.source->path.empty()) paths.insert(place.source->path);
    };
    add(node.place);
    for (const Place& origin : node.origins) add(origin);
    for (const Node& item : node.items) collectFiles(item, paths);
    for (const Member& member : node.members) {
        add(member.key_place);
        collectFiles(member.value, paths);
    }
}

/// The config first, then what it is made of.
std::vector<std::string> filesOf(const Node& document, const Description& description,
                                 const std::string& config)
{
    std::set<std::string> paths;
    collectFiles(document, paths);
    for (const auto& file : description.files) paths.insert(file.second->path);
    std::vector<std::string> files = {configPath(config)};
    for (const std::string& path : paths)
        if (!path.empty() && path != files.front()) files.push_back(path);
    return files;
}

/// As the shortest text says it: 1.2, not the double that its float is.
Json plain(float value) { return Json::parse(shortest(value)); }

Json valuesOf(const ParamDesc& param)
{
    auto values = Json::array();
    for (int i = 0; i < componentCount(param.type); ++i) values.push_back(plain(param.value[i]));
    return values;
}

template <class T, class Value>
Json valueIn(const std::vector<T>& list, const std::string& name, Value value)
{
    const T* found = findNamed(list, name);
    return found ? Json(value(*found)) : Json(nullptr);
}

Json paramJson(const ParamDesc& param, const Description& text, const Description& shipped)
{
    return {{"name", param.name},
            {"type", table::word(param.type)},
            {"value", valuesOf(param)},
            {"initial", valueIn(text.params, param.name, valuesOf)},
            {"shipped", valueIn(shipped.params, param.name, valuesOf)},
            {"min", param.min},
            {"max", param.max},
            {"soft_max", param.soft_max},
            {"step", param.step},
            {"unit", param.unit},
            {"label", param.label},
            {"tooltip", param.tooltip},
            {"group", param.group},
            {"bind", table::word(param.bind)},
            {"semantic", table::word(param.semantic)}};
}

Json featureJson(const FeatureDesc& feature, const Description& text, const Description& shipped)
{
    const auto word = [](const FeatureDesc& each) { return each.values[each.value]; };
    return {{"name", feature.name},
            {"boolean", feature.boolean},
            {"values", feature.values},
            {"value", word(feature)},
            {"initial", valueIn(text.features, feature.name, word)},
            {"shipped", valueIn(shipped.features, feature.name, word)},
            {"sets", !feature.sets.empty()},
            {"label", feature.label},
            {"tooltip", feature.tooltip}};
}

/// All that passes write.
Json targetsJson(const Plan& plan)
{
    auto targets = Json::array();
    for (const PlanPass& pass : plan.passes) {
        const auto add = [&](const PlanAttachment& attachment) {
            if (attachment.target < 0) return;
            const PlanTarget& target = plan.targets[attachment.target];
            const PlanTexture& texture = plan.textures[target.texture];
            if (texture.depth > 0) return;  // a volume is no picture to look at
            targets.push_back({{"name", target.name},
                               {"pass", pass.name},
                               {"format", formatInfo(texture.format).name},
                               {"extent", {texture.extent.width, texture.extent.height}}});
        };
        for (const PlanAttachment& color : pass.color) add(color);
        if (pass.has_depth && !isMasked(pass)) add(pass.depth);
    }
    return targets;
}

}  // namespace

Status Slot::load(Device& device, const SourceSet& sources, const SlotRequest& request,
                  Extent extent, const Frame& frame)
{
    const LoadRequest wanted = {request.config, request.variant};
    const Result<Node> document = loadConfig(sources, wanted);
    if (!document) return document.diagnostics();
    Result<Description> description = decode(*document, sources);
    if (!description) return description.diagnostics();
    if (request.file_scene) fitLengths(*description, *document, kShareOfScene);
    for (ParamDesc& param : description->params)  // px stay: only the renderer says what they lack
        if (param.value[2] == 0) param.value = sceneUnits(param, traitsOf(frame), extent.height);
    const std::vector<std::string> files = filesOf(*document, *description, request.config);
    Description text = *description;
    if (request.without_occlusion) description = withoutOcclusion(std::move(*description));

    CompileOptions options{extent};
    std::map<std::string, OutputSource> shown;
    for (const OutputDesc& output : description->outputs) shown[output.name] = {output.name};
    for (const std::string& name : request.outputs)
        if (shown.count(name) > 0) options.outputs.push_back(name);
    if (!request.look.empty() && shown.count(request.look) == 0) {
        const Result<OutputSource> source = exposeOutput(*description, request.look);
        if (!source) return source.diagnostics();
        shown[request.look] = *source;
        options.outputs.push_back(source->output);
    } else if (!request.look.empty()) {
        options.outputs.push_back(request.look);
    }
    const bool again =
        renderer_ && request.config == request_.config && request.variant == request_.variant;
    Diagnostics diagnostics = description.diagnostics();
    const Status started = again ? renderer_->reload(std::move(*description), options)
                                 : start(device, std::move(*description), options, frame);
    append(diagnostics, started.diagnostics());
    if (!started) return diagnostics;
    text_ = std::move(text);
    const Status back = putBack();
    request_ = request;
    shown_ = std::move(shown);
    files_ = files;
    variants_ = variantNames(sources, wanted);
    Result<Description> shipped =
        loadDescription({request.config, request.variant, {}, {}}, shippedSources());
    shipped_ = shipped ? std::move(*shipped) : Description();
    append(diagnostics, back.diagnostics());
    return diagnostics;
}

Status Slot::start(Device& device, Description description, const CompileOptions& options,
                   const Frame& frame)
{
    auto renderer = Renderer::create(device, std::move(description), options, traitsOf(frame));
    if (!renderer) return renderer.diagnostics();
    renderer_ = std::move(*renderer);
    changed_params_.clear();
    changed_features_.clear();
    return {};
}

// A renderer keeps over a reload what knobs changed; here the text says all.
Status Slot::putBack()
{
    Diagnostics diagnostics;
    for (const std::string& name : std::exchange(changed_features_, {})) {
        const FeatureDesc* feature = findNamed(text_.features, name);
        if (!feature) continue;
        append(diagnostics,
               renderer_->setFeature(name, feature->values[feature->value]).diagnostics());
    }
    for (const std::string& name : std::exchange(changed_params_, {})) {
        const ParamDesc* param = findNamed(text_.params, name);
        if (!param) continue;
        append(diagnostics,
               renderer_->setParam(name, param->value.data(), componentCount(param->type))
                   .diagnostics());
    }
    return diagnostics;
}

Status Slot::setParam(const std::string& name, const std::vector<float>& values)
{
    Status status = renderer_->setParam(name, values.data(), static_cast<int>(values.size()));
    if (status) changed_params_.push_back(name);
    return status;
}

Status Slot::setFeature(const std::string& name, const std::string& word)
{
    Status status = renderer_->setFeature(name, word);
    if (!status) return status;
    changed_features_.push_back(name);
    const FeatureDesc* feature = findNamed(renderer_->description().features, name);
    for (const FeatureDesc::Level& level : feature->sets)
        for (const FeatureDesc::Setting& setting : level.settings)
            (findNamed(text_.params, setting.name) ? changed_params_ : changed_features_)
                .push_back(setting.name);
    return status;
}

Result<OutputSource> Slot::sourceOf(const std::string& show) const
{
    const auto found = shown_.find(show);
    if (found != shown_.end() && findNamed(renderer_->plan().outputs, found->second.output))
        return found->second;
    Diagnostic error = {Code::output_missing,
                        "the config '" + request_.config + "' draws no '" + show + "' now"};
    error.help = suggestName(show, namesOf(renderer_->plan().outputs), "outputs");
    return error;
}

Json Slot::state() const
{
    const Description& now = renderer_->description();
    Json json = {{"config", request_.config}, {"variant", request_.variant},
                 {"description", now.text},   {"outputs", namesOf(text_.outputs)},
                 {"variants", variants_},     {"targets", targetsJson(renderer_->plan())},
                 {"files", files_},           {"params", Json::array()},
                 {"features", Json::array()}, {"views", Json::array()}};
    for (const ParamDesc& param : now.params)
        json["params"].push_back(paramJson(param, text_, shipped_));
    for (const FeatureDesc& feature : now.features)
        json["features"].push_back(featureJson(feature, text_, shipped_));
    for (const ViewDesc& view : now.views)
        json["views"].push_back({{"name", view.name},
                                 {"target", view.target.name},
                                 {"scale", plain(view.scale)},
                                 {"offset", plain(view.offset)}});
    return json;
}

Result<std::string> Slot::patch(const SourceSet& sources) const
{
    if (!shippedSources().find(configPath(request_.config)))
        return sources.find(configPath(request_.config))->text;
    const Result<Node> base = loadConfig(shippedSources(), {request_.config});
    if (!base) return base.diagnostics();
    Result<Node> now = loadConfig(sources, {request_.config, request_.variant});
    if (!now) return now.diagnostics();
    return patchText(*base, std::move(*now), {request_.config}, sources);
}

}  // namespace crevice::page
