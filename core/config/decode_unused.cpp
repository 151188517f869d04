// SPDX-License-Identifier: MIT
// What a config declares and nothing uses: surely misspelt.
#include "core/config/decode_steps.h"

#include <crevice/glsl_stage.h>

#include "core/base/text.h"
#include "core/glsl/lexer.h"
#include "core/json/override.h"

#include <algorithm>
#include <optional>

namespace crevice::table {

namespace {

// Only what the config's own file, modules on disk and overrides declare is looked at: a shipped
// module may well declare more than one config uses, and deleting a pass leaves what fed it behind.
struct UseChecker {
    const Node& document;
    const Description& description;
    std::set<std::string> names;  // that something uses
    Diagnostics found = {};
    std::optional<std::set<std::string, std::less<>>> words = {};  // of all GLSL; read when needed

    Diagnostics run()
    {
        for (const auto& file : description.files)
            for (const GlslInclude& include : findIncludes(file.second))
                if (include.interface) names.insert(include.name);
        check(description.params, "param", "params", "no shader, size, count or no_op");
        check(description.features, "feature", "features", "no condition and no shader");
        check(description.generated, "generated", "generated values", "no shader and no input");
        check(description.imports, "import", "imports", "no shader and no input");
        check(description.targets, "target", "targets", "no pass, output or view");
        check(description.shaders, "shader", "shaders", "no pass");
        check(description.interfaces, "interface", "interfaces", "no #include");
        return std::move(found);
    }

    bool inGlsl(const std::string& word)
    {
        if (!words) {
            words.emplace();
            for (const auto& file : description.files) {
                const BlankedText blanked = blankComments(file.second->text);
                GlslTokens tokens;
                tokenize(blanked.text, 0, 1, tokens);
                for (const GlslToken& token : tokens)
                    if (token.kind == GlslToken::Kind::identifier) words->emplace(token.text);
            }
        }
        return words->count(word) > 0;
    }

    bool used(const Named& each) { return names.count(each.name) > 0; }

    bool used(const ParamDesc& each)
    {
        const bool define = each.bind == Bind::define;
        return used(Named(each)) || inGlsl(define ? upperCase(each.name) : each.name);
    }

    bool used(const FeatureDesc& each)
    {
        return !each.sets.empty() || used(Named(each)) || inGlsl(upperCase(each.name));
    }

    bool used(const GeneratedDesc& each) { return used(Named(each)) || inGlsl(each.name); }

    // A camera, draw list and lights are known by their type; a config may rest on the frame
    // without naming them in any shader.
    bool used(const ImportDesc& each)
    {
        return each.type != ImportType::texture || used(Named(each)) || inGlsl(each.name);
    }

    bool used(const TargetDesc& each)
    {
        return used(Named(each)) || inGlsl(each.name) ||
               (each.history && inGlsl(historyName(each)));
    }

    bool isOwn(const Named& each) const
    {
        const SourceRef& writer = each.place.source;
        return writer == document.place.source ||
               (writer && (writer->path.empty() || writer->path == kOverridePath));
    }

    template <class T>
    void check(const std::vector<T>& list, const std::string& what, const char* heading,
               const std::string& readers)
    {
        std::vector<const T*> unused;
        std::vector<std::string> others;
        for (const T& each : list) {
            if (isOwn(each) && !used(each))
                unused.push_back(&each);
            else
                others.push_back(each.name);
        }
        for (const T* each : unused) {
            if (found.size() == kMaxDiagnostics) return;
            found.push_back(
                {Code::unused_name,
                 what + " '" + each->name + "' is used by nothing: " + readers + " names it",
                 others.empty() ? "use it or leave it out"
                                : suggestName(each->name, others, heading),
                 each->place, each->pointer});
            // What a variant takes away may leave something unused that is well used without it,
            // and what a module declares may be used in another config.
            const bool own = each->place.source == document.place.source;
            if (own ? !document.origins.empty() : each->place.source->path.empty())
                found.back().severity = Severity::warning;
        }
    }
};

}  // namespace

Diagnostics unusedNames(const Node& document, const Description& description,
                        std::set<std::string> referred)
{
    return UseChecker{document, description, std::move(referred)}.run();
}

}  // namespace crevice::table
