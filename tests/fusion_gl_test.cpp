// SPDX-License-Identifier: MIT
// Passes that are one draw, bit for bit, what they draw as two.
#include "tests/gl_fixture.h"
#include "tests/test_config.h"

#include "core/renderer.h"

using namespace crevice;

namespace {

const char* const kFull =
    "#version 300 es\nout highp vec2 uv;\nvoid main() {\n    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
    "    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);\n}\n";

// Many values of each size, ties of 8-bit steps and values past 0 and 1 among them.
const char* const kSource =
    "#version 300 es\nprecision highp float;\nout vec4 source;\nvoid main() {\n"
    "    vec2 at = floor(gl_FragCoord.xy);\n"
    "    source = vec4((at.x + 0.5) / 255.0, at.x * at.y / 977.0, 1.0 / (1.0 + at.x), at.y / 30.0 - 0.05);\n}\n";

const char* const kBend =
    "#version 300 es\nprecision PRECISION float;\nuniform highp sampler2D source;\n"
    "uniform highp float gain;\nin highp vec2 uv;\nout vec4 bent;\n"
    "vec4 bend(vec4 v) { return v.yxwz * gain; }\nvoid main() { bent = bend(texture(source, uv)); }\n";

const char* const kShow =
    "#version 300 es\nprecision highp float;\nuniform highp sampler2D bent;\nuniform float gain;\n"
    "in vec2 uv;\nout vec4 shown;\nvec4 bend(vec4 v) { return gain * v; }\n"
    "void main() { shown = bend(sqrt(abs(texture(bent, uv)))); }\n";

Description chainThrough(const std::string& format, const std::string& precision)
{
    std::string bend = kBend;
    bend.replace(bend.find("PRECISION"), 9, precision);
    return describe(R"({"format": 1, "name": "chain", "params": {"gain": {"default": 0.9}},
        "targets": {"source": {"format": ["rgba32f", "rgba8"]}, "bent": {"format": [")" + format + R"("]},
                    "shown": {"format": ["rgba32f", "rgba8"]}},
        "shaders": {"source": {"vertex": "full.vert", "fragment": "source.frag"},
                    "bend": {"vertex": "full.vert", "fragment": "bend.frag"},
                    "show": {"vertex": "full.vert", "fragment": "show.frag"}},
        "passes": {"source": {"type": "fullscreen", "shader": "source", "color": ["source"]},
                   "bend": {"type": "fullscreen", "shader": "bend", "color": ["bent"]},
                   "show": {"type": "fullscreen", "shader": "show", "color": ["shown"]}},
        "outputs": {"shown": "shown"}})",
                    {{"full.vert", kFull}, {"source.frag", kSource}, {"bend.frag", bend}, {"show.frag", kShow}});
}

CompileOptions keeping(const std::vector<std::string>& rules)
{
    CompileOptions options;
    options.extent = {256, 32};
    options.keep = rules;
    return options;
}

}  // namespace

TEST_CASE("Fused passes draw what stored textures would hold, in every format that may be between them")
{
    GlFixture gl;
    for (const char* format : {"r8", "rg8", "rgba8", "r32f", "rg32f", "rgba32f"}) {
        if (!gl.device->caps().renderable[static_cast<int>(formatFromName(format))]) continue;
        for (const char* precision : {"highp", "mediump"}) {
            INFO(format << ' ' << precision);
            const Description description = chainThrough(format, precision);
            const auto one = need(Renderer::create(*gl.device, description, keeping({}), {}));
            const auto two = need(Renderer::create(*gl.device, description, keeping({"fusion"}), {}));
            CHECK(one->plan().passes.size() == 1);
            CHECK(two->plan().passes.size() == 3);
            need(one->render({}));
            need(two->render({}));
            CHECK(gl.read(one->output("shown")).pixels == gl.read(two->output("shown")).pixels);
        }
    }
}
