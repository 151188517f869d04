// SPDX-License-Identifier: MIT
#include <crevice/gl_device.h>

#include "backends/gl/device_class.h"
#include "backends/gl/failure.h"
#include "backends/gl/formats.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace crevice {

GlDevice::~GlDevice()
{
    if (!isCurrent()) abandon();
}

void GlDevice::markContext()
{
    static std::atomic<GLint> devices{0};
    mark_divisor_ = ++devices;
    mark_ = GlVertexArray::make(gl_);
    gl_.BindVertexArray(mark_.name());
    gl_.VertexAttribDivisor(0, static_cast<GLuint>(mark_divisor_));
    gl_.BindVertexArray(0);
}

bool GlDevice::isCurrent() const
{
    if (!gl_.IsVertexArray(mark_.name())) return false;
    GLint bound = 0, divisor = 0;
    gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    gl_.BindVertexArray(mark_.name());
    gl_.GetVertexAttribiv(0, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &divisor);
    gl_.BindVertexArray(static_cast<GLuint>(bound));
    return divisor == mark_divisor_;
}

Status GlDevice::checkCurrent()
{
    if (isCurrent()) {
        deleteRetired();
        return {};
    }
    noticeReset(gl_);
    const Status status = takeErrors(gl_, "the device");
    if (tellsLoss(status.diagnostics())) return status;
    const bool none = !gl_.GetString(GL_VERSION);
    return failure(Code::gl_version,
                   none ? "no GL context is current on this thread"
                        : "another GL context is current on this thread than the device's",
                   "make the device's context current before calling the device or its renderers");
}

void GlDevice::deleteRetired()
{
    framebuffers_.deleteRetired();
    textures_.deleteRetired();
    meshes_.deleteRetired();
    programs_.deleteRetired();
    timers_.deleteRetired();
}

Status GlDevice::prepare(const ProgramCache& program_cache)
{
    Scope scope(*this);
    markContext();
    state_.bindTexture(0, 0, 0);  // so that unit 0 is put back
    caps_ = readCaps(gl_, info_);
    program_cache_ = GlProgramCache(gl_, program_cache);
    Result<GlCopier> copier = GlCopier::make(gl_, program_cache_);
    if (!copier) return copier.diagnostics();
    copier_ = std::move(*copier);
    makeSamplers();
    if (!caps_.software) timing_ = GlTimers::make(gl_, info_);
    caps_.timers = timing_.exist();
    return takeErrors(gl_, "makeGlDevice");
}

void GlDevice::makeSamplers()
{
    for (Filter filter : {Filter::nearest, Filter::linear, Filter::trilinear}) {
        for (Wrap wrap : {Wrap::clamp, Wrap::repeat}) {
            const GLint filter_mode = filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
            const GLint smaller =
                filter == Filter::trilinear ? GL_LINEAR_MIPMAP_LINEAR : filter_mode;
            const GLint wrap_mode = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
            auto made = GlSampler::make(gl_);
            gl_.SamplerParameteri(made.name(), GL_TEXTURE_MIN_FILTER, smaller);
            gl_.SamplerParameteri(made.name(), GL_TEXTURE_MAG_FILTER, filter_mode);
            for (const GLenum along : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
                gl_.SamplerParameteri(made.name(), along, wrap_mode);
            samplers_[static_cast<int>(filter)][static_cast<int>(wrap)] = std::move(made);
        }
    }
}

Result<TextureId> GlDevice::createTexture(const TextureDesc& desc)
{
    const int limit = desc.depth > 0 ? caps_.max_volume_size : caps_.max_texture_size;
    const int longest = std::max({desc.extent.width, desc.extent.height, desc.depth});
    if (longest > limit)
        return failure(
            Code::too_big_for_device,
            "texture '" + desc.label + "' is " + std::to_string(desc.extent.width) + "x" +
                std::to_string(desc.extent.height) +
                (desc.depth > 0 ? "x" + std::to_string(desc.depth) + " voxels" : " pixels") +
                "; this device holds " + std::to_string(limit) + " a side",
            "render at a smaller size");
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    if (desc.samples > 1) return createMultisampled(desc);
    Scope scope(*this);
    auto texture = GlTexture::make(gl_);
    const GLuint name = texture.name();
    TextureSlot slot{std::move(texture), {}, name, desc.format, desc.extent};
    slot.depth = desc.depth;
    slot.mips = desc.mips;
    state_.bindTexture(0, name, 0, slot.target());
    int levels = 1;
    while (desc.mips && longest >> levels > 0) ++levels;
    allocateTexture(gl_, glFormat(desc.format).internal, desc.extent, desc.depth, levels);
    if (Status status = takeErrors(gl_, "createTexture", desc.label.c_str()); !status)
        return status.diagnostics();
    setLabel(gl_, GL_TEXTURE, name, desc.label);
    return TextureId{textures_.add(std::move(slot))};
}

Result<TextureId> GlDevice::createMultisampled(const TextureDesc& desc)
{
    Scope scope(*this);
    auto buffer = GlRenderbuffer::make(gl_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, desc.samples,
                                       glFormat(desc.format).internal, desc.extent.width,
                                       desc.extent.height);
    if (Status status = takeErrors(gl_, "createTexture", desc.label.c_str()); !status)
        return status.diagnostics();
    setLabel(gl_, GL_RENDERBUFFER, buffer.name(), desc.label);
    const GLuint name = buffer.name();
    return TextureId{
        textures_.add({{}, std::move(buffer), name, desc.format, desc.extent, desc.samples, {}})};
}

/// What can be said of it without looking into it.
Status GlDevice::checkName(const HostTexture& host)
{
    const bool texture =
        host.kind == HostTexture::Kind::texture || host.kind == HostTexture::Kind::layer;
    if (texture && !gl_.IsTexture(host.name)) {
        if (Status status = takeErrors(gl_, "adoptTexture", host.label.c_str()); !status)
            return status;
        return failure(Code::bad_input,
                       "the host's texture '" + host.label + "' has the name " +
                           std::to_string(host.name) + ", which is no texture of this context",
                       host.name == 0
                           ? "of a window's own depth say that its kind is a framebuffer"
                           : "make it in the device's context, or in one that shares with it");
    }
    if (host.samples > 1 && !host.copied() && caps_.version < 310)
        return failure(Code::sampler_version,
                       "the host's texture '" + host.label + "' has " +
                           std::to_string(host.samples) +
                           " samples a pixel, and OpenGL ES 3.0 reads none of them",
                       "set HostTexture::part, and crevice reads a resolved copy");
    return {};
}

Result<TextureId> GlDevice::adoptTexture(const HostTexture& host)
{
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    Scope scope(*this);
    if (Status status = checkName(host); !status) return status.diagnostics();
    HostTexture known = host;
    TextureSlot slot{{}, {}, host.name, host.format, host.extent, host.samples, {}};
    if (host.copied()) {
        Result<GlHostCopy> copy = GlHostCopy::make(gl_, state_, known);
        if (!copy) return unlessLost(copy.diagnostics(), "adoptTexture").diagnostics();
        slot.copy = std::move(*copy);
        slot.name = slot.copy.texture();
        slot.samples = 1;
    } else if (Status status = checkHostTexture(gl_, state_, known); !status) {
        return unlessLost(status, "adoptTexture").diagnostics();
    }
    slot.format = known.format;
    return TextureId{textures_.add(std::move(slot))};
}

Status GlDevice::unlessLost(const Status& failed, const char* what)
{
    noticeReset(gl_);
    const Status status = takeErrors(gl_, what);
    return tellsLoss(status.diagnostics()) ? status : failed;
}

Status GlDevice::refresh(TextureId id)
{
    if (Status status = checkCurrent(); !status) return status;
    if (Status status = checkReadable(*this, id); !status) return status;
    const TextureSlot& texture = textures_.at(id.value);
    if (texture.copy.texture() == 0) return {};
    Scope scope(*this);
    if (Status status = state_.checkHost(); !status) return status;
    const Status status = texture.copy.update(gl_);
    return status ? status : unlessLost(status, "refresh");
}

void GlDevice::attach(GLenum point, TextureId id, int layer)
{
    const TextureSlot& texture = textures_.at(id.value);
    if (texture.depth > 0)
        gl_.FramebufferTextureLayer(GL_FRAMEBUFFER, point, texture.name, 0, layer);
    else if (texture.renderbuffer.name() != 0)
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, texture.name);
    else
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, point, texture.target(), texture.name, 0);
}

Status GlDevice::fill(GlFramebuffer& framebuffer, const std::string& label,
                      const std::vector<TextureId>& color, TextureId depth)
{
    framebuffer = GlFramebuffer::make(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    const auto count = static_cast<int>(color.size());
    std::array<GLenum, kMaxColorAttachments> buffers = {GL_NONE};
    for (int i = 0; i < count; ++i) {
        buffers[i] = color[i] ? GL_COLOR_ATTACHMENT0 + i : GL_NONE;
        if (color[i]) attach(buffers[i], color[i], layerOf(color, i));
    }
    if (depth) attach(GL_DEPTH_ATTACHMENT, depth, 0);
    gl_.DrawBuffers(std::max(count, 1), buffers.data());
    // Desktop OpenGL before 4.1 wants what is read to be there.
    const auto first =
        std::find_if(buffers.begin(), buffers.end(), [](GLenum b) { return b != GL_NONE; });
    gl_.ReadBuffer(first == buffers.end() ? GL_NONE : *first);
    const GLenum complete = gl_.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (Status status = takeErrors(gl_, "createFramebuffer", label.c_str()); !status) return status;
    if (complete != GL_FRAMEBUFFER_COMPLETE)
        return failure(Code::gl_error,
                       "framebuffer '" + label + "' is " + framebufferStatusName(complete),
                       "give its targets one size, and formats that this device renders to");
    setLabel(gl_, GL_FRAMEBUFFER, framebuffer.name(), label);
    return {};
}

namespace {

Status checkAttachments(const Device& device, const FramebufferDesc& desc)
{
    std::vector<TextureId> all = desc.color;
    all.insert(all.end(), desc.resolve_color.begin(), desc.resolve_color.end());
    all.insert(all.end(), {desc.depth, desc.resolve_depth});
    for (const TextureId id : all)
        if (id && !device.info(id).exists)
            return failure(Code::bad_input,
                           "framebuffer '" + desc.label + "' names texture " +
                               std::to_string(id.value) + ", which is none of this device",
                           "take an id that this device gave and that is not destroyed yet");
    return {};
}

}  // namespace

Result<FramebufferId> GlDevice::createFramebuffer(const FramebufferDesc& desc)
{
    const auto count = static_cast<int>(desc.color.size());
    if (count > caps_.max_color_attachments)
        return failure(Code::too_many,
                       "framebuffer '" + desc.label + "' has " + std::to_string(count) +
                           " colour attachments; this device has " +
                           std::to_string(caps_.max_color_attachments),
                       "write fewer targets in one pass");
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    Scope scope(*this);
    FramebufferSlot slot;
    if (Status status = checkAttachments(*this, desc); !status) return status.diagnostics();
    if (Status status = fill(slot.drawn, desc.label, desc.color, desc.depth); !status)
        return status.diagnostics();
    slot.color = desc.color;
    const auto& colors = desc.resolve_color;
    const auto used = [](TextureId id) { return static_cast<bool>(id); };
    if (desc.resolve_depth || std::any_of(colors.begin(), colors.end(), used)) {
        Status status = fill(slot.resolved, desc.label + " resolved", colors, desc.resolve_depth);
        if (!status) return status.diagnostics();
    }
    return FramebufferId{framebuffers_.add(std::move(slot))};
}

Result<ProgramId> GlDevice::createProgram(const ProgramDesc& desc)
{
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    takeHostErrors();
    Result<GlLinkedProgram> program = makeProgram(gl_, program_cache_, desc);
    if (!program) return program.diagnostics();
    return ProgramId{programs_.add(std::move(*program))};
}

ObjectInfo GlDevice::info(ObjectId id) const
{
    switch (id.kind) {
    case ObjectId::Kind::texture:
        if (const TextureSlot* texture = textures_.find(id.value)) {
            ObjectInfo info{true, texture->renderbuffer.name() != 0 ? 0 : texture->name,
                            texture->samples};
            info.format = texture->format;
            info.depth = texture->depth;
            return info;
        }
        return {};
    case ObjectId::Kind::mesh:
        if (const MeshSlot* mesh = meshes_.find(id.value))
            return {true,
                    0,
                    1,
                    mesh->index_count,
                    mesh->origin,
                    mesh->label,
                    mesh->normals,
                    mesh->uv,
                    Format::none,
                    0,
                    &mesh->sheets};
        return {};
    case ObjectId::Kind::program: return {programs_.find(id.value) != nullptr};
    case ObjectId::Kind::framebuffer: return {framebuffers_.find(id.value) != nullptr};
    case ObjectId::Kind::timer: return {timers_.find(id.value) != nullptr};
    }
    return {};
}

void GlDevice::attachLayers(const FramebufferSlot& framebuffer)
{
    for (int i = 0; i < static_cast<int>(framebuffer.color.size()); ++i) {
        const TextureId id = framebuffer.color[i];
        if (id && textures_.at(id.value).depth > 0)
            attach(GL_COLOR_ATTACHMENT0 + i, id, pass_.first_layer + layerOf(framebuffer.color, i));
    }
}

void GlDevice::makeMips(const FramebufferSlot& framebuffer)
{
    for (const TextureId id : framebuffer.color) {
        const TextureSlot* texture = textures_.find(id.value);
        if (!texture || !texture->mips) continue;
        state_.bindTexture(0, texture->name, 0, texture->target());
        gl_.GenerateMipmap(texture->target());
    }
}

void GlDevice::destroy(ObjectId id)
{
    switch (id.kind) {
    case ObjectId::Kind::texture: textures_.retire(id.value); break;
    case ObjectId::Kind::mesh: meshes_.retire(id.value); break;
    case ObjectId::Kind::program: programs_.retire(id.value); break;
    case ObjectId::Kind::framebuffer: framebuffers_.retire(id.value); break;
    case ObjectId::Kind::timer: return timers_.retire(id.value);  // many die at once
    }
    if (isCurrent()) deleteRetired();  // else before the next call that finds the context
}

Status GlDevice::writeTexture(TextureId id, const Image& image)
{
    if (Status status = checkCurrent(); !status) return status;
    if (Status status = checkReadable(*this, id); !status) return status;
    const TextureSlot& texture = textures_.at(id.value);
    if (image.extent != texture.extent)
        return failure(Code::bad_input, "an image differs in size from the texture that it is for",
                       "make the image as large as the texture");
    Scope scope(*this);
    const GlFormat& format = glFormat(texture.format);
    const std::vector<std::uint8_t> pixels = packPixels(image, texture.format);
    state_.bindTexture(0, texture.name, 0);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.extent.width, image.extent.height,
                      format.upload_format, format.upload_type, pixels.data());
    return takeErrors(gl_, "writeTexture");
}

Result<Image> GlDevice::readTexture(TextureId id)
{
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    if (Status status = checkReadable(*this, id); !status) return status.diagnostics();
    const TextureSlot& texture = textures_.at(id.value);
    Scope scope(*this);
    if (Status status = state_.checkHost(); !status) return status.diagnostics();
    const GLuint nearest = sampler({Filter::nearest, Wrap::clamp}, texture.format);
    Result<Image> rgba = copier_.read(gl_, state_, texture.name, nearest, texture.extent);
    if (!rgba) return rgba;
    Image image(texture.extent, formatInfo(texture.format).channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = rgba->pixels[i / image.channels * 4 + i % image.channels];
    return image;
}

Status GlDevice::beginRead(TextureId id)
{
    if (Status status = checkReadable(*this, id); !status) return status;
    if (hasErrors(errors_)) return errors_;  // as endFrame will say
    TextureSlot& texture = textures_.at(id.value);
    state_.unmask();
    const GLuint nearest = sampler({Filter::nearest, Wrap::clamp}, texture.format);
    return reads_.begin(gl_, state_, copier_, texture.read, texture.name, nearest);
}

std::optional<std::array<float, 4>> GlDevice::takeRead(TextureId id)
{
    if (!textures_.find(id.value)) return std::nullopt;
    return GlReads::take(gl_, textures_.at(id.value).read);
}

Result<std::unique_ptr<Device>> makeGlDevice(const GlLoader& loader, const GlDeviceOptions& options)
{
    Result<GlApi> gl = loadGlApi(loader);
    if (!gl) return gl.diagnostics();
    Result<GlInfo> info = readInfo(*gl, options.ignore_extensions);
    if (!info) {
        const Status status = takeErrors(*gl, "makeGlDevice");
        return tellsLoss(status.diagnostics()) ? status.diagnostics() : info.diagnostics();
    }
    settleOptional(*gl, *info, loader);
    auto device = std::make_unique<GlDevice>(*gl, *info, options);
    if (Status status = device->prepare(options.program_cache); !status)
        return status.diagnostics();
    return std::unique_ptr<Device>(std::move(device));
}

void abandonGlDevice(Device& device) { static_cast<GlDevice&>(device).abandon(); }

}  // namespace crevice
