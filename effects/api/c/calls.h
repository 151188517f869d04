// SPDX-License-Identifier: MIT
// What every function of the C API does: checks what it is given, lets no exception out, and makes
// an error of diagnostics. Structs that callers hand over and get may be those of another version
// of <crevice/crevice.h>, shorter or longer than this one's.
#pragma once

#include <crevice/crevice.h>
#include <crevice/diagnostic.h>

#include <cstring>

/// A list of diagnostics with the strings that C reads.
struct crevice_error {
    struct Entry {
        crevice::Diagnostic diagnostic;
        std::string text;
    };

    std::vector<Entry> entries;
    std::string text;

    explicit crevice_error(const crevice::Diagnostics& diagnostics);
};

namespace crevice {

/// Null where the status is ok.
crevice_error* errorOf(const Status& status);

/// What stands for an error where there is no memory for one. It is never freed.
crevice_error* outOfMemory();

/// Errors: CV6011 for a null pointer; `what` names it: "the effect".
Status checkGiven(const void* pointer, const char* what);

/// The first that is not ok, else ok.
template <class... More>
Status firstOf(Status first, More... more)
{
    if constexpr (sizeof...(more) > 0)
        if (first) return firstOf(std::move(more)...);
    return first;
}

/// False where the call threw. In the runtime, built without exceptions, one ends the process.
template <class Call>
bool calledWhole(const Call& call) noexcept
{
#ifdef __cpp_exceptions
    try {
        call();
    } catch (...) {
        return false;
    }
#else
    call();
#endif
    return true;
}

/// Runs `call`, which gives a Status; exceptions, such as those of a host's callback, end here.
template <class Call>
crevice_error* guarded(const Call& call) noexcept
{
    crevice_error* error = nullptr;
    return calledWhole([&] { error = errorOf(call()); }) ? error : outOfMemory();
}

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

/// Errors: CV6011 for a number that is none of the enum's, from 0 to `last`; `name` is its type's.
template <class Enum>
Status checkEnum(const Enum& given, Enum last, const char* name)
{
    static_assert(sizeof(Enum) == sizeof(int));
    int number = 0;  // C++ must not even look at what is none of its values
    std::memcpy(&number, &given, sizeof number);
    if (number >= 0 && number <= static_cast<int>(last)) return {};
    return Diagnostic{Code::bad_input,
                      std::string("there is no ") + name + " " + std::to_string(number),
                      std::string("take one of the words of ") + name};
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
