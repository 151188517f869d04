// SPDX-License-Identifier: MIT
// What is left out of a config, and what then has no meaning any more.
#include "core/config/left_out.h"

#include "core/base/text.h"
#include "core/json/merge.h"

namespace crevice {
namespace {

// Sections, and the key that declarations have and patches have not; none where strings declare.
constexpr struct {
    const char* section;
    const char* key;
} kSections[] = {{"params", "default"},     {"features", "default"}, {"features", "type"},
                 {"imports", "type"},       {"targets", "format"},   {"shaders", "fragment"},
                 {"passes", "shader"},      {"views", "target"},     {"outputs", ""},
                 {"boxes", "edge"},         {"outputs", "target"},   {"interfaces", ""},
                 {"generated", "generator"}};

bool declares(const std::string& section, const Node& entry)
{
    return anyOf(kSections, [&](const auto& each) {
        return each.section == section &&
               (*each.key ? entry.find(each.key) != nullptr : entry.kind == Node::Kind::string);
    });
}

// The file that takes the place of `file`, or null.
const LoadedFile* replacing(const LoadedFile& file, const std::vector<LoadedFile>& files)
{
    const LoadedFile* last = nullptr;
    for (const LoadedFile& other : files) {
        const auto replaced = [&](const auto& need) { return contains(other.replaces, need); };
        if (other.named > file.named && anyOf(file.needs, replaced) &&
            file.extended.count(other.identity) == 0 && (!last || other.named > last->named))
            last = &other;
    }
    return last;
}

void eraseNames(Node& object, const std::string& section, const Names& gone)
{
    const auto is_gone = [&](const Member& each) { return gone.count({section, each.key}) > 0; };
    eraseIf(object.members, is_gone);
}

// What a body or a variant says of these names, levels of features included.
void prune(Node& body, const Names& gone)
{
    for (Member& section : body.members) eraseNames(section.value, section.key, gone);
    Node* features = body.find("features");
    if (!features) return;
    for (Member& feature : features->members)
        if (Node* sets = feature.value.find("sets"))
            for (Member& word : sets->members)
                for (const char* section : {"params", "features"})
                    eraseNames(word.value, section, gone);
}

// "geometry/back_faces" of a module; of a file on disk, its path as it was given.
std::string nameOf(const LoadedFile& file)
{
    std::string name = startsWith(file.identity, "/") ? file.name : file.identity;
    if (endsWith(name, ".json")) name.resize(name.size() - 5);
    return name;
}

// What files declare that are not left out. Before `last`, what a file says of a name of a left out
// file that it extends is a change of that one's, also where it reads as a declaration.
Names declaredByOthers(const std::vector<LoadedFile>& files, const std::vector<bool>& out,
                       std::size_t last)
{
    Names kept;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (out[i]) continue;
        Names declared, changed;
        collectNames(files[i].body, false, declared);
        for (std::size_t base = 0; i < last && base < files.size(); ++base)
            if (out[base] && files[i].extended.count(files[base].identity) > 0)
                collectNames(files[base].body, false, changed);
        for (const auto& each : changed) declared.erase(each);
        kept.insert(declared.begin(), declared.end());
    }
    return kept;
}

// What may be given only once: a shader's GLSL, the file behind an interface. Null when neither.
const Node* glslAt(const Node& body, const char* list, const std::string& name)
{
    const Node* all = body.find(list);
    const Node* value = all ? all->find(name) : nullptr;
    const Node* file = value && value->kind == Node::Kind::object ? value->find("fragment") : value;
    return file && file->kind == Node::Kind::string ? file : nullptr;
}

// To have `other` in the place of `one`.
std::string wayOut(const std::vector<LoadedFile>& files, const LoadedFile& one,
                   const LoadedFile& other)
{
    const SourceRef& asker = one.place.source;
    if (!asker || asker == other.place.source || !startsWith(asker->path, "configs/") ||
        isOnDisk(other.identity))
        return "keep one of the two in 'extends'; one that replaces the other is named last";
    std::vector<std::string> modules;
    for (const LoadedFile& each : files)
        if (each.place.source == asker)
            modules.push_back(jsonString(nameOf(&each == &one ? other : each)));
    return "write --set " + nameOf(one) + "=" + nameOf(other) +
           " instead, or in a file, in the place of '" + asker->path + "', \"extends\": [" +
           joined(modules) + "]";
}

}  // namespace

std::optional<std::string> madeByBoth(const Node& one, const Node& other)
{
    for (const char* list : {"interfaces", "shaders"}) {
        const Node* made = one.find(list);
        if (!made) continue;
        for (const Member& member : made->members) {
            const Node* mine = glslAt(one, list, member.key);
            const Node* theirs = glslAt(other, list, member.key);
            if (!mine || !theirs) continue;
            if (list[0] == 'i') return "interface '" + member.key + "'";
            if (mine->text != theirs->text) return "shader '" + member.key + "'";
        }
    }
    return std::nullopt;
}

void collectNames(const Node& body, bool all, Names& names)
{
    for (const Member& section : body.members)
        for (const Member& entry : section.value.members)
            if (all || declares(section.key, entry.value)) names.emplace(section.key, entry.key);
}

std::optional<Diagnostic> clashIn(const std::vector<LoadedFile>& files)
{
    for (std::size_t later = files.size(); later-- > 1;)
        for (std::size_t first = later; first-- > 0;) {
            const LoadedFile &one = files[first], &other = files[later];
            // A file is read after all that it extends.
            if (other.extended.count(one.identity) > 0) continue;
            const auto made = madeByBoth(one.body, other.body);
            if (!made) continue;
            Diagnostic clash{Code::module_clash,
                             "'" + other.name + "' and '" + one.name + "' both make " + *made +
                                 ", and neither extends the other",
                             wayOut(files, one, other), other.place, other.pointer};
            clash.notes.push_back({one.place, "the other one was asked for here"});
            return clash;
        }
    return std::nullopt;
}

Removal leaveOutReplaced(std::vector<LoadedFile>& files)
{
    Removal left_out;
    std::vector<bool> out(files.size());
    std::size_t last = 0;  // of those that replace
    for (std::size_t i = 0; i < files.size(); ++i) {
        const LoadedFile* by = replacing(files[i], files);
        out[i] = by != nullptr;
        if (!by) continue;
        collectNames(files[i].body, true, left_out.names);
        const std::string reason = "it needs '" + joined(files[i].needs, "', '") + "', which '" +
                                   nameOf(*by) + "' takes the place of";
        left_out.files.push_back({nameOf(files[i]), by->place, textNode(reason, by->place)});
        last = std::max(last, static_cast<std::size_t>(by - files.data()));
    }
    if (left_out.files.empty()) return left_out;
    for (const auto& each : declaredByOthers(files, out, last)) left_out.names.erase(each);
    left_out.place = files[last].place;
    for (std::size_t i = 0; i < last; ++i) {
        prune(files[i].body, left_out.names);
        for (Member& variant : files[i].variants) prune(variant.value, left_out.names);
    }
    for (std::size_t i = files.size(); i-- > 0;)
        if (out[i]) files.erase(files.begin() + static_cast<std::ptrdiff_t>(i));
    return left_out;
}

}  // namespace crevice
