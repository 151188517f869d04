// SPDX-License-Identifier: MIT
// The recording device's log as text; nothing is formatted before somebody asks for it.
#include <crevice/recording_device.h>

#include "core/base/text.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace crevice {
namespace {

constexpr const char* kCallNames[] = {
    "createTexture",  "createFramebuffer", "createProgram", "createMesh",   "adoptMesh",
    "adoptTexture",   "refresh",           "destroy",       "writeTexture", "readTexture",
    "beginRead",      "beginFrame",        "endFrame",      "beginPass",    "endPass",
    "setProgram",     "setTexture",        "setUniform",    "draw",         "drawByHost",
    "drawFullscreen", "present",           "finish",        "createTimer",  "beginTimer",
    "endTimer",       "readTimer",
};
constexpr const char* kCompareNames[] = {"always",  "less",          "less_equal",
                                         "greater", "greater_equal", "equal"};
constexpr const char* kCullNames[] = {"none", "back", "front"};
constexpr const char* kFilterNames[] = {"nearest", "linear", "trilinear"};
constexpr const char* kBlendNames[] = {"", " blend", " blend min", " blend max"};
constexpr const char* kWrapNames[] = {"clamp", "repeat"};
constexpr const char* kLoadNames[] = {"load", "clear", "discard"};
constexpr const char* kStoreNames[] = {"store", "discard"};

constexpr std::size_t kValuesShown = 16;

bool isInteger(GlslType type) { return type >= GlslType::int_ && type <= GlslType::bool_; }

// Line with a space before each.
class Line {
public:
    Line& add(std::string_view word)
    {
        text_ += ' ';
        text_ += word;
        return *this;
    }
    Line& add(float number) { return add(significant(number, 6)); }
    Line& add(Extent extent)
    {
        return add(std::to_string(extent.width) + "x" + std::to_string(extent.height));
    }
    template <class Integer>
    Line& addInteger(Integer number)
    {
        return add(std::to_string(number));
    }

    std::string text() const { return text_; }

private:
    std::string text_;
};

void addLoad(Line& line, LoadOp load, const float* clear, int channels)
{
    line.add(kLoadNames[static_cast<int>(load)]);
    for (int i = 0; i < channels && load == LoadOp::clear; ++i) line.add(clear[i]);
}

std::string passText(const PassInfo& pass)
{
    Line line;
    line.add(pass.label).add(pass.extent);
    for (int i = 0; i < pass.color_count; ++i) {
        line.add("color" + std::to_string(i));
        addLoad(line, pass.color_load[i], pass.clear_color[i], 4);
        line.add(kStoreNames[static_cast<int>(pass.color_store[i])]);
    }
    if (pass.first_layer > 0) line.add("from layer").addInteger(pass.first_layer);
    if (pass.makes_mips) line.add("makes mips");
    if (pass.within_area)
        line.add("within").addInteger(pass.area.x).addInteger(pass.area.y).add(pass.area.extent);
    if (pass.at_depth >= 0) line.add("at depth").add(pass.at_depth);
    if (!pass.has_depth) return line.text();
    line.add("depth");
    addLoad(line, pass.depth_load, &pass.clear_depth, 1);
    return line.add(kStoreNames[static_cast<int>(pass.depth_store)]).text();
}

std::string stateText(const std::uint32_t* words)
{
    return std::string(" depth_test ") + kCompareNames[words[0]] +
           (words[1] ? " depth_write" : "") + " cull " + kCullNames[words[2]] +
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
    const std::vector<float> all = values(call);
    const std::uint32_t count = words_[call.words + 2];
    const UniformInfo* uniform = uniformOf(call);
    Line line;
    line.add((uniform ? uniform->name : "nothing") +
             (count > 1 ? "[" + std::to_string(count) + "]" : ""));
    for (std::size_t i = 0; i < std::min(all.size(), kValuesShown); ++i) line.add(all[i]);
    return line.text() + (all.size() > kValuesShown ? " ..." : "");
}

std::string RecordingDevice::createdText(const Object& object) const
{
    Line line;
    if (object.kind == ObjectId::Kind::texture)
        line.add(formatInfo(object.texture.format).name).add(object.texture.extent);
    if (object.kind == ObjectId::Kind::texture && object.texture.samples > 1)
        line.addInteger(object.texture.samples).add("samples");
    if (object.texture.depth > 0) line.addInteger(object.texture.depth).add("layers");
    if (object.texture.mips) line.add("mips");
    if (object.kind == ObjectId::Kind::mesh) line.addInteger(object.index_count).add("indices");
    if (object.kind == ObjectId::Kind::framebuffer) {
        for (TextureId id : object.framebuffer.color) line.add("color").add(label(id.value));
        if (object.framebuffer.depth) line.add("depth").add(label(object.framebuffer.depth.value));
        for (TextureId id : object.framebuffer.resolve_color)
            if (id) line.add("resolve").add(label(id.value));
        if (object.framebuffer.resolve_depth)
            line.add("resolve depth").add(label(object.framebuffer.resolve_depth.value));
    }
    return line.text();
}

std::string RecordingDevice::presentText(const Record& call) const
{
    const std::uint32_t* at = words_.data() + call.words;
    const Extent extent = {static_cast<int>(at[3]), static_cast<int>(at[4])};
    const std::string corner = std::to_string(static_cast<std::int32_t>(at[1])) + "," +
                               std::to_string(static_cast<std::int32_t>(at[2]));
    Line line;
    line.add(label(call.object)).add("-> framebuffer").addInteger(at[0]).add(extent);
    line.add("at").add(corner);
    if (at[5] != 0) line.add("multiplied");
    return line.text();
}

std::string RecordingDevice::bindingText(const Record& call) const
{
    const std::uint32_t* at = words_.data() + call.words;
    const UniformInfo* uniform = uniformOf(call);
    Line line;
    line.add(uniform ? uniform->name : "nothing").add("unit").addInteger(at[1]).add("<- texture");
    return line.add(label(call.object)).add(kFilterNames[at[2]]).add(kWrapNames[at[3]]).text();
}

std::string RecordingDevice::arguments(const Record& call) const
{
    const std::uint32_t* at = words_.data() + call.words;
    const std::string object = label(call.object);
    Line line;
    switch (call.call) {
    case Call::create_texture:
    case Call::create_framebuffer:
    case Call::create_program:
    case Call::create_mesh:
    case Call::adopt_mesh:
    case Call::refresh:
    case Call::adopt_texture:
        return line.add(object).text() + createdText(objects_.at(call.object));
    case Call::destroy: return line.add(kindName(objects_.at(call.object).kind)).add(object).text();
    case Call::write_texture:
    case Call::begin_read:
    case Call::read_texture: return line.add(object).text();
    case Call::begin_pass: return passText(passes_[at[0]]);
    case Call::set_program: return line.add(object).text() + stateText(at);
    case Call::set_texture: return bindingText(call);
    case Call::set_uniform: return uniformText(call);
    case Call::draw:
        return line.add("mesh").add(object).text() + " " + std::to_string(at[0]) + ".." +
               std::to_string(at[0] + at[1]);
    case Call::present: return presentText(call);
    case Call::begin_frame:
    case Call::end_frame:
    case Call::end_pass:
    case Call::draw_by_host:
    case Call::draw_fullscreen:
    case Call::finish:
    case Call::create_timer:
    case Call::begin_timer:
    case Call::end_timer:
    case Call::read_timer: break;
    }
    return {};
}

}  // namespace crevice
