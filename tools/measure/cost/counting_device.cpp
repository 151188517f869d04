// SPDX-License-Identifier: MIT
#include "tools/measure/cost/counting_device.h"

#include "core/base/text.h"
#include "core/glsl/preprocessor.h"
#include "core/run/uniform_values.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"
#include "tools/render/scene_upload.h"

#include <cmath>

namespace crevice {
namespace {

/// Sums one of the two counts of countedFragment's output over all pixels.
double sumOf(const Image& image, std::size_t which)
{
    double sum = 0;
    for (std::size_t i = 2 * which; i + 1 < image.pixels.size(); i += image.channels)
        sum += std::round(image.pixels[i] * 255.0) + 256 * std::round(image.pixels[i + 1] * 255.0);
    return sum;
}

constexpr const char* kCount = "crevice_fetches";
constexpr const char* kLoops = "crevice_loops";
constexpr const char* kWhich = "crevice_which";
constexpr const char* kMain = "crevice_uncounted_main";

bool fetches(std::string_view word)
{
    static const std::vector<std::string> kFunctions = {
        "texture",           "textureLod",        "textureOffset",        "textureLodOffset",
        "textureGrad",       "textureGradOffset", "textureProj",          "textureProjLod",
        "textureProjOffset", "textureProjGrad",   "textureProjLodOffset", "textureProjGradOffset",
        "texelFetch",        "texelFetchOffset",  "textureGather",        "textureGatherOffset"};
    return contains(kFunctions, word);
}

/// Puts `what` at the byte.
struct Insertion {
    std::size_t at;
    std::size_t replaced;  ///< Bytes that it takes the place of.
    std::string what;
};

/// Where the parenthesis that opens at token `open` closes; the number of tokens where it does not.
std::size_t closing(const GlslTokens& tokens, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        if (tokens[i].is("(")) ++depth;
        if (tokens[i].is(")") && --depth == 0) return i;
    }
    return tokens.size();
}

/// The `out` of an output's declaration, and the layout before it, become nothing.
void dropOut(const GlslTokens& tokens, std::size_t out, const char* text,
             std::vector<Insertion>& insertions)
{
    std::size_t first = out;
    for (std::size_t i = out; i > 0 && !tokens[i - 1].is(";") && !tokens[i - 1].is("define"); --i)
        if (tokens[i - 1].is("layout")) first = i - 1;
    const auto begin = static_cast<std::size_t>(tokens[first].text.data() - text);
    const auto end = static_cast<std::size_t>(tokens[out].text.data() + 3 - text);
    insertions.push_back({begin, end - begin, ""});
}

std::string applied(const std::string& text, const std::vector<Insertion>& insertions)
{
    std::string result;
    std::size_t from = 0;
    for (const Insertion& each : insertions) {
        result.append(text, from, each.at - from).append(each.what);
        from = each.at + each.replaced;
    }
    return result.append(text, from, std::string::npos);
}

/// What must change at each token outside of directives, in the order of the text.
std::vector<Insertion> insertionsIn(const std::string& text, const GlslTokens& tokens)
{
    std::vector<Insertion> insertions;
    std::vector<std::size_t> ends;  // tokens, of calls that are still open
    int braces = 0, parentheses = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const GlslToken& token = tokens[i];
        const auto at = static_cast<std::size_t>(token.text.data() - text.data());
        braces += token.is("{") ? 1 : token.is("}") ? -1 : 0;
        parentheses += token.is("(") ? 1 : token.is(")") ? -1 : 0;
        const bool call = i + 1 < tokens.size() && tokens[i + 1].is("(");
        if (token.is("out") && braces == 0 && parentheses == 0)
            dropOut(tokens, i, text.data(), insertions);
        if (token.is("main") && braces == 0 && call) insertions.push_back({at, 4, kMain});
        if (fetches(token.text) && call) {
            insertions.push_back({at, 0, std::string("(++") + kCount + ", "});
            ends.push_back(closing(tokens, i + 1));
        }
        for (; !ends.empty() && ends.back() == i; ends.pop_back())
            insertions.push_back({at + 1, 0, ")"});
    }
    return insertions;
}

/// Counts how often each loop is entered, and its body run.
void countLoops(const std::vector<GlslLoop>& loops, std::vector<Insertion>& insertions)
{
    std::vector<Insertion> before, after;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const std::string count = std::string(kLoops) + "[" + std::to_string(i) + "]";
        const TextPart& condition = loops[i].condition;
        before.push_back({loops[i].whole.begin, 0, "{ ++" + count + ".x; "});
        const bool always = condition.begin == condition.end;
        before.push_back({condition.begin, 0, always ? "(true" : "("});
        after.push_back({condition.end, 0, ") && ++" + count + ".y > 0"});
        after.push_back({loops[i].whole.end, 0, " }"});
    }
    insertions.insert(insertions.begin(), before.begin(), before.end());
    insertions.insert(insertions.end(), after.begin(), after.end());
    std::stable_sort(insertions.begin(), insertions.end(),
                     [](const Insertion& a, const Insertion& b) { return a.at < b.at; });
}

}  // namespace

CountingDevice::~CountingDevice()
{
    clearCounts();
    for (const auto& [program, twin] : twins_) device_.destroy(twin.program);
}

void CountingDevice::clearCounts()
{
    for (const Count& count : counts_) {
        device_.destroy(count.framebuffer);
        device_.destroy(count.texture);
    }
    counts_.clear();
}

Result<PassCounts> CountingDevice::counts()
{
    PassCounts all;
    for (const Count& count : counts_) {
        const Result<Image> image = device_.readTexture(count.texture);
        if (!image) return image.diagnostics();
        PassCount& pass = all[count.pass];
        if (count.which == 0)
            pass = {sumOf(*image, 0), sumOf(*image, 1), {}};
        else  // a loop that no pixel enters runs no body
            pass.runs.push_back(sumOf(*image, 1) / std::max(sumOf(*image, 0), 1.0));
    }
    return all;
}

Result<FramebufferId> CountingDevice::createFramebuffer(const FramebufferDesc& desc)
{
    Result<FramebufferId> id = device_.createFramebuffer(desc);
    if (id) depths_[id->value] = desc.depth;
    return id;
}

Result<ProgramId> CountingDevice::createProgram(const ProgramDesc& desc)
{
    Result<ProgramId> id = device_.createProgram(desc);
    if (!id) return id;
    if (const Status added = addTwin(desc, *id); !added) return added.diagnostics();
    return id;
}

Status CountingDevice::addTwin(const ProgramDesc& desc, ProgramId program)
{
    ProgramDesc counting = desc;
    const std::vector<GlslLoop> loops = loopsOf(desc.fragment.text);
    const std::optional<std::string> text = countedFragment(desc.fragment.text, loops);
    if (!text) return {};
    counting.label += " fetches";
    counting.fragment.text = *text;
    const Result<ProgramId> made = device_.createProgram(counting);
    if (!made) return made.diagnostics();
    Twin& twin = twins_[program.value];
    twin.program = *made;
    twin.loops = static_cast<int>(loops.size());
    for (const UniformInfo& other : device_.uniforms(*made))
        if (other.name == kWhich) twin.which = other.location;
    for (const UniformInfo& mine : device_.uniforms(program))
        for (const UniformInfo& other : device_.uniforms(*made))
            if (mine.name == other.name) twin.locations[mine.location] = other.location;
    return {};
}

void CountingDevice::destroy(ObjectId id)
{
    if (id.kind == ObjectId::Kind::program) {
        if (const auto found = twins_.find(id.value); found != twins_.end()) {
            device_.destroy(found->second.program);
            twins_.erase(found);
        }
    }
    device_.destroy(id);
}

Status CountingDevice::beginFrame()
{
    clearCounts();
    return device_.beginFrame();
}

void CountingDevice::beginPass(const PassInfo& pass)
{
    pass_ = pass;
    bindings_.clear();
    fullscreen_ = false;
    device_.beginPass(pass);
}

void CountingDevice::setProgram(ProgramId id, const StateDesc& state)
{
    program_ = id;
    state_ = state;
    device_.setProgram(id, state);
}

void CountingDevice::setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler)
{
    bindings_.push_back({location, unit, id, sampler});
    device_.setTexture(location, unit, id, sampler);
}

void CountingDevice::setUniform(int location, GlslType type, int count, const void* data)
{
    Uniform& uniform = twins_[program_.value].uniforms[location];
    uniform.type = type;
    uniform.count = count;
    uniform.words.resize(wordsOf(type, count));
    std::memcpy(uniform.words.data(), data, uniform.words.size() * sizeof uniform.words[0]);
    device_.setUniform(location, type, count, data);
}

void CountingDevice::drawFullscreen()
{
    fullscreen_ = true;
    device_.drawFullscreen();
}

void CountingDevice::endPass()
{
    device_.endPass();
    const Twin& twin = twins_[program_.value];
    if (!counting_ || !fullscreen_ || !twin.program) return;
    for (int which = 0; which <= twin.loops; ++which) drawTwin(twin, which);
}

/// What cannot be drawn into, as where the mask has several samples, is not counted.
void CountingDevice::drawTwin(const Twin& twin, int which)
{
    const bool masked = pass_.has_depth && pass_.depth_load == LoadOp::load;
    const Result<TextureId> texture =
        device_.createTexture({std::string(pass_.label) + " fetches", Format::rgba8, pass_.extent});
    if (!texture) return;
    const Result<FramebufferId> framebuffer = device_.createFramebuffer(
        {pass_.label, {*texture}, masked ? depths_[pass_.framebuffer.value] : TextureId()});
    if (!framebuffer) return device_.destroy(*texture);
    counts_.push_back({pass_.label, which, *texture, *framebuffer});
    PassInfo pass = pass_;
    pass.framebuffer = *framebuffer;
    pass.color_count = 1;
    pass.color_load[0] = LoadOp::clear;
    pass.color_store[0] = StoreOp::store;
    for (float& channel : pass.clear_color[0]) channel = 0;
    pass.has_depth = masked;
    device_.beginPass(pass);
    device_.setProgram(twin.program, state_);
    const auto locationOf = [&twin](int location) {
        const auto found = twin.locations.find(location);
        return found == twin.locations.end() ? -1 : found->second;
    };
    for (const Binding& each : bindings_)
        if (const int location = locationOf(each.location); location >= 0)
            device_.setTexture(location, each.unit, each.texture, each.sampler);
    for (const auto& [mine, uniform] : twin.uniforms)
        if (const int location = locationOf(mine); location >= 0)
            device_.setUniform(location, uniform.type, uniform.count, uniform.words.data());
    device_.setUniform(twin.which, GlslType::int_, 1, &which);
    device_.drawFullscreen();
    device_.endPass();
}

Result<PassCounts> countFrame(Description description, const SceneView& view)
{
    const Result<OpenDevice> open = openDevice("");
    if (!open) return open.diagnostics();
    CountingDevice device(*open->device);
    const Result<UploadedScene> scene = UploadedScene::upload(*open->device, view.scene);
    if (!scene) return scene.diagnostics();
    const Frame drawn = makeFrame(*scene, view.camera, view.extent);
    Result<HostTextures> host = HostTextures::make(*open->device, description, view.extent, drawn);
    if (!host) return host.diagnostics();
    const Result<Frame> frame = host->frameOf(drawn);
    if (!frame) return frame.diagnostics();
    // A pass that does not run is not counted.
    const Result<std::unique_ptr<Renderer>> renderer = Renderer::create(
        device, std::move(description), {view.extent, {}, {"cached"}}, traitsOf(*frame));
    if (!renderer) return renderer.diagnostics();
    // Until a history holds what it does in every later frame.
    for (int warm_up = remembers((*renderer)->plan()) ? 2 : 0; warm_up >= 0; --warm_up) {
        if (warm_up == 0) device.startCounting();
        if (const Status status = (*renderer)->render(*frame); !status) return status.diagnostics();
    }
    return device.counts();
}

std::optional<std::string> countedFragment(const std::string& text,
                                           const std::vector<GlslLoop>& loops)
{
    const std::string blanked = blankComments(text).text;
    GlslTokens tokens;
    std::size_t begin = 0, body = 0;  // of the line; of what follows #version and #extension
    int line = 1;
    while (begin < blanked.size()) {
        const std::size_t end = std::min(blanked.find('\n', begin), blanked.size());
        const std::string_view whole(blanked.data() + begin, end - begin);
        GlslTokens found;
        tokenize(whole, 0, line++, found);
        const bool directive = !found.empty() && found[0].is("#");
        begin = std::min(end + 1, blanked.size());
        if (directive && found.size() > 1 && (found[1].is("version") || found[1].is("extension")))
            body = begin;
        if (directive && (found.size() < 2 || !found[1].is("define"))) continue;
        tokens.insert(tokens.end(), found.begin(), found.end());
    }
    std::vector<Insertion> insertions = insertionsIn(blanked, tokens);
    countLoops(loops, insertions);
    std::string counted = applied(blanked, insertions);
    if (!has(counted, kMain)) return std::nullopt;
    const std::string size = std::to_string(loops.size() + 1);
    counted.insert(body, std::string("highp int ") + kCount + " = 0;\nhighp ivec2 " + kLoops + "[" +
                             size + "];\nuniform highp int " + kWhich + ";\n");
    counted +=
        std::string("\nout highp vec4 crevice_count;\nvoid main()\n{\n    for (int i = 0; i < ") +
        size + "; ++i) " + kLoops + "[i] = ivec2(0);\n    " + kMain +
        "();\n    highp ivec2 count = " + kWhich + " == 0 ? ivec2(" + kCount + ", 1) : " + kLoops +
        "[" + kWhich +
        " - 1];\n    crevice_count = vec4(count.x & 255, "
        "count.x >> 8, count.y & 255, count.y >> 8) / 255.0;\n}\n";
    return counted;
}

}  // namespace crevice
