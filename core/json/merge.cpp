// SPDX-License-Identifier: MIT
// RFC 7396 merge patches with origins.
#include "core/json/merge.h"

#include "core/base/text.h"

#include <algorithm>

namespace crevice {

namespace {

bool isObject(const Node& node) { return node.kind == Node::Kind::object; }

// "an object", for a sentence.
std::string oneOf(const Node& node)
{
    const std::string name = kindName(node.kind);
    const bool vowel = isObject(node) || node.kind == Node::Kind::array;
    return node.kind == Node::Kind::null ? name : (vowel ? "an " : "a ") + name;
}

Diagnostic missingKey(const Node& base, const Member& patch, std::string pointer)
{
    Diagnostic diagnostic{
        Code::merge_missing,
        "found null for key '" + patch.key + "', which is not there to be deleted", "",
        patch.key_place};
    diagnostic.pointer = std::move(pointer);
    diagnostic.help = "leave the key out";
    if (base.members.empty()) return diagnostic;
    if (base.place.source) diagnostic.notes.push_back({base.place, "the base object is here"});
    std::vector<std::string> keys;
    for (const Member& member : base.members) keys.push_back(member.key);
    diagnostic.help = suggestName(patch.key, std::move(keys), "keys");
    return diagnostic;
}

// The key that a bare value stands for at `pointer`: "radius": 0.8 below /params is its "default".
// Empty where there is none such.
std::string_view mainKey(std::string_view pointer)
{
    const auto parts = std::count(pointer.begin(), pointer.end(), '/');
    const bool tunable = startsWith(pointer, "/params/") || startsWith(pointer, "/features/");
    if (tunable) return parts == 2 ? "default" : "";
    if (!startsWith(pointer, "/passes/") || parts != 4) return "";
    return startsWith(pointer.substr(pointer.find('/', 8)), "/inputs/") ? "from" : "";
}

// An object in which the value has that key.
Node under(std::string_view key, const Node& value)
{
    Node object;
    object.kind = Node::Kind::object;
    object.place = value.place;
    object.members.push_back({std::string(key), value.place, value});
    return object;
}

Diagnostic wrongKind(const Node& base, const Node& patch, const std::string& pointer)
{
    Diagnostic diagnostic{Code::merge_kind,
                          "found " + oneOf(patch) + " where " + oneOf(base) + " is to be changed",
                          "", patch.place, pointer};
    if (base.place.source) diagnostic.notes.push_back({base.place, "the base value is here"});
    if (isObject(base))
        diagnostic.help = "write an object with the keys to change, or null to delete";
    else
        diagnostic.help = "write the whole value: only objects change key by key";
    return diagnostic;
}

class Merger {
public:
    explicit Merger(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void merge(Node& base, const Node& patch, const std::string& pointer)
    {
        if (const std::string_view key = mainKey(pointer); !key.empty()) {
            if (!isObject(base) && isObject(patch)) base = under(key, base);
            if (isObject(base) && !isObject(patch)) return merge(base, under(key, patch), pointer);
        }
        if (isObject(base) != isObject(patch)) {
            diagnostics_.push_back(wrongKind(base, patch, pointer));
        } else if (isObject(base) && base.members.empty()) {
            base.members = std::move(fresh(patch, pointer).members);
        } else if (isObject(base)) {
            // A patch names each key once, so what it adds need not be searched.
            std::size_t searched = base.members.size();
            for (const Member& member : patch.members)
                mergeMember(base, member, memberPointer(pointer, member.key), searched);
        } else {
            std::vector<Place> origins = base.origins;
            origins.push_back(base.place);
            base = patch;
            base.origins = std::move(origins);
        }
    }

private:
    void mergeMember(Node& base, const Member& patch, const std::string& pointer,
                     std::size_t& searched)
    {
        std::vector<Member>& members = base.members;
        const auto end = members.begin() + static_cast<std::ptrdiff_t>(searched);
        const auto found =
            std::find_if(members.begin(), end, [&](const Member& m) { return m.key == patch.key; });
        const bool there = found != end;
        if (patch.value.kind != Node::Kind::null) {
            if (there)
                merge(found->value, patch.value, pointer);
            else
                addMember(base, patch, pointer);
        } else if (there) {
            members.erase(found);
            --searched;
            base.deleted.push_back(patch);
        } else {
            diagnostics_.push_back(missingKey(base, patch, pointer));
        }
    }

    // Deleting below a key that is not there is a mistake in that key where a similar one is.
    void addMember(Node& base, const Member& patch, const std::string& pointer)
    {
        const std::size_t before = diagnostics_.size();
        Node value = fresh(patch.value, pointer);
        if (diagnostics_.size() > before) {
            Diagnostic missing = missingKey(base, patch, pointer);
            if (startsWith(missing.help, "did you mean")) {
                missing.message = "found the key '" + patch.key +
                                  "' with a null in it, and there "
                                  "is nothing to be deleted";
                diagnostics_.resize(before);
                diagnostics_.push_back(std::move(missing));
            }
        }
        base.members.push_back({patch.key, patch.key_place, std::move(value)});
    }

    // A copy for a place where nothing was, so that nothing can be deleted either. No member
    // is looked up: a large file merges in linear time.
    Node fresh(const Node& patch, const std::string& pointer)
    {
        if (!isObject(patch)) return patch;
        Node copy;
        copy.kind = patch.kind;
        copy.place = patch.place;
        for (const Member& member : patch.members) {
            const std::string below = memberPointer(pointer, member.key);
            if (member.value.kind == Node::Kind::null)
                diagnostics_.push_back(missingKey({}, member, below));
            else
                copy.members.push_back({member.key, member.key_place, fresh(member.value, below)});
        }
        return copy;
    }

    Diagnostics& diagnostics_;
};

}  // namespace

void mergePatch(Node& base, const Node& patch, Diagnostics& diagnostics)
{
    Merger(diagnostics).merge(base, patch, {});
}

}  // namespace crevice
