// SPDX-License-Identifier: MIT
// What a config declares and nothing uses: surely misspelt.
#include "core/config/decode_steps.h"

#include <crevice/glsl_stage.h>

#include "core/base/text.h"
#include "core/glsl/lexer.h"
#include "core/json/override.h"

#include <algorithm>
#include <optional>
#include <set>

namespace crevice::table {

namespace {

// Only what the config's own file and overrides declare is looked at: a module may well declare
// more than one config uses, and deleting a pass leaves what fed it behind.
class UseChecker {
public:
    UseChecker(const Node& document, const Description& description)
        : root_(document.place.source),
          patched_(!document.origins.empty()),
          description_(description)
    {
    }

    Diagnostics run()
    {
        collect();
        check(description_.params, "param", "params", "no shader, size, count or no_op");
        check(description_.features, "feature", "features", "no condition and no shader");
        check(description_.generated, "generated", "generated values", "no shader and no input");
        check(description_.imports, "import", "imports", "no shader and no input");
        check(description_.targets, "target", "targets", "no pass, output or view");
        check(description_.shaders, "shader", "shaders", "no pass");
        check(description_.interfaces, "interface", "interfaces", "no #include");
        return std::move(found_);
    }

private:
    void collect();
    void collectPass(const PassDesc& pass);
    bool inGlsl(const std::string& word);
    bool isOwn(const Named& each) const
    {
        const SourceRef& writer = each.place.source;
        return writer == root_ || (writer && writer->path == kOverridePath);
    }
    bool used(const Named& each) { return used_.count(each.name) > 0; }
    bool used(const ParamDesc& param);
    bool used(const FeatureDesc& feature);
    bool used(const GeneratedDesc& each) { return used(Named(each)) || inGlsl(each.name); }
    bool used(const ImportDesc& each);
    bool used(const TargetDesc& target);

    template <class T>
    void check(const std::vector<T>& list, const char* what, const char* heading,
               const char* readers);

    const SourceRef root_;
    const bool patched_;
    const Description& description_;
    Diagnostics found_;
    std::set<std::string> used_;
    std::optional<std::set<std::string, std::less<>>> words_;  // of all GLSL; read when needed
};

void UseChecker::collectPass(const PassDesc& pass)
{
    used_.insert({pass.shader.name, pass.depth.name});
    for (const Reference& each : pass.color) used_.insert(each.name);
    for (const Condition::Term& each : pass.when.terms) used_.insert(each.subject.name);
    for (const BypassDesc& each : pass.bypass) used_.insert(each.input.name);
    for (const NoOpDesc& each : pass.no_op) used_.insert(each.param.name);
    used_.insert({pass.frustum_scale_param.name, pass.mask.name, pass.cull_below_pixel.name});
    for (const InputDesc& each : pass.inputs) used_.insert(each.from.name);
}

void UseChecker::collect()
{
    for (const PassDesc& each : description_.passes) collectPass(each);
    for (const GeneratedDesc& each : description_.generated) used_.insert(each.count_param.name);
    for (const TargetDesc& each : description_.targets)
        used_.insert({each.size.of.name, each.size.scale_param.name, each.samples_param.name});
    for (const OutputDesc& each : description_.outputs) used_.insert(each.target.name);
    for (const ViewDesc& each : description_.views) used_.insert(each.target.name);
    for (const auto& file : description_.files)
        for (const GlslInclude& include : findIncludes(file.second))
            if (include.interface) used_.insert(include.name);
}

bool UseChecker::inGlsl(const std::string& word)
{
    if (!words_) {
        words_.emplace();
        for (const auto& file : description_.files) {
            const BlankedText blanked = blankComments(file.second->text);
            GlslTokens tokens;
            tokenize(blanked.text, 0, 1, tokens);
            for (const GlslToken& token : tokens)
                if (token.kind == GlslToken::Kind::identifier) words_->emplace(token.text);
        }
    }
    return words_->count(word) > 0;
}

bool UseChecker::used(const ParamDesc& param)
{
    const bool define = param.bind == Bind::define;
    return used(Named(param)) || inGlsl(define ? upperCase(param.name) : param.name);
}

bool UseChecker::used(const FeatureDesc& feature)
{
    return !feature.sets.empty() || used(Named(feature)) || inGlsl(upperCase(feature.name));
}

// A camera, draw list and lights are known by their type; a config may rest on the frame without
// naming them in any shader.
bool UseChecker::used(const ImportDesc& each)
{
    return each.type != ImportType::texture || used(Named(each)) || inGlsl(each.name);
}

bool UseChecker::used(const TargetDesc& target)
{
    return used(Named(target)) || inGlsl(target.name) ||
           (target.history && inGlsl(historyName(target)));
}

template <class T>
void UseChecker::check(const std::vector<T>& list, const char* what, const char* heading,
                       const char* readers)
{
    std::vector<std::string> others;
    for (const T& each : list) {
        if (!isOwn(each) || used(each)) continue;
        if (others.empty())
            for (const T& other : list)
                if (!isOwn(other) || used(other)) others.push_back(other.name);
        found_.push_back({Code::unused_name,
                          std::string(what) + " '" + each.name +
                              "' is used by nothing: " + readers + " names it",
                          "", each.place, each.pointer});
        Diagnostic& error = found_.back();
        error.help =
            others.empty() ? "use it or leave it out" : suggestName(each.name, others, heading);
        // What a variant takes away may leave something unused that is well used without it.
        if (patched_ && each.place.source == root_) error.severity = Severity::warning;
    }
}

}  // namespace

Diagnostics unusedNames(const Node& document, const Description& description)
{
    return UseChecker(document, description).run();
}

}  // namespace crevice::table
