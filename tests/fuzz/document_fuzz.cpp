// SPDX-License-Identifier: MIT
// Any bytes as a document and as a value: a tree whose places lie in the text, or errors that do.
#include <crevice/document.h>

#include <cstdlib>

using namespace crevice;

namespace {

void expect(bool holds)
{
    if (!holds) std::abort();
}

void checkPlaces(const Node& node)
{
    expect(node.place.line > 0 && node.place.column > 0 && node.place.length > 0);
    for (const Node& item : node.items) checkPlaces(item);
    for (const Member& member : node.members) checkPlaces(member.value);
}

void check(const Result<Node>& result)
{
    if (result) return checkPlaces(*result);
    expect(hasErrors(result.diagnostics()));
    for (const Diagnostic& each : result.diagnostics()) expect(each.place.line > 0);
    expect(!toText(result.diagnostics()).empty() && !toJson(result.diagnostics()).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto source = std::make_shared<SourceText>();
    source->name = "fuzz.json";
    source->text.assign(reinterpret_cast<const char*>(data), size);
    check(parseDocument(source));
    if (!source->text.empty()) check(parseValue(source));
    return 0;
}
