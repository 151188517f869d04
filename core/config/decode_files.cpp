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
};

// What `name`, written by `writer` in the file at `from`, stands for. Only "./" and "../" leave the
// sources, and only from a file on disk. Errors, without a place: CV1204, CV1006.
Result<Found> findFile(const SourceSet& sources, const SourceText& writer, const std::string& from,
                       const std::string& name)
{
    const std::string key = resolvePath(from, name);
    const bool disk = isRelative(name) && isOnDisk(from);
    const Result<SourceRef> found = disk ? openNamed(writer, key) : sources.find(key);
    if (!found) return found.diagnostics();
    if (*found && (*found)->text.size() > kMaxDocumentBytes)
        return Diagnostic{Code::too_large,
                          "the file '" + key +
                              "' has more than the 1048576 bytes (1 MiB) "
                              "that are read",
                          "is this GLSL?"};
    return Found{key, *found};
}

std::string absence(const Found& file)
{
    return isOnDisk(file.key) ? absenceOf(file.key) : "does not exist";
}

// `ending` says what the file is for: ".frag", ".vert", ".glsl".
std::string suggestFile(const SourceSet& sources, const std::string& name,
                        const std::string& ending)
{
    std::vector<std::string> paths;
    for (const std::string& path : sources.list())
        if (endsWith(path, ending)) paths.push_back(path);
    return (isRelative(name) ? "the path is seen from the folder of the file that has it; " : "") +
           suggestName(name, std::move(paths), "files");
}

class FileReader {
public:
    FileReader(const SourceSet& sources, Description& description, Report& report)
        : sources_(sources),
          description_(description),
          report_(report)
    {
    }

    // Reads the file behind `reference` and all that it includes.
    void readFrom(Reference& reference, const std::string& who, const std::string& ending)
    {
        if (reference.pointer.empty()) return;  // it was not written, or not a name
        const SourceText nowhere{"./", {}};
        const SourceText& writer = reference.place.source ? *reference.place.source : nowhere;
        const Result<Found> found = findFile(sources_, writer, locationOf(writer), reference.name);
        if (!found) return refuse(found.diagnostics().front(), reference);
        const Found& file = *found;
        if (!file.source) {
            report_.at(reference, Code::file_missing,
                       who + " names file '" + reference.name + "', which " + absence(file),
                       suggestFile(sources_, reference.name, ending));
            report_.sameMistake("file " + file.key);
            return;
        }
        reference.name = file.key;
        std::vector<Found> waiting = {file};
        while (!waiting.empty()) {
            const Found next = waiting.back();
            waiting.pop_back();
            if (description_.files.emplace(next.key, next.source).second)
                follow(next, reference.pointer, waiting);
        }
    }

private:
    // Adds what `file` includes to `waiting`. An interface's file is read by its own reference.
    void follow(const Found& file, const std::string& pointer, std::vector<Found>& waiting)
    {
        for (const GlslInclude& include : findIncludes(file.source)) {
            if (include.interface) {
                if (!findNamed(description_.interfaces, include.name) &&
                    !takeDefault(include.name, waiting))
                    expectInterface(include, pointer);
                continue;
            }
            const Result<Found> found = findFile(sources_, *file.source, file.key, include.name);
            if (!found)
                refuse(found.diagnostics().front(), {"", include.place, pointer});
            else if (found->source)
                waiting.push_back(*found);
            else
                missing(include, pointer, "file '" + include.name + "', which " + absence(*found),
                        suggestFile(sources_, include.name, ".glsl"));
        }
    }

    // A file that is there, or may be, and is not read.
    void refuse(const Diagnostic& why, const Reference& reference)
    {
        report_.at(reference, why.code, why.message, why.help);
        report_.sameMistake(why.message);
    }

    // An interface that no module gives is the file of its name under common/, where there is one.
    bool takeDefault(const std::string& name, std::vector<Found>& waiting)
    {
        const Result<Found> found = findFile(sources_, {"", {}}, "", "common/" + name + ".glsl");
        if (!found || !found->source) return false;
        InterfaceDesc given;
        given.name = name;
        given.file.name = found->key;
        description_.interfaces.push_back(std::move(given));
        waiting.push_back(*found);
        return true;
    }

    void expectInterface(const GlslInclude& include, const std::string& pointer)
    {
        const std::vector<std::string> names = namesOf(description_.interfaces);
        if (report_.errorAt("/interfaces")) return;
        const std::string modules = modulesThatDeclare(sources_, "interfaces", include.name);
        missing(include, pointer, "interface <" + include.name + ">, which does not exist",
                "add a module that provides it to extends" +
                    (modules.empty() ? "" : ": " + modules) + "; " +
                    suggestName(include.name, names, "interfaces"));
    }

    void missing(const GlslInclude& include, const std::string& pointer, const std::string& what,
                 std::string help)
    {
        report_.at({"", include.place, pointer}, Code::include_missing,
                   "found an #include of " + what, std::move(help));
        report_.sameMistake(what);
    }

    const SourceSet& sources_;
    Description& description_;
    Report& report_;
};

}  // namespace

void readShaderFiles(const SourceSet& sources, Description& description, Report& report)
{
    FileReader reader(sources, description, report);
    for (ShaderDesc& each : description.shaders) {
        reader.readFrom(each.vertex, "shader '" + each.name + "'", ".vert");
        reader.readFrom(each.fragment, "shader '" + each.name + "'", ".frag");
    }
    for (InterfaceDesc& each : description.interfaces)
        reader.readFrom(each.file, "interface '" + each.name + "'", ".glsl");
}

}  // namespace crevice::table
