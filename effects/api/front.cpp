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

/// The member's value; null where it is missing or, with an error, no list.
std::optional<table::Cursor> listAt(table::Report& report, const table::Cursor& object,
                                    const char* key, const char* doc)
{
    for (const Member& member : object.node.members) {
        if (member.key != key) continue;
        table::Cursor list = object.child(member);
        list.doc = doc;
        if (list.node.kind == Node::Kind::array) return list;
        report.atValue(list, Code::wrong_type, list.label + ": wanted a list");
    }
    return {};
}

FrontLevel readLevel(table::Report& report, table::Cursor entry)
{
    entry.key = entry.label = "level";
    FrontLevel level;
    level.place = entry.node.place;
    level.pointer = entry.pointer;
    table::Reader reader(report, entry);
    reader.field("config", level.name, "The name of a config, as `crevice render` takes it.",
                 table::required());
    reader.field("set", table::Later(), kSetDoc);
    reader.field("ms", level.ms, "GPU time of a frame in milliseconds, above 0.",
                 table::required());
    reader.field("error", level.error, "The bench's rmse of AO.", table::required());
    reader.finish();
    if (const auto set = listAt(report, entry, "set", kSetDoc))
        for (std::size_t i = 0; i < set->node.items.size(); ++i)
            table::read(report, set->item(i), level.set.emplace_back(), {});
    return level;
}

}  // namespace

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
    const auto list = listAt(report, top, "levels", kLevelsDoc);
    std::vector<FrontLevel> levels;
    for (std::size_t i = 0; list && i < list->node.items.size(); ++i)
        levels.push_back(readLevel(report, list->item(i)));
    Diagnostics errors = report.take(*document);
    if (errors.empty()) errors = checkFront(levels).diagnostics();
    for (Diagnostic& each : errors)
        if (!each.place.source && list) each.place = list->node.place;
    if (!errors.empty()) return errors;
    return levels;
}

}  // namespace crevice
