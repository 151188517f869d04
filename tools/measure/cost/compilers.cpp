// SPDX-License-Identifier: MIT
#include "tools/measure/cost/compilers.h"

#include "core/base/text.h"
#include "tools/commands/cli/child_process.h"
#include "tools/measure/reference/reference_cache.h"

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {

namespace {

constexpr double kCompileSeconds =
    300;  // a large config's programs take one compiler a few seconds

constexpr const char* kProgram = "/compile_programs";

/// What `compile_programs` reads.
std::string inputOf(const std::vector<PlanProgram>& programs)
{
    std::string input;
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const std::string& vertex = programs[i].vertex.text;
        const std::string& fragment = programs[i].fragment.text;
        input += "program " + std::to_string(i) + " " + std::to_string(vertex.size()) + " " +
                 std::to_string(fragment.size()) + "\n" + vertex + fragment;
    }
    return input;
}

Diagnostic broken(const std::string& folder, const CostGpu& gpu, const std::string& what)
{
    return {
        Code::no_compilers,
        std::string("the compiler for ") + gpu.name + " in '" + folder + "' does not work: " + what,
        "build it again: remove that folder, then run tools/scripts/mobile_compilers.sh"};
}

/// The last line that is not empty, where most programs say why they end.
std::string lastLine(const std::string& output)
{
    std::string last;
    for (const std::string_view line : split(output, '\n'))
        if (!line.empty()) last = line;
    return last;
}

}  // namespace

Result<std::string> findCompilers(std::string folder)
{
    const char* named = std::getenv("CREVICE_MOBILE_COMPILERS");
    if (folder.empty() && named) folder = named;
    if (folder.empty()) folder = usualCacheFolder() + "/mobile_compilers";
    std::vector<std::string> wanted = {kProgram};
    for (const CostGpu& gpu : costGpus()) wanted.push_back(std::string("/inst/lib/") + gpu.shim);
    for (const std::string& file : wanted) {
        std::error_code error;
        if (fs::exists(folder + file, error)) continue;
        return Diagnostic{
            Code::no_compilers,
            "the compilers of phones' GPUs are not there: '" + folder + file + "' is missing",
            "build them with tools/scripts/mobile_compilers.sh, about ten minutes; or name their "
            "folder with --compilers or CREVICE_MOBILE_COMPILERS"};
    }
    return folder;
}

Result<CompiledPrograms> compilePrograms(const std::string& folder, const CostGpu& gpu,
                                         const std::vector<PlanProgram>& programs)
{
    const std::string mesa = folder + "/inst";
    std::vector<std::string> variables = gpu.variables;
    variables.insert(variables.end(),
                     {"LD_LIBRARY_PATH=" + mesa + "/lib", "LD_PRELOAD=" + mesa + "/lib/" + gpu.shim,
                      "LIBGL_DRIVERS_PATH=" + mesa + "/dri", "EGL_PLATFORM=surfaceless",
                      "MESA_SHADER_CACHE_DISABLE=1", "LIBGL_ALWAYS_SOFTWARE=0"});
    const ProgramRun run =
        runProgram(folder + kProgram, variables, inputOf(programs), kCompileSeconds);
    if (!run.ended) return broken(folder, gpu, run.failure);
    CompiledPrograms compiled;
    std::vector<std::string> outputs;
    bool complete = false;
    for (const std::string_view line : split(run.output, '\n')) {
        if (startsWith(line, "version ")) {
            compiled.version = line.substr(std::min(line.find("Mesa"), line.size()));
        } else if (startsWith(line, "program ")) {
            outputs.emplace_back();
        } else if (!outputs.empty()) {
            outputs.back().append(line).append("\n");
        }
        complete = line == "end" || (complete && line.empty());
    }
    if (run.exit_code != 0 || !complete || outputs.size() != programs.size())
        return broken(folder, gpu, lastLine(run.output));
    for (const std::string& output : outputs) compiled.figures.push_back(readFigures(gpu, output));
    return compiled;
}

}  // namespace crevice
