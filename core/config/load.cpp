// SPDX-License-Identifier: MIT
// From a config's name to one merged document.
#include <crevice/config.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/config/decode_report.h"
#include "core/config/left_out.h"
#include "core/json/merge.h"

#include <filesystem>
#include <system_error>

namespace crevice {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSuffix = ".json";
constexpr std::string_view kConfigs = "configs/";

std::string withSuffix(const std::string& name)
{
    return endsWith(name, kSuffix) ? name : name + std::string(kSuffix);
}

// Configs by name, and modules by path where asked for.
std::vector<std::string> namesIn(const SourceSet& sources, bool modules)
{
    std::vector<std::string> names;
    for (const std::string& path : sources.list()) {
        const bool config = startsWith(path, kConfigs);
        if (!endsWith(path, kSuffix) || (!config && !modules)) continue;
        const std::size_t begin = config ? kConfigs.size() : 0;
        names.push_back(path.substr(begin, path.size() - kSuffix.size() - begin));
    }
    return names;
}

// Whether it is the config itself and not its name.
bool isText(const std::string& config) { return startsWith(config, "{"); }

// The roots of all files of a request: its own, and the folder of the config.
std::vector<std::string> rootsOf(const LoadRequest& request)
{
    std::vector<std::string> roots = request.roots;
    const fs::path config = request.config;
    if (isText(request.config))
        roots.push_back(".");
    else if (endsWith(request.config, kSuffix))
        roots.push_back(config.has_parent_path() ? config.parent_path().string() : ".");
    return roots;
}

// A module that is named with the config is laid over it as an override's.
LoadRequest spreadOut(LoadRequest request)
{
    const std::vector<std::string> parts = splitName(request.config);
    request.config = parts[0];
    for (std::size_t i = parts.size(); i-- > 1;)
        request.overrides.insert(request.overrides.begin(), "+" + parts[i]);
    return request;
}

Result<SourceRef> findConfig(const SourceSet& sources, const LoadRequest& request)
{
    const std::string& config = request.config;
    const bool file = endsWith(config, kSuffix);
    const auto roots = std::make_shared<const std::vector<std::string>>(rootsOf(request));
    if (isText(config))
        return std::make_shared<const SourceText>(SourceText{"(JSON text)", config, {}, {}, roots});
    if (SourceRef source = file ? readFile(config, roots) : nullptr) return source;
    const std::string shipped = std::string(kConfigs) + config + std::string(kSuffix);
    if (SourceRef source = sources.find(file ? config : shipped)) return source;
    std::vector<std::string> names = filesBeside(config, config, kSuffix);
    const char* what = names.empty() ? "shipped configs" : "files here and shipped configs";
    for (std::string& name : configNames(sources)) names.push_back(std::move(name));
    Diagnostic missing{Code::module_missing,
                       file ? "the file '" + config + "' " + absenceOf(config)
                       : readStart(config, 0).failure == "it is a folder"
                           ? "'" + config + "' is a folder, and no config"
                           : "there is no config '" + config + "'",
                       suggestName(config, names, what)};
    if (!file && !startsWith(missing.help, "did you"))
        missing.help = suggestName(withSuffix(config), names, what);
    if (!file) missing.help += "; the name of a file of your own ends in .json";
    if (config.find(',') != config.npos) missing.help = "name one config at a time, without ','";
    if (config.find('=') != config.npos) missing.help = "write --set " + config + ": one for each";
    if (!file && sources.find(config + std::string(kSuffix)))
        missing.help =
            "'" + config + "' is a module: lay it over a config, as in 'mobile+" + config + "'";
    return missing;
}

// Takes the member out of the object, where it has one.
std::optional<Member> takeMember(Node& object, std::string_view key)
{
    for (auto at = object.members.begin(); at != object.members.end(); ++at) {
        if (at->key != key) continue;
        Member member = std::move(*at);
        object.members.erase(at);
        return member;
    }
    return std::nullopt;
}

Diagnostic wrongType(const Node& found, const char* wanted, std::string pointer, std::string help)
{
    return {Code::wrong_type, "found " + brief(found) + " where " + wanted + " was wanted",
            std::move(help), found.place, std::move(pointer)};
}

// True for "+geometry/host_depth", which lays a module over the config.
bool adds(const std::string& override) { return startsWith(override, "+"); }

// True for "filter/box=filter/median", which swaps a module for another.
bool swaps(const std::string& override)
{
    const std::size_t slash = override.find('/');
    return !adds(override) && slash != 0 && slash < override.find('=');
}

// These are taken out of each file, so what is still there was laid over the config: by `where`, a
// variant or an override, which the pointer `outer` leads to.
void checkTaken(Node& document, const std::string& where, const std::string& outer,
                Diagnostics& errors)
{
    for (const char* key : {"extends", "variants", "needs", "replaces"})
        if (const std::optional<Member> taken = takeMember(document, key))
            errors.push_back({Code::unknown_key,
                              "found '" + taken->key + "' in " + where + ", which cannot have it",
                              "write it into a file of its own; --set OLD=NEW swaps a module",
                              taken->key_place, memberPointer(outer, key)});
}

// What distinguishes two files, by whatever path they were reached. A catalog path never begins
// with '/', a canonical path on disk always does.
std::string identityOf(const SourceText& source)
{
    if (!source.path.empty()) return source.path;
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(source.name, error);
    return error ? source.name : canonical.string();
}

// Reads a config's files, each once and each after all that it extends.
struct FileLoader {
    const SourceSet& sources;
    const LoadRequest request;
    std::vector<LoadedFile> files = {};  // in the order of merging
    std::string config = {};             // the identity of the config itself
    Diagnostics errors = {};
    std::vector<LoadedFile> open = {};  // from the config to the file being read
    int named = 0;                      // so many files, the same ones again included
    bool full = false;                  // as `limits` say
    std::vector<Override> swapped = {};
    std::vector<std::string> extended = {};  // all that configs name

    // Reads the config and all that it extends. What it returns was left out.
    Removal run()
    {
        readSwaps();
        const Result<SourceRef> found = findConfig(sources, request);
        if (!found) {
            errors = found.diagnostics();
            return {};
        }
        config = identityOf(**found);
        load(*found, {}, "");
        loadAdded();
        if (errors.empty()) checkSwaps();
        Removal left_out;
        if (errors.empty()) left_out = leaveOutReplaced(files);
        if (errors.empty())
            if (std::optional<Diagnostic> clash = clashIn(files)) errors.push_back(*clash);
        cutShort(errors);
        return left_out;
    }

    // The file if it was read, else null.
    LoadedFile* find(const std::string& identity)
    {
        for (LoadedFile& file : files)
            if (file.identity == identity) return &file;
        return nullptr;
    }

    void load(const SourceRef& found, const Place& asked, const std::string& pointer)
    {
        LoadedFile file{{found->name, asked, pointer}, identityOf(*found)};
        LoadedFile* const done = find(file.identity);
        if (done) done->named = named++;
        if (done || !mayOpen(file) || isFull(file)) return;
        file.named = named++;
        SourceText text = *found;
        if (asked.source) text.asked = std::make_shared<const Place>(asked);
        Result<Node> document = parseDocument(std::make_shared<const SourceText>(std::move(text)));
        append(errors, document.diagnostics());
        if (document) {
            checkFormat(*document);
            takeMember(*document, "$schema");  // by which editors find what checks the file
            const std::vector<Node> extends = takeNames(*document, "extends");
            for (const Node& each : takeNames(*document, "needs")) file.needs.push_back(each.text);
            for (const Node& each : takeNames(*document, "replaces"))
                file.replaces.push_back(each.text);
            file.variants = takeVariants(*document);
            open.push_back(std::move(file));
            for (std::size_t i = 0; i < extends.size(); ++i)
                if (extends[i].kind == Node::Kind::string)
                    loadEntry(afterSwaps(extends[i]), "/extends/" + std::to_string(i));
            file = std::move(open.back());
            open.pop_back();
            file.body = std::move(*document);
        }
        files.push_back(std::move(file));
    }

    // What overrides lay over the config, as if it were at the end of its `extends`.
    void loadAdded()
    {
        for (const std::string& text : request.overrides) {
            if (!adds(text)) continue;
            const Place place = overridePlace(text, rootsOf(request));
            if (text.size() == 1)
                errors.push_back({Code::override_syntax, "found '+' where +MODULE was wanted",
                                  "write +geometry/host_depth", place});
            else
                loadEntry(textNode(text.substr(1), place), "");
        }
    }

    void readSwaps()
    {
        for (const std::string& text : request.overrides) {
            if (!swaps(text)) continue;
            Result<Override> read = readOverride(text, rootsOf(request));
            append(errors, read.diagnostics());
            if (read && read->value.kind != Node::Kind::string)
                errors.push_back(
                    wrongType(read->value, "a name", "",
                              "write the name of a module; to set a value, write its name "
                              "alone, or a path that begins with '/'"));
            else if (read)
                swapped.push_back(std::move(*read));
        }
    }

    // What an override puts in the place of an entry of `extends`. What modules extend is theirs.
    const Node& afterSwaps(const Node& entry)
    {
        const std::string& file = entry.place.source->path;
        if (!file.empty() && !isRelative(file) && !startsWith(file, kConfigs)) return entry;
        extended.push_back(entry.text);
        const Override* swap = findNamed(swapped, entry.text);
        return swap ? swap->value : entry;
    }

    // The targets and interfaces that a module and what it extends make.
    Names madeBy(const std::string& module) const
    {
        FileLoader loader{sources, {R"({"format": 1, "extends": [)" + jsonString(module) + "]}"}};
        loader.run();
        Names made;
        for (const LoadedFile& file : loader.files) collectNames(file.body, false, made);
        for (auto each = made.begin(); each != made.end();)
            each = each->first == "targets" || each->first == "interfaces" ? std::next(each)
                                                                           : made.erase(each);
        return made;
    }

    // A swap for what makes nothing of the same names leaves a hole that each reader would report.
    void checkSwaps()
    {
        for (const Override& swap : swapped) {
            if (!contains(extended, swap.name)) {
                errors.push_back({Code::module_missing, "no config extends '" + swap.name + "'",
                                  suggestName(swap.name, extended, "modules to swap"), swap.place});
                continue;
            }
            const Names wanted = madeBy(swap.name);
            const auto serves = [&](const std::string& module) {
                const Names made = madeBy(module);
                return anyOf(made, [&](const auto& each) { return wanted.count(each) > 0; });
            };
            if (wanted.empty() || serves(swap.value.text)) continue;
            std::vector<std::string> others;
            const std::string folder = swap.name.substr(0, swap.name.rfind('/') + 1);
            for (const std::string& each : namesIn(sources, true))
                if (startsWith(each, folder) && serves(each)) others.push_back(each);
            errors.push_back({Code::module_missing,
                              "'" + swap.value.text + "' makes nothing of what '" + swap.name +
                                  "' makes, whose place it would take",
                              suggestName(swap.value.text, others, "modules that can"),
                              swap.value.place});
        }
    }

    bool mayOpen(const LoadedFile& file)
    {
        std::string chain;
        for (const LoadedFile& opened : open)
            if (!chain.empty() || opened.identity == file.identity) chain += opened.name + " -> ";
        if (!chain.empty())
            errors.push_back({Code::module_cycle,
                              "'extends' leads back to itself: " + chain + file.name,
                              "take this entry out of 'extends'", file.place, file.pointer});
        else if (open.size() > kMaxExtendsDepth)
            errors.push_back(
                {Code::module_depth,
                 "found 'extends' more than " + std::to_string(kMaxExtendsDepth) + " deep",
                 "let the config name what it needs in one list", file.place, file.pointer});
        else
            return true;
        return false;
    }

    // Whether no more files are read. The first that is one too many is reported.
    bool isFull(const LoadedFile& file)
    {
        const int most = request.limits.files;
        if (static_cast<int>(files.size() + open.size()) < most) return false;
        if (!full)
            errors.push_back({Code::over_limit,
                              "the config extends more than " + std::to_string(most) + " files",
                              "merge some into one, or raise Limits::files (--limit files=N)",
                              file.place, file.pointer});
        full = true;
        return true;
    }

    Result<SourceRef> findExtended(const Node& entry, const std::string& pointer) const
    {
        const SourceText& from = *entry.place.source;
        const std::string& name = entry.text;
        Diagnostic missing{Code::module_missing, "there is no module or config '" + name + "'", "",
                           entry.place, pointer};
        missing.help = slashed(from, name);
        if (!missing.help.empty() && !isOnDisk(name)) return missing;
        if (endsWith(name, ".frag") || endsWith(name, ".vert") || endsWith(name, ".glsl")) {
            const std::string module = name.substr(0, name.rfind('.')) + std::string(kSuffix);
            const auto beside = openNamed(from, resolvePath(locationOf(from), module));
            missing.message = "'" + name + "' names a shader, and 'extends' takes JSON modules";
            missing.help = isOnDisk(name) && beside && *beside
                               ? "write '" + module + "', which is there"
                               : "name a module whose `shaders` have it";
            return missing;
        }
        if (!isOnDisk(name)) {
            const std::string path = name + std::string(kSuffix);
            if (SourceRef source = sources.find(path)) return source;
            if (SourceRef source = sources.find(std::string(kConfigs) + path)) return source;
            missing.help = suggestName(name, namesIn(sources, true), "modules and configs");
            const std::string own = "./" + withSuffix(name);
            const std::string file = resolvePath(locationOf(from), own);
            if (const auto there = openNamed(from, file); from.path.empty() && there && *there)
                missing.help = "write '" + own + "': the path to a file begins with './'";
            return missing;
        }
        const bool shipped = !from.path.empty() && !isRelative(from.path);
        const std::string path = resolvePath(locationOf(from), name);
        if (path.empty())
            return Diagnostic{Code::module_escape,
                              "the path '" + name + "' leads out of the modules",
                              "name a module, such as 'ssao/hemisphere'", entry.place, pointer};
        Result<SourceRef> found =
            shipped ? Result<SourceRef>(sources.find(path)) : openNamed(from, path);
        if (!found) {
            Diagnostic refused = found.diagnostics().front();
            refused.place = entry.place;
            refused.pointer = pointer;
            return refused;
        }
        if (*found) return found;
        missing.message = shipped ? "there is no module '" + path + "'"
                                  : "the file '" + path + "' " + absenceOf(path);
        if (!shipped && missing.help.empty())
            missing.help =
                suggestName(withSuffix(name), filesBeside(path, name, kSuffix), "files there");
        if (!missing.help.empty()) missing.help += "; ";
        missing.help +=
            "the path is seen from the folder of '" + from.name + "', and ends in .json";
        return missing;
    }

    void loadEntry(const Node& entry, const std::string& pointer)
    {
        if (errors.size() >= kMaxDiagnostics) return;
        const Result<SourceRef> found = findExtended(entry, pointer);
        if (!found) return append(errors, found.diagnostics());
        load(*found, entry.place, pointer);
        const LoadedFile* theirs = find(identityOf(**found));
        if (!theirs || open.empty()) return;
        std::set<std::string>& mine = open.back().extended;
        mine.insert(theirs->identity);
        mine.insert(theirs->extended.begin(), theirs->extended.end());
    }

    void checkFormat(const Node& document)
    {
        const Node* format = document.find("format");
        if (format && format->integer() && format->number == 1) return;
        errors.push_back({Code::format_version,
                          "found " + (format ? "format " + brief(*format) : "no 'format'") +
                              " where 1 was wanted",
                          format ? "write \"format\": 1, or update crevice to read a later one"
                                 : "begin the file with \"format\": 1",
                          format ? format->place : document.place, "/format"});
    }

    // The strings of a list: `extends`, `needs` or `replaces`.
    std::vector<Node> takeNames(Node& document, const char* key)
    {
        const std::optional<Member> taken = takeMember(document, key);
        if (!taken) return {};
        const Node& list = taken->value;
        const std::string pointer = memberPointer("", key);
        if (list.kind != Node::Kind::array)
            errors.push_back(wrongType(list, "a list of names", pointer,
                                       "write it in brackets: [\"name\", ...]"));
        for (std::size_t i = 0; i < list.items.size(); ++i)
            if (list.items[i].kind != Node::Kind::string)
                errors.push_back(wrongType(list.items[i], "a name",
                                           pointer + "/" + std::to_string(i),
                                           "write a name in double quotes"));
        return list.items;
    }

    std::vector<Member> takeVariants(Node& document)
    {
        std::optional<Member> taken = takeMember(document, "variants");
        if (!taken) return {};
        if (taken->value.kind != Node::Kind::object)
            errors.push_back(wrongType(taken->value, "an object of variants", "/variants",
                                       "write {\"name\": {what to change}, ...}"));
        for (const Member& variant : taken->value.members)
            if (variant.value.kind != Node::Kind::object)
                errors.push_back(wrongType(variant.value, "an object",
                                           memberPointer("/variants", variant.key),
                                           "write what to change, as in the config itself: "
                                           "{\"params\": ...}"));
        return std::move(taken->value.members);
    }
};

std::vector<std::string> variantsOf(const std::vector<LoadedFile>& files)
{
    std::set<std::string> names;
    for (const LoadedFile& file : files)
        for (const Member& variant : file.variants) names.insert(variant.key);
    return {names.begin(), names.end()};
}

// A name may come more than once.
void applyVariant(Node& document, const std::vector<LoadedFile>& files, const LoadRequest& request,
                  Diagnostics& errors)
{
    std::vector<std::string> names = variantsOf(files);
    for (const LoadedFile& file : files)
        for (const Member& variant : file.variants)
            if (variant.key == request.variant) mergePatch(document, variant.value, errors);
    checkTaken(document, "a variant", memberPointer("/variants", request.variant), errors);
    if (contains(names, request.variant)) return;
    errors.push_back({Code::variant_missing,
                      "there is no variant '" + request.variant + "' of '" + request.config + "'",
                      suggestName(request.variant, std::move(names), "variants"), document.place,
                      "/variants"});
}

}  // namespace

Result<Node> loadConfig(const SourceSet& sources, const LoadRequest& asked)
{
    const LoadRequest request = spreadOut(asked);
    FileLoader loader{sources, request};
    const Removal left_out = loader.run();
    if (!loader.errors.empty()) return loader.errors;  // merging what is not whole adds false ones
    Node document;
    document.kind = Node::Kind::object;
    Diagnostics errors;
    for (const LoadedFile& file : loader.files) mergePatch(document, file.body, errors);
    for (const Member& each : left_out.files) document.deleted.push_back(each);
    for (const auto& [section, name] : left_out.names)
        if (Node* entries = document.find(section))
            entries->deleted.push_back({name, left_out.place, {}});
    const Node& own = loader.find(loader.config)->body;
    document.place = own.place;
    for (const char* key : {"name", "description"})  // an override's module has them too
        if (const Node* value = own.find(key))
            if (Node* merged = document.find(key)) *merged = *value;
    const auto changes_structure = [](const std::string& text) {
        return startsWith(text, "/") || swaps(text);
    };
    const bool changed = anyOf(request.overrides, changes_structure);
    document.origins.assign(changed ? 2 : request.variant.empty() ? 0 : 1, document.place);
    if (!request.variant.empty()) applyVariant(document, loader.files, request, errors);
    for (const std::string& text : request.overrides) {
        if (swaps(text) || adds(text)) continue;
        Diagnostics found = applyOverride(document, text, rootsOf(request)).diagnostics();
        for (Diagnostic& each : found)
            for (const char* section : {"params", "features"})
                if (each.code == Code::unknown_param)
                    each.help =
                        table::declaredBy(sources, section, text.substr(0, text.find('='))) +
                        each.help;
        append(errors, found);
    }
    checkTaken(document, "an override", "", errors);
    cutShort(errors);
    if (!errors.empty()) return errors;
    return document;
}

std::vector<std::string> variantNames(const SourceSet& sources, const LoadRequest& asked)
{
    FileLoader loader{sources, spreadOut(asked)};
    loader.run();
    return variantsOf(loader.files);
}

std::vector<std::string> configNames(const SourceSet& sources) { return namesIn(sources, false); }

std::vector<std::string> splitName(const std::string& name)
{
    if (endsWith(name, kSuffix) || isText(name)) return {name};
    const std::size_t file = name.rfind(std::string(kSuffix) + "+");
    const std::size_t plus = name.find('+', file == std::string::npos ? 0 : file);
    std::vector<std::string> parts = {name.substr(0, plus)};
    if (plus == std::string::npos) return parts;
    for (std::string_view part : split(std::string_view(name).substr(plus + 1), '+'))
        parts.emplace_back(part);
    return parts;
}

}  // namespace crevice
