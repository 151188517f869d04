// SPDX-License-Identifier: MIT
// Every node of every shipped config and module deleted, renamed and retyped, one at a time. What
// comes of it is a plan, or errors that a reader can act on: at the change, or at something that
// refers to what is no longer there. No device is called before all of that is settled.
//
// An ordinary run takes every eleventh mutation, a nightly one all of them.
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/support/nightly.h"

#include <functional>

using namespace crevice;

namespace {

constexpr int kStride = 11;  // prime to the three mutations of a member and the two of an item

/// A value of another kind.
std::string retyped(const Node& value)
{
    switch (value.kind) {
    case Node::Kind::number: return "\"word\"";
    case Node::Kind::string: return "7";
    case Node::Kind::boolean: return "[]";
    case Node::Kind::array: return "{\"x\": 1}";
    default: return "true";
    }
}

/// A text with one stretch of it replaced.
struct Mutation {
    std::string text;
    std::string what;
    int first_line = 0, last_line = 0;  ///< Of what holds the changed node.
    std::set<std::string> names;        ///< The node's own and all below it.
};

/// All keys and texts of a value; of a module that it names, those of the module.
void collectNames(const Node& node, std::set<std::string>& names)
{
    if (node.kind == Node::Kind::string && names.insert(node.text).second)
        for (const char* folder : {"", "configs/"})
            if (const SourceRef module = shippedSources().find(folder + node.text + ".json"))
                collectNames(*parseDocument(module), names);
    for (const Node& item : node.items) collectNames(item, names);
    for (const Member& member : node.members) {
        names.insert(member.key);
        collectNames(member.value, names);
    }
}

/// Mutations of documents, of which it makes each `stride`-th.
class Mutator {
public:
    using Each = std::function<void(const Mutation&)>;

    Mutator(int stride, Each each) : stride_(stride), each_(std::move(each)) {}

    void run(const SourceRef& source)
    {
        text_ = source->text;
        visit(need(parseDocument(source)), "");
    }

    int count() const { return count_; }  ///< Of those that it left out too.

private:
    std::size_t offsetOf(const Place& place) const
    {
        std::size_t begin = 0;
        for (int line = 1; line < place.line; ++line) begin = text_.find('\n', begin) + 1;
        return begin + static_cast<std::size_t>(place.column) - 1;
    }

    /// Behind the value's last character.
    std::size_t endOf(const Node& value) const
    {
        const std::size_t begin = offsetOf(value.place);
        if (value.kind != Node::Kind::array && value.kind != Node::Kind::object)
            return begin + static_cast<std::size_t>(value.place.length);
        std::size_t last = begin + 1;
        for (const Node& item : value.items) last = endOf(item);
        for (const Member& member : value.members) last = endOf(member.value);
        return text_.find(value.kind == Node::Kind::array ? ']' : '}', last) + 1;
    }

    std::string replaced(std::size_t begin, std::size_t end, const std::string& with) const
    {
        return text_.substr(0, begin) + with + text_.substr(end);
    }

    /// Without the stretch and the comma that parts it from its neighbour.
    std::string without(std::size_t begin, std::size_t end) const
    {
        const std::size_t next = text_.find_first_not_of(" \n", end);
        if (text_[next] == ',') return replaced(begin, next + 1, "");
        const std::size_t before = text_.find_last_not_of(" \n", begin - 1);
        return replaced(text_[before] == ',' ? before : begin, end, "");
    }

    void visit(const Node& node, const std::string& pointer)
    {
        const auto give = [&](const char* what, const std::string& below, const std::string& name,
                              const Node& changed, const std::string& text) {
            Mutation mutation{text, what + below, node.place.line, lineOf(endOf(node)), {name}};
            collectNames(changed, mutation.names);
            const std::vector<std::string> keys = pointerKeys(pointer);
            if (!keys.empty()) mutation.names.insert(keys.begin() + 1, keys.end());  // no section
            each_(mutation);
        };
        for (const Member& member : node.members) {
            const std::string below = pointer + "/" + member.key;
            const std::size_t key = offsetOf(member.key_place), end = endOf(member.value);
            const Node& value = member.value;
            if (wanted()) give("without ", below, member.key, value, without(key, end));
            if (wanted())
                give("renamed ", below, member.key, value, replaced(key + 1, key + 1, "zz"));
            if (wanted())
                give("retyped ", below, member.key, value,
                     replaced(offsetOf(value.place), end, retyped(value)));
            visit(value, below);
        }
        for (const Node& item : node.items) {
            const std::string below = pointer + "/" + std::to_string(&item - node.items.data());
            const std::size_t begin = offsetOf(item.place), end = endOf(item);
            if (wanted()) give("without ", below, "", item, without(begin, end));
            if (wanted()) give("retyped ", below, "", item, replaced(begin, end, retyped(item)));
            visit(item, below);
        }
    }

    bool wanted() { return ++count_ % stride_ == 0; }

    int lineOf(std::size_t offset) const
    {
        const auto begin = text_.begin();
        return static_cast<int>(std::count(begin, begin + static_cast<long>(offset), '\n')) + 1;
    }

    const int stride_;
    const Each each_;
    std::string text_;
    int count_ = 0;
};

/// A config that shows the module: itself, or the first shipped config that extends it.
std::string configFor(const std::string& path)
{
    const std::string folder = "configs/", ending = ".json";
    const std::string name = path.substr(0, path.size() - ending.size());
    if (path.rfind(folder, 0) == 0) return name.substr(folder.size());
    for (const std::string& config : configNames(shippedSources()))
        if (shippedSources().find(folder + config + ending)->text.find("\"" + name + "\"") !=
            std::string::npos)
            return config;
    return {};
}

/// Errors until there is a renderer; none when there is one.
Diagnostics errorsOf(const SourceSet& sources, const std::string& config, RecordingDevice& device)
{
    const Result<Node> document = loadConfig(sources, {config});
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, sources);
    if (!description) return description.diagnostics();
    SceneTraits traits;
    traits.lights = 1;
    auto renderer = Renderer::create(device, *description, {{64, 36}, {}, {}}, traits);
    return renderer ? Diagnostics() : renderer.diagnostics();
}

/// True at the change, or where a diagnostic names what the change concerns.
bool concerns(const Diagnostic& reported, const Mutation& mutation)
{
    const auto inside = [&](const Place& place) {
        const bool whole = place.line == 1 && place.column == 1;  // something it has not at all
        return place.source && place.source->name.rfind("changed ", 0) == 0 &&
               (whole || (place.line >= mutation.first_line && place.line <= mutation.last_line));
    };
    if (inside(reported.place)) return true;
    for (const Note& note : reported.notes)
        if (inside(note.place)) return true;
    const std::string text = lowerCase(reported.message + " " + reported.pointer);
    return anyOf(mutation.names, [&](const std::string& name) {
        return !name.empty() && text.find(lowerCase(name)) != std::string::npos;
    });
}

void checkReported(const Diagnostics& reported, const Mutation& mutation,
                   const RecordingDevice& device)
{
    for (const Diagnostic& each : reported) {
        CHECK(each.place.source);
        CHECK(each.place.line > 0);
        CHECK_FALSE(each.message.empty());
        CHECK_FALSE(each.help.empty());
        CHECK(concerns(each, mutation));
    }
    CHECK(device.log().empty());
}

}  // namespace

TEST_CASE("Every shipped config and module, changed anywhere, plans or says where and why not")
{
    const int stride = nightly() ? 1 : kStride;
    int broken = 0;
    std::string path, config;
    Mutator mutator(stride, [&](const Mutation& mutation) {
        MemorySources mine;
        mine.add(path, mutation.text, "changed " + path);
        const LayeredSources sources({&mine, &shippedSources()});
        RecordingDevice device;
        const Diagnostics reported = errorsOf(sources, config, device);
        if (reported.empty()) return;
        ++broken;
        INFO(config << ": " << path << " " << mutation.what << "\n" << toText(reported));
        checkReported(reported, mutation, device);
    });
    for (const std::string& each : shippedSources().list()) {
        path = each;
        config = endsWith(path, ".json") ? configFor(path) : "";
        if (!config.empty()) mutator.run(shippedSources().find(path));
    }
    CHECK(mutator.count() > 3000);
    CHECK(broken > mutator.count() / stride / 4);
}
