// SPDX-License-Identifier: MIT
// Loading configs: what they extend, and everything that can be wrong with it.
// Which files on disk a config may name, and which may be read at all.
#include "core/base/files.h"
#include "tests/core/config/load_fixture.h"
#include "tests/support/temporary_folder.h"

#include <crevice/config.h>

#include <sys/stat.h>

using namespace crevice;

namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

constexpr const char* kSecret = "hunter2";

// A folder with a config in mine/ and a secret beside it.
struct Neighbours {
    explicit Neighbours(const std::string& name) : folder(name)
    {
        folder.write("secret.env", std::string(kSecret) + "\n");
        fs::create_directories(folder.path / "mine");
    }

    // The one error of a config of that text in mine/.
    Diagnostic failureOf(const std::string& text, std::vector<std::string> roots = {}) const
    {
        const std::string config = folder.write("mine/config.json", text);
        return failure(smallCatalog(), {config, {}, {}, std::move(roots)});
    }

    TemporaryFolder folder;
};

// All diagnostics of a config in mine/ with this shader, for files beside it.
Diagnostics shaderErrors(const Neighbours& around, const std::string& fragment,
                         const LoadRequest& extra = {})
{
    LoadRequest request = extra;
    request.config = around.folder.write(
        "mine/config.json",
        file(R"("shaders": {"a": {"vertex": "./a.vert", "fragment": ")" + fragment + "\"}}"));
    around.folder.write("mine/a.vert", "#version 300 es\nvoid main() {}\n");
    const Node document = loaded(smallCatalog(), request);
    Diagnostics errors;
    const Result<Description> description = decode(document, smallCatalog());
    for (const Diagnostic& each : description.diagnostics())
        if (each.pointer.find("/shaders") == 0 && each.code != Code::unused_name)
            errors.push_back(each);
    return errors;
}

void checkRefused(const Diagnostic& error)
{
    const std::string text = toText(error);
    INFO(text);
    CHECK(error.code == Code::module_escape);
    CHECK_FALSE(placeName(error.place).empty());
    CHECK(text.find(kSecret) == std::string::npos);
    CHECK_THAT(error.help, Catch::Contains("--root"));
}

}  // namespace

TEST_CASE("a place in a module leads back to the entry of the config that brought it")
{
    const Node document = loaded(smallCatalog(), {"fine"});
    const Place in_module = at(document, "passes/ssao")->place;
    CHECK(in_module.source->name == "ssao/hemisphere.json");
    CHECK(isModule(in_module));
    const Place own = ownPlace(in_module);
    CHECK(own.source->name == "configs/fine.json");
    CHECK(own.line == 1);
    CHECK(own.source->text.substr(own.column - 1, own.length) == "\"base\"");
    const Place in_config = at(document, "params/samples/default")->place;
    CHECK_FALSE(isModule(in_config));
    CHECK(ownPlace(in_config).line == in_config.line);
    CHECK(ownPlace(in_config).source == in_config.source);
}

TEST_CASE("a module reached twice is merged once, where it is met first")
{
    MemorySources sources = smallCatalog();
    sources.add("a.json", file(R"("extends": ["ssao/hemisphere"],
                                  "params": {"radius": {"default": 2}})"));
    sources.add("configs/diamond.json", file(R"("extends": ["a", "ssao/hemisphere", "a"])"));
    const Node document = loaded(sources, {"diamond"});
    CHECK(at(document, "params/radius/default")->number == 2);
    CHECK(at(document, "params/radius/default")->origins.size() == 1);
}

TEST_CASE("files on disk extend files beside them and modules of the catalog")
{
    const TemporaryFolder folder("load_disk");
    folder.write("shared.json", file(R"("extends": ["ssao/hemisphere"], "x-shared": 1)"));
    const std::string mine = folder.write(
        "sub/mine.json", file(R"("extends": ["../shared.json", "./more.json", "filter/box"])"));
    folder.write("sub/more.json", file(R"("params": {"radius": {"default": 9}})"));
    const Node document = loaded(smallCatalog(), {mine, {}, {}, {folder.path.string()}});
    CHECK(at(document, "x-shared"));
    CHECK(at(document, "passes/box"));
    const Node* radius = at(document, "params/radius/default");
    CHECK(radius->number == 9);
    CHECK(radius->place.source->name == folder.path.string() + "/sub/more.json");
    CHECK(document.place.source->name == mine);
}

TEST_CASE("a cycle on disk is found under another spelling of the path")
{
    const TemporaryFolder folder("load_cycle");
    std::filesystem::create_directories(folder.path / "sub");
    const std::string mine =
        folder.write("mine.json", file(R"("extends": ["./sub/../mine.json"])"));
    CHECK(failure(smallCatalog(), {mine}).code == Code::module_cycle);
}

TEST_CASE("a config extends no file outside of its folder, and does not learn whether it is there")
{
    const Neighbours around("roots_extends");
    const std::string above = around.folder.path.string();
    for (const std::string& name :
         Names{"../secret.env", "../missing.env", "./../secret.env", "./sub/../../secret.env",
               above + "/secret.env", above + "/missing.env", above + "/mine/../secret.env"}) {
        const Diagnostic error = around.failureOf(file(R"("extends": [")" + name + "\"]"));
        checkRefused(error);
        CHECK(error.place.column == 27);
        CHECK_THAT(error.message, Catch::Contains((around.folder.path / "mine").string() + "'"));
    }
    const std::string there = around.failureOf(file(R"("extends": ["../secret.env"])")).message;
    const std::string gone = around.failureOf(file(R"("extends": ["../secret.emv"])")).message;
    CHECK(there.size() == gone.size());
}

TEST_CASE("a path with a zero byte leads nowhere")
{
    const Neighbours around("roots_zero");
    around.folder.write("mine/a.json", file(""));
    for (const char* name : {"../secret.env\\u0000", "./a.json\\u0000", "./..\\u0000/secret.env"})
        CHECK(around.failureOf(file(R"("extends": [")" + std::string(name) + "\"]")).code ==
              Code::module_escape);
}

TEST_CASE("a link out of the folder is no way out of it")
{
    const Neighbours around("roots_link");
    fs::create_symlink("../secret.env", around.folder.path / "mine/near.json");
    fs::create_symlink("..", around.folder.path / "mine/up");
    checkRefused(around.failureOf(file(R"("extends": ["./near.json"])")));
    checkRefused(around.failureOf(file(R"("extends": ["./up/secret.env"])")));
    around.folder.write("mine/real.json", file(R"("x-real": 1)"));
    fs::create_symlink("real.json", around.folder.path / "mine/alias.json");
    const std::string config =
        around.folder.write("mine/config.json", file(R"("extends": ["./alias.json"])"));
    CHECK(at(loaded(smallCatalog(), {config}), "x-real"));
    fs::create_directory_symlink(around.folder.path / "mine", around.folder.path / "linked");
    CHECK(at(loaded(smallCatalog(), {(around.folder.path / "linked/config.json").string()}),
             "x-real"));
}

TEST_CASE("a folder whose name begins with that of the config's folder is another one")
{
    const Neighbours around("roots_prefix");
    around.folder.write("mine2/a.json", file(""));
    checkRefused(around.failureOf(file(R"("extends": ["../mine2/a.json"])")));
}

TEST_CASE("a file that a config extends may not climb higher than the config")
{
    const Neighbours around("roots_nested");
    around.folder.write("mine/sub/up.json", file(R"("extends": ["../more.json"])"));
    around.folder.write("mine/more.json", file(R"("x-more": 1)"));
    const std::string config =
        around.folder.write("mine/config.json", file(R"("extends": ["./sub/up.json"])"));
    CHECK(at(loaded(smallCatalog(), {config}), "x-more"));
    around.folder.write("mine/sub/up.json", file(R"("extends": ["../../secret.env"])"));
    checkRefused(failure(smallCatalog(), {config}));
}

TEST_CASE("a root allows what is below it, and one that does not exist allows nothing")
{
    const Neighbours around("roots_allowed");
    around.folder.write("base.json", file(R"("x-base": 1)"));
    const std::string text = file(R"("extends": ["../base.json"])");
    const std::string config = around.folder.write("mine/config.json", text);
    CHECK(at(loaded(smallCatalog(), {config, {}, {}, {around.folder.path.string()}}), "x-base"));
    CHECK(at(loaded(smallCatalog(), {config, {}, {}, {"/"}}), "x-base"));
    for (const char* root : {"", "nowhere", "/nowhere"})
        checkRefused(around.failureOf(text, {root}));
}

TEST_CASE("GLSL is read below the config's folder alone, whatever names it")
{
    const Neighbours around("roots_glsl");
    fs::create_symlink("../secret.env", around.folder.path / "mine/link.frag");
    around.folder.write("mine/include.frag",
                        "#version 300 es\n#include \"./../secret.env\"\nvoid main() {}\n");
    const std::string above = around.folder.path.string();
    around.folder.write("mine/absolute.frag",
                        "#version 300 es\n#include \"" + above + "/secret.env\"\nvoid main() {}\n");
    around.folder.write("mine/deep/a.glsl", "#include \"../../secret.env\"\n");
    around.folder.write("mine/deep.frag",
                        "#version 300 es\n#include \"./deep/a.glsl\"\nvoid main() {}\n");
    for (const std::string& name :
         Names{"./../secret.env", "../missing.env", "./link.frag", "./include.frag", "./deep.frag",
               "./absolute.frag", above + "/secret.env", above + "/missing.env", above}) {
        const Diagnostics errors = shaderErrors(around, name);
        INFO(name);
        REQUIRE(errors.size() == 1);
        checkRefused(errors[0]);
    }
    const LoadRequest allowed = {{}, {}, {}, {around.folder.path.string()}};
    for (const std::string& name : {std::string("../secret.env"), above + "/secret.env"})
        for (const Diagnostic& each : shaderErrors(around, name, allowed))
            CHECK(each.code != Code::module_escape);
}

TEST_CASE("an absolute path below the config's folder is read, and none that a module names")
{
    const Neighbours around("roots_absolute");
    const std::string mine = (around.folder.path / "mine").string();
    around.folder.write("mine/a.frag", "#version 300 es\nvoid main() {}\n");
    around.folder.write("mine/more.json", file(R"("x-more": 1)"));
    for (const Diagnostic& each : shaderErrors(around, mine + "/a.frag"))
        CHECK(each.code != Code::file_missing);
    const std::string config =
        around.folder.write("mine/config.json", file(R"("extends": [")" + mine + "/more.json\"]"));
    CHECK(at(loaded(smallCatalog(), {config}), "x-more"));

    MemorySources sources = smallCatalog();
    const std::string secret = (around.folder.path / "secret.env").string();
    sources.add("configs/sly.json", file(R"("interfaces": {"a": ")" + secret + "\"}"));
    sources.add("configs/slier.json", file(R"("extends": [")" + secret + "\"]"));
    const Node sly = loaded(sources, {"sly"});
    const Result<Description> description = decode(sly, sources);
    CHECK_THAT(toText(description.diagnostics()), Catch::Contains("which does not exist"));
    CHECK(failure(sources, {"slier"}).code == Code::module_missing);
}

TEST_CASE("an override names files below the current folder and below the roots alone")
{
    const Neighbours around("roots_override");
    const std::string fragment = "/shaders/a/fragment=";
    const Diagnostics errors = shaderErrors(
        around, "./a.vert", {{}, {}, {fragment + (fs::path("..") / ".." / "secret.env").string()}});
    REQUIRE(errors.size() == 1);
    checkRefused(errors[0]);
    const fs::path here = around.folder.path.lexically_relative(fs::current_path());
    const std::string secret = here.string().find("../") == 0 ? (here / "secret.env").string() : "";
    if (secret.empty()) return;
    checkRefused(shaderErrors(around, "./a.vert", {{}, {}, {fragment + secret}}).at(0));
    for (const Diagnostic& each : shaderErrors(
             around, "./a.vert", {{}, {}, {fragment + secret}, {around.folder.path.string()}}))
        CHECK(each.code != Code::module_escape);
}

TEST_CASE("what is no regular file is not opened, and nothing waits for it")
{
    const TemporaryFolder folder("roots_irregular");
    const std::string pipe = (folder.path / "pipe.json").string();
    const std::string zero = (folder.path / "zero.json").string();
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    fs::create_symlink("/dev/zero", zero);
    for (const std::string& path : {pipe, zero}) {
        CHECK_THAT(readBytes(path, 10).failure, Catch::Contains("no regular file"));
        const Diagnostic error = failure(smallCatalog(), {path});
        CHECK(error.code == Code::module_missing);
        CHECK_THAT(error.message, Catch::Contains("cannot be read: it is no regular file"));
    }
    CHECK_THAT(readBytes(folder.path.string(), 10).failure, Catch::Contains("it is a folder"));
    CHECK(readBytes((folder.path / "none").string(), 10).missing);
}
