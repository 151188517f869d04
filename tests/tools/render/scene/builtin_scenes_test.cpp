// SPDX-License-Identifier: MIT
// Built-in scenes: what their pictures and benches do not show.
#include "tools/render/scene/builtin_scenes.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <cstdlib>

using namespace crevice;

namespace {

// With a model of a few triangles in the bunny's place, for tests of all else.
Result<Scene> roomWith(const std::string& bunny)
{
    const TemporaryFolder folder("builtin_room");
    folder.write("bunny.obj", bunny);
    ::setenv("CREVICE_MODELS", folder.path.c_str(), 1);
    Result<Scene> room = builtinScene("room");
    ::unsetenv("CREVICE_MODELS");
    return room;
}

const char* const kTetrahedron =
    "v -1 -1 -1\nv 1 -1 -1\nv 0 -1 1\nv 0 1 0\n"
    "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

}  // namespace

TEST_CASE("a bunny of one's own is taken first, and a broken one is reported")
{
    const Scene room = need(roomWith(kTetrahedron));
    CHECK(room.meshes[room.instances.back().mesh].indices.size() == 12);
    onlyError(roomWith("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), Code::scene_broken);
}

TEST_CASE("a built-in scene of no known name is missing")
{
    const Diagnostic missing = onlyError(builtinScene("plan"), Code::scene_missing);
    CHECK(missing.help.find("'plane'") != std::string::npos);
}
