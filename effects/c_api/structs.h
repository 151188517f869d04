// SPDX-License-Identifier: MIT
// Structs of every version of <crevice/crevice.h>: what callers hand over and get may be shorter or
// longer than this version's.
#pragma once

#include <crevice/result.h>

#include "effects/c_api/report.h"

#include <cstring>

namespace crevice {

/// A struct as this version has it.
struct StructType {
    const char* name;
    std::size_t size;
    std::size_t alignment;
};

/// What the caller said. Requires a struct that is not null.
std::size_t structSize(const void* given);

/// Errors: CV6011 for null, and for a size that no version can have.
Status checkStruct(const void* given, const StructType& type);

/// Copies what was handed over into `own`, of `type.size` zeros.
///
/// Errors: those of checkStruct; CV6011 where what this version does not know is not zero.
Status takeStruct(const void* given, const StructType& type, void* own);

/// Copies `own` to the caller, as much as there is room for; what this version does not know
/// becomes zero. Requires what checkStruct asks for.
void giveStruct(const void* own, std::size_t size, void* into);

template <class Struct>
Status check(const Struct* given, const char* name)
{
    return checkStruct(given, {name, sizeof(Struct), alignof(Struct)});
}

template <class Struct>
Status take(const Struct* given, const char* name, Struct& own)
{
    return takeStruct(given, {name, sizeof(Struct), alignof(Struct)}, &own);
}

template <class Struct>
void give(const Struct& own, Struct* into)
{
    giveStruct(&own, sizeof own, into);
}

/// The number in an enum of C, which may be none of its values: C++ must not even look at those.
template <class Enum>
int numberOf(const Enum& given)
{
    static_assert(sizeof(Enum) == sizeof(int));
    int number = 0;
    std::memcpy(&number, &given, sizeof number);
    return number;
}

/// Calls `each(index, struct)`, which gives a Status, for those of an array, until one fails.
///
/// Errors: its own; those of `take`; CV6011 for a count below 0 and for structs of several sizes.
template <class Struct, class Each>
Status takeEach(const Struct* given, int count, const char* name, const Each& each)
{
    if (count < 0)
        return Diagnostic{Code::bad_input, std::string("the count of ") + name + " structs is " +
                                               std::to_string(count)};
    Status status = count > 0 ? check(given, name) : Status();
    const std::size_t stride = count > 0 && status ? structSize(given) : 0;
    for (int i = 0; i < count && status; ++i) {
        const auto* at =
            reinterpret_cast<const char*>(given) + static_cast<std::size_t>(i) * stride;
        Struct own = {};
        status = take(reinterpret_cast<const Struct*>(at), name, own);
        if (status && own.struct_size != stride)
            return Diagnostic{Code::bad_input,
                              std::string("an array has ") + name + " structs of several sizes"};
        if (status) status = each(static_cast<std::size_t>(i), own);
    }
    return status;
}

}  // namespace crevice
