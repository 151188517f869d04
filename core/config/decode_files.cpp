// SPDX-License-Identifier: MIT
// The GLSL files that a config names, and what they include.
#include "core/config/decode_steps.h"

#include <crevice/glsl_stage.h>

#include "core/base/files.h"
#include "core/base/text.h"

#include <algorithm>

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
        return Diagnostic{Code::too_large,
                          "the file '" + key +
                              "' has more than the 1048576 bytes (1 MiB) "
                              "that are read",
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
                          suggestFile(sources, reference.name, file.key, ending));
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
            const Reference at{include.name, include.place, pointer};
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
                        suggestFile(sources, at.name, found->key, ".glsl"));
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
        description.interfaces.push_back({{name}, {found->key}});
        waiting.push_back(*found);
        return true;
    }

    void expectInterface(const Reference& at)
    {
        if (report.errorAt("/interfaces")) return;
        const std::string modules = modulesThatDeclare(sources, "interfaces", at.name);
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

}  // namespace crevice::table
