// SPDX-License-Identifier: MIT
// The recording device between frames: what is created, filled, read and destroyed.
#include <crevice/recording_device.h>

#include <algorithm>
#include <utility>

namespace crevice {
namespace {

// Enough for a long frame; past it the log grows, and a test that counts allocations sees that.
constexpr std::size_t kRecordCapacity = 1 << 13;
constexpr std::size_t kWordCapacity = 1 << 17;
constexpr std::size_t kPassCapacity = 1 << 8;

void addUniforms(std::vector<UniformInfo>& all, const GlslStage& stage)
{
    for (const GlslUniform& uniform : stage.uniforms) {
        if (findNamed(all, uniform.name)) continue;
        const int location = all.empty() ? 0 : all.back().location + all.back().count;
        all.push_back({uniform.name, uniform.type, uniform.count, location});
    }
}

}  // namespace

DeviceCaps generousCaps()
{
    DeviceCaps caps;
    caps.name = "recording device";
    caps.version = 320;
    caps.max_texture_size = 16384;
    caps.max_volume_size = 2048;
    caps.max_color_attachments = kMaxColorAttachments;
    caps.max_texture_units = 32;
    caps.max_fragment_uniform_vectors = 1024;
    caps.max_vertex_uniform_vectors = 1024;
    std::fill(std::begin(caps.renderable), std::end(caps.renderable), true);
    constexpr std::uint32_t kTwoFourEight = 1u << 1 | 1u << 3 | 1u << 7;
    std::fill(std::begin(caps.sample_counts), std::end(caps.sample_counts), kTwoFourEight);
    return caps;
}

const char* RecordingDevice::kindName(ObjectId::Kind kind)
{
    constexpr const char* kNames[] = {"texture", "mesh", "program", "framebuffer", "timer"};
    return kNames[static_cast<int>(kind)];
}

RecordingDevice::RecordingDevice(DeviceCaps caps) : caps_(std::move(caps))
{
    records_.reserve(kRecordCapacity);
    words_.reserve(kWordCapacity);
    passes_.reserve(kPassCapacity);
}

int RecordingDevice::live() const
{
    return static_cast<int>(std::count_if(objects_.begin(), objects_.end(),
                                          [](const auto& each) { return each.second.alive; }));
}

int RecordingDevice::live(ObjectId::Kind kind) const
{
    const auto counts = [&](const auto& each) {
        return each.second.alive && each.second.kind == kind;
    };
    return static_cast<int>(std::count_if(objects_.begin(), objects_.end(), counts));
}

void RecordingDevice::record(Call call, std::uint32_t object, Words words)
{
    records_.push_back({call, object, program_, words_.size()});
    words_.insert(words_.end(), words);
}

void RecordingDevice::blame(std::string what) { misuse_.push_back(std::move(what)); }

Status RecordingDevice::checkContext(const std::string& what) const
{
    if (lost_) return Diagnostic{Code::context_lost, "the context of " + what + " is lost"};
    if (!current_)
        return Diagnostic{Code::gl_version, "the context of " + what + " is not current"};
    return {};
}

/// Counts an attempt; when it is the one to fail, or the context is not there, says so.
bool RecordingDevice::failsNow(Diagnostics& errors, const std::string& what)
{
    ++attempts_;
    errors = checkContext(what).diagnostics();
    if (!errors.empty()) return true;
    if (fail_in_ == 0 || --fail_in_ != 0) return false;
    errors.push_back({Code::out_of_memory, "no memory is left for " + what});
    return true;
}

std::uint32_t RecordingDevice::add(Object object, Call call)
{
    if (in_frame_) blame("'" + object.label + "' is created inside a frame");
    objects_.emplace(++last_id_, std::move(object));
    record(call, last_id_);
    return last_id_;
}

const RecordingDevice::Object* RecordingDevice::objectOf(std::uint32_t id) const
{
    const auto found = objects_.find(id);
    return found == objects_.end() ? nullptr : &found->second;
}

RecordingDevice::Object* RecordingDevice::find(ObjectId id, const char* caller)
{
    const auto found = objects_.find(id.value);
    Object* object = found == objects_.end() ? nullptr : &found->second;
    if (object && object->kind == id.kind && object->alive) return object;
    blame(std::string(caller) + " gets a " + kindName(id.kind) + " that " +
          (object && object->kind == id.kind ? "was destroyed: '" + object->label + "'"
                                             : std::string("does not exist")));
    return nullptr;
}

Result<TextureId> RecordingDevice::createTexture(const TextureDesc& desc)
{
    Diagnostics errors;
    if (failsNow(errors, "texture '" + desc.label + "'")) return errors;
    const int longest = std::max({desc.extent.width, desc.extent.height, desc.depth});
    if (std::min(desc.extent.width, desc.extent.height) < 1 ||
        longest > (desc.depth > 0 ? caps_.max_volume_size : caps_.max_texture_size))
        blame("texture '" + desc.label + "' has a size that cannot be");
    Object object{ObjectId::Kind::texture, desc.label};
    object.texture = desc;
    return TextureId{add(std::move(object), Call::create_texture)};
}

Result<TextureId> RecordingDevice::adoptTexture(const HostTexture& host)
{
    Diagnostics errors;
    if (failsNow(errors, "texture '" + host.label + "'")) return errors;
    Object object{ObjectId::Kind::texture, host.label};
    const Format format = host.format == Format::none ? Format::depth24 : host.format;
    object.texture = {host.label, format, host.extent, host.copied() ? 1 : host.samples};
    object.native_name = host.copied() ? 0 : host.name;
    object.copied = host.copied();
    object.defined = true;
    return TextureId{add(std::move(object), Call::adopt_texture)};
}

Status RecordingDevice::refresh(TextureId id)
{
    const Object* object = find(id, "refresh");
    if (!object) return checkReadable(*this, id);
    if (in_frame_) blame("texture '" + object->label + "' is refreshed inside a frame");
    if (object->copied) record(Call::refresh, id.value);
    return checkContext("texture '" + object->label + "'");
}

/// All that is drawn into has as many samples, and what that is resolved into has one; and one
/// size, where the device wants that.
void RecordingDevice::checkAttachments(const FramebufferDesc& desc)
{
    int samples = 0;
    Extent extent;
    const auto check = [&](TextureId id, bool resolved) {
        const Object* texture = id ? find(id, "createFramebuffer") : nullptr;
        if (!texture) return;
        const int found = texture->texture.samples;
        if (resolved ? found != 1 || samples == 1 : samples > 0 && found != samples)
            blame("framebuffer '" + desc.label + "' cannot have '" + texture->label + "' with " +
                  std::to_string(found) + " samples");
        if (!resolved) samples = found;
        if (caps_.equal_attachments && extent != Extent() && texture->texture.extent != extent)
            blame("framebuffer '" + desc.label + "' cannot have '" + texture->label +
                  "' of another size");
        extent = texture->texture.extent;
    };
    for (const TextureId id : desc.color) check(id, false);
    check(desc.depth, false);
    for (const TextureId id : desc.resolve_color) check(id, true);
    check(desc.resolve_depth, true);
}

Result<FramebufferId> RecordingDevice::createFramebuffer(const FramebufferDesc& desc)
{
    Diagnostics errors;
    if (failsNow(errors, "framebuffer '" + desc.label + "'")) return errors;
    checkAttachments(desc);
    Object object{ObjectId::Kind::framebuffer, desc.label};
    object.framebuffer = desc;
    const std::uint32_t id = add(std::move(object), Call::create_framebuffer);
    framebuffers_.insert(id);
    return FramebufferId{id};
}

Result<ProgramId> RecordingDevice::createProgram(const ProgramDesc& desc)
{
    Diagnostics errors;
    if (failsNow(errors, "program '" + desc.label + "'")) return errors;
    Object object{ObjectId::Kind::program, desc.label};
    object.uniforms = forced_;
    addUniforms(object.uniforms, desc.vertex);
    addUniforms(object.uniforms, desc.fragment);
    object.uniform_set.resize(object.uniforms.size());
    return ProgramId{add(std::move(object), Call::create_program)};
}

Result<MeshId> RecordingDevice::createMesh(const MeshDesc& desc)
{
    if (Status status = checkMesh(desc); !status) return status.diagnostics();
    Diagnostics errors;
    if (failsNow(errors, "mesh '" + desc.label + "'")) return errors;
    Object object{ObjectId::Kind::mesh, desc.label};
    object.index_count = static_cast<std::uint32_t>(desc.indices.size());
    object.origin = originOf(desc);
    if (desc.may_have_sheets) object.sheets = sheetsOf(desc);
    return MeshId{add(std::move(object), Call::create_mesh)};
}

Result<MeshId> RecordingDevice::adoptMesh(const HostMesh& host)
{
    if (Status status = checkMesh(host); !status) return status.diagnostics();
    Diagnostics errors;
    if (failsNow(errors, "mesh '" + host.label + "'")) return errors;
    Object object{ObjectId::Kind::mesh, host.label};
    object.index_count = host.index_count;
    object.normals = host.normal.buffer != 0;
    object.uv = host.uv.buffer != 0;
    return MeshId{add(std::move(object), Call::adopt_mesh)};
}

ObjectInfo RecordingDevice::info(ObjectId id) const
{
    const Object* object = objectOf(id.value);
    if (!object || !object->alive || object->kind != id.kind) return {};
    const bool texture = id.kind == ObjectId::Kind::texture;
    const std::uint32_t own_name = texture ? id.value : 0;
    return {true,
            object->native_name ? object->native_name : own_name,
            object->texture.samples,
            object->index_count,
            object->origin,
            object->label,
            object->normals,
            object->uv,
            object->texture.format,
            object->texture.depth,
            &object->sheets};
}

void RecordingDevice::destroy(ObjectId id)
{
    if (id.value == 0) return;
    if (in_frame_) blame("an object is destroyed inside a frame");
    Object* object = find(id, "destroy");
    if (!object) return;
    for (const std::uint32_t framebuffer : framebuffers_) {
        const Object& other = objects_.at(framebuffer);
        if (uses(other.framebuffer, id.value))
            blame("texture '" + object->label + "' is destroyed before framebuffer '" +
                  other.label + "', which uses it");
    }
    object->alive = false;
    framebuffers_.erase(id.value);
    record(Call::destroy, id.value);
}

Status RecordingDevice::writeTexture(TextureId id, const Image& image)
{
    Object* object = find(id, "writeTexture");
    if (!object) return checkReadable(*this, id);
    Diagnostics errors;
    if (failsNow(errors, "the content of texture '" + object->label + "'")) return errors;
    if (in_pass_) blame("texture '" + object->label + "' is written inside a pass");
    if (image.extent != object->texture.extent || image.channels < 1)
        blame("texture '" + object->label + "' is written with an image of another size");
    object->image = image;
    object->defined = true;
    record(Call::write_texture, id.value);
    return {};
}

Result<Image> RecordingDevice::readTexture(TextureId id)
{
    Object* object = find(id, "readTexture");
    if (Status status = checkReadable(*this, id); !status) return status.diagnostics();
    if (Status status = checkContext("texture '" + object->label + "'"); !status)
        return status.diagnostics();
    if (!object->defined) blame("texture '" + object->label + "' is read, with undefined content");
    record(Call::read_texture, id.value);
    if (object->image.channels > 0) return object->image;
    return Image(object->texture.extent, formatInfo(object->texture.format).channels);
}

Status RecordingDevice::beginRead(TextureId id)
{
    Object* object = find(id, "beginRead");
    if (Status status = checkReadable(*this, id); !status) return status;
    if (Status status = checkContext("texture '" + object->label + "'"); !status) return status;
    if (!in_frame_ || in_pass_) blame("beginRead outside a frame, or inside a pass");
    if (!object->defined) blame("texture '" + object->label + "' is read, with undefined content");
    record(Call::begin_read, id.value);
    std::array<float, 4>& texel = object->read.emplace();
    for (int i = 0; i < object->image.channels; ++i) texel[i] = object->image.pixels[i];
    return {};
}

std::optional<std::array<float, 4>> RecordingDevice::takeRead(TextureId id)
{
    if (!in_frame_) blame("takeRead outside a frame");
    const auto object = objects_.find(id.value);
    if (results_held_ || object == objects_.end()) return std::nullopt;
    return std::exchange(object->second.read, std::nullopt);
}

const std::vector<UniformInfo>& RecordingDevice::uniforms(ProgramId id) const
{
    return objects_.at(id.value).uniforms;
}

}  // namespace crevice
