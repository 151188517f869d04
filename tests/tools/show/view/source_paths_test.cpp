// SPDX-License-Identifier: MIT
// Files on disk as sources of the page: names between them lead to the same files.
#include "tools/show/view/source_paths.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace {

MemorySources shippedMobile()
{
    MemorySources shipped;
    shipped.add("configs/mobile.json", "{}");
    return shipped;
}

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
