// SPDX-License-Identifier: MIT
// A device that draws nothing: it keeps a log of every call and watches how it is called.
//
// Most tests run on it. It knows what a device that draws cannot check: which calls came in an
// order that makes no sense, which textures were read before anything was in them, what was never
// destroyed. It can also fail on demand, as a device without memory would.
#pragma once

#include <crevice/device.h>

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

/// A device that can do everything: all formats, 16384 pixels a side, 8 attachments.
DeviceCaps generousCaps();

class RecordingDevice : public Device {
public:
    explicit RecordingDevice(DeviceCaps caps = generousCaps());

    /// The calls so far, one line each, by the labels of the objects:
    ///
    ///     beginPass ssao 256x144 color0 discard store
    ///     setTexture normal unit 1 <- texture 'normal' nearest clamp
    ///     setUniform radius 0.5
    ///     draw mesh 'bunny' 0..300
    ///
    /// A uniform's values past the sixteenth are left out; `lastUniform` has them.
    std::string log() const;

    /// Forgets the calls, and the destroyed objects that they name, but keeps the memory of calls,
    /// so that a steady frame allocates nothing.
    void clearLog();

    /// The values of the last setUniform for that name in the log; empty when there is none.
    std::vector<float> lastUniform(std::string_view name) const;

    /// What callers did wrong, one sentence each. A test that draws asserts that it is empty.
    const std::vector<std::string>& misuse() const { return misuse_; }

    /// Makes the n-th coming call that creates or fills an object fail with CV6009; 0 makes none.
    void failAt(int n) { fail_in_ = n; }

    /// Makes the next endFrame fail with CV6005.
    void failFrame() { frame_fails_ = true; }

    /// Loses the context: from now on all that can fail does so, with CV6016.
    void loseContext() { lost_ = true; }

    /// Takes the context from the thread, or gives it back: until then all that can fail does so,
    /// with CV6004.
    void setCurrent(bool current) { current_ = current; }

    /// What clipControl reports.
    void setClipControl(const ClipControl& control) { clip_control_ = control; }

    /// What depthRange reports.
    void setDepthRange(const DepthRange& range) { depth_range_ = range; }

    /// Gives the device timers: what the first, second, ... of a frame will measure, in
    /// milliseconds, at least one; those past the end measure what the last does.
    void setTimers(std::vector<double> times_ms)
    {
        timers_ms_ = std::move(times_ms);
        caps_.timers = true;
    }

    /// Holds the results of timers and of beginRead back, as a GPU does that is behind.
    void holdResults(bool hold) { results_held_ = hold; }

    /// Gives every coming program that uniform, in the place of its own of the same name: as a
    /// driver would that sees what the text does not show.
    void forceUniform(UniformInfo uniform) { forced_.push_back(std::move(uniform)); }

    /// Calls so far that created or filled an object, or failed to.
    int attempts() const { return attempts_; }

    /// Objects that exist: of one kind, or all.
    int live(ObjectId::Kind kind) const;
    int live() const;

    const DeviceCaps& caps() const override { return caps_; }
    Result<TextureId> createTexture(const TextureDesc& desc) override;
    Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) override;
    Result<ProgramId> createProgram(const ProgramDesc& desc) override;
    Result<MeshId> createMesh(const MeshDesc& desc) override;
    Result<MeshId> adoptMesh(const HostMesh& host) override;
    Result<TextureId> adoptTexture(const HostTexture& host) override;
    Status refresh(TextureId id) override;
    ClipControl clipControl() const override { return clip_control_; }
    DepthRange depthRange() const override { return depth_range_; }

    /// The native name of a texture that was not adopted is its id.
    ObjectInfo info(ObjectId id) const override;

    void destroy(ObjectId id) override;
    Status writeTexture(TextureId id, const Image& image) override;

    /// What writeTexture put there, or zeros.
    Result<Image> readTexture(TextureId id) override;

    /// What writeTexture put into the first texel, or zeros.
    Status beginRead(TextureId id) override;
    std::optional<std::array<float, 4>> takeRead(TextureId id) override;

    /// Every uniform that the program's stages declare, in the order of the text.
    const std::vector<UniformInfo>& uniforms(ProgramId id) const override;

    Status beginFrame() override;
    Status endFrame() override;
    void beginPass(const PassInfo& pass) override;
    void endPass() override;
    void setProgram(ProgramId id, const StateDesc& state) override;
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) override;
    void setUniform(int location, GlslType type, int count, const void* data) override;
    void draw(MeshId id, std::uint32_t first, std::uint32_t count) override;
    /// Calls `drawing` with the id of the running program.
    void drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host) override;
    void drawFullscreen() override;
    Status present(TextureId id, const HostFramebuffer& host) override;
    void finish() override;
    TimerId createTimer() override;
    void beginTimer(TimerId id) override;
    void endTimer() override;
    bool timerReady(TimerId id) override;
    double readTimer(TimerId id) override;

private:
    enum class Call {
        create_texture,
        create_framebuffer,
        create_program,
        create_mesh,
        adopt_mesh,
        adopt_texture,
        refresh,
        destroy,
        write_texture,
        read_texture,
        begin_read,
        begin_frame,
        end_frame,
        begin_pass,
        end_pass,
        set_program,
        set_texture,
        set_uniform,
        draw,
        draw_by_host,
        draw_fullscreen,
        present,
        finish,
        create_timer,
        begin_timer,
        end_timer,
        read_timer,
    };

    /// One call; what it was given beyond the object lies in `words_`.
    struct Record {
        Call call;
        std::uint32_t object;
        std::uint32_t program;  // the running one
        std::size_t words;
    };

    struct Object {
        ObjectId::Kind kind;
        std::string label;
        bool alive = true;
        TextureDesc texture = {};
        std::uint32_t native_name = 0;
        bool copied = false;   // of what the host has
        bool defined = false;  // something is in the texture
        Image image = {};
        std::optional<std::array<float, 4>> read = {};
        std::optional<double> time_ms = {};
        FramebufferDesc framebuffer = {};
        std::vector<UniformInfo> uniforms = {};
        std::vector<bool> uniform_set = {};  // a sampler's lasts for one setProgram
        std::uint32_t index_count = 0;
        MeshOrigin origin = {};
        std::vector<std::uint32_t> sheets = {};
        bool normals = true;
        bool uv = true;
    };

    using Words = std::initializer_list<std::uint32_t>;

    static const char* kindName(ObjectId::Kind kind);
    void record(Call call, std::uint32_t object = 0, Words words = {});
    void blame(std::string what);
    Status checkContext(const std::string& what) const;
    bool failsNow(Diagnostics& errors, const std::string& what);
    std::uint32_t add(Object object, Call call);
    const Object* objectOf(std::uint32_t id) const;
    Object* find(ObjectId id, const char* caller);
    int uniformAt(int location, const char* caller);
    void checkAttachments(const FramebufferDesc& desc);
    static bool uses(const FramebufferDesc& desc, std::uint32_t texture);
    void loadAttachment(TextureId id, LoadOp load, StoreOp store);
    void checkDraw(const char* caller);
    std::string label(std::uint32_t object) const;
    const UniformInfo* uniformOf(const Record& call) const;
    std::vector<float> values(const Record& call) const;
    std::string uniformText(const Record& call) const;
    std::string presentText(const Record& call) const;
    std::string bindingText(const Record& call) const;
    std::string createdText(const Object& object) const;
    std::string arguments(const Record& call) const;

    DeviceCaps caps_;
    ClipControl clip_control_;
    DepthRange depth_range_;
    std::map<std::uint32_t, Object> objects_;  // by id; the dead ones too, while the log names them
    std::uint32_t last_id_ = 0;                // ids are never used again
    std::set<std::uint32_t> framebuffers_;     // those alive
    std::vector<Record> records_;
    std::vector<std::uint32_t> words_;
    std::vector<PassInfo> passes_;  // those in the log
    std::set<std::string, std::less<>> pass_labels_;
    std::vector<std::string> misuse_;
    PassInfo pass_ = {};  // the one that runs
    std::uint32_t program_ = 0;
    bool in_frame_ = false;
    bool in_pass_ = false;
    bool drawn_ = false;  // something, in this pass
    std::vector<UniformInfo> forced_;
    std::vector<double> timers_ms_ = {0};
    std::size_t timers_begun_ = 0;  // this frame
    bool results_held_ = false;
    bool in_timer_ = false;
    bool frame_fails_ = false;
    bool lost_ = false;
    bool current_ = true;
    int fail_in_ = 0;
    int attempts_ = 0;
};

}  // namespace crevice
