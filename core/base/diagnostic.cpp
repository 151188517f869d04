// SPDX-License-Identifier: MIT
// Diagnostics as text and as JSON, and the search for the name that was meant.
#include <crevice/diagnostic.h>

#include "core/base/text.h"

#include <cstdio>

namespace crevice {
namespace {

constexpr std::size_t kMaxExcerpt = 160;  // bytes of a source line; more wraps in any terminal
constexpr std::size_t kExcerptLead = 50;  // bytes kept in front of the place when a line is cut

// The source line with a line below that marks the place: one column for each character, so that
// the marks stay below it, and tabs as tabs. Bytes that would upset a terminal become '?'.
void appendExcerpt(std::string& out, const Place& place)
{
    std::string_view line = lineOf(place.source->text, place.line);
    std::size_t begin = std::min<std::size_t>(std::max(place.column - 1, 0), line.size());
    const bool cut = line.size() > kMaxExcerpt && begin > kExcerptLead;
    const std::size_t skipped = cut ? utf8Prefix(line, begin - kExcerptLead).size() : 0;
    line.remove_prefix(skipped);
    begin -= skipped;
    const std::size_t end = begin + static_cast<std::size_t>(std::max(place.length, 1));
    const std::size_t size = utf8Prefix(line, kMaxExcerpt).size();
    std::string shown = skipped > 0 ? "..." : "";
    std::string marks(shown.size(), ' ');
    bool marked = false;
    for (std::size_t at = 0; at < size;) {
        const std::size_t length = utf8Length(line, at);
        const bool tab = line[at] == '\t';
        const bool shows = length > 0 && (tab || !isControl(line, at));
        shown += shows ? line.substr(at, length) : "?";
        if (at < begin)
            marks += tab ? '\t' : ' ';
        else if (at < end)
            marks += marked ? '~' : '^';
        marked = at >= begin;
        at += std::max<std::size_t>(length, 1);
    }
    if (!marked) marks += '^';  // the place is the end of the line
    if (size < line.size()) shown += "...";

    char margin[24];
    const int width = std::snprintf(margin, sizeof(margin), "%5d", place.line);
    out += margin + (" | " + shown) + '\n';
    if (place.column > 0) out += std::string(width, ' ') + " | " + marks + '\n';
}

constexpr std::size_t kMaxCompared = 64;  // bytes of a name; a longer one is no slip of the pen

// Insertions, deletions, replacements and swaps of neighbours that lead from `a` to `b` (the
// optimal string alignment distance). Requires that `b` has at most kMaxCompared bytes.
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::size_t rows[3][kMaxCompared + 1] = {};
    std::size_t *two_up = rows[0], *up = rows[1], *row = rows[2];
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(two_up, up);
        std::swap(up, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = up[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({up[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], two_up[j - 2] + 1);
        }
    }
    return row[b.size()];
}

// How far `candidate` is from what was written; above `limit` is not near. Less of a name and a
// name with more behind it ("r8unorm" for "r8") or before it ("gl_r8") count as just near enough,
// a path's end ("hemisphere" for "ssao/hemisphere", "views" for "camera.views") as one letter off.
std::size_t nameDistance(std::string_view written, std::string_view candidate, std::size_t limit)
{
    const bool bare = written.find_first_of("/.") == written.npos;
    const std::string_view last = candidate.substr(candidate.find_last_of(bare ? "/." : "/") + 1);
    if (last.size() < candidate.size()) {  // npos + 1 is 0
        if (last == written.substr(written.rfind('/') + 1)) return std::min<std::size_t>(limit, 1);
        if (bare) return std::min(limit + 1, nameDistance(written, last, limit) + 1);
    }
    const bool more = written.size() > candidate.size();
    const std::string_view longer = more ? written : candidate,
                           shorter = more ? candidate : written;
    const bool part =
        shorter.size() > 1 && (startsWith(longer, shorter) || endsWith(longer, shorter));
    const std::size_t far = part ? limit : limit + 1;
    if (longer.size() - shorter.size() > limit || longer.size() > kMaxCompared) return far;
    return std::min(far, editDistance(written, candidate));
}

// The first in the alphabet of those that are nearest.
const std::string* nearestName(std::string_view name, const std::vector<std::string>& names)
{
    const std::string written = lowerCase(name);
    const std::size_t limit = std::max<std::size_t>(written.size() > 1, written.size() / 3);
    const std::string* nearest = nullptr;
    std::size_t smallest = limit + 1;
    for (const std::string& candidate : names) {
        const std::size_t distance = nameDistance(written, lowerCase(candidate), limit);
        if (distance < smallest || (nearest && distance == smallest && candidate < *nearest)) {
            smallest = distance;
            nearest = &candidate;
        }
    }
    return nearest;
}

std::string jsonPlace(const Place& place)
{
    const std::string file = place.source ? jsonString(place.source->name) : "null";
    return "\"file\": " + file + ", \"line\": " + std::to_string(place.line) +
           ", \"column\": " + std::to_string(place.column) +
           ", \"length\": " + std::to_string(place.length);
}

const char* severityName(Severity severity)
{
    return severity == Severity::error ? "error" : "warning";
}

}  // namespace

Diagnostic::Diagnostic() = default;
Diagnostic::Diagnostic(Code of, std::string said, std::string way_out, Place at,
                       std::string in_document, std::vector<Note> more, Severity how)
    : code(of),
      message(std::move(said)),
      help(std::move(way_out)),
      place(std::move(at)),
      pointer(std::move(in_document)),
      notes(std::move(more)),
      severity(how)
{
}
Diagnostic::Diagnostic(const Diagnostic&) = default;
Diagnostic::Diagnostic(Diagnostic&&) noexcept = default;
Diagnostic& Diagnostic::operator=(const Diagnostic&) = default;
Diagnostic& Diagnostic::operator=(Diagnostic&&) noexcept = default;
Diagnostic::~Diagnostic() = default;

Status::Status() = default;
Status::Status(Diagnostic error) : diagnostics_(listOf(std::move(error))) {}
Status::Status(Diagnostics diagnostics) : diagnostics_(std::move(diagnostics)) {}
Status::Status(const Status&) = default;
Status::Status(Status&&) noexcept = default;
Status& Status::operator=(const Status&) = default;
Status& Status::operator=(Status&&) noexcept = default;
Status::~Status() = default;

Diagnostics listOf(Diagnostic diagnostic)
{
    Diagnostics list;
    list.push_back(std::move(diagnostic));
    return list;
}

bool hasErrors(const Diagnostics& diagnostics)
{
    return anyOf(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void cutShort(Diagnostics& diagnostics)
{
    if (diagnostics.size() <= kMaxDiagnostics) return;
    const std::size_t more = diagnostics.size() - kMaxDiagnostics;
    std::stable_partition(diagnostics.begin(), diagnostics.end(),
                          [](const Diagnostic& d) { return d.severity == Severity::error; });
    diagnostics.erase(diagnostics.begin() + kMaxDiagnostics, diagnostics.end());
    diagnostics.back().notes.push_back(moreNote(more));
}

Note moreNote(std::size_t more)
{
    return {{}, "and " + std::to_string(more) + " more, which are not listed; mend these first"};
}

void append(Diagnostics& all, const Diagnostics& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

void blame(Diagnostic& error, const Place& place, const std::string& what)
{
    if (place.source == error.place.source) return;
    error.notes.insert(error.notes.begin(), {error.place, what});
    error.place = place;
}

std::string codeName(Code code)
{
    char name[16];
    std::snprintf(name, sizeof(name), "CV%04d", static_cast<int>(code));
    return name;
}

std::string placeName(const Place& place)
{
    if (!place.source) return {};
    std::string name = place.source->name;
    if (place.line > 0) name += ':' + std::to_string(place.line);
    if (place.line > 0 && place.column > 0) name += ':' + std::to_string(place.column);
    return name;
}

std::string toText(const Diagnostic& diagnostic)
{
    const std::string place = printableLine(placeName(diagnostic.place));
    std::string out = place.empty() ? "" : place + ": ";
    out += std::string(severityName(diagnostic.severity)) + ' ' + codeName(diagnostic.code) + ": " +
           printableLine(diagnostic.message) + '\n';
    if (diagnostic.place.source && diagnostic.place.line > 0) appendExcerpt(out, diagnostic.place);
    if (!diagnostic.pointer.empty()) out += "  at " + printableLine(diagnostic.pointer) + '\n';
    for (const Note& note : diagnostic.notes) {
        const std::string where = placeName(note.place);
        out += "  note: " + printableLine((where.empty() ? "" : where + ": ") + note.text) + '\n';
    }
    if (!diagnostic.help.empty()) out += "  help: " + printableLine(diagnostic.help) + '\n';
    return out;
}

std::string toText(const Diagnostics& diagnostics)
{
    std::string out;
    for (const Diagnostic& diagnostic : diagnostics) out += toText(diagnostic);
    return out;
}

std::string toJson(const Diagnostics& diagnostics)
{
    std::string out = "[";
    for (const Diagnostic& each : diagnostics) {
        std::string notes;
        for (const Note& note : each.notes)
            notes += (notes.empty() ? "{" : ", {") + jsonPlace(note.place) +
                     ", \"text\": " + jsonString(note.text) + "}";
        out += (out.size() > 1 ? "," : "") + ("\n  {\"code\": " + jsonString(codeName(each.code))) +
               ", \"severity\": " + jsonString(severityName(each.severity)) +
               ", \"message\": " + jsonString(each.message) + ", " + jsonPlace(each.place) +
               ", \"pointer\": " + jsonString(each.pointer) + ", \"notes\": [" + notes +
               "], \"help\": " + jsonString(each.help) + "}";
    }
    return out + (diagnostics.empty() ? "]\n" : "\n]\n");
}

std::string suggestName(std::string_view name, const std::vector<std::string>& names,
                        std::string_view what)
{
    constexpr std::size_t kMaxListed = 40;  // all params of a config: six lines of a terminal
    if (names.empty()) return "there are no " + std::string(what);
    const std::string* nearest = nearestName(name, names);
    std::vector<std::string> listed(std::min(names.size(), kMaxListed));
    std::partial_sort_copy(names.begin(), names.end(), listed.begin(), listed.end());
    const std::string rest = names.size() > kMaxListed
                                 ? " and " + std::to_string(names.size() - kMaxListed) + " more"
                                 : "";
    return (nearest ? "did you mean '" + *nearest + "'? " : "") + std::string(what) + ": " +
           joined(listed) + rest;
}

}  // namespace crevice
