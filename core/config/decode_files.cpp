// SPDX-License-Identifier: MIT
// The GLSL files that a config names and include; and what it declares and nothing uses.
#include "core/config/decode_report.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/glsl/preprocessor.h"
#include "core/json/merge.h"

namespace crevice::table {
namespace {

struct Found {
    std::string key;  // in Description::files
    SourceRef source;
    bool on_disk = false;  // it was looked for there
};

// What `name`, written by `writer` in the file at `from`, stands for. Only '/', "./" and "../"
// leave the sources, and only from a file on disk. Errors, without a place: CV1204, CV1006.
Result<Found> findFile(const SourceSet& sources, const SourceText& writer, const std::string& from,
                       const std::string& name)
{
    const std::string key = resolvePath(from, name);
    const bool disk = isOnDisk(name) && isOnDisk(from);
    const Result<SourceRef> found = disk ? openNamed(writer, key) : sources.find(key);
    if (!found) return found.diagnostics();
    if (*found && (*found)->text.size() > kMaxDocumentBytes)
        return Diagnostic{
            Code::too_large,
            "the file '" + key + "' has more than the 1048576 bytes (1 MiB) that are read",
            "is this GLSL?"};
    return Found{key, *found, disk};
}

std::string absence(const Found& file)
{
    return file.on_disk ? absenceOf(file.key) : "does not exist";
}

// `ending` says what the file is for: ".frag", ".vert", ".glsl".
std::string suggestFile(const SourceSet& sources, const std::string& name, const std::string& key,
                        const std::string& ending)
{
    std::vector<std::string> paths;
    if (isOnDisk(key)) paths = filesBeside(key, name, ending);
    const char* what = paths.empty() ? "files" : "files there";
    for (const std::string& path : paths.empty() ? sources.list() : std::vector<std::string>())
        if (endsWith(path, ending)) paths.push_back(path);
    return suggestName(name, paths, what) +
           (isRelative(name) ? "; the path is seen from the folder of the file that has it" : "");
}

struct FileReader {
    const SourceSet& sources;
    Description& description;
    Report& report;

    // Reads the file behind `reference` and all that it includes.
    void readFrom(Reference& reference, const std::string& who, const std::string& ending)
    {
        if (reference.pointer.empty()) return;  // it was not written, or not a name
        const SourceText nowhere{"./", {}};
        const SourceText& writer = reference.place.source ? *reference.place.source : nowhere;
        const Result<Found> found = findFile(sources, writer, locationOf(writer), reference.name);
        if (!found) return refuse(found.diagnostics().front(), reference);
        const Found& file = *found;
        if (!file.source) {
            Reported& error =
                report.at(reference, Code::file_missing,
                          who + " names file '" + reference.name + "', which " + absence(file),
                          slashed(writer, reference.name));
            if (error.help.empty())
                error.help = suggestFile(sources, reference.name, file.key, ending);
            error.mistake = "file " + file.key;
            return;
        }
        reference.name = file.key;
        std::vector<Found> waiting = {file};
        while (!waiting.empty()) {
            const Found next = waiting.back();
            waiting.pop_back();
            if (isFull(reference)) return;
            if (description.files.emplace(next.key, next.source).second)
                follow(next, reference.pointer, waiting);
        }
    }

    // Whether no more files are read. Reported once.
    bool isFull(const Reference& reference)
    {
        const int most = description.limits.files;
        if (static_cast<int>(description.files.size()) < most) return false;
        report
            .at(reference, Code::over_limit,
                "the config names more than " + std::to_string(most) + " GLSL files",
                "merge some into one, or raise Limits::files (--limit files=N)")
            .mistake = "too many files";
        return true;
    }

    // Adds what `file` includes to `waiting`. An interface's file is read by its own reference.
    void follow(const Found& file, const std::string& pointer, std::vector<Found>& waiting)
    {
        for (const GlslInclude& include : findIncludes(file.source)) {
            if (report.full()) return report.count();
            const Reference at{{include.name, include.place, pointer}};
            if (include.interface) {
                if (!findNamed(description.interfaces, at.name) && !takeDefault(at.name, waiting))
                    expectInterface(at);
                continue;
            }
            const Result<Found> found = findFile(sources, *file.source, file.key, at.name);
            if (!found)
                refuse(found.diagnostics().front(), at);
            else if (found->source)
                waiting.push_back(*found);
            else
                missing(at, "file '" + at.name + "', which " + absence(*found),
                        findNamed(description.interfaces, at.name)
                            ? "write #include <" + at.name + ">"
                            : suggestFile(sources, at.name, found->key, ".glsl"));
        }
    }

    // A file that is there, or may be, and is not read.
    void refuse(const Diagnostic& why, const Reference& reference)
    {
        report.at(reference, why.code, why.message, why.help).mistake = why.message;
    }

    // An interface that no module gives is the file of its name under common/, where there is one.
    bool takeDefault(const std::string& name, std::vector<Found>& waiting)
    {
        const Result<Found> found = findFile(sources, {"", {}}, "", "common/" + name + ".glsl");
        if (!found || !found->source) return false;
        description.interfaces.push_back({{name}, {{found->key}}});
        waiting.push_back(*found);
        return true;
    }

    void expectInterface(const Reference& at)
    {
        if (report.errorAt("/interfaces")) return;
        const std::string modules = modulesThatDeclare(sources, "interfaces", at.name);
        for (const auto& each : description.left_out) {
            if (!has(modules, each.module)) continue;
            missing(at,
                    "interface <" + at.name + ">, and '" + each.module +
                        "', which makes it, is left out: " + each.reason,
                    "take a config that does without it");
            return;
        }
        missing(at, "interface <" + at.name + ">, which does not exist",
                "add a module that provides it to extends" +
                    (modules.empty() ? "" : ": " + modules) + "; " +
                    suggestName(at.name, namesOf(description.interfaces), "interfaces"));
    }

    void missing(const Reference& at, const std::string& what, const std::string& help)
    {
        report.at(at, Code::include_missing, "found an #include of " + what, help).mistake = what;
    }
};

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
        check(description.boxes, "box", "boxes", "no pass");
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

    // Whether it is used without being named in the config.
    bool isRead(const Named&) { return false; }
    bool isRead(const ParamDesc& each)
    {
        return inGlsl(each.bind == Bind::define ? upperCase(each.name) : each.name);
    }
    bool isRead(const FeatureDesc& each)
    {
        return !each.sets.empty() || inGlsl(upperCase(each.name));
    }
    bool isRead(const GeneratedDesc& each) { return inGlsl(each.name); }
    // A camera, draw list and lights are known by type; no shader need name what they give.
    bool isRead(const ImportDesc& each)
    {
        return each.type != ImportType::texture || inGlsl(each.name);
    }
    bool isRead(const TargetDesc& each)
    {
        return inGlsl(each.name) || (each.history && inGlsl(historyName(each)));
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
            if (isOwn(each) && names.count(each.name) == 0 && !isRead(each))
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

void readShaderFiles(Description& description, Report& report)
{
    FileReader reader{report.sources, description, report};
    for (ShaderDesc& each : description.shaders) {
        reader.readFrom(each.vertex, "shader '" + each.name + "'", ".vert");
        reader.readFrom(each.fragment, "shader '" + each.name + "'", ".frag");
    }
    for (InterfaceDesc& each : description.interfaces)
        reader.readFrom(each.file, "interface '" + each.name + "'", ".glsl");
}

Diagnostics unusedNames(const Node& document, const Description& description,
                        std::set<std::string> referred)
{
    return UseChecker{document, description, std::move(referred)}.run();
}

}  // namespace crevice::table
