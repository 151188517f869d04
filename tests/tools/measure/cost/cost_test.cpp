// SPDX-License-Identifier: MIT
// Sums, what counts as worse, and what is written and read again: on figures made up here.
// What compilers print, as they printed it with Mesa 22.3.6.
#include "tools/measure/cost/cost.h"
#include "core/base/text.h"
#include "tests/support/need.h"
#include "tools/measure/cost/counted_fragment.h"
#include "tools/measure/cost/gpus.h"

#include "tools/show/plan/planning.h"

using namespace crevice;

namespace {

CostReport figures(int instructions, int spills, int threads, double cycles)
{
    return {{"gpu", "Mali-G57"},  {"instructions", instructions},
            {"spills", spills},   {"fills", 2 * spills},
            {"threads", threads}, {"most_threads", 2},
            {"cycles", cycles},   {"code_bytes", 16 * instructions}};
}

CostReport pass(const char* name, PassRole role, double pixels, double fetches,
                const CostReport& each)
{
    CostReport made = {{"pass", name},       {"for", nameOf(role)}, {"size", {64, 32}},
                       {"pixels", pixels},   {"tile_bytes", 100},   {"read_bytes", 60},
                       {"loaded_bytes", 40}, {"gpus", {each}}};
    if (role != PassRole::geometry_for_ao) made["fetches"] = fetches;
    return made;
}

/// One config: half-size AO, a filter, back faces and lighting.
CostReport report()
{
    CostReport config = {
        {"config", "some"}, {"frame_pixels", 128 * 64}, {"geometry_bytes_for_ao", 1000}};
    config["passes"] = {pass("ssao", PassRole::ao, 0.25, 8, figures(400, 3, 1, 40)),
                        pass("filter", PassRole::ao, 1, 5, figures(100, 0, 2, 4)),
                        pass("back_faces", PassRole::geometry_for_ao, 1, 0, figures(10, 0, 2, 0.5)),
                        pass("lighting", PassRole::picture, 1, 3, figures(300, 0, 2, 12))};
    addSums(config);
    return {{"scene", "room"},       {"size", {128, 64}},
            {"camera", "eye=4,2,6"}, {"variant", "fast"},
            {"set", {"radius=0.5"}}, {"compilers", "Mesa 22.3.6"},
            {"gpus", {"Mali-G57"}},  {"configs", CostReport::array({config})}};
}

/// How many figures are worse than `report()` once `change` has been at its config.
template <class Change>
std::size_t worse(Change&& change)
{
    CostReport now = report();
    CostReport& config = now["configs"][0];
    change(config["passes"]);
    addSums(config);
    return need(compareCosts(report(), now)).worse.size();
}

std::vector<PassRole> rolesOf(const char* config)
{
    const Description description = need(loadDescription({config, {}, {}, {}}, shippedSources()));
    return passRoles(need(compile(description, usualTraits(), usualCaps(), {kUsualExtent})));
}

/// The counted text of a shader with this body of main.
std::string counted(const std::string& body)
{
    const auto text = countedFragment(
        "#version 300 es\nprecision highp float;\nout float ao;\n"
        "void main()\n{\n" +
            body + "\n}\n",
        {});
    REQUIRE(text);
    return *text;
}

const char* const kMali =
    R"(MESA_SHADER_POSITION shader: 14 inst, 2.000000 cycles, 0.062500 fma, 0.078125 cvt, 0.187500 sfu, 0.000000 v, 0.000000 t, 2.000000 ls, 8 quadwords, 2 threads, 0 loops, 0:0 spills:fills
MESA_SHADER_FRAGMENT shader: 1538 inst, 138.000000 cycles, 10.656250 fma, 8.781250 cvt, 8.812500 sfu, 0.250000 v, 3.000000 t, 138.000000 ls, 776 quadwords, 1 threads, 5 loops, 18:120 spills:fills
)";

const char* const kMidgard =
    R"(MESA_SHADER_FRAGMENT shader: 1130 inst, 544 bundles, 802 quadwords, 16 registers, 2 threads, 5 loops, 17:125 spills:fills
)";

const char* const kV3d =
    R"(Falling back to strategy 'fallback scheduler' for MESA_SHADER_FRAGMENT prog 1/1
SHADER-DB-GLSL3 - MESA_SHADER_FRAGMENT shader: 9 inst, 4 threads, 0 loops, 0 uniforms, 1 max-temps, 0:0 spills:fills, 0 sfu-stalls, 9 inst-and-stalls, 0 nops
MESA_SHADER_FRAGMENT shader: 1521 inst, 2 threads, 6 loops, 462 uniforms, 65 max-temps, 26:35 spills:fills, 12 sfu-stalls, 1533 inst-and-stalls, 158 nops
)";

// A shader of a driver's own, then ours, with what runs once a draw between shps and shpe.
const char* const kAdreno = R"(MESA: info: Native code for unnamed FRAG shader TTN with sha1 9ba1:
MESA: info: mul.f r0.x, r0.x, r0.y
MESA: info: ; FRAG: outputs: r0.x (FRAG_RESULT_COLOR)
MESA: info: Native code for unnamed FRAG shader GLSL1 with sha1 347f:
MESA: info: @const(c0.x)	0x40400000, 0xd0d0d0d0, 0xd0d0d0d0, 0xd0d0d0d0
MESA: info: shps #l61
MESA: info: (rpt3)add.f r5.x, (r)r5.x, c1.x
MESA: info: (sy)(ss)shpe
MESA: info: l61:
MESA: info: bary.f (ei)r63.x, 0, r0.x
MESA: info: (sy)sqrt hr2.x, hr1.x
MESA: info: (rpt1)mul.f hr1.z, (r)hr1.z, (r)hr1.z
MESA: info: (nop2) mul.f r2.z, (2.0), r1.w
MESA: info: cmps.f.lt hr2.y, h(0.5), hr2.y
MESA: info: (ss)(nop1) mad.f16 hr1.x, hr1.x, hr1.y, hr2.x
MESA: info: cov.f16f32 r3.x, hr1.x
MESA: info: (rpt2)nop
MESA: info: sam (f16)(xyzw)hr1.x, r0.x, s#0, t#0
MESA: info: end
MESA: info: ; FRAG: outputs: hr2.z (FRAG_RESULT_DATA0)
FRAG shader: 16 inst, 6 nops, 10 non-nops, 0 mov, 1 cov, 32 dwords, 0 last-baryf, 0 half, 2 full, 4 constlen, 7 cat0, 1 cat1, 5 cat2, 1 cat3, 1 cat4, 1 cat5, 0 cat6, 0 cat7, 3 stp, 4 ldp, 4 sstall, 1 (ss), 0 systall, 1 (sy), 12 waves, 0 loops
)";

CompilerFigures read(const char* gpu, const char* output)
{
    REQUIRE(findCostGpu(gpu));
    return readFigures(*findCostGpu(gpu), output);
}

}  // namespace

TEST_CASE("The cost of AO is that of its passes, each for its share of the picture's pixels")
{
    const CostReport config = report()["configs"][0];
    const CostReport &alone = config["ao"], &all = config["ao_with_geometry"];
    CHECK(alone["passes"] == 2);
    CHECK(alone["fetches"] == 13.0);
    CHECK(alone["tile_bytes"] == 200);
    const CostReport& gpu = alone["gpus"][0];
    CHECK(gpu["instructions"] == 500);
    CHECK(gpu["largest_spills"] == 3);
    CHECK(gpu["its_fills"] == 6);
    CHECK(gpu["lowest_threads"] == 1);
    CHECK(gpu["cycles"] == 40 * 0.25 + 4);
    CHECK(all["passes"] == 3);
    CHECK(all["fetches"] == 13.0);
    CHECK(all["tile_bytes"] == 1300);
    CHECK(all["gpus"][0]["cycles"] == 14.5);
}

TEST_CASE("Spills, lost occupancy and a tenth more of anything are worse, and less is not")
{
    const auto after = [](std::size_t pass, const char* key, auto value) {
        return worse([&](CostReport& passes) { passes[pass]["gpus"][0][key] = value; });
    };
    CHECK(worse([](CostReport&) {}) == 0);
    CHECK(after(1, "spills", 9) == 1);
    CHECK(after(0, "fills", 12) == 1);
    CHECK(after(0, "instructions", 445) == 0);
    CHECK(after(0, "instructions", 570) == 1);
    CHECK(after(0, "cycles", 50) == 1);
    CHECK(after(2, "instructions", 100) == 1);
    CHECK(after(0, "threads", 0) == 1);
    CHECK(after(1, "refusal", "no") == 1);
    CHECK(worse([](CostReport& now) { now[1]["fetches"] = 7; }) == 1);
    CHECK(worse([](CostReport& now) { now[3]["gpus"][0] = figures(900, 9, 1, 90); }) == 0);
    CHECK(worse([](CostReport& now) { now[0]["gpus"][0] = figures(200, 0, 2, 9); }) == 0);
    CHECK(worse([](CostReport& now) { now.erase(0); }) == 0);
}

TEST_CASE("Costs are read as they were written, under the options that they were measured under")
{
    const ApprovedCost again = need(readCost("costs.json", costJson(report()), {}));
    CHECK(again.report == report());
    CHECK(again.options.configs == std::vector<std::string>{"some"});
    CHECK(again.options.scene.size == "128x64");
    CHECK(again.options.config.overrides == std::vector<std::string>{"radius=0.5"});
    for (const char* text : {"", "[1, 2]", "{\"scene\": 3}", "not JSON"}) {
        INFO(text);
        onlyError(readCost("costs.json", text, {}), Code::results_broken);
    }
    CostReport cut = report();
    cut["configs"][0].erase("ao_with_geometry");
    CHECK_FALSE(compareCosts(cut, report()).ok());
}

TEST_CASE("The table has a row for each pass and says when fetches were not counted")
{
    CostReport made = report();
    CHECK(costText(made).find("AO in all           13.00") != std::string::npos);
    CHECK(costText(made).find("not counted") == std::string::npos);
    made["configs"][0]["uncounted"] = "there is no EGL";
    made["configs"][0]["passes"][0]["gpus"][0]["refusal"] = "'x' undeclared";
    const std::string text = costText(made);
    CHECK(text.find("fetches and loops not counted: there is no EGL\n") != std::string::npos);
    CHECK(text.find("Mali-G57 refuses ssao: 'x' undeclared\n") != std::string::npos);
}

TEST_CASE("Passes are for AO, for the picture, or geometry that one of them needs")
{
    using R = PassRole;
    CHECK(rolesOf("mobile") ==
          std::vector<R>{R::geometry, R::ao, R::ao, R::ao, R::ao, R::ao, R::ao, R::picture});
    CHECK(rolesOf("high") == std::vector<R>{R::geometry, R::ao, R::geometry_for_ao,
                                            R::geometry_for_ao, R::geometry_for_ao, R::ao, R::ao,
                                            R::ao, R::ao, R::ao, R::ao, R::picture});
}

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

TEST_CASE("A macro counts what it fetches, and one that is another name of such a function fetches")
{
    const auto counted = [](const char* line, const char* body) {
        const auto text = countedFragment(
            std::string("#version 300 es\n") + line + "\nout float ao;\n" + body, {});
        REQUIRE(text);
        return *text;
    };
    const std::string at = counted("#define AT(p) texelFetch(t, p, 0)", "void main() { AT(p).r; }");
    CHECK(has(at, "#define AT(p) (++crevice_fetches, texelFetch(t, p, 0))\n"));
    CHECK(has(at, "{ AT(p).r; }"));
    const std::string named = counted("#define old texture\n#define older old\n#define no (t, uv)",
                                      "void main() { old(t, uv); older(t, uv); texture no; }");
    CHECK(has(named, "#define older old\n"));
    CHECK(has(named, "{ (++crevice_fetches, old(t, uv)); (++crevice_fetches, older(t, uv)); "));
}

TEST_CASE("The figures of Mali's compiler are those of the fragment shader, unit by unit")
{
    const CompilerFigures figures = read("Mali-G57", kMali);
    CHECK(figures.refusal == "");
    CHECK(figures.instructions == 1538);
    CHECK(figures.spills == 18);
    CHECK(figures.fills == 120);
    CHECK(figures.threads == 1);
    CHECK(figures.code_bytes == 776 * 16);
    CHECK(figures.cycles == 138);
    CHECK(figures.unit_cycles == std::vector<double>{10.65625, 8.78125, 8.8125, 0.25, 3, 138});
    CHECK(figures.registers == -1);
    CHECK(figures.arithmetic == -1);

    const CompilerFigures older = read("Mali-T860", kMidgard);
    CHECK(older.registers == 16);
    CHECK(older.cycles == -1);
    CHECK(older.threads == 2);
}

TEST_CASE("V3D's compiler is believed in its last line, after all its tries")
{
    const CompilerFigures figures = read("v3d-4.2", kV3d);
    CHECK(figures.instructions == 1521);
    CHECK(figures.spills == 26);
    CHECK(figures.fills == 35);
    CHECK(figures.threads == 2);
    CHECK(figures.registers == 65);
    CHECK(figures.code_bytes == 1521 * 8);
}

TEST_CASE("Adreno's arithmetic is counted in the disassembly of our own shader, repeats included")
{
    const Arithmetic counts = countArithmetic(kAdreno);
    CHECK(counts.all == 7);
    CHECK(counts.half == 5);
    const CompilerFigures figures = read("Adreno-630", kAdreno);
    CHECK(figures.arithmetic == 7);
    CHECK(figures.half_arithmetic == 5);
    CHECK(figures.spills == 3);
    CHECK(figures.fills == 4);
    CHECK(figures.threads == 12);
    CHECK(figures.registers == 2);
    CHECK(figures.code_bytes == 32 * 4);
}

TEST_CASE("A program that a compiler refuses or says nothing of has no figures")
{
    CHECK(read("Mali-G52", "refused 0:2(60): error: `x' undeclared\nrefused more\n").refusal ==
          "0:2(60): error: `x' undeclared");
    CHECK(read("Mali-G52", "").refusal == "it prints no figures");
    CHECK(read("Mali-G52", "MESA_SHADER_VERTEX shader: 16 inst, 4 threads\n").refusal != "");
    CHECK(parseFigures("MESA_SHADER_FRAGMENT shader: , x, 3").size() == 1);
    CHECK(findCostGpu("Mali") == nullptr);
}
