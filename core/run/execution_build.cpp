// SPDX-License-Identifier: MIT
// Making a plan's objects and preparing its commands.
#include "core/run/execution.h"
#include "core/sampling/generators.h"

namespace crevice {
namespace {

bool uses(const Plan& plan, InputKind kind)
{
    for (const PlanPass& pass : plan.passes)
        for (const PlanInput& input : pass.inputs)
            if (input.kind == kind) return true;
    return false;
}

PassInfo passInfo(const Plan& plan, const PlanPass& pass)
{
    PassInfo info;
    info.label = pass.name.c_str();
    info.extent = pass.extent;
    info.color_count = static_cast<int>(pass.color.size());
    for (int i = 0; i < info.color_count; ++i) {
        const PlanAttachment& color = pass.color[i];
        info.color_load[i] = color.load;
        info.color_store[i] = color.store;
        std::copy(color.clear.begin(), color.clear.end(), info.clear_color[i]);
        info.makes_mips =
            info.makes_mips ||
            (color.target >= 0 && plan.textures[plan.targets[color.target].texture].mips);
    }
    info.has_depth = pass.has_depth && pass.depth.target >= 0;
    info.depth_load = pass.depth.load;
    info.depth_store = pass.depth.store;
    info.clear_depth = pass.depth.clear[0];
    return info;
}

}  // namespace

Result<std::unique_ptr<Execution>> Execution::create(Device& device, Plan plan,
                                                     const Execution* previous, bool remember)
{
    std::unique_ptr<Execution> made(new Execution(device, std::move(plan)));
    if (previous && remember) made->takeHistories(*previous);
    for (std::size_t i = 0; i < made->plan_.boxes.size(); ++i) {
        PreparedBox& box = made->boxes_.emplace_back(PreparedBox{ViewDraws(made->drawn_)});
        for (std::size_t pass = 0; pass < made->plan_.passes.size(); ++pass)
            if (made->plan_.passes[pass].box == static_cast<int>(i)) box.last_pass = pass;
    }
    Status status = made->createTextures();
    if (status) status = made->createGenerated();
    if (status) status = made->createPrograms(previous);
    for (int view = 0; status && view < made->plan_.views; ++view)
        status = made->createPasses(view);
    if (!status) return status.diagnostics();
    return made;
}

/// All of the plan's histories or none: `history_valid` is one for all. What was drawn last becomes
/// what the first frame reads. Both executions have the textures then; only one may go on.
void Execution::takeHistories(const Execution& previous)
{
    bool all = previous.remembers_ && plan_.views == previous.plan_.views;
    std::vector<std::vector<SharedTexture>> taken = textures_;
    for (const PlanTarget& target : plan_.targets) {
        if (target.history_texture < 0 || !all) continue;
        remembers_ = true;
        const PlanTarget* const other = findNamed(previous.plan_.targets, target.name);
        all = other && other->history_texture >= 0;
        if (!all) break;
        const PlanTexture& own = plan_.textures[target.texture];
        const PlanTexture& last = previous.plan_.textures[other->texture];
        all = own.format == last.format && own.extent == last.extent && own.copies == last.copies;
        taken[target.texture] = previous.textures_[other->texture];
        taken[target.history_texture] = previous.textures_[other->history_texture];
        if (previous.swapped_) std::swap(taken[target.texture], taken[target.history_texture]);
    }
    remembers_ = remembers_ && all;
    if (!remembers_) return;
    textures_ = std::move(taken);
    views_ = previous.views_;
}

Status Execution::createTextures()
{
    for (std::size_t i = 0; i < plan_.textures.size(); ++i) {
        const PlanTexture& texture = plan_.textures[i];
        if (!textures_[i].empty()) continue;  // a history that goes on
        const std::string label = texture.targets.empty() ? "unused" : texture.targets.front();
        for (int view = 0; view < texture.copies; ++view) {
            const std::string of_view = view > 0 ? " of view " + std::to_string(view) : "";
            Result<TextureId> id =
                device_.createTexture({label + of_view, texture.format, texture.extent,
                                       texture.samples, texture.depth, texture.mips});
            if (!id) return id.diagnostics();
            textures_[i].push_back(std::make_shared<Owned<TextureId>>(device_, *id));
        }
    }
    Status status;
    const auto create = [&](const char* label, float value, Owned<TextureId>& texture) {
        if (status) status = createFilled(label, Format::rgba8, Image({1, 1}, 4, value), texture);
    };
    for (const float constant : plan_.constants)
        create("constant", constant, constants_.emplace_back());
    if (uses(plan_, InputKind::material)) create("white", 1.0f, white_);
    if (uses(plan_, InputKind::imported)) create("black", 0.0f, black_);
    return status;
}

/// Creates a texture and writes the image into it.
Status Execution::createFilled(const std::string& label, Format format, const Image& image,
                               Owned<TextureId>& texture)
{
    Result<TextureId> id = device_.createTexture({label, format, image.extent});
    if (!id) return id.diagnostics();
    texture = Owned<TextureId>(device_, *id);
    return device_.writeTexture(*id, image);
}

Status Execution::createGenerated()
{
    for (const GeneratorDesc& each : plan_.generated) {
        generated_.emplace_back();
        if (!generatesTexture(each.generator)) {
            const auto kernel = makeKernel(each);
            if (!kernel) return kernel.diagnostics();
            values_.setKernel(generated_.size() - 1, *kernel);
            continue;
        }
        const Result<Image> noise = makeNoise(each);
        if (!noise) return noise.diagnostics();
        // Half floats: every OpenGL ES 3.0 device samples and filters them, and -1 to 1 fits.
        if (Status status = createFilled(each.name, Format::rgba16f, *noise, generated_.back());
            !status)
            return status;
    }
    return {};
}

Status Execution::createPrograms(const Execution* previous)
{
    for (const PlanProgram& program : plan_.programs) {
        if (SharedProgram shared = previous ? previous->programOf(program.key) : nullptr)
            programs_.emplace_back(program.key, std::move(shared));
        else if (Status status = createProgram(program); !status)
            return status;
        else
            compiled_.push_back(program.label);
    }
    if (!previous) return {};
    for (const auto& [key, program] : previous->programs_)
        if (!programOf(key)) programs_.emplace_back(key, program);
    const std::size_t most = plan_.programs.size() + kMaxIdlePrograms;
    if (programs_.size() > most) programs_.resize(most);
    return {};
}

Status Execution::createProgram(const PlanProgram& program)
{
    Result<ProgramId> id = device_.createProgram({program.label, program.vertex, program.fragment});
    if (id) {
        programs_.emplace_back(program.key, std::make_shared<Owned<ProgramId>>(device_, *id));
        return {};
    }
    Diagnostics errors = id.diagnostics();
    for (Diagnostic& error : errors) {
        error.pointer = program.pointer;
        error.notes.push_back({program.place, "in shader '" + program.label + "'"});
    }
    return errors;
}

Result<Execution::Programs> Execution::prepare(const Plan& other)
{
    Programs all;
    for (const PlanProgram& program : other.programs) {
        if (!programOf(program.key))
            if (Status status = createProgram(program); !status) return status.diagnostics();
        all.emplace_back(program.key, programOf(program.key));
    }
    return all;
}

void Execution::keep(const Programs& programs)
{
    for (const auto& program : programs)
        if (!programOf(program.first)) programs_.push_back(program);
}

Execution::SharedProgram Execution::programOf(const std::string& key) const
{
    for (const auto& [known, program] : programs_)
        if (known == key) return program;
    return nullptr;
}

Status Execution::createPasses(int view)
{
    Diagnostics errors;
    for (const PlanPass& pass : plan_.passes) {
        PreparedPass& prepared = runs_.emplace_back();
        prepared.plan = &pass;
        prepared.view = view;
        prepared.info = passInfo(plan_, pass);
        prepared.program = programs_[pass.program].second->id();
        prepared.state = pass.state;
        if (isMasked(pass)) {
            prepared.info.at_depth = 0.0f;
            prepared.state.depth_test = Compare::less;
        }
        for (const bool swapped : {false, true})
            if (Status status = createFramebuffer(prepared, swapped); !status) return status;
        prepared.info.framebuffer = prepared.framebuffer.id();
        for (const UniformInfo& uniform : device_.uniforms(prepared.program))
            bindUniform(uniform, prepared, errors);
        warnings_.add(pass, device_.uniforms(prepared.program));
    }
    return errors;
}

/// `swapped`, only for a pass that writes a target whose history someone reads.
Status Execution::createFramebuffer(PreparedPass& prepared, bool swapped)
{
    const PlanPass& pass = *prepared.plan;
    FramebufferDesc desc;
    desc.label = pass.name;
    bool remembered = false;
    const auto attach = [&](const PlanAttachment& attachment, TextureId& drawn, TextureId& read) {
        drawn = targetTexture(attachment.target, prepared.view, swapped);
        if (attachment.target < 0) return;
        const PlanTarget& target = plan_.targets[attachment.target];
        remembered = remembered || target.history_texture >= 0;
        // Of what was resolved, samples are gone: a pass that goes on draws on the result.
        if (target.drawn_texture == target.texture || pass.over >= 0) return;
        read = std::exchange(drawn, texture(target.drawn_texture, prepared.view));
    };
    for (const PlanAttachment& color : pass.color)
        attach(color, desc.color.emplace_back(), desc.resolve_color.emplace_back());
    if (pass.has_depth) attach(pass.depth, desc.depth, desc.resolve_depth);
    if (swapped && !remembered) return {};
    Result<FramebufferId> id = device_.createFramebuffer(desc);
    if (!id) return id.diagnostics();
    (swapped ? prepared.odd_frame : prepared.framebuffer) = Owned<FramebufferId>(device_, *id);
    return {};
}

TextureId Execution::targetTexture(int target, int view, bool swapped) const
{
    if (target < 0) return {};
    const PlanTarget& desc = plan_.targets[target];
    const bool other = swapped && desc.history_texture >= 0;
    return texture(other ? desc.history_texture : desc.texture, view);
}

TextureId Execution::texture(int index, int view) const
{
    const std::vector<SharedTexture>& copies = textures_[index];
    return copies[copies.size() > 1 ? view : 0]->id();
}

/// The texture behind an input; null for those that a frame brings.
TextureId Execution::textureOf(const PlanInput& input, int view, bool swapped) const
{
    switch (input.kind) {
    case InputKind::target: return targetTexture(input.index, view, swapped);
    case InputKind::history: return targetTexture(input.index, view, !swapped);
    case InputKind::generated: return generated_[input.index].id();
    case InputKind::constant: return constants_[input.index].id();
    case InputKind::imported:
    case InputKind::material: break;
    }
    return {};
}

/// Gives an active uniform what the plan has bound to it. The plan was made from a scan of the
/// text; where the driver sees more than the scan did, the uniform would silently stay 0.
void Execution::bindUniform(const UniformInfo& active, PreparedPass& prepared, Diagnostics& errors)
{
    const PlanPass& pass = *prepared.plan;
    const PlanInput* input = isSampler(active.type) ? findNamed(pass.inputs, active.name) : nullptr;
    if (input) return bindTexture(*input, active, prepared);
    const PlanUniform* uniform = findNamed(pass.uniforms, active.name);
    if (!uniform || uniform->type != active.type) {
        errors.push_back(unbound(pass, active, uniform));
        return;
    }
    const int count = std::min(active.count, uniform->count);
    const bool per_draw = uniform->source == UniformSource::draw;
    if (per_draw && uniform->index == view_normal_from_model) {
        view_draws_.readNormals();
        for (PreparedBox& box : boxes_) box.draws.readNormals();
    }
    prepared.reads_box = prepared.reads_box || uniform->source == UniformSource::box;
    auto& uniforms = per_draw ? prepared.draw_uniforms : prepared.uniforms;
    uniforms.push_back({active.location, active.type, count, values_.offsetOf(*uniform)});
    if (!per_draw) prepared.sent.resize(prepared.sent.size() + wordsOf(active.type, count));
}

/// Why an active uniform cannot be fed: `uniform` is what the plan has of that name, or null.
Diagnostic Execution::unbound(const PlanPass& pass, const UniformInfo& active,
                              const PlanUniform* uniform) const
{
    const PlanProgram& program = plan_.programs[pass.program];
    const std::string why = uniform ? "of type " + std::string(glslName(active.type)) +
                                          ", and its value is " + glslName(uniform->type)
                                    : "which its text does not declare in a known form";
    return {uniform ? Code::uniform_type : Code::uniform_unbound,
            "shader '" + program.label + "' of pass '" + pass.name + "' has uniform '" +
                active.name + "', " + why,
            "declare it on a line of its own, without macros", program.place, program.pointer};
}

void Execution::bindTexture(const PlanInput& input, const UniformInfo& uniform,
                            PreparedPass& prepared)
{
    const int unit = static_cast<int>(&input - prepared.plan->inputs.data());
    TextureBinding binding{uniform.location, unit, textureOf(input, prepared.view, false),
                           textureOf(input, prepared.view, true), input.sampling};
    if (binding.odd_frame.value == binding.texture.value) binding.odd_frame = {};
    binding.multisampled = uniform.type == GlslType::sampler2d_ms;
    if (input.kind == InputKind::imported) binding.import = input.index;
    const bool material = input.kind == InputKind::material;
    if (material) binding.map = input.index;
    (material ? prepared.material_textures : prepared.textures).push_back(binding);
}

}  // namespace crevice
