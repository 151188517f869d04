// SPDX-License-Identifier: MIT
// SPIR-V as a list of instructions, and a copy of it in the making.
#pragma once

#define SPV_ENABLE_UTILITY_CODE
#include <GLSL.std.450.h>
#include <spirv.hpp>

#include <cstdint>
#include <map>
#include <vector>

namespace crevice {

using SpirvWords = std::vector<std::uint32_t>;
using SpirvId = std::uint32_t;

struct SpirvInstruction {
    spv::Op op = spv::OpNop;
    SpirvId type = 0;    ///< Of the result; 0 where there is none.
    SpirvId result = 0;  ///< Likewise.
    SpirvWords operands = {};
};

/// What a numeric type is made of.
struct SpirvShape {
    /// OpTypeFloat, OpTypeInt, OpTypeVector or OpTypeMatrix; else OpNop.
    spv::Op op = spv::OpNop;
    /// Of a vector or of a matrix's columns; the type itself for a number.
    SpirvId element = 0;
    std::uint32_t count = 1;
    bool is_signed = true;
};

/// Requires a whole module, as a compiler hands it over.
std::vector<SpirvInstruction> readInstructions(const SpirvWords& words);

/// Writes a module that begins as a copy of another. Declarations that the copy comes to need go
/// behind those of the original.
class SpirvWriter {
public:
    SpirvWriter(const SpirvWords& header, const std::vector<SpirvInstruction>& original);

    /// Appends an instruction of the original, or one of an own function.
    void append(const SpirvInstruction& instruction);

    /// Appends an instruction in the current function and gives its result, new where `result` is
    /// 0.
    SpirvId emit(spv::Op op, SpirvId type, const SpirvWords& operands, SpirvId result = 0);
    SpirvId emitExtended(GLSLstd450 what, SpirvId type, SpirvWords operands);

    SpirvId part(SpirvId value, std::uint32_t index);

    SpirvId typeOf(SpirvId value) const;
    SpirvShape shapeOf(SpirvId type) const;
    bool isConstant(SpirvId id) const;

    /// Of `value` in every component.
    SpirvId constant(SpirvId type, float value);
    SpirvId constant(SpirvId type, std::uint32_t bits);

    /// A type that the original may have, made where it has not.
    SpirvId makeType(spv::Op op, const SpirvWords& operands) { return declare(op, 0, operands); }

    SpirvId newId() { return header_[3]++; }

    SpirvWords words() const;

private:
    void note(const SpirvInstruction& instruction);
    SpirvId declare(spv::Op op, SpirvId type, const SpirvWords& operands);

    SpirvWords header_;
    SpirvWords declarations_;
    SpirvWords functions_;
    bool in_functions_ = false;
    SpirvId extended_ = 0;                          ///< The instruction set GLSL.std.450.
    std::map<SpirvId, SpirvId> types_;              ///< Of each result.
    std::map<SpirvId, SpirvInstruction> declared_;  ///< Types and constants.
};

}  // namespace crevice
