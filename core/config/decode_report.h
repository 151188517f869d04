// SPDX-License-Identifier: MIT
// What the steps of `decode` share: where in the document they are, and the errors so far; and its
// steps after the table. They run on broken descriptions too, so that one run finds all errors;
// what an error before explains is not reported again.
#pragma once

#include <crevice/config.h>

#include <set>

namespace crevice::table {

/// A value in the document: where it is and what to call it.
struct Cursor {
    const Node& node;
    std::string pointer = {};  ///< RFC 6901.
    Place key_place = {};      ///< Of the member's key; the value's own for the top.
    std::string key = {};      ///< The member's key.
    std::string label = {};    ///< "radius default": the last two keys, for messages.
    const char* doc = "";      ///< What the table says of it: the help of its errors.

    Cursor child(const Member& member) const;
    Cursor item(std::size_t at) const
    {
        return {node.items[at], pointer + "/" + std::to_string(at), key_place, key, label, doc};
    }
};

/// An error, and what it has to do with others.
struct Reported : Diagnostic {
    /// Of the same mistake the first in the document is reported; the others become its notes.
    std::string mistake = {};
    Place cause = {};  ///< What it comes of: where it is reported then.
};

/// Errors in any order, to be put into the document's. Past kMaxDiagnostics the last error stays.
class Report {
public:
    Report(const Node& document, const SourceSet& set) : sources(set), document_(document) {}

    const SourceSet& sources;  ///< Looked through for what would declare a name.
    const Node& document() const { return document_; }

    /// Whether an entry that nothing declares is left out with a warning: what the config gives a
    /// value may have gone with a module that an override swapped, which a second origin tells of.
    bool leavesOut(const Place& key) const;

    /// Where what stands under `section` is declared instead: "write it under params"; or empty.
    std::string otherSection(const std::string& section, const std::string& name) const;

    /// Makes that warning of the error about it.
    static void leaveOut(Diagnostic& error)
    {
        error.severity = Severity::warning;
        error.help = "it is left out: what declares it is not part of this config";
    }

    /// An error about a value, or about its key. Without a help of its own it has the table's
    /// sentence. What comes back is valid until the next call.
    Reported& atValue(const Cursor& cursor, Code code, std::string message, std::string help = {});
    Reported& atKey(const Cursor& cursor, Code code, std::string message, std::string help = {});

    /// An error about a name that was decoded before, with a note for each place that it replaced.
    Reported& at(const Named& named, Code code, std::string message, std::string help = {},
                 const std::vector<Place>& origins = {});
    Reported& at(const Reference& reference, Code code, std::string message, std::string help = {})
    {
        return at(reference, code, std::move(message), std::move(help), reference.origins);
    }
    Reported& add(Diagnostic diagnostic);

    /// Whether kMaxDiagnostics were reported; what is found then need only be counted.
    bool full() const { return errors_.size() == kMaxDiagnostics; }
    void count() { ++more_; }

    /// The last error. Requires one.
    Reported& last() { return errors_.back(); }

    /// Whether an error was reported at the pointer, or at it or below.
    bool errorAt(std::string_view pointer) const;
    bool errorWithin(std::string_view pointer) const;

    /// Everything, in the order of the document, each mistake once.
    Diagnostics take(const Node& document);

private:
    const Node& document_;
    std::vector<Reported> errors_;
    std::optional<Reported> dropped_;  // an error past those
    int more_ = 0;                     // so many were dropped
};

/// The node behind an RFC 6901 pointer, and the position of each of its ancestors and itself among
/// their siblings: comparing such paths gives the document's order. Null where it leads nowhere.
struct Located {
    const Node* node = nullptr;
    std::vector<std::size_t> path = {};
};
Located locate(const Node& document, std::string_view pointer);

/// To the value behind a pointer that leads somewhere; its name is the value's text.
Reference referenceAt(const Node& document, const std::string& pointer);

/// A number as a message shows it: "0.5", "1e-09".
std::string numberText(double number);

/// "x-..." is the host's own data, at every level.
inline bool isExtension(std::string_view key) { return key.substr(0, 2) == "x-"; }

/// Reports names that collide (CV2107) and targets that follow each other's size (CV2204).
void checkNames(const Description& description, Report& report);

/// Reports what refers to nothing or stands where it may not: CV2101 to CV2106, CV2201, CV2207 and
/// CV4001. Returns all names that something refers to.
std::set<std::string> checkReferences(const Node& document, const Description& description,
                                      Report& report);

/// Reads each GLSL file that a shader or interface names, and what it includes, into
/// `description.files`; the references become the keys there. Reports CV2104 and CV5005.
void readShaderFiles(Description& description, Report& report);

/// Errors CV2108 about params, targets and the like that the config's own file declares and nothing
/// uses; warnings under a variant or a pointer's override. Requires the GLSL files.
Diagnostics unusedNames(const Node& document, const Description& description,
                        std::set<std::string> referred);

/// The modules of `sources` that declare a name in a section themselves, a target with its format:
/// "filter/box, filter/none" for the target "ao_filtered". Empty where none does.
std::string modulesThatDeclare(const SourceSet& sources, std::string_view section,
                               const std::string& name);

/// Those as the beginning of a help; empty where there are none.
std::string declaredBy(const SourceSet& sources, std::string_view section, const std::string& name);

}  // namespace crevice::table
