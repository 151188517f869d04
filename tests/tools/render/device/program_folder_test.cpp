// SPDX-License-Identifier: MIT
// Linked programs in a folder: what --program-cache names.
#include "tools/render/device/program_folder.h"
#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

TEST_CASE("A folder of programs that cannot be made is an error, one that goes is one warning")
{
    const TemporaryFolder folder("programs");
    const std::string file = folder.write("file", "no folder");
    for (const std::string& path : {file, file + "/below"})
        onlyError(ProgramFolder::open(path), Code::cannot_write);
    const auto programs = need(ProgramFolder::open((folder.path / "goes").string()));
    std::filesystem::remove_all(folder.path / "goes");
    const ProgramCache cache = programs->cache();
    for (const char* key : {"a", "b"}) cache.store(key, {1});
    onlyWarning(programs->warnings(), Code::cannot_write);
    CHECK(cache.load("a").empty());
}
