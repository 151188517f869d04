// SPDX-License-Identifier: MIT
// What only a socket shows: streams that stay open and end. view_requests.py has all else.
#include "tools/show/view/server.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace crevice;

namespace {

// A connection that sends the request at once.
class Connection {
public:
    Connection(int port, const std::string& request) : file_(socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const timeval patience = {5, 0};
        setsockopt(file_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
        REQUIRE(connect(file_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0);
        REQUIRE(send(file_, request.data(), request.size(), 0) > 0);
    }
    ~Connection() { close(file_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    // All that came when it has the text so many times, or when the other end closes or is silent.
    std::string readUntil(const std::string& text, int times)
    {
        char part[4096];
        const auto count = [&] {
            int found = 0;
            for (std::size_t at = 0; (at = all_.find(text, at)) != std::string::npos; ++at) ++found;
            return found;
        };
        while (count() < times) {
            const ssize_t size = recv(file_, part, sizeof(part), 0);
            if (size <= 0) return all_ + "[closed]";
            all_.append(part, static_cast<std::size_t>(size));
        }
        return all_;
    }

private:
    int file_;
    std::string all_;
};

}  // namespace

TEST_CASE("a stream of events is kept open by comments, brings events and ends with its server")
{
    const TemporaryFolder folder("server");
    folder.write("index.html", "page");
    UserFiles files({"mobile", "", {}, ""}, shippedSources());
    const Result<PageFiles> page = PageFiles::list(folder.path.string());
    REQUIRE(page.ok());
    Events events;
    Server server(std::chrono::milliseconds(20));
    const Result<int> port = server.bind(0);
    REQUIRE(port.ok());
    const Site site("token", *port, *page, files, {});
    server.start(site, events);

    Connection stream(*port, "GET /token/events HTTP/1.1\r\nHost: localhost:" +
                                 std::to_string(*port) + "\r\n\r\n");
    CHECK(stream.readUntil(": here", 3).find("[closed]") == std::string::npos);
    events.push("file", "{}");
    CHECK(stream.readUntil("event: file\ndata: {}\n\n", 1).find("[closed]") == std::string::npos);
    server.stop();
    CHECK(stream.readUntil("never", 1).find("[closed]") != std::string::npos);
}
