// SPDX-License-Identifier: MIT
#include "effects/c_api/structs.h"

#include <algorithm>

namespace crevice {

namespace {

/// More is taken for a size that nobody set, before so much of a stack is read or written.
constexpr std::size_t kLargestStruct = 4096;

Diagnostic wrongSize(std::size_t size, const StructType& type)
{
    return {Code::bad_input,
            std::string("struct_size of ") + type.name + " is " + std::to_string(size) +
                ", and the struct has " + std::to_string(type.size) + " bytes",
            "set it to sizeof the struct"};
}

}  // namespace

std::size_t structSize(const void* given)
{
    std::size_t size = 0;
    std::memcpy(&size, given, sizeof size);
    return size;
}

Status checkStruct(const void* given, const StructType& type)
{
    if (Status there = checkGiven(given, type.name); !there) return there;
    const std::size_t size = structSize(given);
    // With no member beyond the size it is the size of a pointer, taken by mistake.
    if (size > sizeof size && size <= kLargestStruct && size % type.alignment == 0) return {};
    return wrongSize(size, type);
}

Status takeStruct(const void* given, const StructType& type, void* own)
{
    if (Status there = checkStruct(given, type); !there) return there;
    const std::size_t size = structSize(given);
    const auto* bytes = static_cast<const char*>(given);
    const auto is_zero = [](char byte) { return byte == 0; };
    if (size > type.size && !std::all_of(bytes + type.size, bytes + size, is_zero))
        return Diagnostic{Code::bad_input,
                          std::string(type.name) +
                              " has members that this version of crevice does "
                              "not know, and they are set",
                          "leave them zero, or take a later version"};
    std::memcpy(own, given, std::min(size, type.size));
    return {};
}

void giveStruct(const void* own, std::size_t size, void* into)
{
    const std::size_t room = structSize(into);
    constexpr std::size_t kFirst = sizeof room;
    auto* bytes = static_cast<char*>(into);
    std::memcpy(bytes + kFirst, static_cast<const char*>(own) + kFirst,
                std::min(room, size) - kFirst);
    if (room > size) std::memset(bytes + size, 0, room - size);
}

}  // namespace crevice
