// SPDX-License-Identifier: MIT
// What compilers print, as they printed it with Mesa 22.3.6.
#include "tools/measure/cost/gpus.h"
#include "tests/support/catch.h"

using namespace crevice;

namespace {

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
