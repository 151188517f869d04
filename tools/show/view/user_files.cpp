// SPDX-License-Identifier: MIT
#include "tools/show/view/user_files.h"

#include "core/base/content_hash.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/image/image_file.h"
#include "tools/show/plan/planning.h"

namespace crevice {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kConfigFolder = "configs/";
constexpr std::string_view kJsonSuffix = ".json";

// Links stay, since names are resolved without them.
fs::path absolutePath(const fs::path& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

fs::path commonFolder(const fs::path& one, const fs::path& other)
{
    fs::path common;
    for (auto a = one.begin(), b = other.begin(); a != one.end() && b != other.end(); ++a, ++b) {
        if (*a != *b) break;
        common /= *a;
    }
    return common;
}

// Whether a file of the folder is named like one of the shipped configs.
bool hidesShipped(const fs::path& folder, const SourceSet& shipped)
{
    std::error_code error;
    for (const std::string& path : shipped.list())
        if (startsWith(path, kConfigFolder) &&
            fs::exists(folder / path.substr(kConfigFolder.size()), error))
            return true;
    return false;
}

std::string versionOf(const std::string& text)
{
    ContentHash hash;
    hash.addText(text);
    return hash.hex();
}

bool isUtf8(const std::string& text)
{
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8Length(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

// What keeps the text from being written to the file, or nothing.
Diagnostics refusal(const std::string& file, const FileBytes& present, const std::string& text)
{
    if (!isUtf8(text))
        return {{Code::bad_utf8, "the text for '" + file + "' is not UTF-8: it could not be read"}};
    if (!present && !present.missing)
        return {{Code::cannot_write, "cannot write '" + file + "': " + present.failure}};
    if (isUtf8(present.bytes)) return {};
    return {{Code::bad_utf8,
             "'" + file + "' is not UTF-8: the page would save another text than it has",
             "convert it, as with iconv"}};
}

}  // namespace

SourcePaths::SourcePaths(const std::string& config_file, const std::vector<std::string>& roots,
                         const SourceSet& shipped)
    : shipped_(shipped)
{
    const fs::path config = absolutePath(config_file);
    top_ = config.parent_path();
    for (const std::string& root : roots) top_ = commonFolder(top_, absolutePath(root));
    if (hidesShipped(top_, shipped)) folder_ += "mine/";
    config_name_ = of(config_file).substr(kConfigFolder.size());
    config_name_.resize(config_name_.size() - kJsonSuffix.size());
}

std::string SourcePaths::of(const std::string& file) const
{
    const std::string below = absolutePath(file).lexically_relative(top_).generic_string();
    if (below.empty() || below == "." || startsWith(below, "..")) return "";
    const std::string path = folder_ + below;
    return shipped_.find(path) ? "" : path;
}

UserFiles::UserFiles(ConfigOptions options, const SourceSet& shipped)
    : options_(std::move(options)),
      shipped_(shipped),
      config_name_(options_.config)
{
    const std::string file = splitName(options_.config).front();
    if (!endsWith(file, ".json") || !readFile(file)) return;
    paths_.emplace(file, options_.roots, shipped_);
    config_name_ = paths_->configName() + options_.config.substr(file.size());
    watched_.add(file);
    addNamed();
}

// Adds what the config, whole or broken, is made of just now. Returns what is new.
std::vector<std::string> UserFiles::addNamed()
{
    const std::map<std::string, std::string> before = watched_.texts();
    const Result<Node> document = loadConfig(shipped_, requestOf(options_));
    const Result<Description> description = document ? decode(*document, shipped_, options_.limits)
                                                     : Result<Description>(document.diagnostics());
    if (document) watched_.add(*document);
    if (description) watched_.add(*description);
    watched_.add(description.diagnostics());
    broken_ = !description;
    std::vector<std::string> added;
    for (const auto& each : watched_.texts())
        if (before.count(each.first) == 0) added.push_back(each.first);
    return added;
}

// None of a file that the page cannot have.
std::optional<UserFile> UserFiles::fileOf(const std::string& file, const std::string& text) const
{
    const std::string path = paths_->of(file);
    if (path.empty() || text.size() > kMaxDocumentBytes) return std::nullopt;
    return UserFile{path, text, versionOf(text)};
}

// One, by all the names that it is known by.
std::vector<std::string> UserFiles::filesAt(const std::string& path) const
{
    std::vector<std::string> files;
    for (const auto& each : watched_.texts())
        if (!path.empty() && paths_->of(each.first) == path) files.push_back(each.first);
    return files;
}

std::vector<UserFile> UserFiles::all()
{
    std::vector<UserFile> files;
    if (!paths_) return files;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [file, text] : watched_.texts()) {
        const SourceRef now = readFile(file);
        if (auto each = fileOf(file, now ? now->text : text)) files.push_back(std::move(*each));
    }
    return files;
}

Save UserFiles::save(const std::string& path, const std::string& version, const std::string& text)
{
    if (!paths_) return {Save::End::unknown};
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::vector<std::string> files = filesAt(path);
    if (files.empty()) return {Save::End::unknown};
    const FileBytes present = readStart(files.front(), kMaxDocumentBytes + 1);
    if (const Diagnostics why = refusal(files.front(), present, text); !why.empty())
        return {Save::End::failed, {}, why};
    if (present && versionOf(present.bytes) != version)
        return {Save::End::changed, {path, present.bytes, versionOf(present.bytes)}};
    const Status written = writeFile(files.front(), text);
    if (!written) return {Save::End::failed, {}, written.diagnostics()};
    for (const std::string& file : files) watched_.wrote(file, text);
    saved_ = true;
    return {Save::End::done, {path, text, versionOf(text)}};
}

std::vector<UserFile> UserFiles::changes()
{
    constexpr int kPollsOfBroken = 10;
    std::vector<UserFile> files;
    if (!paths_) return files;
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> changed = watched_.changes();
    const bool mended = broken_ && ++polls_ % kPollsOfBroken == 0;
    if (!changed.empty() || saved_ || mended)
        for (const std::string& file : addNamed()) changed.push_back(file);
    saved_ = false;
    for (const std::string& file : changed)
        if (auto each = fileOf(file, watched_.texts().at(file))) files.push_back(std::move(*each));
    return files;
}

Diagnostics UserFiles::check() const
{
    GlslCheck shaders;
    return planForEveryScene(loadDescription(options_, shipped_), options_.variant, kUsualExtent,
                             shaders)
        .diagnostics();
}

}  // namespace crevice
