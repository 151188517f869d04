// SPDX-License-Identifier: MIT
// What `crevice view` answers to each request, as values: no sockets.
//
//   GET  /TOKEN/              the page; /TOKEN/NAME one of its files
//   GET  /TOKEN/view.json     what to show, and the user's files
//   GET  /TOKEN/scene         the user's scene, as tools/render/scene/scene_bytes.h reads it
//   PUT  /TOKEN/scene/NAME    a model's file in its place; answers what its reader has to say
//   GET  /TOKEN/events        Server-Sent Events: `file`, where one was changed by others
//   PUT  /TOKEN/files/PATH    saves one of the files; If-Match names the version that it replaces
#pragma once

#include "tools/show/view/user_files.h"

#include <crevice/diagnostic.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace crevice {

/// Paths on disk by names in the page, such as "index.html". Only what its folder held when it was
/// listed is ever read: what a browser asks for is looked up here and never made into a path.
using PageFiles = std::map<std::string, std::string>;

/// Lists the folder, and folders in it; hidden files and links out of it are left out. Errors:
/// CV7011 where it has no index.html.
Result<PageFiles> listPage(const std::string& folder);

/// Where the page is: share/crevice/page beside the folder of this program, as it is installed, or
/// out/page of the source tree that it was built from. Empty where it is in neither.
std::string builtPageFolder();

struct SiteRequest {
    std::string method;
    std::string path;                  ///< Without a query, and with %xx as what it stands for.
    std::vector<std::string> hosts;    ///< Each Host that was sent.
    std::vector<std::string> origins;  ///< Each Origin.
    std::vector<std::string> sites;    ///< Each Sec-Fetch-Site.
    std::vector<std::string> if_match = {};
    std::string body = {};
    bool too_large = false;  ///< The body was cut: it has more than Site::mostBytes.
};

struct SiteAnswer {
    int status = 200;
    std::string type = {};
    std::shared_ptr<const std::string> body = {};  ///< Null for none.
    std::string allow = {};                        ///< With 405: the methods that there are.
    bool events = false;                           ///< The body is the stream of events.
};

/// Headers of every answer.
extern const std::vector<std::pair<std::string, std::string>> kSiteHeaders;

/// What is shown beside the config, and how it changes.
struct SiteView {
    std::string variant = {};
    std::string camera = {};
    std::string scene = {};  ///< As --scene takes it; empty: what the page begins with.
    std::shared_ptr<const std::string> scene_bytes = {};  ///< Null for a built-in scene.
    /// Makes such bytes of a model's file, of that name, which was dropped on the page.
    std::function<Result<std::string>(const std::string& name, const std::string& file)> read = {};
};

/// The secret in an address, 32 hex digits: 128 random bits of the system's. Errors: CV6022 where
/// it has none to give.
Result<std::string> randomToken();

class Site {
public:
    /// Who does not know the token is shown nothing. `files` must outlive this.
    Site(std::string token, int port, PageFiles page, UserFiles& files, SiteView view);

    /// "http://127.0.0.1:PORT/TOKEN/"
    std::string address() const;

    /// From any thread.
    SiteAnswer answer(const SiteRequest& request);

    /// That the body of such a request may have: of a model 256 MiB, else kMaxDocumentBytes.
    std::size_t mostBytes(const SiteRequest& request) const;

private:
    std::string nameOf(const SiteRequest& request) const;
    bool isOurs(const std::string& host) const;
    bool isAskedByOurs(const SiteRequest& request) const;
    SiteAnswer get(const std::string& name);
    SiteAnswer putScene(const std::string& name, const SiteRequest& request);
    SiteAnswer put(const std::string& path, const SiteRequest& request) const;
    std::string viewJson();

    std::string token_, port_;
    PageFiles page_;
    UserFiles& files_;
    std::mutex scene_;  // of the scene in `view_`
    SiteView view_;
};

/// The data of an event that tells of the file.
std::string fileEvent(const UserFile& file);

// --- server.cpp: HTTP on the loopback address alone, what is told to all open pages, the browser
// ---

/// Events in the order in which they came, as Server-Sent Events write them. From any thread.
class Events {
public:
    /// `data` is one line.
    void push(const std::string& name, const std::string& data);

    /// Ends all waits, for good.
    void close();

    /// How many there were so far.
    std::uint64_t count() const;

    /// The next one after the first `seen`, which is then counted; "" where none came in that time.
    /// Nothing once they are closed. Who is more than 64 behind misses the oldest.
    std::optional<std::string> next(std::uint64_t& seen, std::chrono::milliseconds wait);

private:
    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::deque<std::string> kept_;  // the last ones
    std::uint64_t count_ = 0;
    bool closed_ = false;
};

class Server {
public:
    Server();
    ~Server();  ///< Stops.
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Takes that port of 127.0.0.1, or any free one for 0, and returns it. Errors: CV6022.
    Result<int> bind(int port);

    /// Answers from threads of its own, until `stop`. After `bind`; both must outlive this.
    void start(Site& site, Events& events);

    /// Ends all streams and waits until the last request was answered, or for a second.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Has xdg-open show the address, without a shell and without waiting. False where there is no such
/// program.
bool openBrowser(const std::string& address);

}  // namespace crevice
