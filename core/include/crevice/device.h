// SPDX-License-Identifier: MIT
// The abstract device: what a plan needs from a graphics API, and nothing else.
//
// Plain structs go in, typed ids come out; zero is null. A device belongs to one context and one
// thread. Objects are created between frames, never inside one. Validation is core's task: a device
// may assert that what it gets makes sense.
#pragma once

#include <crevice/glsl_stage.h>
#include <crevice/image.h>

#include <array>
#include <cstdint>
#include <optional>

namespace crevice {

enum class Format {
    none,
    r8,
    rg8,
    rgb565,
    rgba8,
    rgb10_a2,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r11g11b10f,
    depth16,
    depth24,
    depth32f,
};

constexpr int kFormatCount = 15;

enum class FormatClass { none, unorm, floating, depth };

/// What holds for a format on every device.
struct FormatInfo {
    Format format;
    const char* name;  ///< The JSON spelling.
    FormatClass format_class;
    int channels;
    int bytes;             ///< A texel; depth24 counts 4.
    bool core_renderable;  ///< OpenGL ES 3.0 renders to it with no extension.
    /// ... and reads it with the filter linear; else that reads black (table 3.13, section 3.8.13).
    bool filterable;
    double absolute_step;  ///< Between neighbouring values: this much,
    double relative_step;  ///< and this share of the value, at most.
};

/// Facts about `format`; Format::none has zero channels and bytes.
const FormatInfo& formatInfo(Format format);

/// The format of that JSON name; Format::none when there is none.
Format formatFromName(std::string_view name);

/// The JSON spellings of all formats but none, in the order of the enum.
const std::vector<std::string>& formatNames();

/// All formats but none, in the order of the enum.
const std::vector<FormatInfo>& allFormats();

/// Most samples that a pixel may have; what a device draws, `DeviceCaps::sample_counts` says.
constexpr int kMaxSamples = 32;

/// Draws the draw list, or one triangle over the target.
enum class PassType { draw, fullscreen };

enum class Cull { none, back, front };
enum class Compare { always, less, less_equal, greater, greater_equal, equal };
enum class Filter { nearest, linear, trilinear };  ///< The last one between mips, too.
enum class Wrap { clamp, repeat };

/// How what is drawn joins what is there: not at all; over it, by its alpha, which its colour has
/// been multiplied by; or the smaller or larger of the two, channel by channel.
enum class Blend { none, over, min, max };

/// Fixed-function state.
struct StateDesc {
    Compare depth_test = Compare::always;  ///< A draw pass with a depth target defaults to less.
    bool depth_write = false;              ///< ... and to true.
    Cull cull = Cull::none;
    Blend blend = Blend::none;
};

/// An object of any kind, for `Device::destroy`.
struct ObjectId {
    enum class Kind { texture, mesh, program, framebuffer, timer };

    Kind kind;
    std::uint32_t value;
};

template <ObjectId::Kind kind>
struct IdOf {
    std::uint32_t value = 0;
    explicit operator bool() const { return value != 0; }
    operator ObjectId() const { return {kind, value}; }  // NOLINT
};
using TextureId = IdOf<ObjectId::Kind::texture>;
using MeshId = IdOf<ObjectId::Kind::mesh>;
using ProgramId = IdOf<ObjectId::Kind::program>;
using FramebufferId = IdOf<ObjectId::Kind::framebuffer>;
using TimerId = IdOf<ObjectId::Kind::timer>;

/// What a device can do; read once when it is made.
struct DeviceCaps {
    std::string name;       ///< Renderer and version as the driver reports them.
    int version = 300;      ///< 300, 310 or 320; a desktop's counts as what it is compatible with.
    bool software = false;  ///< Rendered by the CPU: timer queries lie, time with finish().
    int max_texture_size = 2048;
    int max_volume_size = 256;  ///< Texels along an edge of a texture with several layers.
    int max_color_attachments = 4;
    int max_texture_units = 16;              ///< Of the fragment stage.
    int max_fragment_uniform_vectors = 224;  ///< A mat4 takes 4, an array one for each element.
    int max_vertex_uniform_vectors = 256;
    bool renderable[kFormatCount + 1] = {};  ///< By Format.

    /// All attachments of a framebuffer must have one size, as in WebGL 2: depth that is larger
    /// than its pass (FramebufferDesc::depth) is refused.
    bool equal_attachments = false;

    bool timers = false;  ///< Device::createTimer makes any; false on software renderers.

    /// By Format: bit n is set when a pixel may have n + 1 samples; bit 0 is not looked at.
    std::uint32_t sample_counts[kFormatCount + 1] = {};

    bool canRender(Format format) const { return renderable[static_cast<int>(format)]; }
};

/// The least that every OpenGL ES 3.0 device has.
DeviceCaps minimumCaps();

struct TextureDesc {
    std::string label = {};
    Format format = Format::rgba8;
    Extent extent = {};
    /// Above 1 it can be drawn into and resolved, and neither sampled nor read, unless it is
    /// adopted: then sampler2DMS reads it, from OpenGL ES 3.1 on.
    int samples = 1;
    /// Above 0 it is a volume of so many layers (GL_TEXTURE_3D), which sampler3D reads.
    int depth = 0;
    bool mips = false;  ///< With smaller levels down to one texel, see PassInfo::makes_mips.
};

/// A picture in an object of the host's, to be read.
struct HostTexture {
    enum class Kind {
        texture,       ///< GL_TEXTURE_2D, or with samples GL_TEXTURE_2D_MULTISAMPLE,
        layer,         ///< ... one `layer` of a GL_TEXTURE_2D_ARRAY,
        renderbuffer,  ///< ... a renderbuffer,
        framebuffer,   ///< ... or the depth of a framebuffer; 0 is the default one.
    };

    std::uint32_t name = 0;  ///< The API's own (GLuint).
    std::string label = {};  ///< For messages.
    /// depth24 also stands for GL_DEPTH24_STENCIL8, and depth32f for GL_DEPTH32F_STENCIL8. `none`:
    /// depth of whichever of the three formats GL says.
    Format format = Format::depth24;
    Extent extent = {};  ///< Of the picture, in pixels; all that the object has, unless `part`.
    int samples = 1;     ///< Above 1 only of a texture: all else is copied, and so resolved.
    Kind kind = Kind::texture;
    int layer = 0;  ///< From 0.
    /// The lower left pixel of the picture, where it is a part of a larger one, as `part` says.
    bool part = false;
    int x = 0, y = 0;

    bool operator==(const HostTexture& other) const
    {
        return name == other.name && format == other.format && extent == other.extent &&
               samples == other.samples && kind == other.kind && layer == other.layer &&
               part == other.part && x == other.x && y == other.y;
    }

    /// Whether no shader can read it as it is, so that the device keeps a copy.
    bool copied() const { return kind != Kind::texture || part; }
};

/// How the host's clip space relates to pictures: what glClipControl sets.
struct ClipControl {
    bool zero_to_one = false;  ///< Depth runs from 0 to 1 in clip space; else from -1.
    bool upper_left = false;   ///< Row 0 of a picture lies at the top of clip space.

    bool operator==(const ClipControl& other) const
    {
        return zero_to_one == other.zero_to_one && upper_left == other.upper_left;
    }
};

/// The window depths of the near and far plane: what glDepthRange sets. The first may be greater.
struct DepthRange {
    float near_depth = 0;  ///< [0, 1]
    float far_depth = 1;   ///< [0, 1], and not near_depth.

    bool operator==(const DepthRange& other) const
    {
        return near_depth == other.near_depth && far_depth == other.far_depth;
    }
};

struct FramebufferDesc {
    std::string label = {};
    std::vector<TextureId> color = {};  ///< A null id leaves that location without a texture.
    /// May be larger than a pass that clears it first and keeps nothing of it, unless
    /// DeviceCaps::equal_attachments.
    TextureId depth = {};
    // A volume is drawn into layer by layer, see PassInfo::first_layer; one that stands at several
    // places of `color` gives each of them the next layer.

    /// Where the above have several samples: what those whose StoreOp is store are resolved into as
    /// a pass ends; colour to the mean, depth to one sample. The samples themselves do not stay.
    std::vector<TextureId> resolve_color = {};
    TextureId resolve_depth = {};
};

/// Which of a volume's layers, from PassInfo::first_layer on, a place of `color` has.
int layerOf(const std::vector<TextureId>& color, int place);

struct ProgramDesc {
    std::string label = {};
    GlslStage vertex = {};
    GlslStage fragment = {};
};

/// Interleaved vertices: position (3 floats), normal (3), uv (2), at locations 0, 1, 2.
struct Vertex {
    float position[3] = {0, 0, 0};
    float normal[3] = {0, 0, 1};
    float uv[2] = {0, 0};
};

struct MeshDesc {
    std::string label = {};
    std::vector<Vertex> vertices = {};
    std::vector<std::uint32_t> indices = {};  ///< Triangles.
    bool may_have_sheets = true;              ///< Whether sheetsOf looks for them, see DrawItem.
};

/// How the numbers of an attribute are stored. `snorm` stands for [-1, 1] and `unorm` for [0, 1] in
/// so many bits; snorm10 is GL_INT_2_10_10_10_REV, all components in one word.
enum class VertexType { float32, float16, snorm8, unorm8, snorm16, unorm16, snorm10 };

/// Bytes that so many components take.
std::uint32_t bytesOf(VertexType type, int components);

/// Where an attribute of the host's vertices lies.
struct HostAttribute {
    std::uint32_t buffer = 0;  ///< The API's own name (GLuint); 0 where the mesh has none.
    VertexType type = VertexType::float32;
    std::uint32_t offset = 0;  ///< Of the first vertex, in bytes.
    std::uint32_t stride = 0;  ///< From vertex to vertex, in bytes; 0: one right behind the other.
};

enum class IndexType { uint32, uint16, uint8 };

/// Bytes that an index takes.
std::uint32_t bytesOf(IndexType type);

/// Triangles in buffers of the host's.
struct HostMesh {
    std::string label = {};  ///< For messages.
    HostAttribute position = {};
    /// Without one, (0, 0, 1): right where a config draws depth alone, else CV6019 warns.
    HostAttribute normal = {};
    HostAttribute uv = {};  ///< Without one, (0, 0); CV6019 warns where a texture is read so.
    std::uint32_t vertex_count = 0;
    std::uint32_t index_buffer = 0;  ///< 0: vertices make triangles in their order.
    IndexType index_type = IndexType::uint32;
    std::uint32_t index_offset = 0;  ///< Of the first index, in bytes.
    std::uint32_t index_count = 0;   ///< Indices, or without them vertices, that may be drawn.
};

/// The most bytes that a mesh's vertices may take, and its indices: 32-bit drivers end here.
constexpr std::uint64_t kMaxMeshBytes = 0x7fffffff;

/// Errors: CV6007 for so many vertices or indices that one of them takes more than kMaxMeshBytes.
Status checkMeshSize(const std::string& label, std::uint64_t vertices, std::uint64_t indices);

/// Errors: those of `checkMeshSize`; CV6011 for an index past the last vertex.
Status checkMesh(const MeshDesc& mesh);

/// What can be told without the buffers. Errors: CV6011 for a mesh without positions, for indices
/// whose offset is no multiple of their size, and for more vertices drawn than there are.
Status checkMesh(const HostMesh& mesh);

/// Where the device's own origin of a mesh lies in model space.
struct MeshOrigin {
    double x = 0, y = 0, z = 0;
};

/// The middle of a mesh that lies beside its model's origin by more than its own size, as a city's
/// houses do; else that origin. Positions are kept about it: matrices in double add the distance.
MeshOrigin originOf(const MeshDesc& mesh);

/// The first index of each triangle of a sheet: of a connected surface with open edges, such as a
/// leaf, cloth or the ground. A body may have holes whose outline is short for its area, as scanned
/// models have. Vertices at one place count as one. In time n log n: 0.3 s for a million triangles.
std::vector<std::uint32_t> sheetsOf(const MeshDesc& mesh);

/// What a device knows of one of its objects. Of an id that it does not have, `exists` is false.
struct ObjectInfo {
    bool exists = false;
    std::uint32_t native_name = 0;  ///< Of a texture, see Device::nativeName.
    int samples = 1;                ///< A pixel of a texture.
    std::uint32_t index_count = 0;  ///< Of a mesh.
    MeshOrigin origin = {};         ///< Of a mesh: what its positions are kept about.
    std::string_view label = {};    ///< Of a mesh; good as long as that is.
    bool normals = true;            ///< Whether a mesh has them,
    bool uv = true;                 ///< ... and these.
    Format format = Format::none;   ///< Of a texture.
    int depth = 0;                  ///< Layers of a texture that is a volume.
    /// Of a mesh: its sheetsOf. These triangles stand once more behind its last index.
    const std::vector<std::uint32_t>* sheets = nullptr;
};

/// A uniform that a linked program really has.
struct UniformInfo {
    std::string name;  ///< Without "[0]".
    GlslType type = GlslType::float_;
    int count = 1;
    int location = -1;
};

struct SamplerDesc {
    Filter filter = Filter::nearest;
    Wrap wrap = Wrap::clamp;
};

enum class LoadOp { load, clear, discard };
enum class StoreOp { store, discard };

constexpr int kMaxColorAttachments = 8;

/// Pixels of a picture; (x, y) is the lower left one.
struct PixelArea {
    int x = 0, y = 0;
    Extent extent = {};
};

/// How a pass begins and ends: its framebuffer and what happens to each attachment.
struct PassInfo {
    const char* label = "";
    FramebufferId framebuffer = {};
    Extent extent = {};
    int color_count = 0;
    LoadOp color_load[kMaxColorAttachments] = {};
    StoreOp color_store[kMaxColorAttachments] = {};
    float clear_color[kMaxColorAttachments][4] = {};
    bool has_depth = false;
    LoadOp depth_load = LoadOp::discard;
    StoreOp depth_store = StoreOp::discard;
    float clear_depth = 1.0f;
    int first_layer = 0;       ///< Of the volumes among the colour attachments.
    bool makes_mips = false;   ///< As it ends, of all colour attachments that have any.
    float at_depth = -1.0f;    ///< Window depth of all that is drawn; below 0 it has its own.
    bool within_area = false;  ///< Draws change `area` alone; loads are of everything.
    PixelArea area = {};
};

/// The host's framebuffer or texture and the rectangle to fill, in pixels from 0 at the lower left.
struct HostFramebuffer {
    std::uint32_t name = 0;  ///< The API's own name; 0 is the default framebuffer.
    int x = 0, y = 0;
    Extent extent = {};
    std::uint32_t texture = 0;  ///< A GL_TEXTURE_2D instead of a framebuffer, where it is not 0.
    int level = 0;              ///< ... of which this level is drawn into.

    /// Multiplies what is there instead, channel by channel but for alpha: AO darkens pictures so.
    bool multiply = false;
};

/// One context's worth of graphics. Every function must be called with that context current. Where
/// it is not, functions that return a Status or Result say so with CV6004 and change nothing. An id
/// that the device does not have is an error CV6011.
class Device {
public:
    virtual ~Device() = default;

    virtual const DeviceCaps& caps() const = 0;

    /// Creates an object; the caller owns it and gives it to `destroy`.
    /// Errors: CV6004, CV6005, CV6007, CV6009, CV6016; CV5001 and CV5002 for programs, CV6011 for
    /// meshes. A texture's content is undefined.
    virtual Result<TextureId> createTexture(const TextureDesc& desc) = 0;
    virtual Result<FramebufferId> createFramebuffer(const FramebufferDesc& desc) = 0;
    virtual Result<ProgramId> createProgram(const ProgramDesc& desc) = 0;
    virtual Result<MeshId> createMesh(const MeshDesc& desc) = 0;

    /// Takes triangles that lie in buffers of the host's; `destroy` forgets them. The buffers must
    /// stay as large as they are; what they hold may change, see DrawItem::revision. Indices are
    /// not looked at: none may name a vertex past the last. Errors: CV6004; CV6011 for what is none
    /// of the context's buffers, or ends before the last vertex or index, and those of checkMesh.
    virtual Result<MeshId> adoptMesh(const HostMesh& host) = 0;

    /// Takes a picture that the host owns; `destroy` forgets it and leaves it alive. A texture is
    /// read as it is. Of all else (`HostTexture::copied`) the device keeps a copy in a texture of
    /// its own, made here and by `refresh`. Errors: CV6004; CV6011 with the reason where the object
    /// is none of the context, or its kind, format, size or samples are not those given; CV6014 for
    /// samples that the device cannot read; CV6017; those of createTexture.
    virtual Result<TextureId> adoptTexture(const HostTexture& host) = 0;

    /// Copies what was adopted so again, once the host has drawn into it; does nothing for textures
    /// that are read as they are. Outside of frames.
    /// Errors: CV6004, CV6005, CV6011, CV6016, CV6017.
    virtual Status refresh(TextureId id) = 0;

    /// What glClipControl was last set to by the host.
    virtual ClipControl clipControl() const = 0;

    /// What glDepthRange was last set to by the host.
    virtual DepthRange depthRange() const = 0;

    /// What is known of an object of any kind, or that there is none.
    virtual ObjectInfo info(ObjectId id) const = 0;

    /// The API's own name of a texture, for a host's own shaders: with the GL device a name for
    /// glBindTexture(GL_TEXTURE_2D, name), or GL_TEXTURE_2D_MULTISAMPLE if it was adopted with
    /// samples. 0 of an id that the device does not have, and of samples that are never read.
    ///
    /// It is the device's: read it, and neither write nor delete it. Its own parameters are
    /// GL_NEAREST and GL_CLAMP_TO_EDGE, one level; bind a sampler object for others. The name is
    /// good for as long as the id is; Renderer::output says how long that is.
    std::uint32_t nativeName(TextureId id) const { return info(id).native_name; }

    /// Destroys one object of any kind. Ignores a null id, and one that the device does not have.
    virtual void destroy(ObjectId id) = 0;

    /// Replaces level 0 of a texture; channels are converted to the texture's format.
    /// Errors: CV6004, CV6005, CV6009, CV6011, CV6016.
    virtual Status writeTexture(TextureId id, const Image& image) = 0;

    /// Reads level 0 as floats, depth too. Waits for the GPU. Errors: those of writeTexture.
    virtual Result<Image> readTexture(TextureId id) = 0;

    /// Begins to read the first texel of level 0 of a texture, as it is then, and forgets a read of
    /// it before. Inside a frame, not in a pass. Errors: CV6005, CV6009, CV6011, CV6016.
    virtual Status beginRead(TextureId id) = 0;

    /// The four channels that were read of the texture, once: nothing where that was taken, where
    /// nothing was begun, and while the GPU is not through. Never waits. Inside a frame.
    virtual std::optional<std::array<float, 4>> takeRead(TextureId id) = 0;

    /// The active uniforms, without built-ins. Requires a program of the device.
    virtual const std::vector<UniformInfo>& uniforms(ProgramId id) const = 0;

    /// Brackets all drawing of a frame: keeps the host's state and puts it back.
    /// beginFrame returns CV6004 or CV6016 where nothing can be drawn; no endFrame must follow
    /// then. endFrame returns CV6005 with the pass's name when the driver reported an error, CV6009
    /// when memory ran out, and CV6016 when the context is lost: then the device is of no more use.
    virtual Status beginFrame() = 0;
    virtual Status endFrame() = 0;

    virtual void beginPass(const PassInfo& pass) = 0;
    virtual void endPass() = 0;
    virtual void setProgram(ProgramId id, const StateDesc& state) = 0;

    /// Binds a texture to the sampler at `location`, through texture unit `unit`.
    virtual void setTexture(int location, int unit, TextureId id, const SamplerDesc& sampler) = 0;

    /// `data` holds `count` values of `type`: floats or 32-bit ints; matrices by columns.
    virtual void setUniform(int location, GlslType type, int count, const void* data) = 0;

    /// Draws triangles [first, first + count) of indices.
    virtual void draw(MeshId id, std::uint32_t first, std::uint32_t count) = 0;

    /// Has the host draw by itself: calls `drawing` with the API's own name (GLuint) of the running
    /// program and with `host`, all being set as for a `draw` of this device. Whatever
    /// `drawing` leaves behind is set right again but for program and textures: set those again.
    virtual void drawByHost(void (*drawing)(std::uint32_t program, void* host), void* host) = 0;

    /// Draws one triangle that covers the viewport; the vertex shader builds it from gl_VertexID.
    virtual void drawFullscreen() = 0;

    /// Draws a colour texture into the host's framebuffer or texture, scaled to its rectangle: one
    /// channel as grey, two as red and green, alpha 1 where it has none. To half the size, each
    /// pixel is the mean of four. The rest stays as it is.
    /// Errors: those of writeTexture, CV6017; CV6005 where GL draws into no such target; CV6011 for
    /// a rectangle that leaves it, but for the default framebuffer, whose size GL does not tell.
    virtual Status present(TextureId id, const HostFramebuffer& host) = 0;

    /// Waits until everything issued is done.
    virtual void finish() = 0;

    /// Makes a timer; the caller owns it and gives it to `destroy`. Null where the device has none
    /// (DeviceCaps::timers). All below require a timer of the device.
    virtual TimerId createTimer() = 0;

    /// Measures the GPU's time from here to endTimer, and forgets what the timer held. Inside a
    /// frame, one at a time.
    virtual void beginTimer(TimerId id) = 0;
    virtual void endTimer() = 0;

    /// Whether readTimer would not wait.
    virtual bool timerReady(TimerId id) = 0;

    /// What the timer measured, in milliseconds; outside of frames. Waits for the GPU, but not in
    /// WebGL, where results come between tasks of the page. Negative when the result is void: the
    /// GPU was disturbed, nothing was measured, or WebGL has no result yet.
    virtual double readTimer(TimerId id) = 0;
};

/// Whether the device has that texture, a picture with one sample a pixel, to read and copy.
/// Errors: CV6011.
Status checkReadable(const Device& device, TextureId id);

}  // namespace crevice
