// SPDX-License-Identifier: MIT
// The recording device's log as text; nothing is formatted before somebody asks for it.
#include "backends/recording_device.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>

namespace crevice {
namespace {

constexpr const char* kCallNames[] = {
    "createTexture", "createFramebuffer", "createProgram", "createMesh",     "adoptTexture",
    "destroy",       "writeTexture",      "readTexture",   "beginFrame",     "endFrame",
    "beginPass",     "endPass",           "setProgram",    "setTexture",     "setUniform",
    "draw",          "drawFullscreen",    "present",       "finish",
    "beginTimer",    "endTimer",          "readTimer",
};
constexpr const char* kKindNames[] = {"texture", "mesh", "program", "framebuffer"};
constexpr const char* kCompareNames[] = {"always",  "less",          "less_equal",
                                         "greater", "greater_equal", "equal"};
constexpr const char* kCullNames[] = {"none", "back", "front"};
constexpr const char* kBlendNames[] = {"none", "alpha", "add", "multiply"};
constexpr const char* kFilterNames[] = {"nearest", "linear"};
constexpr const char* kWrapNames[] = {"clamp", "repeat"};
constexpr const char* kLoadNames[] = {"load", "clear", "discard"};
constexpr const char* kStoreNames[] = {"store", "discard"};

constexpr std::size_t kValuesShown = 16;

bool isInteger(GlslType type)
{
    switch (type) {
    case GlslType::int_: case GlslType::ivec2: case GlslType::ivec3: case GlslType::ivec4:
    case GlslType::uint_: case GlslType::bool_: return true;
    default: return false;
    }
}

std::ostream& operator<<(std::ostream& out, Extent extent)
{
    return out << extent.width << 'x' << extent.height;
}

std::string passText(const PassInfo& pass)
{
    std::ostringstream out;
    out << ' ' << pass.label << ' ' << pass.extent;
    for (int i = 0; i < pass.color_count; ++i) {
        out << " color" << i << ' ' << kLoadNames[static_cast<int>(pass.color_load[i])];
        if (pass.color_load[i] == LoadOp::clear)
            for (float value : pass.clear_color[i]) out << ' ' << value;
        out << ' ' << kStoreNames[static_cast<int>(pass.color_store[i])];
    }
    if (pass.within_area)
        out << " within " << pass.area.x << ' ' << pass.area.y << ' ' << pass.area.extent;
    if (pass.at_depth >= 0) out << " at depth " << pass.at_depth;
    if (!pass.has_depth) return out.str();
    out << " depth " << kLoadNames[static_cast<int>(pass.depth_load)];
    if (pass.depth_load == LoadOp::clear) out << ' ' << pass.clear_depth;
    out << ' ' << kStoreNames[static_cast<int>(pass.depth_store)];
    return out.str();
}

std::string stateText(const std::uint32_t* words)
{
    return std::string(" depth_test ") + kCompareNames[words[0]] +
           (words[1] ? " depth_write" : "") + " cull " + kCullNames[words[2]] + " blend " +
           kBlendNames[words[3]];
}

}  // namespace

void RecordingDevice::clearLog()
{
    records_.clear();
    words_.clear();
    passes_.clear();
    for (auto each = objects_.begin(); each != objects_.end();)
        each = each->second.alive ? std::next(each) : objects_.erase(each);
    if (!objectOf(program_)) program_ = 0;
}

std::string RecordingDevice::log() const
{
    std::string text;
    for (const Record& call : records_)
        text += kCallNames[static_cast<int>(call.call)] + arguments(call) + '\n';
    return text;
}

std::vector<float> RecordingDevice::lastUniform(std::string_view name) const
{
    for (auto call = records_.rbegin(); call != records_.rend(); ++call) {
        if (call->call != Call::set_uniform) continue;
        const UniformInfo* uniform = uniformOf(*call);
        if (uniform && uniform->name == name) return values(*call);
    }
    return {};
}

std::string RecordingDevice::label(std::uint32_t object) const
{
    const Object* found = objectOf(object);
    return found ? "'" + found->label + "'" : std::string("nothing");
}

/// The uniform that a setTexture or setUniform means: words are location, then what follows.
const UniformInfo* RecordingDevice::uniformOf(const Record& call) const
{
    if (call.program == 0) return nullptr;
    for (const UniformInfo& uniform : objects_.at(call.program).uniforms)
        if (uniform.location == static_cast<int>(words_[call.words])) return &uniform;
    return nullptr;
}

/// What a setUniform was given, integers converted.
std::vector<float> RecordingDevice::values(const Record& call) const
{
    const std::uint32_t* words = &words_[call.words];
    std::vector<float> result(words[3]);
    if (!result.empty()) std::memcpy(result.data(), words + 4, result.size() * sizeof(float));
    if (!isInteger(static_cast<GlslType>(words[1]))) return result;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<float>(static_cast<std::int32_t>(words[4 + i]));
    return result;
}

std::string RecordingDevice::uniformText(const Record& call) const
{
    std::ostringstream out;
    const std::vector<float> all = values(call);
    const std::uint32_t count = words_[call.words + 2];
    const UniformInfo* uniform = uniformOf(call);
    out << ' ' << (uniform ? uniform->name : "nothing");
    if (count > 1) out << '[' << count << ']';
    for (std::size_t i = 0; i < std::min(all.size(), kValuesShown); ++i) out << ' ' << all[i];
    if (all.size() > kValuesShown) out << " ...";
    return out.str();
}

std::string RecordingDevice::createdText(const Object& object) const
{
    std::ostringstream out;
    if (object.kind == ObjectId::Kind::texture)
        out << ' ' << formatInfo(object.texture.format).name << ' ' << object.texture.extent;
    if (object.kind == ObjectId::Kind::texture && object.texture.samples > 1)
        out << ' ' << object.texture.samples << " samples";
    if (object.kind == ObjectId::Kind::mesh) out << ' ' << object.index_count << " indices";
    if (object.kind == ObjectId::Kind::framebuffer) {
        for (TextureId id : object.framebuffer.color) out << " color " << label(id.value);
        if (object.framebuffer.depth) out << " depth " << label(object.framebuffer.depth.value);
        for (TextureId id : object.framebuffer.resolve_color)
            if (id) out << " resolve " << label(id.value);
        if (object.framebuffer.resolve_depth)
            out << " resolve depth " << label(object.framebuffer.resolve_depth.value);
    }
    return out.str();
}

std::string RecordingDevice::arguments(const Record& call) const
{
    const std::uint32_t* words = words_.data() + call.words;
    const std::string object = label(call.object);
    std::ostringstream out;
    switch (call.call) {
    case Call::create_texture: case Call::create_framebuffer: case Call::create_program:
    case Call::create_mesh: case Call::adopt_texture:
        out << ' ' << object << createdText(objects_.at(call.object));
        break;
    case Call::destroy:
        out << ' ' << kKindNames[static_cast<int>(objects_.at(call.object).kind)] << ' ' << object;
        break;
    case Call::write_texture: case Call::read_texture:
        out << ' ' << object;
        break;
    case Call::begin_pass: return passText(passes_[words[0]]);
    case Call::set_program: return ' ' + object + stateText(words);
    case Call::set_texture: {
        const UniformInfo* uniform = uniformOf(call);
        out << ' ' << (uniform ? uniform->name : "nothing") << " unit " << words[1]
            << " <- texture " << object << ' ' << kFilterNames[words[2]] << ' '
            << kWrapNames[words[3]];
        break;
    }
    case Call::set_uniform: return uniformText(call);
    case Call::draw:
        out << " mesh " << object << ' ' << words[0] << ".." << words[0] + words[1];
        break;
    case Call::present:
        out << ' ' << object << " -> framebuffer " << words[0] << ' ' << words[3] << 'x'
            << words[4] << " at " << static_cast<std::int32_t>(words[1]) << ','
            << static_cast<std::int32_t>(words[2]);
        break;
    case Call::begin_timer: case Call::read_timer:
        out << ' ' << words[0];
        break;
    case Call::begin_frame: case Call::end_frame: case Call::end_pass: case Call::draw_fullscreen:
    case Call::finish: case Call::end_timer: break;
    }
    return out.str();
}

}  // namespace crevice
