// SPDX-License-Identifier: MIT
// The recording device: what it logs, what it notices, how it fails.
#include <crevice/recording_device.h>

#include "tests/support/need.h"

#include <chrono>

using namespace crevice;

namespace {

// One texture, a framebuffer on it, a program and a mesh.
struct Rig {
    RecordingDevice device;
    TextureId input = device.createTexture({"input", Format::r8, {8, 4}}).value();
    TextureId target = device.createTexture({"target", Format::rgba8, {8, 4}}).value();
    FramebufferId framebuffer = device.createFramebuffer({"draw", {target}, {}}).value();
    ProgramId program = makeProgram();
    MeshId mesh = device.createMesh({"cube", {{}, {}, {}}, {0, 1, 2}}).value();

    ProgramId makeProgram()
    {
        GlslStage vertex, fragment;
        vertex.uniforms = {{"offsets", GlslType::vec2, 3, true, {}}};
        fragment.uniforms = {{"offsets", GlslType::vec2, 3, true, {}},
                             {"light_count", GlslType::int_, 1, false, {}},
                             {"image", GlslType::sampler2d, 1, false, {}}};
        return device.createProgram({"shade", vertex, fragment}).value();
    }

    PassInfo pass() const
    {
        PassInfo info;
        info.label = "draw";
        info.framebuffer = framebuffer;
        info.extent = {8, 4};
        info.color_count = 1;
        info.color_load[0] = LoadOp::discard;
        return info;
    }

    void begin()
    {
        need(device.beginFrame());
        device.beginPass(pass());
        device.setProgram(program, {});
    }

    void bindAll()
    {
        const float offsets[6] = {1, 2, 3, 4, 5, 6};
        const int lights = -7;
        device.setUniform(0, GlslType::vec2, 3, offsets);
        device.setUniform(3, GlslType::int_, 1, &lights);
        device.setTexture(4, 2, input, {Filter::linear, Wrap::repeat});
    }

    void end()
    {
        device.endPass();
        CHECK(device.endFrame().ok());
    }

    void setFloat(int location)
    {
        const float value = 1;
        device.setUniform(location, GlslType::float_, 1, &value);
    }

    /// Begins a pass that has another value than its framebuffer.
    template <class Value>
    void beginWith(Value PassInfo::*member, const std::common_type_t<Value>& other)
    {
        need(device.beginFrame());
        PassInfo info = pass();
        info.*member = other;
        device.beginPass(info);
    }

    /// Presents what a pass has drawn that stores and loads its target so.
    void presentAfter(StoreOp store, LoadOp load = LoadOp::discard)
    {
        need(device.writeTexture(input, Image({8, 4}, 1)));
        need(device.beginFrame());
        PassInfo info = pass();
        info.color_store[0] = store;
        info.color_load[0] = load;
        device.beginPass(info);
        device.setProgram(program, {});
        bindAll();
        device.drawFullscreen();
        end();
        need(device.present(target, {}));
    }

    void destroyAll()
    {
        device.destroy(mesh);
        device.destroy(program);
        device.destroy(framebuffer);
        device.destroy(target);
        device.destroy(input);
    }

    bool blamed(const std::string& part) const
    {
        for (const std::string& text : device.misuse())
            if (text.find(part) != std::string::npos) return true;
        return false;
    }
};

}  // namespace

TEST_CASE("A frame in order is logged call by call, and nothing is blamed")
{
    Rig rig;
    REQUIRE(rig.device.writeTexture(rig.input, Image({8, 4}, 1, 0.5f)).ok());
    rig.begin();
    rig.bindAll();
    rig.device.draw(rig.mesh, 0, 3);
    rig.end();
    need(rig.device.present(rig.target, {0, 3, 4, {16, 8}}));

    rig.destroyAll();
    CHECK(rig.device.log() ==
          "createTexture 'input' r8 8x4\n"
          "createTexture 'target' rgba8 8x4\n"
          "createFramebuffer 'draw' color 'target'\n"
          "createProgram 'shade'\n"
          "createMesh 'cube' 3 indices\n"
          "writeTexture 'input'\n"
          "beginFrame\n"
          "beginPass draw 8x4 color0 discard store\n"
          "setProgram 'shade' depth_test always cull none\n"
          "setUniform offsets[3] 1 2 3 4 5 6\n"
          "setUniform light_count -7\n"
          "setTexture image unit 2 <- texture 'input' linear repeat\n"
          "draw mesh 'cube' 0..3\n"
          "endPass\n"
          "endFrame\n"
          "present 'target' -> framebuffer 0 16x8 at 3,4\n"
          "destroy mesh 'cube'\n"
          "destroy program 'shade'\n"
          "destroy framebuffer 'draw'\n"
          "destroy texture 'target'\n"
          "destroy texture 'input'\n");
    CHECK(rig.device.live() == 0);
    CHECK(rig.device.misuse().empty());
    CHECK(rig.device.lastUniform("offsets") == std::vector<float>{1, 2, 3, 4, 5, 6});
    CHECK(rig.device.lastUniform("nobody").empty());
}

TEST_CASE("What makes no sense is blamed, in words that say which object and why")
{
    const struct {
        const char* words;
        bool begun;  ///< A pass, with its program.
        void (*misuse)(Rig&);
    } rows[] = {
        // objects that are dead, foreign or of another kind
        {"was destroyed: 'cube'", false,
         [](Rig& rig) {
             rig.device.destroy(rig.mesh);
             rig.device.destroy(rig.mesh);
         }},
        {"does not exist", false, [](Rig& rig) { rig.device.destroy(TextureId{99}); }},
        {"does not exist", false, [](Rig& rig) { rig.device.destroy(MeshId{rig.program.value}); }},
        {"before framebuffer 'draw'", false, [](Rig& rig) { rig.device.destroy(rig.target); }},
        // calls out of order
        {"outside a pass", false, [](Rig& rig) { rig.device.drawFullscreen(); }},
        {"outside a frame", false, [](Rig& rig) { rig.device.beginPass(rig.pass()); }},
        {"endFrame", true, [](Rig& rig) { CHECK(rig.device.endFrame().ok()); }},
        {"'late' is created inside a frame", true,
         [](Rig& rig) {
             CHECK(rig.device.createMesh({"late", {}, {}}).ok());
         }},
        {"destroyed inside a frame", true, [](Rig& rig) { rig.device.destroy(rig.mesh); }},
        {"setUniform without a program", false,
         [](Rig& rig) {
             need(rig.device.beginFrame());
             rig.device.beginPass(rig.pass());
             rig.setFloat(0);
         }},
        // inputs of a draw
        {"undefined content", true, [](Rig& rig) { rig.bindAll(); }},  // nothing was written
        {"which the pass draws into", true,
         [](Rig& rig) { rig.device.setTexture(4, 0, rig.target, {}); }},
        {"uniform 'offsets' of program 'shade' was never set", true,
         [](Rig& rig) { rig.device.drawFullscreen(); }},
        {"another type", true, [](Rig& rig) { rig.setFloat(3); }},
        {"does not have", true, [](Rig& rig) { rig.device.setTexture(40, 0, rig.input, {}); }},
        {"past its last index", true, [](Rig& rig) { rig.device.draw(rig.mesh, 2, 2); }},
        // a pass that is not as its framebuffer
        {"another size", false,
         [](Rig& rig) {
             rig.beginWith(&PassInfo::extent, {4, 4});
         }},
        {"other attachments", false, [](Rig& rig) { rig.beginWith(&PassInfo::color_count, 0); }},
        {"other attachments", false, [](Rig& rig) { rig.beginWith(&PassInfo::has_depth, true); }},
        // what is presented
        {"undefined content", false, [](Rig& rig) { rig.presentAfter(StoreOp::discard); }},
        {"undefined content", false,
         [](Rig& rig) { rig.presentAfter(StoreOp::store, LoadOp::load); }},
        {"undefined content", false,  // of a pass that discards what was there and draws nothing
         [](Rig& rig) {
             need(rig.device.writeTexture(rig.target, Image({8, 4}, 4)));
             need(rig.device.beginFrame());
             rig.device.beginPass(rig.pass());
             rig.end();
             need(rig.device.present(rig.target, {}));
         }},
    };
    for (const auto& [words, begun, misuse] : rows) {
        INFO(words);
        Rig rig;
        if (begun) rig.begin();
        misuse(rig);
        CHECK(rig.blamed(words));
    }
    Rig rig;
    rig.device.destroy(TextureId{});  // null is nothing to blame
    rig.presentAfter(StoreOp::store);
    CHECK(rig.device.misuse().empty());
}

TEST_CASE("many objects are destroyed without a look at each for each")
{
    RecordingDevice device;
    const auto begin = std::chrono::steady_clock::now();
    std::vector<TextureId> textures(50000);
    for (TextureId& texture : textures)
        texture = need(device.createTexture({"t", Format::rgba8, {1, 1}}));
    for (const TextureId texture : textures) device.destroy(texture);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    CHECK(device.live() == 0);
    CHECK(taken.count() < 5);
}
