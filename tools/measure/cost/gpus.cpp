// SPDX-License-Identifier: MIT
// The table of GPUs, and reading what Mesa's compilers print: for Mali, V3D and Adreno one line of
// figures each, in src/{panfrost,broadcom} and src/gallium/drivers/freedreno/ir3/ir3_gallium.c.
#include "tools/measure/cost/gpus.h"

#include "core/base/text.h"
#include "tools/commands/cli/child_process.h"
#include "tools/measure/reference/tracer.h"

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

std::vector<std::string> words(std::string_view text)
{
    if (text.empty()) return {};
    const std::vector<std::string_view> parts = split(text, ' ');
    return {parts.begin(), parts.end()};
}

/// "r0.x" and "hr2.y" alike: whether an operand is a 16-bit register.
bool isHalfRegister(std::string_view operand) { return startsWith(operand, "hr"); }

/// Arithmetic of Adreno is what its encoding's categories 2, 3 and 4 hold: these words, by their
/// beginnings up to the '.'. Category 1 moves and converts, 5 samples, 6 reaches memory.
bool isArithmetic(std::string_view word)
{
    static const std::vector<std::string> kWords = words(
        "bary flat add min max mul sign cmps absneg cmpv floor ceil rndne rndaz trunc sub "
        "and or not xor mull bfrev clz shl shr ashr mgen getbit setrm cbits shb msad mad "
        "madsh sel sad shrm shlm shrg shlg andg dp2acc dp4acc wmm rcp rsq log2 exp2 sin cos "
        "sqrt hrsq hlog2 hexp2");
    return contains(kWords, word.substr(0, word.find('.')));
}

/// Takes flags such as "(ss)(nop3) (rpt2)" off the front. How often the instruction repeats.
int takeFlags(std::string_view& line)
{
    int repeats = 0;
    while (!line.empty() && line.front() == '(') {
        const std::size_t end = line.find(')');
        if (end == std::string_view::npos) return 0;
        const std::string_view flag = line.substr(1, end - 1);
        if (startsWith(flag, "rpt"))
            repeats = static_cast<int>(parseNumber(flag.substr(3)).value_or(0));
        line = trimmed(line.substr(end + 1));
    }
    return repeats;
}

void countInstruction(std::string_view line, Arithmetic& counts)
{
    const int times = 1 + takeFlags(line);
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos || !isArithmetic(line.substr(0, space))) return;
    std::string_view result = trimmed(line.substr(space));
    takeFlags(result);  // "(ei)r63.x"
    counts.all += times;
    if (isHalfRegister(result)) counts.half += times;
}

/// What a line has after "MESA: info: ", which Mesa's log puts before what it prints by itself.
std::string_view withoutLogPrefix(std::string_view line)
{
    constexpr std::string_view kPrefix = "MESA: info: ";
    return startsWith(line, kPrefix) ? line.substr(kPrefix.size()) : line;
}

double figure(const std::map<std::string, double>& figures, const char* word, double otherwise)
{
    const auto found = figures.find(word);
    return found == figures.end() ? otherwise : found->second;
}

CompilerFigures figuresOf(const CostGpu& gpu, const std::map<std::string, double>& said)
{
    const auto whole = [&](const char* word, int otherwise) {
        return static_cast<int>(figure(said, word, otherwise));
    };
    CompilerFigures figures;
    figures.instructions = whole("inst", 0);
    figures.run = figures.instructions;
    figures.spills = whole(gpu.spills, 0);
    figures.fills = whole(gpu.fills, 0);
    figures.threads = whole(gpu.threads, 0);
    figures.registers = whole(gpu.registers, -1);
    figures.code_bytes = whole(gpu.code, 0) * gpu.code_bytes;
    for (const std::string& unit : gpu.units) {
        figures.unit_cycles.push_back(figure(said, unit.c_str(), 0));
        figures.cycles = std::max(figures.cycles, figures.unit_cycles.back());
    }
    return figures;
}

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

const std::vector<CostGpu>& costGpus()
{
    const char* const kMali = "libpanfrost_noop_drm_shim.so";
    // The phones: Helio G85, Dimensity 700, RK3399 (a board, as is the Raspberry Pi 4), Snapdragon
    // 845.
    static const std::vector<CostGpu> kGpus = {
        {"Mali-G52", kMali, words("PAN_MESA_DEBUG=precompile PAN_GPU_ID=7212"), "threads", 2,
         "spills", "fills", "", "quadwords", 16, words("arith texture vary ldst"), false, 2, 1000,
         0},
        {"Mali-G57", kMali, words("PAN_MESA_DEBUG=precompile PAN_GPU_ID=9093"), "threads", 2,
         "spills", "fills", "", "quadwords", 16, words("fma cvt sfu v t ls"), false, 2, 950, 0},
        {"Mali-T860", kMali, words("PAN_MESA_DEBUG=precompile PAN_GPU_ID=860"), "threads", 4,
         "spills", "fills", "registers", "quadwords", 16, words(""), false, 4, 800, 8},
        {"Adreno-630", "libfreedreno_noop_drm_shim.so",
         words("FD_GPU_ID=630 FD_MESA_DEBUG=serialc,shaderdb IR3_SHADER_DEBUG=fs,disasm "
               "GALLIUM_THREAD=0"),
         "waves", 16, "stp", "ldp", "full", "dwords", 4, words(""), true, 2, 710, 128},
        {"V3D-4.2", "libv3d_noop_drm_shim.so", words("V3D_DEBUG=shaderdb,precompile"), "threads", 4,
         "spills", "fills", "max-temps", "inst", 8, words(""), false, 8, 500, 4},
    };
    return kGpus;
}

const CostGpu* findCostGpu(std::string_view name)
{
    for (const CostGpu& gpu : costGpus())
        if (lowerCase(gpu.name) == lowerCase(name)) return &gpu;
    return nullptr;
}

std::map<std::string, double> parseFigures(std::string_view line)
{
    for (const std::string_view start : {"MESA_SHADER_FRAGMENT shader: ", "FRAG shader: "}) {
        if (!startsWith(line, start)) continue;
        std::map<std::string, double> figures;
        for (std::string_view part : split(line.substr(start.size()), ',')) {
            part = trimmed(part);
            const std::optional<double> value = takeNumber(part);
            if (!value) continue;
            if (startsWith(part, ":")) {
                part.remove_prefix(1);
                figures["spills"] = *value;
                if (const auto fills = takeNumber(part)) figures["fills"] = *fills;
            } else {
                figures[std::string(trimmed(part))] = *value;
            }
        }
        return figures;
    }
    return {};
}

CompilerFigures readFigures(const CostGpu& gpu, std::string_view output)
{
    std::map<std::string, double> said;
    CompilerFigures refused;
    for (const std::string_view line : split(output, '\n')) {
        std::map<std::string, double> found = parseFigures(line);
        if (!found.empty()) said = std::move(found);
        if (startsWith(line, "refused ") && refused.refusal.empty())
            refused.refusal = line.substr(8);
    }
    if (!refused.refusal.empty()) return refused;
    if (said.count("inst") == 0 || said.count(gpu.threads) == 0) {
        refused.refusal = "it prints no figures";
        return refused;
    }
    CompilerFigures figures = figuresOf(gpu, said);
    if (!gpu.disassembled) return figures;
    const Arithmetic counts = countArithmetic(output);
    const double told = figure(said, "cat2", 0) + figure(said, "cat3", 0) + figure(said, "cat4", 0);
    if (counts.all != told) return figures;  // a disassembly that is read wrongly tells nothing
    figures.arithmetic = counts.all;
    figures.half_arithmetic = counts.half;
    return figures;
}

Arithmetic countArithmetic(std::string_view output)
{
    Arithmetic counts;
    bool inside = false, preamble = false;  // what runs once a draw, and counts in no figure
    for (const std::string_view whole : split(output, '\n')) {
        const std::string_view line = trimmed(withoutLogPrefix(whole));
        if (startsWith(line, "Native code for ")) {
            inside = has(line, " FRAG shader ");
            if (inside) counts = {};  // the last one is that of the program
        } else if (startsWith(line, "; FRAG: outputs")) {
            inside = false;
        } else if (has(line, "shps ")) {
            preamble = true;
        } else if (endsWith(line, "shpe")) {
            preamble = false;
        } else if (inside && !preamble && !line.empty() && line.front() != ';') {
            countInstruction(line, counts);
        }
    }
    return counts;
}

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
