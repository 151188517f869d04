// SPDX-License-Identifier: MIT
// A diagnostic: one message with its code, its place and a way out. And Result<T>: a value, or the
// diagnostics that say why there is none. Nothing in crevice throws.
//
//     my.json:9:57: error CV2103: pass 'lighting' reads target 'ao_filterd', which does not exist
//         9 |   "passes": { "lighting": { "inputs": { "ao": "ao_filterd" } } }
//           |                                                ^~~~~~~~~~~~
//       at /passes/lighting/inputs/ao
//       note: effects/lighting/blinn_phong.json:31:21: the base value was 'ao_filtered'
//       help: did you mean 'ao_filtered'? targets: albedo, ao, ao_filtered, color, depth, normal
#pragma once

#include <crevice/codes.h>
#include <crevice/source.h>

#include <cassert>
#include <optional>

namespace crevice {

enum class Severity { error, warning };

/// A further place that belongs to a diagnostic, such as where a merged value came from.
struct Note {
    Place place;
    std::string text;
};

/// One message. `message` is one sentence: what was found, what was wanted; no final full stop.
struct Diagnostic {
    Code code = Code::internal;
    std::string message;
    std::string help = {};  ///< The way out: the nearest valid name, the allowed set, a command.
    Place place = {};
    std::string pointer = {};  ///< RFC 6901 pointer into the merged document; empty when none.
    std::vector<Note> notes = {};
    Severity severity = Severity::error;

    // None inline: one is made and thrown away in hundreds of places.
    Diagnostic();
    Diagnostic(Code code, std::string message, std::string help = {}, Place place = {},
               std::string pointer = {}, std::vector<Note> notes = {},
               Severity severity = Severity::error);
    Diagnostic(const Diagnostic&);
    Diagnostic(Diagnostic&&) noexcept;
    Diagnostic& operator=(const Diagnostic&);
    Diagnostic& operator=(Diagnostic&&) noexcept;
    ~Diagnostic();
};

using Diagnostics = std::vector<Diagnostic>;

/// The same as a warning.
inline Diagnostic asWarning(Diagnostic diagnostic)
{
    diagnostic.severity = Severity::warning;
    return diagnostic;
}

/// True when any of them is an error and not a warning.
bool hasErrors(const Diagnostics& diagnostics);

/// As many of one run are reported; nobody reads more.
constexpr std::size_t kMaxDiagnostics = 100;

/// Cuts a list to kMaxDiagnostics, errors first; a note of the last says how many more there were.
void cutShort(Diagnostics& diagnostics);

/// That note.
Note moreNote(std::size_t more);

/// A list of that one.
Diagnostics listOf(Diagnostic diagnostic);

/// Appends one list to another.
void append(Diagnostics& all, const Diagnostics& more);

/// Reports the error at a place in another file; where it was becomes the first note, which says
/// `what`. Nothing changes where both places are in one file.
void blame(Diagnostic& error, const Place& place, const std::string& what);

/// The code as users see it: "CV2103".
std::string codeName(Code code);

/// "my.json:9:57", "my.json" when the line is unknown, "" when nothing is known.
std::string placeName(const Place& place);

/// The message as in this header's example, ending in a newline. Text from files is made printable,
/// so that no name in it controls a terminal.
std::string toText(const Diagnostic& diagnostic);
std::string toText(const Diagnostics& diagnostics);

/// An array of objects with the keys code, severity, message, file, line, column, length, pointer,
/// notes and help, for programs.
std::string toJson(const Diagnostics& diagnostics);

/// A help line for a name that is not among `names`: the nearest one, if any is near, then the
/// first of them in the alphabet under the heading `what` ("targets").
std::string suggestName(std::string_view name, const std::vector<std::string>& names,
                        std::string_view what);

/// Either a value, perhaps with warnings, or at least one error.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)) {}  // NOLINT: implicit, for `return value;`
    Result(T value, Diagnostics warnings)
        : value_(std::move(value)),
          diagnostics_(std::move(warnings))
    {
    }
    Result(Diagnostic error) : diagnostics_(listOf(std::move(error))) {}  // NOLINT
    Result(Diagnostics errors) : diagnostics_(std::move(errors))          // NOLINT
    {
        assert(hasErrors(diagnostics_));
    }

    bool ok() const { return value_.has_value(); }
    explicit operator bool() const { return ok(); }

    /// The value. Requires ok().
    T& value()
    {
        assert(ok());
        return *value_;
    }
    const T& value() const
    {
        assert(ok());
        return *value_;
    }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// Errors when not ok(); warnings, usually none, when ok().
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    std::optional<T> value_;
    Diagnostics diagnostics_;
};

/// A Result with no value.
class [[nodiscard]] Status {
public:
    Status();
    Status(Diagnostic error);         // NOLINT
    Status(Diagnostics diagnostics);  // NOLINT
    Status(const Status&);
    Status(Status&&) noexcept;
    Status& operator=(const Status&);
    Status& operator=(Status&&) noexcept;
    ~Status();

    bool ok() const { return !hasErrors(diagnostics_); }
    explicit operator bool() const { return ok(); }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    Diagnostics diagnostics_;
};

}  // namespace crevice
