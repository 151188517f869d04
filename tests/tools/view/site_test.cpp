// SPDX-License-Identifier: MIT
// What is answered to whom: the token, the host, the methods, the files.
#include "tools/view/site.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tools/view/token.h"

#include <nlohmann/json.hpp>

#include <set>

using namespace crevice;

namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";

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
        Result<PageFiles> page = PageFiles::list((folder.path / "page").string());
        REQUIRE(page.ok());
        SiteView view{"low", "eye=1,2,3", "model", std::make_shared<const std::string>("bytes")};
        site.emplace(kToken, 8080, *page, *files, view);
    }

    SiteAnswer get(const std::string& path, const std::string& method = "GET") const
    {
        return site->answer({method, path, {"127.0.0.1:8080"}, {}});
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
    const std::string at = "/" + kToken + "/";
    CHECK(served.site->address() == "http://127.0.0.1:8080" + at);
    CHECK(*served.get(at).body == "<p>page</p>");
    CHECK(served.get(at).type == "text/html; charset=utf-8");
    CHECK(served.get(at + "crevice_page.wasm").type == "application/wasm");
    CHECK(served.get(at + "index.html", "HEAD").status == 200);
    std::string wrong = at;
    wrong.back() = '0';
    std::string upper = at;
    upper[11] = 'A';
    for (const std::string& path :
         {std::string("/"), std::string(), std::string("/index.html"), "/" + kToken, wrong, upper,
          at.substr(1), "/" + kToken.substr(1) + "/", "/0" + at.substr(1), "//" + kToken + "/",
          std::string("/view.json")}) {
        INFO(path);
        CHECK(served.get(path).status == 404);
        CHECK_FALSE(served.get(path).body);
    }
}

TEST_CASE("only the files that the page's folder holds are read")
{
    const Served served;
    const std::string at = "/" + kToken + "/";
    for (const std::string name :
         {"../secret.txt", "..%2fsecret.txt", "./index.html", "link.txt", ".hidden", "/etc/passwd",
          "page/../../secret.txt", "..", "index.html/", "index.html/../index.html", "INDEX.HTML"}) {
        INFO(name);
        CHECK(served.get(at + name).status == 404);
    }
    CHECK(served.get(at + served.mine).status == 404);
    CHECK(served.get(at + std::string("index.html\0.png", 15)).status == 404);
}

TEST_CASE("a name that leads here from elsewhere is refused")
{
    const Served served;
    const auto statusOf = [&](std::vector<std::string> hosts) {
        return served.site->answer({"GET", "/" + kToken + "/", std::move(hosts), {}}).status;
    };
    CHECK(statusOf({"127.0.0.1:8080"}) == 200);
    CHECK(statusOf({"localhost:8080"}) == 200);
    CHECK(statusOf({}) == 403);
    CHECK(statusOf({""}) == 403);
    CHECK(statusOf({"127.0.0.1"}) == 403);
    CHECK(statusOf({"127.0.0.1:8081"}) == 403);
    CHECK(statusOf({"evil.example:8080"}) == 403);
    CHECK(statusOf({"127.0.0.1:8080", "evil.example"}) == 403);
}

TEST_CASE("methods that are not for a path are refused with those that are")
{
    const Served served;
    const std::string at = "/" + kToken + "/";
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE"}) {
        CHECK(served.get(at, method).status == 405);
        CHECK(served.get(at + "view.json", method).allow == "GET, HEAD");
    }
    for (const char* method : {"GET", "POST", "DELETE", "OPTIONS"}) {
        CHECK(served.get(at + "files/configs/mine.json", method).status == 405);
        CHECK(served.get(at + "files/configs/mine.json", method).allow == "PUT");
    }
}

TEST_CASE("a page is told what to show")
{
    const Served served;
    const nlohmann::json view = jsonOf(served.get("/" + kToken + "/view.json"));
    CHECK(view["config"] == "mine");
    CHECK(view["variant"] == "low");
    CHECK(view["editable"] == true);
    CHECK(view["camera"] == "eye=1,2,3");
    CHECK(view["scene"] == nlohmann::json({{"name", "model"}, {"bytes", true}}));
    REQUIRE(view["files"].size() == 1);
    CHECK(view["files"]["configs/mine.json"]["text"] ==
          R"({"format": 1, "extends": ["learnopengl"]})");
    CHECK(*served.get("/" + kToken + "/scene").body == "bytes");
    CHECK(served.get("/" + kToken + "/events").events);

    UserFiles none({"mobile", "", {}, ""}, shippedSources());
    const auto page = PageFiles::list((served.folder.path / "page").string());
    const Site shipped(kToken, 1, *page, none, {"", "", "street", nullptr});
    const SiteRequest ask = {"GET", "/" + kToken + "/view.json", {"localhost:1"}, {}};
    CHECK(jsonOf(shipped.answer(ask))["scene"] == nlohmann::json({{"builtin", "street"}}));
    CHECK(jsonOf(shipped.answer(ask))["files"] == nlohmann::json::object());
    CHECK(jsonOf(shipped.answer(ask))["editable"] == false);
    CHECK(jsonOf(Site(kToken, 1, *page, none, {}).answer(ask))["scene"].is_null());
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
    const auto statusAfter = [&](void (*change)(SiteRequest&)) {
        SiteRequest request = served.put("configs/mine.json");
        change(request);
        return served.site->answer(request).status;
    };
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {"http://evil.example"}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {"null"}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {"https://127.0.0.1:8080"}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {"http://127.0.0.1:8081"}; }) == 403);
    CHECK(statusAfter([](SiteRequest& r) { r.origins = {""}; }) == 403);
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
        const Result<std::string> token = randomToken();
        REQUIRE(token.ok());
        CHECK(token->size() == 32);
        CHECK(token->find_first_not_of("0123456789abcdef") == std::string::npos);
        tokens.insert(*token);
    }
    CHECK(tokens.size() == 100);
    CHECK(sameSecret("abc", "abc"));
    CHECK_FALSE(sameSecret("abd", "abc"));
    CHECK_FALSE(sameSecret("ab", "abc"));
    CHECK_FALSE(sameSecret("", "abc"));
}
