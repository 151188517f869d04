// SPDX-License-Identifier: MIT
// The files of a config: which they are, what is saved, and what is told of them.
// Events between threads: all of them, in order, to each who waits.
// Files on disk as sources of the page: names between them lead to the same files.
#include "tools/show/view/user_files.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tools/show/view/site.h"

#include <algorithm>

using namespace crevice;

namespace {

MemorySources shippedMobile()
{
    MemorySources shipped;
    shipped.add("configs/mobile.json", "{}");
    return shipped;
}

const char* const kMine =
    R"({"format": 1, "name": "mine", "extends": ["learnopengl", "./more/radius.json"]})";
const char* const kRadius = R"({"format": 1, "params": {"radius": 0.8}})";

struct Config {
    explicit Config(const std::string& text = kMine)
        : radius(folder.write("more/radius.json", kRadius)),
          mine(folder.write("mine.json", text))
    {
    }

    UserFiles files(const std::string& behind = "") const
    {
        return UserFiles({mine + behind, "", {}, ""}, shippedSources());
    }

    const TemporaryFolder folder{"user_files"};
    const std::string radius, mine;
};

std::vector<std::string> pathsOf(const std::vector<UserFile>& files)
{
    std::vector<std::string> paths;
    for (const UserFile& file : files) paths.push_back(file.path);
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string versionOf(UserFiles& files, const std::string& path)
{
    for (const UserFile& file : files.all())
        if (file.path == path) return file.version;
    return "none";
}

using Paths = std::vector<std::string>;

}  // namespace

TEST_CASE("a config and what lies beside and below it are sources of the same layout")
{
    const TemporaryFolder folder("source_paths");
    const std::string at = folder.path.string();
    const MemorySources shipped = shippedMobile();
    const SourcePaths paths(at + "/mine.json", {}, shipped);
    CHECK(paths.configName() == "mine");
    CHECK(paths.of(at + "/mine.json") == "configs/mine.json");
    CHECK(paths.of(at + "/./glsl/../glsl/x.frag") == "configs/glsl/x.frag");
    CHECK(paths.of(at + "/../x.frag").empty());
    CHECK(paths.of("/etc/passwd").empty());
    CHECK(paths.of(at).empty());
    CHECK(resolvePath("configs/mine.json", "./glsl/x.frag") == paths.of(at + "/glsl/x.frag"));
}

TEST_CASE("what lies above a config is a source where a root allows it")
{
    const TemporaryFolder folder("source_paths");
    const std::string at = folder.path.string();
    const MemorySources shipped = shippedMobile();
    const SourcePaths paths(at + "/looks/mine.json", {at + "/shared/."}, shipped);
    CHECK(paths.configName() == "looks/mine");
    CHECK(paths.of(at + "/looks/mine.json") == "configs/looks/mine.json");
    CHECK(paths.of(at + "/looks/../shared/x.frag") == "configs/shared/x.frag");
    CHECK(resolvePath("configs/looks/mine.json", "../shared/x.frag") ==
          paths.of(at + "/shared/x.frag"));
    CHECK(SourcePaths(at + "/mine.json", {at + "/"}, shipped).configName() == "mine");
}

TEST_CASE("a page gets the files on disk that a config is made of, and no others")
{
    const Config config;
    config.folder.write("other.json", kRadius);
    UserFiles files = config.files();
    CHECK(files.editable());
    CHECK(files.configName() == "mine");
    CHECK(pathsOf(files.all()) == Paths{"configs/mine.json", "configs/more/radius.json"});
    CHECK(files.check().empty());
    CHECK(config.files("+geometry/host_depth").configName() == "mine+geometry/host_depth");

    config.folder.write(
        "mine.json",
        R"({"format": 1, "extends": ["learnopengl"], "shaders": {"ssao": {"fragment": "./a.frag"}}})");
    config.folder.write("a.frag", "#version 300 es\n#include \"./b.glsl\"\nvoid main() {}\n");
    config.folder.write("b.glsl", "// b\n");
    CHECK(pathsOf(config.files().all()) ==
          Paths{"configs/a.frag", "configs/b.glsl", "configs/mine.json"});
}

TEST_CASE("a file of the current folder that is named like a shipped module is not the config's")
{
    const Config config;
    const std::string name = shippedSources().find("ssao/hemisphere.json")->name;
    config.folder.write(name, "mine");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(config.folder.path);
    UserFiles files({"mine.json", "", {}, ""}, shippedSources());
    CHECK(pathsOf(files.all()) == Paths{"configs/mine.json", "configs/more/radius.json"});
    std::filesystem::current_path(before);
}

TEST_CASE("a file is told once the config names it, and once it exists")
{
    const char* const text = R"({"format": 1, "extends": ["learnopengl", "./new.json"]})";
    {
        const Config config;
        UserFiles files = config.files();
        config.folder.write("new.json", kRadius);
        const std::string version = versionOf(files, "configs/mine.json");
        CHECK(files.save("configs/mine.json", version, text).end == Save::End::done);
        CHECK(pathsOf(files.changes()) == Paths{"configs/new.json"});
    }
    const Config early(text);
    UserFiles files = early.files();
    early.folder.write("new.json", kRadius);
    std::vector<UserFile> told;
    for (int poll = 0; poll < 20 && told.empty(); ++poll) told = files.changes();
    CHECK(pathsOf(told) == Paths{"configs/new.json"});
}

TEST_CASE("a file that is not UTF-8 is shown and not written")
{
    const Config config;
    const std::string text = std::string(kRadius) + "// \xe9\n";
    config.folder.write("more/radius.json", text);
    UserFiles files = config.files();
    const std::string path = "configs/more/radius.json";
    const Save save = files.save(path, versionOf(files, path), kRadius);
    REQUIRE(save.end == Save::End::failed);
    CHECK(save.why[0].code == Code::bad_utf8);
    CHECK(readFile(config.radius)->text == text);
}

TEST_CASE("a text that is not UTF-8 is not saved, and later ones are")
{
    const Config config;
    UserFiles files = config.files();
    const std::string path = "configs/more/radius.json";
    const std::string version = versionOf(files, path);
    for (const char* bytes : {"// \xe9\n", "\xc0\x80", "\xed\xa0\x80", "\xef\xbb"}) {
        const Save save = files.save(path, version, std::string(kRadius) + bytes);
        REQUIRE(save.end == Save::End::failed);
        CHECK(save.why[0].code == Code::bad_utf8);
        CHECK(readFile(config.radius)->text == kRadius);
    }
    CHECK(files.save(path, version, std::string(kRadius) + "\xc3\xa9").end == Save::End::done);
}

TEST_CASE("a config below its root, and one that is named like a shipped one, load in the page")
{
    const TemporaryFolder folder("user_files_root");
    folder.write("shared/radius.json", kRadius);
    const std::string file = folder.write(
        "looks/mobile.json", R"({"format": 1, "extends": ["mobile", "../shared/radius.json"]})");
    ConfigOptions options = {file, "", {}, "", {folder.path.string()}};
    UserFiles files(options, shippedSources());
    CHECK(files.check().empty());
    CHECK(files.configName() == "looks/mobile");
    CHECK(pathsOf(files.all()) == Paths{"configs/looks/mobile.json", "configs/shared/radius.json"});

    const std::string alone =
        folder.write("alone/mobile.json", R"({"format": 1, "extends": ["mobile"]})");
    UserFiles same({alone, "", {}, ""}, shippedSources());
    CHECK(same.check().empty());
    CHECK(same.configName() == "mine/mobile");
}

namespace {
constexpr std::chrono::milliseconds kNow(0);
}

TEST_CASE("who waits for events gets those that come, in order")
{
    Events events;
    events.push("file", "before");
    std::uint64_t seen = events.count(), all = 0;
    CHECK(events.next(seen, kNow) == "");
    events.push("file", "{1}");
    events.push("file", "{2}");
    CHECK(events.next(seen, kNow) == "event: file\ndata: {1}\n\n");
    CHECK(events.next(seen, kNow) == "event: file\ndata: {2}\n\n");
    CHECK(events.next(seen, kNow) == "");
    CHECK(events.next(all, kNow) == "event: file\ndata: before\n\n");
}

TEST_CASE("who is far behind goes on with the oldest event that is kept")
{
    Events events;
    std::uint64_t seen = 0;
    for (int k = 0; k < 100; ++k) events.push("n", std::to_string(k));
    CHECK(events.next(seen, kNow) == "event: n\ndata: 36\n\n");
    CHECK(seen == 37);
}
