// SPDX-License-Identifier: MIT
// Fronts: from a file or text to levels, strictly.
#include "effects/api/front.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/config/decode_reader.h"

#include <crevice/shipped.h>

#include <cmath>

namespace crevice {
namespace {

constexpr const char* kLevelsDoc =
    "A list of levels by rising ms: [{\"config\": \"mobile\", \"set\": [], \"ms\": 1.1, "
    "\"error\": 0.078}, ...].";
constexpr const char* kSetDoc =
    "Params and features as --set takes them: [\"radius=1\"]; [] for none.";

/// The text itself, or a file's.
Result<SourceRef> openFront(const std::string& front)
{
    if (startsWith(front, "{"))
        return std::make_shared<const SourceText>(SourceText{"(JSON text)", front});
    if (SourceRef file = readFile(front)) return file;
    return Diagnostic{Code::module_missing, "the file '" + front + "' " + absenceOf(front),
                      "name a front, which `crevice choose --write-front FILE` writes"};
}

/// Reads each entry of a list; what is no list is an error with the sentence `doc`.
template <class Read>
void readList(table::Report& report, const table::Cursor& object, const char* key, const char* doc,
              const Read& each)
{
    for (const Member& member : object.node.members) {
        if (member.key != key) continue;
        table::Cursor list = object.child(member);
        list.doc = doc;
        if (list.node.kind != Node::Kind::array)
            report.atValue(list, Code::wrong_type, list.label + ": wanted a list");
        for (std::size_t i = 0; i < list.node.items.size(); ++i) each(list.item(i));
    }
}

FrontLevel readLevel(table::Report& report, const table::Cursor& entry)
{
    FrontLevel level;
    level.place = entry.node.place;
    level.pointer = entry.pointer;
    table::Reader reader(report, entry);
    reader.field("config", level.name, "The name of a config, as `crevice render` takes it.",
                 table::required());
    reader.field("set", table::Later(), kSetDoc, table::required());
    reader.field("ms", level.ms, "GPU time of a frame in milliseconds, above 0.",
                 table::required());
    reader.field("error", level.error, "The bench's rmse of AO.", table::required());
    reader.finish();
    readList(report, entry, "set", kSetDoc, [&](const table::Cursor& item) {
        table::read(report, item, level.set.emplace_back(), {});
    });
    return level;
}

Diagnostic atLevel(const FrontLevel& level, Code code, const std::string& what, const char* help)
{
    return {code, "level '" + level.name + "' has " + what, help, level.place, level.pointer};
}

}  // namespace

Status checkFront(const std::vector<FrontLevel>& levels)
{
    if (levels.empty())
        return Diagnostic{Code::bad_length, "a front has no level", "give it one at least"};
    double before = 0;
    for (const FrontLevel& each : levels) {
        if (!std::isfinite(each.ms) || !std::isfinite(each.error))
            return atLevel(each, Code::not_finite, "a number that is not finite",
                           "give milliseconds and an error that was measured");
        if (each.ms <= before)
            return atLevel(
                each, Code::out_of_range,
                significant(each.ms, 6) + " ms, wanted more than " + significant(before, 6),
                "give milliseconds above 0, and sort levels by them");
        if (each.error < 0)
            return atLevel(each, Code::out_of_range, "an error of " + significant(each.error, 6),
                           "give the bench's, or 0 where nobody knows it");
        before = each.ms;
    }
    return {};
}

Diagnostics ofLevel(const FrontLevel& level, Diagnostics found)
{
    for (Diagnostic& each : found) {
        if (each.place.source) {
            each.notes.push_back({level.place, "in level '" + level.name + "' of the front"});
        } else {
            each.place = level.place;
            each.pointer = level.pointer;
        }
    }
    return found;
}

Result<std::vector<FrontLevel>> readFront(const std::string& front)
{
    const Result<SourceRef> source = openFront(front);
    if (!source) return source.diagnostics();
    const Result<Node> document = parseDocument(*source);
    if (!document) return document.diagnostics();
    table::Report report(*document, shippedSources());
    const table::Cursor top{*document, "", document->place, "front", "front"};
    std::string word, scene, device;
    std::array<float, 4> size = {};
    table::Reader reader(report, top);
    reader.field("format", table::OneOf{word, {"crevice-front-1"}}, "\"crevice-front-1\".",
                 table::required());
    reader.field("scene", scene, "Where it was measured, for people.");
    reader.field("size", table::Numbers{size, 2, true}, "At how many pixels, for people.");
    reader.field("device", device, "On what, for people.");
    reader.field("levels", table::Later(), kLevelsDoc, table::required());
    reader.finish();
    std::vector<FrontLevel> levels;
    readList(report, top, "levels", kLevelsDoc, [&](table::Cursor entry) {
        entry.key = entry.label = "level";
        levels.push_back(readLevel(report, entry));
    });
    const Diagnostics errors = report.take(*document);
    if (!errors.empty()) return errors;
    Diagnostics wrong = checkFront(levels).diagnostics();
    for (Diagnostic& each : wrong)
        if (!each.place.source) each.place = document->find("levels")->place;
    if (!wrong.empty()) return wrong;
    return levels;
}

}  // namespace crevice
