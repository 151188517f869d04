// SPDX-License-Identifier: MIT
// Rounding after every step, instruction by instruction.
#include "tools/render/device/open_device.h"
#include "tools/render/device/spirv_module.h"

#include <set>

namespace crevice {
namespace {

using Id = SpirvId;

constexpr float kSmallestHalf = 1.0f / 16384;  // 2^-14, the least that no half keeps as a denormal

bool isFloatArithmetic(spv::Op op)
{
    return op == spv::OpFNegate || op == spv::OpFAdd || op == spv::OpFSub || op == spv::OpFMul ||
           op == spv::OpFDiv || op == spv::OpFMod || op == spv::OpExtInst ||
           (op >= spv::OpVectorTimesScalar && op <= spv::OpDot);
}

bool isComparison(spv::Op op)
{
    return op >= spv::OpFOrdEqual && op <= spv::OpFUnordGreaterThanEqual;
}

class MediumpRounder {
public:
    MediumpRounder(const SpirvWords& words, Mediump mediump)
        : original_(readInstructions(words)),
          out_(words, original_)
    {
        for (const SpirvInstruction& each : original_) {
            const SpirvWords& operands = each.operands;
            if (each.op == spv::OpDecorate && operands[1] == spv::DecorationRelaxedPrecision)
                mediump_.insert(operands[0]);
            if (each.op == spv::OpVariable)
                variables_[each.result] = spv::StorageClass(operands[0]);
            if (each.op == spv::OpEntryPoint)
                fragment_ = operands[0] == spv::ExecutionModelFragment;
        }
        if (mediump == Mediump::full) mediump_.clear();
    }

    SpirvWords run()
    {
        for (const SpirvInstruction& instruction : original_) visit(instruction);
        for (const auto& [type, function] : rounding_functions_)
            writeRoundingFunction(type, function);
        return out_.words();
    }

private:
    bool isDropped(const SpirvInstruction& decoration) const;
    bool isRounded(const SpirvInstruction& instruction) const;
    void visit(SpirvInstruction instruction);
    void roundConstants(SpirvInstruction& instruction);

    /// The value that the instruction stands for; all steps but the last are rounded.
    Id compute(const SpirvInstruction& instruction);
    Id computeExtended(const SpirvInstruction& instruction);

    /// The value rounded, as a new result or the one that is given.
    Id rounded(Id value, Id result = 0);
    Id roundedInteger(Id value, Id type, Id result);
    Id roundedMatrix(Id value, Id type, Id result);
    Id roundingFunction(Id type)
    {
        Id& function = rounding_functions_[type];
        if (!function) function = out_.newId();
        return function;
    }
    void writeRoundingFunction(Id type, Id function);

    Id step(spv::Op op, Id type, const SpirvWords& operands)
    {
        return rounded(out_.emit(op, type, operands));
    }
    Id step(GLSLstd450 what, Id type, const SpirvWords& operands)
    {
        return rounded(out_.emitExtended(what, type, operands));
    }
    Id product(Id a, Id b) { return step(spv::OpFMul, out_.typeOf(a), {a, b}); }
    Id difference(Id a, Id b) { return step(spv::OpFSub, out_.typeOf(a), {a, b}); }
    Id quotient(Id a, Id b)
    {
        const Id type = out_.typeOf(b);
        return product(a, step(spv::OpFDiv, type, {out_.constant(type, 1.0f), b}));
    }
    Id scaled(Id vector, Id scalar)
    {
        const Id type = out_.typeOf(vector);
        if (type == out_.typeOf(scalar)) return product(vector, scalar);
        return step(spv::OpVectorTimesScalar, type, {vector, scalar});
    }
    Id dot(Id a, Id b)
    {
        const SpirvShape shape = out_.shapeOf(out_.typeOf(a));
        Id sum = product(out_.part(a, 0), out_.part(b, 0));
        for (std::uint32_t i = 1; i < shape.count; ++i)
            sum =
                step(spv::OpFAdd, shape.element, {sum, product(out_.part(a, i), out_.part(b, i))});
        return sum;
    }
    Id length(Id vector)
    {
        const Id squared = dot(vector, vector);
        return step(GLSLstd450Sqrt, out_.typeOf(squared), {squared});
    }
    Id matrixTimesVector(Id matrix, Id vector);

    std::vector<SpirvInstruction> original_;
    SpirvWriter out_;
    std::set<Id> mediump_;
    std::map<Id, spv::StorageClass> variables_;
    bool fragment_ = false;
    std::map<Id, Id> rounding_functions_;  ///< By type.
};

bool MediumpRounder::isDropped(const SpirvInstruction& decoration) const
{
    const SpirvWords& operands = decoration.operands;
    if (decoration.op == spv::OpMemberDecorate)
        return operands[2] == spv::DecorationRelaxedPrecision;
    if (decoration.op != spv::OpDecorate) return false;
    const auto variable = variables_.find(operands[0]);
    const auto kept = fragment_ ? spv::StorageClassOutput : spv::StorageClassInput;
    switch (operands[1]) {
    case spv::DecorationRelaxedPrecision:
    case spv::DecorationBinding:
    case spv::DecorationDescriptorSet: return true;
    case spv::DecorationLocation: return variable != variables_.end() && variable->second != kept;
    default: return false;
    }
}

bool MediumpRounder::isRounded(const SpirvInstruction& instruction) const
{
    switch (instruction.op) {
    case spv::OpVariable:
    case spv::OpFunction:
    case spv::OpFunctionParameter:
    case spv::OpPhi:
    case spv::OpConstant:
    case spv::OpConstantComposite: return false;
    default:
        return mediump_.count(instruction.result) > 0 &&
               out_.shapeOf(instruction.type).op != spv::OpNop;
    }
}

void MediumpRounder::visit(SpirvInstruction instruction)
{
    if (isDropped(instruction)) return;
    if (isRounded(instruction)) {
        if (isFloatArithmetic(instruction.op)) roundConstants(instruction);
        rounded(compute(instruction), instruction.result);
        return;
    }
    SpirvWords& operands = instruction.operands;
    if (isComparison(instruction.op) &&
        (mediump_.count(operands[0]) || mediump_.count(operands[1])))
        roundConstants(instruction);
    if (instruction.op == spv::OpStore && mediump_.count(operands[0]) &&
        variables_[operands[0]] == spv::StorageClassOutput)
        operands[1] = rounded(operands[1]);
    out_.append(instruction);
}

/// Constants have no precision of their own: they take that of what they meet.
void MediumpRounder::roundConstants(SpirvInstruction& instruction)
{
    const std::size_t first = instruction.op == spv::OpExtInst ? 2 : 0;
    for (std::size_t i = first; i < instruction.operands.size(); ++i)
        if (out_.isConstant(instruction.operands[i]))
            instruction.operands[i] = rounded(instruction.operands[i]);
}

Id MediumpRounder::compute(const SpirvInstruction& instruction)
{
    const SpirvWords& from = instruction.operands;
    switch (instruction.op) {
    case spv::OpExtInst: return computeExtended(instruction);
    case spv::OpFDiv: return quotient(from[0], from[1]);
    case spv::OpDot: return dot(from[0], from[1]);
    case spv::OpMatrixTimesVector: return matrixTimesVector(from[0], from[1]);
    default: return out_.emit(instruction.op, instruction.type, from);
    }
}

Id MediumpRounder::computeExtended(const SpirvInstruction& instruction)
{
    const Id type = instruction.type;
    const Id* from = instruction.operands.data() + 2;
    switch (instruction.operands[1]) {
    case GLSLstd450Pow: {
        const Id power = product(step(GLSLstd450Log2, type, {from[0]}), from[1]);
        return out_.emitExtended(GLSLstd450Exp2, type, {power});
    }
    case GLSLstd450Length: return length(from[0]);
    case GLSLstd450Distance: return length(difference(from[0], from[1]));
    case GLSLstd450Normalize: {
        const Id squared = dot(from[0], from[0]);
        const Id root = step(GLSLstd450InverseSqrt, out_.typeOf(squared), {squared});
        return scaled(from[0], root);
    }
    default: return out_.emit(instruction.op, type, instruction.operands);
    }
}
Id MediumpRounder::matrixTimesVector(Id matrix, Id vector)
{
    const std::uint32_t columns = out_.shapeOf(out_.typeOf(matrix)).count;
    Id sum = scaled(out_.part(matrix, 0), out_.part(vector, 0));
    for (std::uint32_t i = 1; i < columns; ++i) {
        const Id column = scaled(out_.part(matrix, i), out_.part(vector, i));
        sum = step(spv::OpFAdd, out_.typeOf(column), {sum, column});
    }
    return sum;
}

Id MediumpRounder::rounded(Id value, Id result)
{
    const Id type = out_.typeOf(value);
    const SpirvShape shape = out_.shapeOf(type);
    const SpirvShape element = out_.shapeOf(shape.element);
    if (shape.op == spv::OpTypeMatrix) return roundedMatrix(value, type, result);
    if (element.op == spv::OpTypeInt) return roundedInteger(value, type, result);
    if (element.op == spv::OpTypeFloat)
        return out_.emit(spv::OpFunctionCall, type, {roundingFunction(type), value}, result);
    return out_.emit(spv::OpCopyObject, type, {value}, result);  // a vector of bools
}

/// The low 16 bits, with their sign.
Id MediumpRounder::roundedInteger(Id value, Id type, Id result)
{
    if (!out_.shapeOf(out_.shapeOf(type).element).is_signed)
        return out_.emit(spv::OpBitwiseAnd, type, {value, out_.constant(type, 0xffffu)}, result);
    const Id shift = out_.constant(type, 16u);
    const Id high = out_.emit(spv::OpShiftLeftLogical, type, {value, shift});
    return out_.emit(spv::OpShiftRightArithmetic, type, {high, shift}, result);
}

Id MediumpRounder::roundedMatrix(Id value, Id type, Id result)
{
    SpirvWords columns;
    for (std::uint32_t i = 0; i < out_.shapeOf(type).count; ++i)
        columns.push_back(rounded(out_.part(value, i)));
    return out_.emit(spv::OpCompositeConstruct, type, columns, result);
}
void MediumpRounder::writeRoundingFunction(Id type, Id function)
{
    const SpirvShape shape = out_.shapeOf(type);
    const Id boolean = out_.makeType(spv::OpTypeBool, {});
    const Id booleans =
        shape.count == 1 ? boolean : out_.makeType(spv::OpTypeVector, {boolean, shape.count});
    out_.append({spv::OpFunction,
                 type,
                 function,
                 {spv::FunctionControlMaskNone, out_.makeType(spv::OpTypeFunction, {type, type})}});
    const Id value = out_.emit(spv::OpFunctionParameter, type, {});
    out_.append({spv::OpLabel, 0, out_.newId(), {}});
    const Id size = out_.emitExtended(GLSLstd450FAbs, type, {value});
    const Id small =
        out_.emit(spv::OpFOrdLessThan, booleans, {size, out_.constant(type, kSmallestHalf)});
    const Id half = out_.emit(spv::OpQuantizeToF16, type, {value});
    const Id kept = out_.emit(spv::OpSelect, type, {small, out_.constant(type, 0.0f), half});
    out_.append({spv::OpReturnValue, 0, 0, {kept}});
    out_.append({spv::OpFunctionEnd, 0, 0, {}});
}

}  // namespace

SpirvWords rewriteMediump(const SpirvWords& words, Mediump mediump)
{
    return MediumpRounder(words, mediump).run();
}

}  // namespace crevice
