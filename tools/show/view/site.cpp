// SPDX-License-Identifier: MIT
#include "tools/show/view/site.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/measure/line_file.h"

#include <sys/random.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace crevice {

// The page gets nothing from elsewhere, and nobody learns its address or shows it in a frame. Its
// WebAssembly needs 'wasm-unsafe-eval', its editor writes styles of its own, and what is dropped on
// it becomes blobs, as workers may be.
const std::vector<std::pair<std::string, std::string>> kSiteHeaders = {
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; "
     "style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; connect-src 'self' blob: "
     "data:; "
     "font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    {"Cache-Control", "no-store"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Referrer-Policy", "no-referrer"},
    {"X-Content-Type-Options", "nosniff"},
};

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;  // of a folder that is no page, such as one's home

bool isPage(const fs::path& folder)
{
    std::error_code error;
    return fs::is_regular_file(folder / "index.html", error);
}

constexpr const char* kJson = "application/json";
constexpr std::string_view kScenes = "scene/";
constexpr std::size_t kMostModelBytes = 256u << 20;
constexpr std::size_t kMostPageBytes = 64u << 20;  // of one file

SiteAnswer jsonAnswer(int status, const nlohmann::json& value)
{
    return {status, kJson, std::make_shared<const std::string>(jsonLine(value))};
}

SiteAnswer refused(int status, const std::string& message)
{
    return jsonAnswer(status, {{"message", message}});
}

/// By the extensions of files.
const std::map<std::string, const char*> kTypes = {{".css", "text/css; charset=utf-8"},
                                                   {".html", "text/html; charset=utf-8"},
                                                   {".js", "text/javascript; charset=utf-8"},
                                                   {".wasm", "application/wasm"}};

SiteAnswer pageFile(const std::string& path)
{
    FileBytes file = readBytes(path, kMostPageBytes);
    if (!file) return {404};
    const auto type = kTypes.find(std::filesystem::path(path).extension().string());
    return {200, type == kTypes.end() ? "application/octet-stream" : type->second,
            std::make_shared<const std::string>(std::move(file.bytes))};
}

// Whether both are the same, in a time that says nothing of where they differ.
bool sameSecret(std::string_view given, std::string_view secret)
{
    if (given.size() != secret.size()) return false;
    unsigned differing = 0;
    for (std::size_t k = 0; k < secret.size(); ++k)
        differing |= static_cast<unsigned char>(given[k]) ^ static_cast<unsigned char>(secret[k]);
    return differing == 0;
}

// An If-Match may have its quotes, or not.
std::string unquoted(const std::string& version)
{
    const bool quoted = version.size() >= 2 && version.front() == '"' && version.back() == '"';
    return quoted ? version.substr(1, version.size() - 2) : version;
}

}  // namespace

Result<PageFiles> listPage(const std::string& folder)
{
    if (folder.empty() || !isPage(folder))
        return Diagnostic{Code::page_missing,
                          folder.empty() ? "the page is not built"
                                         : "the folder '" + folder + "' has no index.html",
                          "build the page with tools/page.sh, or name its folder with --page"};
    PageFiles files;
    std::error_code error;
    fs::recursive_directory_iterator entries(folder, error);
    for (const fs::recursive_directory_iterator end; !error && entries != end;
         entries.increment(error)) {
        const fs::path& path = entries->path();
        std::error_code unreadable;
        if (startsWith(path.filename().string(), ".")) {
            entries.disable_recursion_pending();
            continue;
        }
        if (!entries->is_regular_file(unreadable) || !isBelow(path.string(), {folder})) continue;
        files[path.lexically_relative(folder).generic_string()] = path.string();
        if (files.size() == kMostFiles) break;
    }
    files["index.html"] = (fs::path(folder) / "index.html").string();
    return files;
}

std::string builtPageFolder()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path().parent_path() / "share/crevice/page";
    if (!error && isPage(installed)) return installed.string();
    return isPage(CREVICE_PAGE_FOLDER) ? CREVICE_PAGE_FOLDER : "";
}

Result<std::string> randomToken()
{
    constexpr char kDigits[] = "0123456789abcdef";
    unsigned char bytes[16];
    if (getrandom(bytes, sizeof(bytes), 0) != static_cast<ssize_t>(sizeof(bytes)))
        return Diagnostic{Code::cannot_serve, "the system gives no random numbers"};
    std::string token;
    for (const unsigned char byte : bytes) {
        token += kDigits[byte >> 4];
        token += kDigits[byte & 15];
    }
    return token;
}

Site::Site(std::string token, int port, PageFiles page, UserFiles& files, SiteView view)
    : token_(std::move(token)),
      port_(std::to_string(port)),
      page_(std::move(page)),
      files_(files),
      view_(std::move(view))
{
}

std::string Site::address() const { return "http://127.0.0.1:" + port_ + "/" + token_ + "/"; }

// Another name would be that of a page elsewhere that had its name lead here (DNS rebinding).
bool Site::isOurs(const std::string& host) const
{
    return host == "127.0.0.1:" + port_ || host == "localhost:" + port_;
}

// Whether no page of another site asks, as far as the browser says.
bool Site::isAskedByOurs(const SiteRequest& request) const
{
    constexpr std::string_view kOrigin = "http://";
    return request.hosts.size() == 1 && isOurs(request.hosts.front()) &&
           allOf(request.origins,
                 [&](const std::string& origin) {
                     return startsWith(origin, kOrigin) && isOurs(origin.substr(kOrigin.size()));
                 }) &&
           allOf(request.sites, [](const std::string& site) {
               return site == "same-origin" || site == "none";  // typed, or opened by a program
           });
}

std::string Site::nameOf(const SiteRequest& request) const
{
    return request.path.substr(std::min(2 + token_.size(), request.path.size()));
}

std::size_t Site::mostBytes(const SiteRequest& request) const
{
    return startsWith(nameOf(request), kScenes) ? kMostModelBytes : kMaxDocumentBytes;
}

SiteAnswer Site::answer(const SiteRequest& request)
{
    constexpr std::string_view kFiles = "files/";
    if (!isAskedByOurs(request)) return {403};
    const std::size_t end = 1 + token_.size();
    if (request.path.size() <= end || request.path[0] != '/' || request.path[end] != '/' ||
        !sameSecret(std::string_view(request.path).substr(1, token_.size()), token_))
        return {404};
    const std::string name = nameOf(request);
    if (request.method == "PUT" && startsWith(name, kScenes))
        return putScene(name.substr(kScenes.size()), request);
    const bool gets = request.method == "GET" || request.method == "HEAD";
    if (!startsWith(name, kFiles)) return gets ? get(name) : SiteAnswer{405, "", {}, "GET, HEAD"};
    if (request.method != "PUT") return {405, "", {}, "PUT"};
    return put(name.substr(kFiles.size()), request);
}

SiteAnswer Site::putScene(const std::string& name, const SiteRequest& request)
{
    if (request.too_large) return refused(413, "a model has at most 256 MiB");
    Result<std::string> bytes = view_.read(name, request.body);
    nlohmann::json answer = {{"diagnostics", nlohmann::json::parse(toJson(bytes.diagnostics()))}};
    if (!bytes) return jsonAnswer(422, answer);
    const std::lock_guard<std::mutex> lock(scene_);
    view_.scene = name;
    view_.camera.clear();
    view_.scene_bytes = std::make_shared<const std::string>(std::move(*bytes));
    return jsonAnswer(200, answer);
}

SiteAnswer Site::get(const std::string& name)
{
    if (name == "events") return {200, "text/event-stream", {}, "", true};
    if (name == "view.json") return {200, kJson, std::make_shared<const std::string>(viewJson())};
    if (name == "scene") {
        const std::lock_guard<std::mutex> lock(scene_);
        if (!view_.scene_bytes) return {404};
        return {200, "application/octet-stream", view_.scene_bytes};
    }
    const auto file = page_.find(name.empty() ? "index.html" : name);
    return file == page_.end() ? SiteAnswer{404} : pageFile(file->second);
}

SiteAnswer Site::put(const std::string& path, const SiteRequest& request) const
{
    if (request.too_large) return refused(413, "a config or GLSL file has at most 1 MiB");
    if (request.if_match.empty())
        return refused(428, "If-Match has to name the version that is replaced");
    const Save save = files_.save(path, unquoted(request.if_match.front()), request.body);
    switch (save.end) {
    case Save::End::done: return jsonAnswer(200, {{"version", save.file.version}});
    case Save::End::changed:
        return jsonAnswer(409, {{"version", save.file.version}, {"text", save.file.text}});
    case Save::End::failed: return refused(403, save.why.front().message);
    case Save::End::unknown: break;
    }
    return refused(404, "the config has no file of that name");
}

std::string Site::viewJson()
{
    const std::lock_guard<std::mutex> lock(scene_);
    nlohmann::json files = nlohmann::json::object();
    for (const UserFile& file : files_.all())
        files[file.path] = {{"text", file.text}, {"version", file.version}};
    nlohmann::json scene;
    if (view_.scene_bytes)
        scene = {{"name", view_.scene}, {"bytes", true}};
    else if (!view_.scene.empty())
        scene = {{"builtin", view_.scene}};
    return jsonLine({{"config", files_.configName()},
                     {"variant", view_.variant},
                     {"editable", files_.editable()},
                     {"files", std::move(files)},
                     {"scene", std::move(scene)},
                     {"camera", view_.camera}});
}

std::string fileEvent(const UserFile& file)
{
    return jsonLine({{"path", file.path}, {"text", file.text}, {"version", file.version}});
}

}  // namespace crevice
