// SPDX-License-Identifier: MIT
// A folder as a set of texts: what it gives, lists and refuses.
#include <crevice/source.h>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace fs = std::filesystem;

TEST_CASE("a folder lists its texts below it and nothing else")
{
    const TemporaryFolder folder("source_list");
    for (const char* name : {"b/x.frag", "a.json", "b/y.glsl", "c/d/z.vert", "k.comp"})
        folder.write(name, "");
    for (const char* name : {"notes.txt", "a.json~", "b/picture.png", "json"})
        folder.write(name, "");
    fs::create_directories(folder.path / "folder.json");
    const DirectorySources sources(folder.path.string());
    CHECK(sources.list() ==
          std::vector<std::string>{"a.json", "b/x.frag", "b/y.glsl", "c/d/z.vert", "k.comp"});
    CHECK(DirectorySources((folder.path / "none").string()).list().empty());
}

TEST_CASE("a folder does not give what lies outside of it")
{
    const TemporaryFolder folder("source_climb");
    folder.write("secret.json", "secret");
    folder.write("root/a.json", "a");
    const DirectorySources sources((folder.path / "root").string());
    CHECK(sources.find("a.json"));
    for (const std::string path :
         {"../secret.json", "x/../../secret.json", "./a.json", "", "..", "a.json/", "//a.json"})
        CHECK_FALSE(sources.find(path));
    CHECK_FALSE(sources.find((folder.path / "secret.json").string()));
}

TEST_CASE("a folder of modules gives no link out of it, but for its roots")
{
    const TemporaryFolder folder("source_links");
    folder.write("secret.env", "secret");
    const std::string mine = (folder.path / "mine").string();
    fs::create_directories(mine);
    fs::create_symlink("../secret.env", mine + "/a.glsl");
    CHECK_FALSE(DirectorySources(mine).find("a.glsl"));
    CHECK(DirectorySources(mine, {folder.path.string()}).find("a.glsl"));
}
