// SPDX-License-Identifier: MIT
// What is answered to whom: the token, the host, the methods, the files.
#include "tools/show/view/site.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"
#include "tools/show/view/token.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <set>

using namespace crevice;

namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";
const std::string kAt = "/" + kToken + "/";

struct Served {
    Served()
    {
        folder.write("page/index.html", "<p>page</p>");
        folder.write("page/crevice_page.wasm", "wasm");
        folder.write("page/.hidden", "hidden");
        folder.write("secret.txt", "secret");
        std::filesystem::create_symlink(folder.path / "secret.txt", folder.path / "page/link.txt");
        mine = folder.write("mine.json", R"({"format": 1, "extends": ["learnopengl"]})");
        files.emplace(ConfigOptions{mine, "", {}, ""}, shippedSources());
        const PageFiles page = need(PageFiles::list((folder.path / "page").string()));
        SiteView view{"low", "eye=1,2,3", "model", std::make_shared<const std::string>("bytes")};
        site.emplace(kToken, 8080, page, *files, view);
    }

    SiteAnswer get(const std::string& path, const std::string& method = "GET",
                   std::vector<std::string> hosts = {"127.0.0.1:8080"}) const
    {
        return site->answer({method, path, std::move(hosts), {}});
    }

    SiteRequest put(const std::string& path) const
    {
        SiteRequest request = {"PUT", "/" + kToken + "/files/" + path, {"127.0.0.1:8080"}, {}};
        request.has_if_match = true;
        request.if_match = files->all().at(0).version;
        request.body = "{}";
        return request;
    }

    const TemporaryFolder folder{"site"};
    std::string mine;
    mutable std::optional<UserFiles> files;
    std::optional<Site> site;
};

nlohmann::json jsonOf(const SiteAnswer& answer)
{
    REQUIRE(answer.body);
    return nlohmann::json::parse(*answer.body);
}

}  // namespace

TEST_CASE("a page is served below its token, and nothing beside it")
{
    const Served served;
    CHECK(served.site->address() == "http://127.0.0.1:8080" + kAt);
    CHECK(*served.get(kAt).body == "<p>page</p>");
    CHECK(served.get(kAt).type == "text/html; charset=utf-8");
    CHECK(served.get(kAt + "crevice_page.wasm").type == "application/wasm");
    CHECK(served.get(kAt + "index.html", "HEAD").status == 200);
    std::string wrong = kAt;
    wrong.back() = '0';
    std::string upper = kAt;
    upper[11] = 'A';
    for (const std::string& path :
         {std::string("/"), std::string(), std::string("/index.html"), "/" + kToken, wrong, upper,
          kAt.substr(1), "/" + kToken.substr(1) + "/", "/0" + kAt.substr(1), "//" + kToken + "/",
          std::string("/view.json")}) {
        INFO(path);
        CHECK(served.get(path).status == 404);
        CHECK_FALSE(served.get(path).body);
    }
}

TEST_CASE("only the files that the page's folder holds are read")
{
    const Served served;
    for (const std::string& name :
         {std::string("../secret.txt"), std::string("..%2fsecret.txt"), std::string("./index.html"),
          std::string("link.txt"), std::string(".hidden"), std::string("/etc/passwd"),
          std::string("page/../../secret.txt"), std::string(".."), std::string("index.html/"),
          std::string("index.html/../index.html"), std::string("INDEX.HTML"), served.mine,
          std::string("mine.json"), std::string("configs/mine.json"), std::string(1500, 'a'),
          std::string("index.html\0.png", 15)}) {
        INFO(name);
        CHECK(served.get(kAt + name).status == 404);
    }
}

TEST_CASE("a name that leads here from elsewhere is refused")
{
    const Served served;
    for (const char* host : {"127.0.0.1:8080", "localhost:8080"})
        CHECK(served.get(kAt, "GET", {host}).status == 200);
    for (const char* host :
         {"", "127.0.0.1", "127.0.0.1:8081", "[::1]:8080", "evil.example", "evil.example:8080"})
        CHECK(served.get(kAt, "GET", {host}).status == 403);
    CHECK(served.get(kAt, "GET", {}).status == 403);
    CHECK(served.get(kAt, "GET", {"127.0.0.1:8080", "evil.example"}).status == 403);
}

TEST_CASE("methods that are not for a path are refused with those that are")
{
    const Served served;
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"}) {
        CHECK(served.get(kAt, method).status == 405);
        CHECK(served.get(kAt + "view.json", method).allow == "GET, HEAD");
    }
    for (const char* method : {"GET", "POST", "DELETE", "OPTIONS"}) {
        CHECK(served.get(kAt + "files/configs/mine.json", method).status == 405);
        CHECK(served.get(kAt + "files/configs/mine.json", method).allow == "PUT");
    }
}

TEST_CASE("a page is told what to show")
{
    const Served served;
    const nlohmann::json view = jsonOf(served.get(kAt + "view.json"));
    CHECK(view["config"] == "mine");
    CHECK(view["variant"] == "low");
    CHECK(view["editable"] == true);
    CHECK(view["camera"] == "eye=1,2,3");
    CHECK(view["scene"] == nlohmann::json({{"name", "model"}, {"bytes", true}}));
    REQUIRE(view["files"].size() == 1);
    CHECK(view["files"]["configs/mine.json"]["text"] ==
          R"({"format": 1, "extends": ["learnopengl"]})");
    CHECK(*served.get(kAt + "scene").body == "bytes");
    CHECK(served.get(kAt + "events").events);

    UserFiles none({"mobile", "", {}, ""}, shippedSources());
    const PageFiles page = need(PageFiles::list((served.folder.path / "page").string()));
    const Site shipped(kToken, 1, page, none, {"", "", "street", nullptr});
    const SiteRequest ask = {"GET", kAt + "view.json", {"localhost:1"}, {}};
    CHECK(jsonOf(shipped.answer(ask))["scene"] == nlohmann::json({{"builtin", "street"}}));
    CHECK(jsonOf(shipped.answer(ask))["files"] == nlohmann::json::object());
    CHECK(jsonOf(shipped.answer(ask))["editable"] == false);
    CHECK(jsonOf(Site(kToken, 1, page, none, {}).answer(ask))["scene"].is_null());
}

TEST_CASE("a save answers with the version, and with the text where that is another")
{
    const Served served;
    SiteRequest request = served.put("configs/mine.json");
    const SiteAnswer saved = served.site->answer(request);
    REQUIRE(saved.status == 200);
    const SiteAnswer late = served.site->answer(request);
    CHECK(late.status == 409);
    CHECK(jsonOf(late)["text"] == "{}");
    CHECK(jsonOf(late)["version"] == jsonOf(saved)["version"]);
    request.if_match = "\"" + jsonOf(saved)["version"].get<std::string>() + "\"";
    request.body = "{ }";
    CHECK(served.site->answer(request).status == 200);
}

TEST_CASE("a save that others send, or that is none, is refused")
{
    const Served served;
    const auto statusAfter = [&](const std::function<void(SiteRequest&)>& change) {
        SiteRequest request = served.put("configs/mine.json");
        change(request);
        return served.site->answer(request).status;
    };
    for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8080",
                               "http://127.0.0.1:8081", "http://127.0.0.1:1", ""})
        CHECK(statusAfter([&](SiteRequest& r) { r.origins = {origin}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.hosts = {"evil.example:8080"}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.path[1] = 'x'; }) == 404);
    CHECK(statusAfter([](SiteRequest& r) { r.path += "x"; }) == 404);
    CHECK(statusAfter([](SiteRequest& r) { r.has_if_match = false; }) == 428);
    CHECK(statusAfter([](SiteRequest& r) { r.too_large = true; }) == 413);
    CHECK(statusAfter([](SiteRequest& r) { r.if_match = "*"; }) == 409);
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {"http://localhost:8080"}; }) == 200);
}

TEST_CASE("a folder without a page is an error that says how to build one")
{
    const TemporaryFolder folder("no_page");
    for (const std::string& path : {folder.path.string(), std::string("nowhere"), std::string()}) {
        const Result<PageFiles> page = PageFiles::list(path);
        REQUIRE_FALSE(page.ok());
        CHECK(page.diagnostics()[0].code == Code::page_missing);
        CHECK(page.diagnostics()[0].help.find("tools/page.sh") != std::string::npos);
    }
}

TEST_CASE("tokens are 128 bits of their own, compared as a whole")
{
    std::set<std::string> tokens;
    for (int k = 0; k < 100; ++k) {
        const std::string token = need(randomToken());
        CHECK(token.size() == 32);
        CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
        tokens.insert(token);
    }
    CHECK(tokens.size() == 100);
    CHECK(sameSecret("abc", "abc"));
    for (const char* other : {"abd", "ab", ""}) CHECK_FALSE(sameSecret(other, "abc"));
}
