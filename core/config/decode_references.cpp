// SPDX-License-Identifier: MIT
// Names that collide, sizes that follow each other, references to nothing or to what may not be.
#include "core/config/decode_report.h"

#include "core/config/field_types.h"
#include "core/config/values.h"
#include "core/frame/frame_math.h"
#include "core/sampling/generators.h"

namespace crevice::table {
namespace {

// What a reference of some kind may name.
struct Names {
    std::string what;                   // "target"
    std::string listed;                 // "targets", the heading of suggestions
    Code code;                          // when there is no such name
    std::vector<std::string> sections;  // that declare them
    std::vector<std::string> all = {};
};

bool isCount(std::string_view text) { return !text.empty() && allOf(text, isDigit); }

struct Checker {
    const Node& document;
    const Description& description;
    Report& report;
    Names targets = {"target", "targets", Code::target_missing, {"targets"}};
    Names sized = {"target", "targets", Code::target_missing, {"targets", "imports"}};
    Names inputs = {"target", "targets", Code::target_missing, {"targets", "generated", "imports"}};
    Names shaders = {"shader", "shaders", Code::shader_missing, {"shaders"}};
    Names params = {"param", "params", Code::reference_missing, {"params"}};
    Names passes = {"pass", "passes", Code::reference_missing, {"passes"}};
    Names boxes = {"box", "boxes", Code::reference_missing, {"boxes"}};
    Names subjects = {"feature or trait", "names", Code::feature_missing, {"features"}};
    std::set<std::string> named = {};

    std::set<std::string> run()
    {
        targets.all = sized.all = namesOf(description.targets);
        inputs.all = textureNames(description);
        for (const ImportDesc& each : description.imports)
            if (each.type == ImportType::texture) sized.all.push_back(each.name);
        if (inputs.all.size() > targets.all.size()) inputs.listed = "targets and textures";
        shaders.all = namesOf(description.shaders);
        params.all = namesOf(description.params);
        passes.all = namesOf(description.passes);
        boxes.all = namesOf(description.boxes);
        subjects.all = namesOf(description.features);
        for (const TraitInfo& trait : kTraits) subjects.all.push_back(trait.name);
        for (const GeneratedDesc& each : description.generated)
            expectNumber(each.count_param, "generated '" + each.name + "'", "count",
                         ParamType::int_, range(1, mostCount(each.generator)));
        for (const BoxDesc& each : description.boxes)
            expectProduct(each.edge, "box '" + each.name + "'", "edge", each,
                          range(1e-12, kMaxParam));
        for (const TargetDesc& each : description.targets) {
            const std::string who = "target '" + each.name + "'";
            expectProduct(each.size.width, who, "width", each, range(1, 16384));
            expectProduct(each.size.height, who, "height", each, range(1, 16384));
            expectProduct(each.size.depth, who, "depth", each, range(1, 16384));
            expect(each.size.of, who + " follows the size of", sized);
            if (!each.size.optional || contains(params.all, each.size.scale_param.name))
                expectNumber(each.size.scale_param, who, "scale", ParamType::float_,
                             range(smallestScale(each.size), kLargestScale));
            expectNumber(each.samples_param, who, "samples", ParamType::int_,
                         range(1, kMaxSamples));
        }
        for (const PassDesc& each : description.passes) checkPass(each);
        for (const OutputDesc& each : description.outputs)
            expectPicture(each.target, "output '" + each.name + "' exports");
        for (const ViewDesc& each : description.views)
            expectPicture(each.target, "view '" + each.name + "' shows");
        return std::move(named);
    }

    // True too when the reference was not written, or is explained by an error already reported.
    bool known(const Reference& reference, const Names& names) const
    {
        const auto broken = [&](const std::string& section) {
            return report.errorAt("/" + section);
        };
        return reference.pointer.empty() || contains(names.all, reference.name) ||
               anyOf(names.sections, broken);
    }

    void expect(const Reference& reference, const std::string& who, const Names& names)
    {
        named.insert(reference.name);
        if (known(reference, names)) return;
        if (report.full()) return report.count();
        const bool target = names.code == Code::target_missing;
        const std::string makers =
            target ? modulesThatDeclare(report.sources, "targets", reference.name) : "";
        Reported& error =
            report.at(reference, names.code,
                      who + " " + names.what + " '" + reference.name + "', which does not exist",
                      makers.empty() ? suggestName(reference.name, names.all, names.listed)
                                     : "add a module that makes it to 'extends': " + makers);
        if (names.code == Code::feature_missing) error.help += "; or declare it under 'features'";
        error.mistake = names.what + " " + reference.name;
        if (isModule(reference.place)) error.cause = ownPlace(reference.place);
        for (const Named& each : description.deleted) {
            for (const std::string& section : names.sections) {
                const std::string pointer = memberPointer("", section);
                if (each.pointer != pointer &&
                    each.pointer != memberPointer(pointer, reference.name))
                    continue;
                error.notes.push_back({each.place, "it was deleted here"});
                error.help = "leave the null out, or delete what names it too; " + error.help;
                if (isModule(reference.place)) error.cause = each.place;
            }
        }
    }

    bool isVolume(const Reference& target) const
    {
        const TargetDesc* desc = findNamed(description.targets, target.name);
        return desc && crevice::isVolume(*desc);
    }

    void expectPicture(const Reference& target, const std::string& who)
    {
        expect(target, who, targets);
        if (isVolume(target))
            report.at(target, Code::attachment_kind,
                      who + " '" + target.name + "', which is a volume and no picture",
                      "let a pass draw what is to be seen of it into a picture");
    }

    // Nothing stands in for a volume.
    void expectStandIn(const PassDesc& pass, const Reference& target, const std::string& verb)
    {
        checkAttached(pass, target, verb);
        if (isVolume(target))
            report.at(target, Code::attachment_kind,
                      "pass '" + pass.name + "' " + verb + " '" + target.name +
                          "', a volume, which nothing can stand in for",
                      "say so of the pass that reads it");
    }

    // A number that is taken from a param: that must fit, and start inside the limits.
    void expectNumber(const Reference& name, const std::string& who, const std::string& number,
                      ParamType type, const Rule& limits)
    {
        const std::string takes = who + " takes its " + number + " from";
        expect(name, takes, params);
        const ParamDesc* param = findNamed(description.params, name.name);
        if (!param || report.errorWithin(param->pointer)) return;
        if (param->type != ParamType::int_ && param->type != type) {
            std::vector<std::string> others;
            for (const ParamDesc& each : description.params)
                if (each.type == type) others.push_back(each.name);
            report.at(name, Code::reference_missing,
                      takes + " param '" + name.name + "', which has another type",
                      "give '" + name.name + "' the type \"" + word(type) + "\"" +
                          (others.empty() ? "" : ", or name one that has it: " + joined(others)));
        } else if (!(param->value[0] >= limits.min && param->value[0] <= limits.max)) {
            const Reference value = referenceAt(document, param->pointer + "/default");
            Reported& error = report.at(
                value, Code::out_of_range,
                param->name + " default " + value.name + " is outside [" + numberText(limits.min) +
                    ", " + numberText(limits.max) + "], the " + number + "s that " + who +
                    " may have",
                "stay inside the range, and let '" + param->name + "' have it as min and max");
            error.notes.push_back({name.place, "the " + number + " is taken from it here"});
        }
    }

    // Numbers of one component, whose product at their defaults fits.
    void expectProduct(const ProductDesc& product, const std::string& who, const std::string& what,
                       const Named& at, const Rule& limits)
    {
        for (const Reference& each : product.params) {
            expectNumber(each, who, what, ParamType::float_, Rule());
            const ParamDesc* param = findNamed(description.params, each.name);
            if (!param || report.errorAt(each.pointer) || report.errorWithin(param->pointer))
                return;
        }
        if (product.params.empty() || product.factor == 0) return;
        const double value = valueOf(product, description.params);
        if (value >= limits.min && value <= limits.max) return;
        report.at(at, Code::out_of_range,
                  who + " has the " + what + " " + numberText(value) + ", which is outside [" +
                      numberText(limits.min) + ", " + numberText(limits.max) + "]",
                  "change " + joined(namesOf(product.params), " or "));
    }

    void checkPass(const PassDesc& pass)
    {
        if (report.errorAt(pass.pointer)) return;  // it is a patch of none
        const std::string who = "pass '" + pass.name + "' ";
        expect(pass.shader, who + "runs", shaders);
        expect(pass.box, who + "draws by the view of", boxes);
        checkWrites(pass);
        checkOver(pass);
        for (const ClearDesc& each : pass.clear) checkAttached(pass, each, "clears");
        checkUndrawn(pass);
        for (const Condition& each : pass.when) checkTerm(pass, each);
        for (const BypassDesc& each : pass.bypass) {
            expectStandIn(pass, each, "bypasses");
            expect(each.input, who + "reads", targets);
        }
        for (const NoOpDesc& each : pass.no_op) {
            expect(each, who + "is a no-op at a value of", params);
            for (const NoOpDesc::Gives& gives : each.gives) {
                expectStandIn(pass, gives, "gives");
                expect(gives.input, who + "reads", targets);
            }
        }
        expect(pass.frustum_scale_param, who + "has as frustum scale", params);
        for (const PreservesConstantDesc& each : pass.preserves_constant)
            expectStandIn(pass, each, "preserves as constant");
        for (const InputDesc& each : pass.inputs) checkInput(pass, each);
    }

    void checkWrites(const PassDesc& pass)
    {
        std::vector<Reference> all = pass.color;
        all.push_back(pass.depth);
        std::set<std::string> written;
        for (const Reference& target : all) {
            expect(target, "pass '" + pass.name + "' writes", targets);
            const bool depth = target.pointer == pass.depth.pointer;
            if (!isOfKind(
                    target, depth,
                    "pass '" + pass.name + (depth ? "' writes as depth" : "' writes as colour")))
                continue;
            if (target.pointer.empty() || isVolume(target) || written.insert(target.name).second)
                continue;
            report.at(target, Code::two_writers,
                      "pass '" + pass.name + "' writes target '" + target.name + "' twice",
                      "give each output of the shader a target of its own");
        }
    }

    // A pass that is drawn over writes a colour target of this one, and is not drawn over itself.
    void checkOver(const PassDesc& pass)
    {
        const std::string who = "pass '" + pass.name + "' draws over";
        expect(pass.over, who, passes);
        const PassDesc* under = findNamed(description.passes, pass.over.name);
        if (!under || report.errorWithin(under->pointer)) return;
        const auto shared = [under](const Reference& each) {
            return findNamed(under->color, each.name) != nullptr;
        };
        if (!under->over.empty() || !anyOf(pass.color, shared))
            report.at(pass.over, Code::reference_missing,
                      who + " '" + under->name + "', " +
                          (under->over.empty() ? "which writes none of its colour targets"
                                               : "which draws over another one itself"),
                      under->over.empty()
                          ? "name under `color` a target that '" + under->name + "' writes"
                          : "name '" + under->over.name + "'");
    }

    // Whether the target is in a depth format where it must be, and only there.
    bool isOfKind(const Reference& at, bool depth, const std::string& who)
    {
        const TargetDesc* target = findNamed(description.targets, at.name);
        if (!target || at.pointer.empty()) return true;
        for (const Format format : target->formats) {
            const FormatInfo& info = formatInfo(format);
            if ((info.format_class == FormatClass::depth) == depth) continue;
            Reported& error =
                report.at(at, Code::attachment_kind,
                          who + " '" + at.name + "', and its format " + info.name + " is none of " +
                              (depth ? "depth" : "colour"),
                          depth ? "name one in a depth format: depth16, depth24 or depth32f"
                                : "name it under `depth`, or give it a colour format");
            if (isModule(at.place)) error.cause = target->formats_place;
            return false;
        }
        return true;
    }

    // Clear, bypass and no_op speak of what the pass itself writes.
    void checkAttached(const PassDesc& pass, const Reference& target, const std::string& verb)
    {
        const std::string who = "pass '" + pass.name + "' " + verb;
        std::vector<std::string> written = namesOf(pass.color);
        if (!pass.depth.pointer.empty()) written.push_back(pass.depth.name);
        if (!known(target, targets)) return expect(target, who, targets);
        const bool reported = report.errorWithin(pass.pointer + "/color") ||
                              report.errorWithin(pass.pointer + "/depth");
        if (reported || contains(written, target.name)) return;
        report.at(target, Code::reference_missing,
                  who + " target '" + target.name + "', which it does not write",
                  suggestName(target.name, written, "its targets"));
    }

    // What a pass is not drawn everywhere for, and that it says what is elsewhere.
    void checkUndrawn(const PassDesc& pass)
    {
        const std::string who = "pass '" + pass.name + "' ";
        expect(pass.mask, who + "has as mask", targets);
        isOfKind(pass.mask, true, who + "has as mask");
        expect(pass.cull_below_pixel, who + "culls by", params);
        const ParamDesc* length = findNamed(description.params, pass.cull_below_pixel.name);
        if (length && length->type != ParamType::float_ && !report.errorWithin(length->pointer))
            report.at(pass.cull_below_pixel, Code::reference_missing,
                      who + "culls by '" + length->name + "', which is not a float",
                      "name a param of type float, in scene units");
        if ((pass.mask.empty() && !pass.scissor) || report.errorWithin(pass.pointer)) return;
        std::vector<Reference> written = pass.color;
        if (pass.scissor && !pass.depth.empty()) written.push_back(pass.depth);
        const PassDesc* under = findNamed(description.passes, pass.over.name);
        for (const Reference& target : written) {
            if (findNamed(pass.clear, target.name)) continue;
            if (under && findNamed(under->color, target.name)) continue;
            Reported& error =
                report.at(target, Code::missing_key,
                          who + "is not drawn everywhere, and its `clear` does not say what '" +
                              target.name + "' is elsewhere",
                          "add to the pass: \"clear\": {\"" + target.name +
                              "\": 1}, or what its shader writes where nothing is seen");
            if (isModule(target.place)) error.cause = ownPlace(target.place);
        }
    }

    void checkTerm(const PassDesc& pass, const Condition& term)
    {
        expect(term, "pass '" + pass.name + "' depends on", subjects);
        const std::string& subject = term.name;
        const FeatureDesc* feature = findNamed(description.features, subject);
        const TraitInfo* trait = findNamed(kTraits, subject);
        if ((!feature && !trait) || report.errorWithin(term.pointer)) return;
        if (feature && report.errorWithin(feature->pointer)) return;
        const std::vector<std::string> allowed =
            feature ? feature->values : std::vector<std::string>{"false", "true"};
        const bool list = locate(document, term.pointer).node->kind == Node::Kind::array;
        for (std::size_t i = 0; i < term.values.size(); ++i) {
            const std::string& value = term.values[i];
            if (contains(allowed, value) || (trait && trait->count && isCount(value))) continue;
            const std::string item = list ? "/" + std::to_string(i) : "";
            report.at(referenceAt(document, term.pointer + item), Code::feature_value,
                      "pass '" + pass.name + "' wants '" + subject + "' to be '" + value +
                          "', which it never is",
                      suggestName(value, allowed, "values") +
                          (trait && trait->count ? ", or a number" : ""));
        }
    }

    void checkInput(const PassDesc& pass, const InputDesc& input)
    {
        const bool renamed = !input.from.pointer.empty();
        const Reference& source = renamed ? input.from : input;
        if (report.errorAt(input.pointer) || report.errorAt(input.pointer + "/from")) return;
        if (indexOf(kMaterialMaps, source.name) >= 0 && !contains(inputs.all, source.name)) {
            if (pass.type == PassType::draw || report.errorAt(pass.pointer + "/type")) return;
            Reported& error =
                report.at(source, Code::target_missing,
                          "pass '" + pass.name + "' reads the material's '" + source.name +
                              "', which a draw pass alone has",
                          "let the pass be of type \"draw\", or take this input away");
            error.mistake = "material maps of " + pass.pointer;
            return;
        }
        expect(source, "pass '" + pass.name + "' reads", inputs);
    }
};

// Names of things that `who` sees together, so that no two may have the same.
struct SharedNames {
    const char* who;
    Report& report;
    std::map<std::string, std::pair<Place, std::string>> seen = {};

    void add(const Named& named, const std::string& what)
    {
        const auto [entry, fresh] = seen.emplace(named.name, std::pair(named.place, what));
        if (fresh) return;
        const auto& [place, first] = entry->second;
        Reported& error = report.at(
            named, Code::name_collision,
            what + " '" + named.name + "' has the name of " + first + ", and " + who + " sees both",
            "rename one of them");
        error.notes.push_back({place, first + " is here"});
    }

    template <class T>
    void add(const std::vector<T>& list, const std::string& what)
    {
        for (const T& each : list) add(each, what);
    }
};

// Follows `size.of` from each target that no walk has come by, until one is met again.
void checkSizeCycles(const Description& description, Report& report)
{
    std::map<std::string, const TargetDesc*> named;
    for (const TargetDesc& each : description.targets) named.emplace(each.name, &each);
    std::set<const TargetDesc*> met;
    for (const TargetDesc& start : description.targets) {
        std::vector<const TargetDesc*> chain;
        const TargetDesc* at = &start;
        while (at && met.insert(at).second) {
            chain.push_back(at);
            const auto next = named.find(at->size.of.name);
            at = next == named.end() ? nullptr : next->second;
        }
        for (auto each = std::find(chain.begin(), chain.end(), at); each != chain.end(); ++each) {
            const TargetDesc& target = **each;
            Reported& error =
                report.at(target.size.of, Code::cycle,
                          "target '" + target.name + "' follows the size of '" +
                              target.size.of.name + "', which leads round in a circle",
                          "let one of them follow the output: leave out its 'of'");
            error.mistake = "sizes in a circle";
        }
    }
}

}  // namespace

std::string modulesThatDeclare(const SourceSet& sources, std::string_view section,
                               const std::string& name)
{
    constexpr std::string_view kSuffix = ".json";
    std::string modules;
    for (const std::string& path : sources.list()) {
        if (!endsWith(path, kSuffix) || startsWith(path, "configs/")) continue;
        if (has("/" + path, "/bench/")) continue;  // laid over configs, and not to be extended
        const SourceRef source = sources.find(path);
        if (!source || source->text.find('"' + name + '"') == std::string::npos) continue;
        const Result<Node> document = parseDocument(source);
        const Node* entries = document ? document->find(section) : nullptr;
        const Node* declared = entries ? entries->find(name) : nullptr;
        const auto has = [&](const char* key) { return declared->find(key) != nullptr; };
        if (declared && (declared->kind == Node::Kind::string || has("format") || has("default") ||
                         has("shader")))
            modules += (modules.empty() ? "" : ", ") + path.substr(0, path.size() - kSuffix.size());
    }
    return modules;
}

std::string declaredBy(const SourceSet& sources, std::string_view section, const std::string& name)
{
    const std::string modules = modulesThatDeclare(sources, section, name);
    return modules.empty() ? "" : "declared by " + modules + ", which the config does not extend; ";
}

std::set<std::string> checkReferences(const Node& document, const Description& description,
                                      Report& report)
{
    return Checker{document, description, report}.run();
}

void checkNames(const Description& description, Report& report)
{
    checkSizeCycles(description, report);
    SharedNames glsl{"GLSL", report};
    glsl.add(description.params, "a param");
    glsl.add(description.targets, "a target");
    glsl.add(description.boxes, "a box");
    glsl.add(description.generated, "a generated value");
    for (const ImportDesc& each : description.imports)
        if (each.type == ImportType::texture) glsl.add(each, "a texture import");
    for (const TargetDesc& each : description.targets)
        if (each.history) glsl.add({historyName(each), each.place, each.pointer}, "a history");

    SharedNames settable{"an override", report};
    settable.add(description.params, "a param");
    settable.add(description.features, "a feature");

    for (const ParamDesc& each : description.params)
        if (findNamed(kFrameValues, each.name))
            report.at(each, Code::name_collision,
                      "param '" + each.name + "' has the name of a uniform that each frame feeds",
                      "rename the param");
}

}  // namespace crevice::table
