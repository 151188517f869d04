// SPDX-License-Identifier: MIT
// The one file that includes cpp-httplib, which is large.
#include "tools/show/view/site.h"

#include "core/base/text.h"

#include <fcntl.h>
#include <httplib.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

extern char** environ;

namespace crevice {
namespace {

constexpr int kThreads = 32;      // a stream of events holds one
constexpr int kMostStreams = 16;  // open pages
constexpr std::size_t kLongestTarget = 2048;
// Of a comment that keeps streams of events open, and finds those whose page is gone.
constexpr std::chrono::milliseconds kHeartbeat(15000);

std::vector<std::string> headersOf(const httplib::Request& request, const char* name)
{
    std::vector<std::string> values;
    const auto found = request.headers.equal_range(name);
    for (auto at = found.first; at != found.second; ++at) values.push_back(at->second);
    return values;
}

SiteRequest siteRequest(const httplib::Request& request)
{
    return {request.method,
            request.path,
            headersOf(request, "Host"),
            headersOf(request, "Origin"),
            headersOf(request, "Sec-Fetch-Site"),
            headersOf(request, "If-Match")};
}

// All of it, however large, so that the answer is read; of which no more than the limit is kept.
void readBody(const httplib::ContentReader& read, std::size_t most, SiteRequest& request)
{
    constexpr std::size_t kMostRead = 512u << 20;
    std::size_t size = 0;
    const bool whole = read([&](const char* data, std::size_t count) {
        size += count;
        if (size <= most) request.body.append(data, count);
        return size <= kMostRead;
    });
    request.too_large = !whole || size > most;
}

}  // namespace

namespace {
constexpr std::size_t kKept = 64;  // one holds a file, of 1 MiB at most
}

void Events::push(const std::string& name, const std::string& data)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    kept_.push_back("event: " + name + "\ndata: " + data + "\n\n");
    if (kept_.size() > kKept) kept_.pop_front();
    ++count_;
    came_.notify_all();
}

void Events::close()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    came_.notify_all();
}

std::uint64_t Events::count() const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return count_;
}

std::optional<std::string> Events::next(std::uint64_t& seen, std::chrono::milliseconds wait)
{
    std::unique_lock<std::mutex> lock(mutex_);
    came_.wait_for(lock, wait, [&] { return closed_ || count_ > seen; });
    if (closed_) return std::nullopt;
    if (count_ <= seen) return "";
    seen = std::max(seen, count_ - kept_.size());
    const std::size_t index = kept_.size() - static_cast<std::size_t>(count_ - seen);
    ++seen;
    return kept_[index];
}

struct Server::Impl {
    void fill(httplib::Response& response, const SiteAnswer& answer);
    void stream(httplib::Response& response);

    httplib::Server http;
    std::thread thread;
    Site* site = nullptr;
    Events* events = nullptr;
    std::atomic<int> streams{0};
};

void Server::Impl::stream(httplib::Response& response)
{
    const bool too_many = ++streams > kMostStreams;
    // Counted as long as its response is there.
    const std::shared_ptr<void> open(nullptr, [this](void*) { --streams; });
    if (too_many) {
        response.status = 503;
        return;
    }
    const auto send = [this, open, seen = events->count(), begun = false](
                          std::size_t, httplib::DataSink& sink) mutable {
        const std::optional<std::string> event =
            begun ? events->next(seen, kHeartbeat) : std::optional<std::string>("");
        begun = true;
        if (!event) return false;
        const std::string text = event->empty() ? ": here\n\n" : *event;
        return sink.write(text.data(), text.size());
    };
    response.set_chunked_content_provider("text/event-stream", send);
}

void Server::Impl::fill(httplib::Response& response, const SiteAnswer& answer)
{
    response.status = answer.status;
    if (!answer.allow.empty()) response.set_header("Allow", answer.allow);
    if (answer.events) return stream(response);
    if (!answer.body || answer.body->empty()) return;
    response.set_content_provider(
        answer.body->size(), answer.type,
        [body = answer.body](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
            return sink.write(body->data() + offset, length);
        });
}

Server::Server() : impl_(std::make_unique<Impl>())
{
    httplib::Server& http = impl_->http;
    http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    // Not SO_REUSEPORT, by which another process could take the port, too.
    http.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
    httplib::Headers headers;
    for (const auto& [name, value] : kSiteHeaders) headers.emplace(name, value);
    http.set_default_headers(headers);
    // One request a connection: what is left of a refused one is never read as another, and a
    // browser's idle connections hold no thread.
    http.set_keep_alive_max_count(1);
    http.set_keep_alive_timeout(1);
    http.set_exception_handler([](const httplib::Request&, httplib::Response& response,
                                  std::exception_ptr) { response.status = 500; });
    // All but PUT, whose body is read first. Before anything else looks at the target.
    http.set_pre_routing_handler([this](const httplib::Request& request,
                                        httplib::Response& response) {
        const bool fits = request.target.size() <= kLongestTarget;
        if (fits && request.method == "PUT") return httplib::Server::HandlerResponse::Unhandled;
        impl_->fill(response, fits ? impl_->site->answer(siteRequest(request)) : SiteAnswer{404});
        return httplib::Server::HandlerResponse::Handled;
    });
    http.Put("[^]*", [this](const httplib::Request& request, httplib::Response& response,
                            const httplib::ContentReader& read) {
        SiteRequest asked = siteRequest(request);
        readBody(read, impl_->site->mostBytes(asked), asked);
        impl_->fill(response, impl_->site->answer(asked));
    });
}

Server::~Server() { stop(); }

Result<int> Server::bind(int port)
{
    constexpr const char* kAddress = "127.0.0.1";
    errno = 0;
    const bool bound = port == 0 || impl_->http.bind_to_port(kAddress, port);
    const int taken = port == 0 ? impl_->http.bind_to_any_port(kAddress) : port;
    if (bound && taken > 0) return taken;
    std::string message = "port " + std::to_string(port) + " of this machine cannot be served on";
    if (errno != 0) message += std::string(": ") + std::strerror(errno);
    return Diagnostic{Code::cannot_serve, message, "leave --port out for any that is free"};
}

void Server::start(Site& site, Events& events)
{
    impl_->site = &site;
    impl_->events = &events;
    impl_->thread = std::thread([this] { impl_->http.listen_after_bind(); });
    while (!impl_->http.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void Server::stop()
{
    if (!impl_->thread.joinable()) return;
    impl_->events->close();
    impl_->http.stop();
    impl_->thread.join();
}

bool openBrowser(const std::string& address)
{
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files, file, "/dev/null", O_RDWR, 0);

    // In a session of its own, so that an interrupt from the terminal does not end the browser.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGDEF);

    std::string program = "xdg-open", argument = address;
    char* arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    const int failure =
        posix_spawnp(&child, program.c_str(), &files, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (failure != 0) return false;
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();  // so it stays no zombie
    return true;
}

}  // namespace crevice
