// SPDX-License-Identifier: MIT
#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tools/measure/cost/counting_device.h"

using namespace crevice;

namespace {

/// The counted text of a shader with this body of main.
std::string counted(const std::string& body)
{
    const auto text = countedFragment(
        "#version 300 es\nprecision highp float;\nout float ao;\n"
        "void main()\n{\n" +
        body + "\n}\n");
    REQUIRE(text);
    return *text;
}

}  // namespace

TEST_CASE("Every fetch is counted where it stands, nested ones too")
{
    CHECK(has(counted("ao = texture(t, uv, 1.0).r;"),
              "ao = (++crevice_fetches, texture(t, uv, 1.0)).r;"));
    CHECK(has(counted("ao = texelFetch(t, ivec2(texelFetch(u, p, 0).xy), 0).r;"),
              "(++crevice_fetches, texelFetch(t, ivec2((++crevice_fetches, "
              "texelFetch(u, p, 0)).xy), 0)).r"));
    CHECK(has(counted("ao = (texture(t,\n    uv)).r;"),
              "((++crevice_fetches, texture(t,\n    uv))).r"));
    CHECK(has(counted("ao = float(textureSize(t, 0).x); // texture(t, uv)"),
              "ao = float(textureSize(t, 0).x);"));
}

TEST_CASE("A macro counts what it fetches")
{
    const auto text = countedFragment(
        "#version 300 es\n#define AT(p) texelFetch(t, p, 0)\n"
        "out float ao;\nvoid main() { ao = AT(p).r; }\n");
    REQUIRE(text);
    CHECK(has(*text, "#define AT(p) (++crevice_fetches, texelFetch(t, p, 0))\n"));
    CHECK(has(*text, "ao = AT(p).r;"));
}
