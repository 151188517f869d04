// SPDX-License-Identifier: MIT
// RFC 7396 merge patches with origins, and "radius=0.8" as one.
#include "core/json/merge.h"

#include "core/base/text.h"

namespace crevice {
namespace {

bool isObject(const Node& node) { return node.kind == Node::Kind::object; }

// Whether two values, not both objects, say the same: 2 and 2.0 do.
bool isSame(const Node& a, const Node& b)
{
    if (a.kind != b.kind) return false;
    if (a.kind == Node::Kind::number) return a.number == b.number;
    return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), isSame) &&
           (a.kind == Node::Kind::array || toJson(a) == toJson(b));
}

// `there` is how many of the base's members were there before the patch.
Diagnostic missingKey(const Node& base, std::size_t there, const Member& patch, std::string pointer)
{
    Diagnostic diagnostic{
        Code::merge_missing,
        "found null for key '" + patch.key + "', which is not there to be deleted",
        "leave the key out; or is one above it misspelt?", patch.key_place, std::move(pointer)};
    if (there == 0) return diagnostic;
    if (base.place.source) diagnostic.notes.push_back({base.place, "the base object is here"});
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < there; ++i) keys.push_back(base.members[i].key);
    diagnostic.help = suggestName(patch.key, std::move(keys), "keys");
    for (const Member& section : base.members)
        if (diagnostic.pointer == "/" + patch.key && section.value.find(patch.key))
            diagnostic.help = "write it below \"" + section.key + "\", where it stands";
    return diagnostic;
}

// The key that a bare value at `pointer` is: "radius": 0.8 below /params the "default"; or empty.
std::string_view mainKey(std::string_view pointer)
{
    const auto parts = std::count(pointer.begin(), pointer.end(), '/');
    const bool tunable = startsWith(pointer, "/params/") || startsWith(pointer, "/features/");
    if (tunable) return parts == 2 ? "default" : "";
    if (startsWith(pointer, "/outputs/")) return parts == 2 ? "target" : "";
    if (!startsWith(pointer, "/passes/") || parts != 4) return "";
    return startsWith(pointer.substr(pointer.find('/', 8)), "/inputs/") ? "from" : "";
}

Diagnostic wrongKind(const Node& base, const Node& patch, const std::string& pointer)
{
    Diagnostic diagnostic{Code::merge_kind,
                          std::string("found ") + kindName(patch.kind) + " where " +
                              kindName(base.kind) + " is to be changed",
                          isObject(base)
                              ? wayToObject(pointer, patch, {"that it has"}) + ", or null to delete"
                              : "write the whole value: only objects change key by key",
                          patch.place, pointer};
    if (base.place.source) diagnostic.notes.push_back({base.place, "the base value is here"});
    return diagnostic;
}

// Only the first `searched` members of the base may be those that the patch means.
void mergeMember(Node& base, const Member& patch, const std::string& pointer, std::size_t& searched,
                 Diagnostics& errors)
{
    std::vector<Member>& members = base.members;
    const auto end = members.begin() + static_cast<std::ptrdiff_t>(searched);
    const auto found =
        std::find_if(members.begin(), end, [&](const Member& m) { return m.key == patch.key; });
    const bool deletes = patch.value.kind == Node::Kind::null;
    if (errors.size() > kMaxDiagnostics) return;  // each costs a search
    if (found == end && !deletes && members.size() == kMaxMembers) {
        errors.push_back(tooManyMembers(patch.key_place, pointer));
    } else if (found == end && deletes) {
        errors.push_back(missingKey(base, searched, patch, pointer));
    } else if (found == end) {
        Node& value = members.emplace_back(Member{patch.key, patch.key_place, {}}).value;
        value.kind = patch.value.kind;
        value.place = patch.value.place;
        if (isObject(value))  // in which nothing can be deleted, as nothing was there
            mergePatch(value, patch.value, errors, pointer);
        else
            value = patch.value;
    } else if (deletes) {
        members.erase(found);
        --searched;
        base.deleted.push_back(patch);
    } else {
        mergePatch(found->value, patch.value, errors, pointer);
    }
}

// The keys on the way to what an override sets.
Result<std::vector<std::string>> overrideKeys(const Node& document, const std::string& name,
                                              const Place& place)
{
    if (name[0] == '/') return pointerKeys(name);
    std::vector<std::string> names;
    for (const char* section : {"params", "features"}) {
        const Node* entries = document.find(section);
        if (!entries) continue;
        // A bare value that no object has been laid under declares nothing.
        const Node* declared = entries->find(name);
        if (declared && declared->kind == Node::Kind::object)
            return std::vector<std::string>{section, name, "default"};
        for (const Member& member : entries->members) names.push_back(member.key);
    }
    return Diagnostic{Code::unknown_param, "'" + name + "' is neither a param nor a feature",
                      suggestName(name, std::move(names), "params and features"), place};
}

std::shared_ptr<SourceText> sourceOf(const std::string& text, std::vector<std::string> roots)
{
    roots.push_back(".");  // where its files stand
    auto source = std::make_shared<SourceText>(SourceText{"--set " + text, text, kOverridePath});
    source->roots = std::make_shared<const std::vector<std::string>>(std::move(roots));
    return source;
}

}  // namespace

std::string wayToObject(std::string_view pointer, const Node& value,
                        const std::vector<std::string>& keys)
{
    const bool number = value.kind == Node::Kind::number;
    if (endsWith(pointer, "/size") && value.items.empty())
        return "write {\"scale\": " + (number ? brief(value) : "0.5") + "}";
    const Node* name = value.items.empty() ? &value : &value.items[0];
    if (!keys.empty() && name == &value)
        return "write an object with some of the keys " + joined(keys);
    if (const Node* named = name->find("name")) name = named;
    return "write {" + (name->kind == Node::Kind::string ? brief(*name) : "\"name\"") +
           ": ..., ...}: what it holds has its name as key";
}

Diagnostic tooManyMembers(const Place& place, std::string pointer)
{
    return {
        Code::too_many_members,
        "found more than the " + std::to_string(kMaxMembers) + " members that an object may have",
        "leave some out; a list below an \"x-...\" key may be of any length", place,
        std::move(pointer)};
}

Node objectOf(std::string_view key, const Place& place, Node value)
{
    Node object;
    object.kind = Node::Kind::object;
    object.place = place;
    object.members.push_back({std::string(key), place, std::move(value)});
    return object;
}

Node patchBetween(const Node& base, const Node& now)
{
    Node patch;
    patch.kind = Node::Kind::object;
    for (const Member& member : now.members) {
        const Node* before = base.find(member.key);
        if (before && isObject(*before) && isObject(member.value)) {
            Node below = patchBetween(*before, member.value);
            if (!below.members.empty()) patch.members.push_back({member.key, {}, std::move(below)});
        } else if (!before || !isSame(*before, member.value)) {
            patch.members.push_back(member);
        }
    }
    for (const Member& member : base.members)
        if (!now.find(member.key)) patch.members.push_back({member.key, {}, Node()});
    return patch;
}

Node textNode(std::string text, const Place& place)
{
    Node node;
    node.kind = Node::Kind::string;
    node.text = std::move(text);
    node.place = place;
    return node;
}

void mergePatch(Node& base, const Node& patch, Diagnostics& errors, const std::string& pointer)
{
    if (const std::string_view key = mainKey(pointer); !key.empty()) {
        if (!isObject(base) && isObject(patch)) base = objectOf(key, base.place, base);
        if (isObject(base) && !isObject(patch))
            return mergePatch(base, objectOf(key, patch.place, patch), errors, pointer);
    }
    if (isObject(base) != isObject(patch)) {
        errors.push_back(wrongKind(base, patch, pointer));
    } else if (isObject(base)) {
        // A patch names each key once, so what it adds need not be searched.
        std::size_t searched = base.members.size();
        for (const Member& member : patch.members)
            mergeMember(base, member, memberPointer(pointer, member.key), searched, errors);
    } else {
        std::vector<Place> origins = base.origins;
        origins.push_back(base.place);
        base = patch;
        base.origins = std::move(origins);
    }
}

Place overridePlace(const std::string& text, const std::vector<std::string>& roots)
{
    return {sourceOf(text, roots), 1, 1, static_cast<int>(text.size())};
}

Result<Override> readOverride(const std::string& text, const std::vector<std::string>& roots)
{
    const std::size_t equals = text.find('=');
    const std::shared_ptr<SourceText> source = sourceOf(text, roots);
    const Place place{source, 1, 1, static_cast<int>(std::min(equals, text.size()))};
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::override_syntax, "found '" + text + "' where name=value was wanted",
                          "write radius=0.8, or /passes/blur/when=null for any place", place};

    const std::size_t second = text.find('=', equals + 1), gap = text.find_last_of(" ,", second);
    if (second != text.npos && gap != text.npos && gap > equals &&
        text.find_first_of("[{\"") == text.npos)
        return Diagnostic{Code::override_syntax, "found two values where one name=value was wanted",
                          "write --set " + text.substr(0, text.find_first_of(" ,", equals)) +
                              " --set " + text.substr(gap + 1),
                          place};

    // The name is blank while the value is read, so that columns count from the override's start.
    source->text = std::string(equals + 1, ' ') + text.substr(equals + 1);
    Result<Node> value = parseValue(source);
    source->text = text;
    if (!value) return value.diagnostics();
    return Override{text.substr(0, equals), place, std::move(*value)};
}

std::vector<std::vector<std::string>> levelPaths(const Node& document, const std::string& name)
{
    std::vector<std::vector<std::string>> paths;
    const Node* features = document.find("features");
    for (const Member& feature : features ? features->members : std::vector<Member>())
        if (const Node* sets = feature.value.find("sets"))
            for (const Member& word : sets->members)
                if (word.value.find(name))
                    paths.push_back({"features", feature.key, "sets", word.key, name});
    return paths;
}

Status applyOverride(Node& document, const std::string& text, const std::vector<std::string>& roots)
{
    Result<Override> read = readOverride(text, roots);
    if (!read) return read.diagnostics();
    const Result<std::vector<std::string>> keys = overrideKeys(document, read->name, read->place);
    if (!keys) return keys.diagnostics();
    Diagnostics errors;
    const auto set = [&](const std::vector<std::string>& path) {
        Node patch = read->value;
        for (auto key = path.rbegin(); key != path.rend(); ++key)
            patch = objectOf(*key, read->place, std::move(patch));
        mergePatch(document, patch, errors);
    };
    set(*keys);
    if (read->name[0] != '/')  // a value by its name stands over all levels
        for (const std::vector<std::string>& path : levelPaths(document, read->name)) set(path);
    return errors;
}

}  // namespace crevice
