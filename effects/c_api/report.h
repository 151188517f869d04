// SPDX-License-Identifier: MIT
// What every function of the C API does: checks what it is given, lets no exception out, and makes
// an error of diagnostics.
#pragma once

#include <crevice/crevice.h>
#include <crevice/result.h>

#include <new>
#include <string>
#include <vector>

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

/// Runs `call`, which gives a Status; exceptions, such as those of a host's callback, end here.
template <class Call>
crevice_error* guarded(const Call& call) noexcept
{
    try {
        return errorOf(call());
    } catch (...) {
        return outOfMemory();
    }
}

}  // namespace crevice
