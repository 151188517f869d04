// SPDX-License-Identifier: MIT
// Errors as C reads them, and structs of every version.
#include "effects/api/c/calls.h"

#include <algorithm>

namespace {

const crevice_error kOutOfMemory({crevice::Diagnostic{
    crevice::Code::out_of_memory, "there is no memory left, or a callback of the host threw",
    "free some, and make callbacks that do not throw"}});

/// More is taken for a size that nobody set, before so much of a stack is read or written.
constexpr std::size_t kLargestStruct = 4096;

crevice::Diagnostic wrongSize(std::size_t size, const crevice::StructType& type)
{
    return {crevice::Code::bad_input,
            std::string("struct_size of ") + type.name + " is " + std::to_string(size) +
                ", and the struct has " + std::to_string(type.size) + " bytes",
            "set it to sizeof the struct"};
}

}  // namespace

crevice_error::crevice_error(const crevice::Diagnostics& diagnostics)
    : text(crevice::toText(diagnostics))
{
    for (const crevice::Diagnostic& each : diagnostics)
        entries.push_back({each, crevice::toText(each)});
}

namespace crevice {

crevice_error* errorOf(const Status& status)
{
    return status ? nullptr : new crevice_error(status.diagnostics());
}

crevice_error* outOfMemory() { return const_cast<crevice_error*>(&kOutOfMemory); }

Status checkGiven(const void* pointer, const char* what)
{
    if (pointer) return {};
    return Diagnostic{Code::bad_input, std::string(what) + " is null"};
}

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

const char* crevice_error_text(const crevice_error* error)
{
    return error ? error->text.c_str() : "";
}

int crevice_error_code(const crevice_error* error)
{
    return error ? static_cast<int>(error->entries[0].diagnostic.code) : 0;
}

int crevice_error_count(const crevice_error* error)
{
    return error ? static_cast<int>(error->entries.size()) : 0;
}

bool crevice_error_get(const crevice_error* error, int index, crevice_diagnostic* diagnostic)
{
    if (index < 0 || index >= crevice_error_count(error)) return false;
    if (!crevice::check(diagnostic, "crevice_diagnostic")) return false;
    const crevice_error::Entry& entry = error->entries[static_cast<std::size_t>(index)];
    const crevice::Diagnostic& from = entry.diagnostic;
    crevice_diagnostic own = {};
    own.warning = from.severity == crevice::Severity::warning;
    own.code = static_cast<int>(from.code);
    own.message = from.message.c_str();
    own.help = from.help.c_str();
    own.file = from.place.source ? from.place.source->name.c_str() : "";
    own.line = from.place.line;
    own.column = from.place.line > 0 ? from.place.column : 0;
    own.pointer = from.pointer.c_str();
    own.text = entry.text.c_str();
    crevice::give(own, diagnostic);
    return true;
}

void crevice_error_free(crevice_error* error)
{
    if (error != crevice::outOfMemory()) delete error;
}
