// SPDX-License-Identifier: MIT
#include "tools/render/device/spirv_module.h"

#include <cstring>

namespace crevice {
namespace {

constexpr std::size_t kHeaderWords = 5;  // magic, version, generator, bound, schema

bool isDeclaration(spv::Op op)
{
    return (op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer) ||
           (op >= spv::OpConstantTrue && op <= spv::OpConstantNull);
}

void write(SpirvWords& words, const SpirvInstruction& instruction)
{
    const std::size_t first = words.size();
    words.push_back(0);
    if (instruction.type) words.push_back(instruction.type);
    if (instruction.result) words.push_back(instruction.result);
    words.insert(words.end(), instruction.operands.begin(), instruction.operands.end());
    words[first] = std::uint32_t(words.size() - first) << spv::WordCountShift | instruction.op;
}

}  // namespace

std::vector<SpirvInstruction> readInstructions(const SpirvWords& words)
{
    std::vector<SpirvInstruction> all;
    for (std::size_t at = kHeaderWords; at < words.size();) {
        SpirvInstruction instruction;
        instruction.op = spv::Op(words[at] & spv::OpCodeMask);
        const std::size_t next = at + (words[at] >> spv::WordCountShift);
        bool has_result = false, has_type = false;
        spv::HasResultAndType(instruction.op, &has_result, &has_type);
        ++at;
        if (has_type) instruction.type = words[at++];
        if (has_result) instruction.result = words[at++];
        instruction.operands.assign(words.begin() + long(at), words.begin() + long(next));
        all.push_back(std::move(instruction));
        at = next;
    }
    return all;
}

SpirvWriter::SpirvWriter(const SpirvWords& header, const std::vector<SpirvInstruction>& original)
    : header_(header.begin(), header.begin() + kHeaderWords)
{
    for (const SpirvInstruction& instruction : original) note(instruction);
}

void SpirvWriter::note(const SpirvInstruction& instruction)
{
    if (instruction.type) types_[instruction.result] = instruction.type;
    if (isDeclaration(instruction.op)) declared_[instruction.result] = instruction;
    if (instruction.op == spv::OpExtInstImport) extended_ = instruction.result;
}

void SpirvWriter::append(const SpirvInstruction& instruction)
{
    in_functions_ = in_functions_ || instruction.op == spv::OpFunction;
    write(in_functions_ ? functions_ : declarations_, instruction);
}

SpirvId SpirvWriter::emit(spv::Op op, SpirvId type, const SpirvWords& operands, SpirvId result)
{
    const SpirvInstruction instruction = {op, type, result ? result : newId(), operands};
    note(instruction);
    write(functions_, instruction);
    return instruction.result;
}

SpirvId SpirvWriter::emitExtended(GLSLstd450 what, SpirvId type, SpirvWords operands)
{
    operands.insert(operands.begin(), {extended_, std::uint32_t(what)});
    return emit(spv::OpExtInst, type, operands);
}

SpirvId SpirvWriter::part(SpirvId value, std::uint32_t index)
{
    const SpirvShape shape = shapeOf(typeOf(value));
    if (shape.element == typeOf(value)) return value;
    return emit(spv::OpCompositeExtract, shape.element, {value, index});
}

SpirvId SpirvWriter::typeOf(SpirvId value) const
{
    const auto found = types_.find(value);
    return found == types_.end() ? 0 : found->second;
}

SpirvShape SpirvWriter::shapeOf(SpirvId type) const
{
    const auto found = declared_.find(type);
    if (found == declared_.end()) return {};
    const SpirvInstruction& made = found->second;
    switch (made.op) {
    case spv::OpTypeFloat: return {made.op, type, 1, true};
    case spv::OpTypeInt: return {made.op, type, 1, made.operands[1] != 0};
    case spv::OpTypeVector:
    case spv::OpTypeMatrix: return {made.op, made.operands[0], made.operands[1], true};
    default: return {};
    }
}

bool SpirvWriter::isConstant(SpirvId id) const
{
    const auto found = declared_.find(id);
    return found != declared_.end() && found->second.type != 0;
}

SpirvId SpirvWriter::declare(spv::Op op, SpirvId type, const SpirvWords& operands)
{
    for (const auto& [id, made] : declared_)
        if (made.op == op && made.type == type && made.operands == operands) return id;
    const SpirvInstruction made = {op, type, newId(), operands};
    note(made);
    write(declarations_, made);
    return made.result;
}

SpirvId SpirvWriter::constant(SpirvId type, std::uint32_t bits)
{
    const SpirvShape shape = shapeOf(type);
    if (shape.element == type) return declare(spv::OpConstant, type, {bits});
    const SpirvId element = constant(shape.element, bits);
    return declare(spv::OpConstantComposite, type, SpirvWords(shape.count, element));
}

SpirvId SpirvWriter::constant(SpirvId type, float value)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return constant(type, bits);
}

SpirvWords SpirvWriter::words() const
{
    SpirvWords all = header_;
    all.insert(all.end(), declarations_.begin(), declarations_.end());
    all.insert(all.end(), functions_.begin(), functions_.end());
    return all;
}

}  // namespace crevice
