// SPDX-License-Identifier: MIT
// The phones' GPUs whose compilers, which tools/scripts/mobile_compilers.sh builds, are asked, and
// what each of them says of a shader.
#pragma once

#include <crevice/plan.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

/// A GPU, its driver in Mesa, and the words in which that driver's compiler gives its figures.
struct CostGpu {
    const char* name;  ///< "Mali-G57", as --gpu and all output have it.
    const char* shim;  ///< The stand-in for its kernel driver, a library that is loaded first.
    std::vector<std::string> variables;  ///< Of the environment: which GPU it is, what to print.
    const char* threads;  ///< The word for how many threads, or waves, a core runs at a time ...
    int most_threads;     ///< ... and how many at the most: full occupancy.
    const char* spills;   ///< Registers written to memory, and read back.
    const char* fills;
    const char* registers;  ///< Those that it takes; empty where it does not say.
    const char* code;       ///< Units of code size, each of so many bytes.
    int code_bytes;
    std::vector<std::string> units;  ///< Those that work side by side, whose cycles it counts.
    bool disassembled;               ///< Its code is printed too, which tells the 16-bit share.
    // A phone that has it, for the estimate of time.
    int cores;
    int megahertz;
    int lanes;  ///< Instructions a core runs in a cycle, where no unit's cycles are told.
};

const std::vector<CostGpu>& costGpus();

/// Null where there is none of that name, whatever the case.
const CostGpu* findCostGpu(std::string_view name);

/// What a compiler says of one fragment shader.
struct CompilerFigures {
    /// Why there is nothing below: what the compiler objects to; empty where it compiled.
    std::string refusal;
    int instructions = 0;
    double run = 0;  ///< Those that one pixel runs: `instructions` until loops are weighed.
    int spills = 0;
    int fills = 0;
    int threads = 0;
    int registers = -1;  ///< -1: not told.
    int code_bytes = 0;
    /// Cycles that one pixel takes each unit, in the order of CostGpu::units, of the shader's text:
    /// loops count once. Empty where they are not told.
    std::vector<double> unit_cycles;
    double cycles = -1;  ///< Of the busiest unit; -1: not told.
    /// Arithmetic instructions, those that a repeat stands for included, no moves and conversions;
    /// and those of them that compute in 16 bits. -1: not told.
    int arithmetic = -1;
    int half_arithmetic = -1;
};

/// The figures of a line such as "FRAGMENT shader: 15 inst, 0.25 cycles, 0:0 spills:fills", by
/// their words; "spills:fills" becomes two. Empty where the line is none of a fragment shader.
std::map<std::string, double> parseFigures(std::string_view line);

/// Of what the compiler of that GPU printed about one program. A refusal where it has no figures.
CompilerFigures readFigures(const CostGpu& gpu, std::string_view output);

/// Arithmetic instructions in Adreno's disassembly of the last fragment shader of the output.
struct Arithmetic {
    int all = 0;
    int half = 0;  ///< Those whose result goes to a 16-bit register.
};
Arithmetic countArithmetic(std::string_view output);

/// Where they lie: in `folder`; where that is empty, in the one that CREVICE_MOBILE_COMPILERS
/// names, or where the script puts them. Errors: CV6021 where one of them is not there.
Result<std::string> findCompilers(std::string folder);

/// What the compiler of one GPU made of a plan's programs.
struct CompiledPrograms {
    std::string version;                   ///< "Mesa 22.3.6"
    std::vector<CompilerFigures> figures;  ///< One for each program, in their order.
};

/// Errors: CV6021 where the compiler does not run to its end.
Result<CompiledPrograms> compilePrograms(const std::string& folder, const CostGpu& gpu,
                                         const std::vector<PlanProgram>& programs);

}  // namespace crevice
