// SPDX-License-Identifier: MIT
// Errors as C reads them.
#include "effects/c_api/report.h"

#include "effects/c_api/structs.h"

namespace {

const crevice_error kOutOfMemory({crevice::Diagnostic{
    crevice::Code::out_of_memory, "there is no memory left, or a callback of the host threw",
    "free some, and make callbacks that do not throw"}});

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
