// SPDX-License-Identifier: MIT
// A device on which mediump has the width that is asked for, whatever the driver does. Some compute
// it in full, some in half floats here and there, such as llvmpipe on CPUs with half-float
// instructions.
//
// glslang turns each shader into SPIR-V, rewriteMediump rewrites that, SPIRV-Cross writes it as
// GLSL again, all in highp. Mediump values are decorated RelaxedPrecision there. In half floats
// each of them is rounded as it arises: from 65520 on to infinity, below 2^-14 to 0, which is the
// least that every phone keeps. What a phone has no instruction for is taken apart first, so that
// what overflows on the way does so here too: normalize() is a dot product, an inverse root and a
// product, pow() a logarithm, a product and an exponential, a / b is a * (1 / b).
#include "tools/render/device/open_device.h"

#include "tools/render/device/forwarding_device.h"
#include "tools/render/glsl/glslang_stage.h"

#include <spirv_cross_c.h>

namespace crevice {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::string_view kOldVersion = "#version 300";
constexpr std::string_view kNewVersion = "#version 310";

Diagnostics explain(const GlslStage& stage, const std::string& log)
{
    return explainLog(stage, Code::shader_compile, log);
}

bool isOld(const GlslStage& stage)
{
    return stage.text.compare(0, kOldVersion.size(), kOldVersion) == 0;
}

/// The text as glslang takes it: it writes SPIR-V of OpenGL ES 3.1 and later alone.
std::string newerText(const GlslStage& stage)
{
    std::string text = stage.text;
    return isOld(stage) ? text.replace(0, kOldVersion.size(), kNewVersion) : text;
}

Result<Words> spirvOf(const GlslStage& stage, glslang_stage_t kind)
{
    const ParsedStage parsed = parseStage(newerText(stage), kind, true);
    if (!parsed.log.empty()) return explain(stage, parsed.log);
    const GlslangProgram program(glslang_program_create());
    glslang_program_add_shader(program.get(), parsed.shader.get());
    if (!glslang_program_link(program.get(), GLSLANG_MSG_DEFAULT_BIT) ||
        !glslang_program_map_io(program.get()))
        return explain(stage, glslang_program_get_info_log(program.get()));
    glslang_program_SPIRV_generate(program.get(), kind);
    Words words(glslang_program_SPIRV_get_size(program.get()));
    glslang_program_SPIRV_get(program.get(), words.data());
    return words;
}

/// False where SPIRV-Cross fails; the context then says why.
bool writeGlsl(spvc_context context, const Words& words, unsigned version, std::string& text)
{
    spvc_parsed_ir parsed = nullptr;
    spvc_compiler compiler = nullptr;
    spvc_compiler_options options = nullptr;
    const char* source = nullptr;
    const bool ready =
        spvc_context_parse_spirv(context, words.data(), words.size(), &parsed) == SPVC_SUCCESS &&
        spvc_context_create_compiler(context, SPVC_BACKEND_GLSL, parsed,
                                     SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) == SPVC_SUCCESS &&
        spvc_compiler_create_compiler_options(compiler, &options) == SPVC_SUCCESS;
    if (!ready) return false;
    spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, version);
    for (const spvc_compiler_option option :
         {SPVC_COMPILER_OPTION_GLSL_ES, SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_FLOAT_PRECISION_HIGHP,
          SPVC_COMPILER_OPTION_GLSL_ES_DEFAULT_INT_PRECISION_HIGHP})
        spvc_compiler_options_set_bool(options, option, SPVC_TRUE);
    spvc_compiler_install_compiler_options(compiler, options);
    if (spvc_compiler_compile(compiler, &source) != SPVC_SUCCESS) return false;
    text = source;
    return true;
}

/// The stage rewritten; its lines are no longer those of its files.
Result<GlslStage> rewrite(const GlslStage& stage, glslang_stage_t kind, Mediump mediump)
{
    const Result<Words> words = spirvOf(stage, kind);
    if (!words) return words.diagnostics();
    spvc_context context = nullptr;
    spvc_context_create(&context);
    const std::unique_ptr<spvc_context_s, void (*)(spvc_context)> owned(context,
                                                                        spvc_context_destroy);
    GlslStage rewritten = stage;
    if (!writeGlsl(context, rewriteMediump(*words, mediump), isOld(stage) ? 300 : 310,
                   rewritten.text))
        return explain(stage, spvc_context_get_last_error_string(context));
    const std::string name = stage.files.front()->name + ", rewritten";
    rewritten.files = {std::make_shared<SourceText>(SourceText{name, rewritten.text})};
    return rewritten;
}

class MediumpDevice : public ForwardingDevice {
public:
    MediumpDevice(std::unique_ptr<Device> device, Mediump mediump)
        : ForwardingDevice(*device),
          owned_(std::move(device)),
          mediump_(mediump),
          caps_(device_.caps())
    {
        caps_.name += mediump == Mediump::half ? ", mediump half" : ", mediump full";
    }

    const DeviceCaps& caps() const override { return caps_; }

    Result<ProgramId> createProgram(const ProgramDesc& desc) override
    {
        Result<GlslStage> vertex = rewrite(desc.vertex, GLSLANG_STAGE_VERTEX, mediump_);
        if (!vertex) return vertex.diagnostics();
        Result<GlslStage> fragment = rewrite(desc.fragment, GLSLANG_STAGE_FRAGMENT, mediump_);
        if (!fragment) return fragment.diagnostics();
        return device_.createProgram({desc.label, std::move(*vertex), std::move(*fragment)});
    }

private:
    std::unique_ptr<Device> owned_;
    Mediump mediump_;
    DeviceCaps caps_;
};

}  // namespace

Result<std::unique_ptr<Device>> makeMediumpDevice(std::unique_ptr<Device> device, Mediump mediump)
{
    return std::unique_ptr<Device>(std::make_unique<MediumpDevice>(std::move(device), mediump));
}

bool canRewriteMediump() { return true; }

}  // namespace crevice
