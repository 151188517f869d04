// SPDX-License-Identifier: MIT
// crevice from C: a depth texture of yours goes in, a texture of ambient occlusion comes out.
//
// C99 or later, and C++. Your own OpenGL context draws; no GL library is linked and none of its
// headers is needed here. In full, without the handling of errors (tools/examples/hello.c has it):
//
//     crevice_device_desc device_desc = {.struct_size = sizeof device_desc, .loader = find_gl};
//     crevice_device* device;
//     crevice_device_create(&device_desc, &device);
//
//     crevice_effect_desc desc = {.struct_size = sizeof desc, .width = 1920, .height = 1080};
//     desc.config = "mobile+geometry/host_depth";
//     crevice_effect* effect;
//     crevice_effect_create(device, &desc, &effect);
//
//     crevice_texture depth = {.struct_size = sizeof depth, .name = my_depth,
//                              .format = "depth24", .width = 1920, .height = 1080};
//     crevice_effect_set_projection(effect, my_projection);
//     crevice_effect_set_texture(effect, "depth", &depth);
//     crevice_effect_render(effect);                            // each frame
//
//     crevice_output ao = {.struct_size = sizeof ao};
//     crevice_effect_get_output(effect, "ao", &ao);             // bind ao.texture; red: 1 is open
//
// Errors      What can fail returns an error, or null where all went well. An error is yours: read
//             it, then free it. A null handle, a null pointer and a struct without its size are
//             errors as well (CV6011). After an error everything is as it was before the call. No
//             C++ exception leaves a function.
// Structs     The first member is sizeof the struct. Set all others to zero but those that you
//             mean: zero is the default. Later versions append members. So a struct of an earlier
//             version has the default for what it lacks, and is never written past its end. One of
//             a later version, of at most 4096 bytes, is taken where its further members are zero,
//             and is CV6011 where they are not; filled in, they become zero.
// Ownership   What _create gives is yours, to be handed to _destroy, which takes null as well.
//             Effects and meshes keep their device alive: destroy them in any order. Of what you
//             hand over, strings, arrays and structs are copied; textures and buffers stay yours.
// Strings     UTF-8. Those of an error live as long as it, those of an effect until it is reloaded
//             or destroyed. None that is handed out is null: what is absent is "".
// Threads     A device, its effects and its context belong to one thread at a time, the one that
//             the context is current on. Devices in different contexts run side by side. Errors
//             and crevice_version belong to no thread.
// GL state    It is as before after each call, if your context was current (see
//             crevice_device_desc).
//
// docs/which_config.md has the configs, configs/README.md the params and outputs.
#ifndef CREVICE_CREVICE_H
#define CREVICE_CREVICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifndef CREVICE_API
#define CREVICE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// The version of this header, by semantic versioning. Before 1.0 a minor version may break things.
#define CREVICE_VERSION_MAJOR 0
#define CREVICE_VERSION_MINOR 1
#define CREVICE_VERSION_PATCH 0
#define CREVICE_VERSION \
    (CREVICE_VERSION_MAJOR * 10000 + CREVICE_VERSION_MINOR * 100 + CREVICE_VERSION_PATCH)

/// CREVICE_VERSION of the library that runs, which may be another than the header's.
CREVICE_API int crevice_version(void);

typedef struct crevice_error crevice_error;      ///< Why a call failed, or a list of warnings.
typedef struct crevice_context crevice_context;  ///< An offscreen OpenGL context.
typedef struct crevice_device crevice_device;    ///< What crevice has in one OpenGL context.
typedef struct crevice_effect crevice_effect;    ///< A config that runs, with all that was set.

// ---- Errors ------------------------------------------------------------------------------------

/// One message of an error.
typedef struct crevice_diagnostic {
    size_t struct_size;
    bool warning;         ///< Not an error by itself.
    int code;             ///< 2103 of CV2103; core/include/crevice/codes.h lists them.
    const char* message;  ///< One sentence: what was found, and what was wanted.
    const char* help;     ///< The way out: the nearest valid name, the allowed set, a command.
    const char* file;     ///< Where it is: a path, or "(JSON text)".
    int line, column;     ///< From 1; 0 where it is nowhere.
    const char* pointer;  ///< RFC 6901 pointer into the config.
    const char* text;     ///< All of it with the line in question, for people; ends in a newline.
} crevice_diagnostic;

/// All messages for people, one after the other; "" of null.
CREVICE_API const char* crevice_error_text(const crevice_error* error);

/// The code of the first message; 0 of null.
CREVICE_API int crevice_error_code(const crevice_error* error);

/// How many messages there are: every mistake of a config at once. 0 of null.
CREVICE_API int crevice_error_count(const crevice_error* error);

/// Fills in one of them. False where there is none such, or the struct lacks its size.
CREVICE_API bool crevice_error_get(const crevice_error* error, int index,
                                   crevice_diagnostic* diagnostic);

/// Not for warnings of crevice_effect_warnings. Null is ignored.
CREVICE_API void crevice_error_free(crevice_error* error);

// ---- Context: for tools, tests and servers; an application has its own --------------------------

/// Makes an offscreen context and makes it current: by "egl", OpenGL ES, or "osmesa", desktop
/// OpenGL on the CPU; null takes the first of them that there is.
///
/// Errors: CV6001, CV6002, CV6012.
CREVICE_API crevice_error* crevice_context_create(const char* backend, crevice_context** context);

/// Makes it current on this thread. Errors: CV6001, CV6002, CV6011.
CREVICE_API crevice_error* crevice_context_make_current(crevice_context* context);

/// A crevice_loader whose `user` is the context.
CREVICE_API void* crevice_context_find(const char* name, void* context);

/// Destroy first what was made in it.
CREVICE_API void crevice_context_destroy(crevice_context* context);

// ---- Device: one OpenGL context -----------------------------------------------------------------

/// Finds a GL function by name ("glClear") in the current context; null where there is none. A
/// wrapped eglGetProcAddress, SDL_GL_GetProcAddress or glfwGetProcAddress.
typedef void* (*crevice_loader)(const char* name, void* user);

/// How a device finds GL, and what it may rely on.
typedef struct crevice_device_desc {
    size_t struct_size;
    crevice_loader loader;  ///< Required.
    void* user;             ///< Handed to the loader.

    /// Leaves GL state as it comes, which saves some 150 queries a frame: set all that you rely on.
    bool leave_state;

    bool skip_checks;  ///< Asks neither for GL errors nor whether the context is another or lost.

    /// Pretends a bare OpenGL ES 3.0 without extensions: for testing what falls back.
    bool ignore_extensions;

    /// Keeps linked programs between runs, so that the next one starts without compiling
    /// (docs/reference/program_cache.md). Either may be null. A key is 16 hex digits. `cache_load`
    /// gives the bytes that were stored, which must stay until the next call of either, and their
    /// count; or null. They are called where programs are made, and must not call GL or crevice.
    /// Keep the bytes where nobody else can write: drivers run them.
    const void* (*cache_load)(const char* key, size_t* count, void* cache_user);
    void (*cache_store)(const char* key, const void* bytes, size_t count, void* cache_user);
    void* cache_user;
} crevice_device_desc;

/// What the driver says of itself.
typedef struct crevice_device_info {
    size_t struct_size;
    const char* name;      ///< Renderer and version, as the driver reports them. Of the device.
    int version;           ///< 300, 310 or 320; a desktop context counts as what it can do.
    bool software;         ///< Drawn by the CPU.
    int max_texture_size;  ///< Pixels along a side.
} crevice_device_info;

/// A device in the current context, which must be current in all calls on it and its effects.
///
/// Errors: CV6003, CV6004 for no context or one that is too old, CV6005, CV6009, CV6016.
CREVICE_API crevice_error* crevice_device_create(const crevice_device_desc* desc,
                                                 crevice_device** device);

/// Errors: CV6011. Needs no current context.
CREVICE_API crevice_error* crevice_device_get_info(const crevice_device* device,
                                                   crevice_device_info* info);

/// Says that the context is gone, where you know before the driver reports it (CV6016). No GL is
/// called from then on; destroy the device and its effects whenever you like.
CREVICE_API void crevice_device_abandon(crevice_device* device);

/// What was made on it goes on until it is destroyed too, so that you may keep the effect alone;
/// the last one needs the context current.
CREVICE_API void crevice_device_destroy(crevice_device* device);

// ---- Effect: a config that runs -----------------------------------------------------------------

/// What an effect is made of.
typedef struct crevice_effect_desc {
    size_t struct_size;

    /// The name of a config ("mobile"), or with modules laid over it
    /// ("mobile+geometry/host_depth"); the path of a file that ends in ".json"; or JSON text that
    /// begins with '{', which names files as one in the current folder would.
    const char* config;

    /// A folder with modules and configs of your own, or null: FOLDER/effects/ssao/mine.json is the
    /// module "ssao/mine", FOLDER/configs/mine.json the config "mine". They hide shipped ones.
    const char* folder;

    /// JSON to lay over the config, or null: what crevice_effect_get_patch gave.
    const char* patch;

    int width, height;  ///< Of the outputs, in pixels.

    /// Names of wanted outputs, such as "ao"; what none of them needs is not run. None means all.
    const char* const* outputs;
    int output_count;

    /// What the config may ask for at most; 0 is the default. Files of JSON, and of GLSL (1024),
    /// passes (512), targets (512), bytes of all textures (2 GiB). More is refused: CV1209.
    int max_files, max_passes, max_targets;
    double max_bytes;

    /// What `crevice bake` wrote, in place of files: `config` is then one of its configs by name,
    /// or null for the first. It is copied. The runtime (crevice::runtime) takes nothing else.
    const void* baked;
    size_t baked_size;
} crevice_effect_desc;

/// Loads the config and makes all that it needs, shaders too.
///
/// Errors: CV1xxx to CV5xxx for all mistakes in it, with places; CV6xxx for what no device can do;
/// CV1301, CV1302 and CV2301 for bytes that are no baked effect, and for what was not baked.
CREVICE_API crevice_error* crevice_effect_create(crevice_device* device,
                                                 const crevice_effect_desc* desc,
                                                 crevice_effect** effect);

/// Reads the config again, or another one, with the folder, patch and outputs of before; null is
/// the same config, whose files may have changed. Values that were set stay; a warning CV4006 names
/// what no longer has a place. Errors: those of crevice_effect_create.
CREVICE_API crevice_error* crevice_effect_reload(crevice_effect* effect, const char* config);

/// Another size of the outputs, in pixels. Errors: CV4005, CV6007, CV6009.
CREVICE_API crevice_error* crevice_effect_resize(crevice_effect* effect, int width, int height);

/// Deletes what it has in the context, which must be current. Your textures and buffers stay.
CREVICE_API void crevice_effect_destroy(crevice_effect* effect);

/// Warnings of the last call on the effect that could give some (create, reload, resize, set,
/// render, warm), or null. They are the effect's until the next such call: do not free them.
CREVICE_API const crevice_error* crevice_effect_warnings(const crevice_effect* effect);

// ---- What a frame is drawn from -----------------------------------------------------------------

/// The matrix that drew the depth, without the view: 16 floats by columns, as for
/// glUniformMatrix4fv. It may be off-centre, flipped, turned, reversed or left-handed. Default:
/// orthographic, of the cube [-1, 1].
CREVICE_API crevice_error* crevice_effect_set_projection(crevice_effect* effect,
                                                         const float* clip_from_view);

/// Where the camera stands: 16 doubles by columns. Only configs that draw the scene or keep a
/// history need it. Default: at the origin, looking along -z, or along +z under a left-handed
/// projection: without perspective one whose box lies along +z as a whole.
CREVICE_API crevice_error* crevice_effect_set_view(crevice_effect* effect,
                                                   const double* view_from_world);

/// A further view of the same scene, such as the right eye's.
typedef struct crevice_view {
    size_t struct_size;

    /// Its projection, by columns: orthographic or reversed in depth if the first view's is.
    float clip_from_view[16];
    double view_from_world[16];  ///< Where its camera stands. All 0: 1, at the origin.
} crevice_view;

/// Views 1 and up, instead of those of before; view 0 is the one of crevice_effect_set_projection
/// and crevice_effect_set_view. crevice_effect_render draws all of them, with programs and a plan
/// that they share. Default: none. Another count plans again and clears histories.
///
/// Errors: CV6011. Those of the matrices come from crevice_effect_render (CV6011).
CREVICE_API crevice_error* crevice_effect_set_views(crevice_effect* effect,
                                                    const crevice_view* views, int count);

/// Before the first frame after a cut: histories are cleared.
CREVICE_API crevice_error* crevice_effect_cut(crevice_effect* effect);

/// Before the first frame after the world's origin moved by `shift`, three doubles in scene units.
CREVICE_API crevice_error* crevice_effect_shift_origin(crevice_effect* effect, const double* shift);

/// The clip control (glClipControl) that the projection is made for and your textures were drawn
/// with: depth from 0 to 1 in clip space, and row 0 at its top. Default: as it is when
/// crevice_effect_render is called.
CREVICE_API crevice_error* crevice_effect_set_clip_control(crevice_effect* effect, bool zero_to_one,
                                                           bool upper_left);

/// The depth range (glDepthRange) that your depth was drawn with. Default: as it is when
/// crevice_effect_render is called. Errors: of two depths that are the same, from
/// crevice_effect_render (CV6011).
CREVICE_API crevice_error* crevice_effect_set_depth_range(crevice_effect* effect, float near_depth,
                                                          float far_depth);

/// What lengths may be relative to, in scene units: the diagonal of the box around the scene, and
/// the median distance, along the view's axis, of what is seen. Default: 0, unknown, which is
/// CV6010 from crevice_effect_render where a length needs it.
CREVICE_API crevice_error* crevice_effect_set_scale(crevice_effect* effect, double diagonal,
                                                    double median_distance);

/// What a picture lies in.
typedef enum crevice_texture_kind {
    CREVICE_TEXTURE,       ///< GL_TEXTURE_2D, or with samples GL_TEXTURE_2D_MULTISAMPLE,
    CREVICE_LAYER,         ///< ... one `layer` of a GL_TEXTURE_2D_ARRAY,
    CREVICE_RENDERBUFFER,  ///< ... a renderbuffer,
    CREVICE_FRAMEBUFFER    ///< ... or the depth of a framebuffer; 0 is the default one.
} crevice_texture_kind;

/// A picture of yours, to be read.
typedef struct crevice_texture {
    size_t struct_size;
    uint32_t name;  ///< The GLuint.

    /// As configs have it: "depth16", "depth24" (with a stencil or without), "depth32f" (likewise),
    /// "rgba8" ... Null: depth of whichever of the three formats GL says.
    const char* format;
    int width, height;  ///< Of the picture, in pixels.
    crevice_texture_kind kind;
    int layer;    ///< From 0.
    int samples;  ///< A pixel, of a texture; 0 is 1. All else is resolved.

    bool part;  ///< The picture is a part of a larger one, and its lower left pixel is (x, y).
    int x, y;
} crevice_texture;

/// Hands over a picture for an import of the config. It must live for as long as it is rendered
/// from; its content may change with every frame. Costs nothing where all is as before. A whole
/// texture is read where it is; of all else crevice_effect_render takes a copy, one blit a frame.
///
/// Errors: CV2102 for a name that the config does not import; CV6011, with the reason, where the
/// picture is not what it is said to be; CV6014, CV6017. The one of before stays.
CREVICE_API crevice_error* crevice_effect_set_texture(crevice_effect* effect, const char* import,
                                                      const crevice_texture* texture);

/// The same for one view, from 0. Views without a texture of their own take that of view 0, which
/// every view needs, and whose format is that of all.
///
/// Errors: those of crevice_effect_set_texture; CV6011 for no such view, and for another format.
CREVICE_API crevice_error* crevice_effect_set_view_texture(crevice_effect* effect, int view,
                                                           const char* import,
                                                           const crevice_texture* texture);

/// Sets a param: as many floats as it has components, or of a length three, two of them 0: scene
/// units, percents of the scene's diagonal, and pixels of the view's height at its median depth
/// ({0, 5, 0} is "5%"). A warning CV5010 says where shaders compiled.
///
/// Errors: CV4004 for an unknown name, CV4001 for a value out of range, CV4003, CV3006.
CREVICE_API crevice_error* crevice_effect_set_param(crevice_effect* effect, const char* name,
                                                    const float* values, int count);

/// Sets a feature to one of its words: "true", "false" or those of an enum. Plans again, and may
/// compile shaders. Errors: CV2105, CV2106.
CREVICE_API crevice_error* crevice_effect_set_feature(crevice_effect* effect, const char* name,
                                                      const char* word);

/// Draws what has changed since the last frame. docs/host.md has a table of errors and what to do
/// after each; skip the effect in that frame.
CREVICE_API crevice_error* crevice_effect_render(crevice_effect* effect);

/// Has the driver compile what the first frame would wait for. Each call draws one pixel of one
/// pass, so that a loading screen goes on between calls; `ready` becomes true once all is done.
/// Call it when all is set that a frame is drawn from: textures, matrices, draws and materials
/// decide what is compiled. Draw callbacks are called. With a governor it warms all levels. The
/// first frame comes out as without it. What is compiled after another size, feature or config is
/// to be warmed again. Errors: those of crevice_effect_render; the next call tries again.
///
///     crevice_error* error = NULL;
///     for (bool ready = false; !ready && !error; draw_my_loading_screen())
///         error = crevice_effect_warm(effect, &ready);
CREVICE_API crevice_error* crevice_effect_warm(crevice_effect* effect, bool* ready);

// ---- Geometry: for configs that draw the scene --------------------------------------------------

// What imports of the types "draw_list" and "lights" are drawn from (crevice_effect_get_import):
//
//     crevice_mesh_desc desc = {.struct_size = sizeof desc, .positions = positions,
//                               .normals = normals, .vertex_count = 3};
//     crevice_mesh* mesh;
//     crevice_mesh_create(device, &desc, &mesh);
//     crevice_draw draw = {.struct_size = sizeof draw, .mesh = mesh};
//     crevice_effect_set_draws(effect, &draw, 1);
//
// Draws, materials and lights are copied, and stay until they are set again. What is as before is
// not drawn again. The structs of an array have one size. Lengths are in scene units.

/// Triangles on the device, drawn by any of its effects.
typedef struct crevice_mesh crevice_mesh;

/// Triangles to be copied. Seen from outside their corners run counter-clockwise.
typedef struct crevice_mesh_desc {
    size_t struct_size;
    const char* label;        ///< For messages, or null.
    const float* positions;   ///< 3 for each vertex, in model space. Required.
    const float* normals;     ///< 3 for each vertex, of length 1; null: (0, 0, 1), for depth alone.
    const float* uvs;         ///< 2 for each vertex; null: 0, where no material has maps.
    uint32_t vertex_count;    ///< Above 0.
    const uint32_t* indices;  ///< 3 for each triangle; null: vertices make them in their order.
    uint32_t index_count;     ///< Of `indices`; 0 without.
} crevice_mesh_desc;

/// Copies triangles to the device. The arrays may go afterwards.
///
/// Errors: CV6011 for no positions, no vertices, a count of indices without them, and an index past
/// the last vertex; CV6007 for more than 2^31 - 1 bytes; CV6004, CV6005, CV6009, CV6016.
CREVICE_API crevice_error* crevice_mesh_create(crevice_device* device,
                                               const crevice_mesh_desc* desc, crevice_mesh** mesh);

/// How the numbers of an attribute are stored: SNORM stands for [-1, 1] and UNORM for [0, 1] in so
/// many bits, SNORM10 for all components in one GL_INT_2_10_10_10_REV.
typedef enum crevice_vertex_type {
    CREVICE_FLOAT32,
    CREVICE_FLOAT16,
    CREVICE_SNORM8,
    CREVICE_UNORM8,
    CREVICE_SNORM16,
    CREVICE_UNORM16,
    CREVICE_SNORM10
} crevice_vertex_type;

typedef enum crevice_index_type {
    CREVICE_UINT32,
    CREVICE_UINT16,
    CREVICE_UINT8
} crevice_index_type;

/// Where an attribute lies in a buffer of yours. A part of crevice_host_mesh, it never changes.
typedef struct crevice_attribute {
    uint32_t buffer;           ///< The GLuint; 0 where the mesh has none.
    crevice_vertex_type type;  ///< Of each component.
    uint32_t offset;           ///< Of the first vertex, in bytes.
    uint32_t stride;           ///< From vertex to vertex, in bytes; 0: right behind one another.
} crevice_attribute;

/// Triangles that stay in buffers of yours. Seen from outside they run counter-clockwise.
typedef struct crevice_host_mesh {
    size_t struct_size;
    const char* label;           ///< For messages, or null.
    crevice_attribute position;  ///< 3 components, in model space. Required.
    crevice_attribute normal;    ///< 3, of length 1; none: (0, 0, 1), for depth alone.
    crevice_attribute uv;        ///< 2; none: 0.
    uint32_t vertex_count;
    uint32_t index_buffer;          ///< The GLuint; 0: vertices make triangles in their order.
    crevice_index_type index_type;  ///< Of `index_buffer`.
    uint32_t index_offset;          ///< Of the first index, in bytes: a multiple of its size.
    uint32_t index_count;           ///< 0 without an index buffer: as many as vertices.
} crevice_host_mesh;

/// Draws triangles from where they are. The buffers must live, and stay as large, as long as the
/// mesh is drawn. What they hold may change: count crevice_draw.revision up then. Indices are not
/// looked at: none may name a vertex past the last.
///
/// Errors: CV6011 for no positions, for what is no buffer of the context or ends before the last
/// vertex or index, and for unknown types; CV6004, CV6016.
CREVICE_API crevice_error* crevice_mesh_adopt(crevice_device* device, const crevice_host_mesh* host,
                                              crevice_mesh** mesh);

/// Effects that draw the mesh keep it alive until they are given other draws or are destroyed.
CREVICE_API void crevice_mesh_destroy(crevice_mesh* mesh);

/// What a draw callback is given. It lives as long as the call.
typedef struct crevice_draw_call {
    size_t struct_size;
    const char* pass;    ///< Its name in the config.
    uint32_t program;    ///< The GLuint of the pass's program, which is current.
    const void* values;  ///< For crevice_draw_call_matrix.
} crevice_draw_call;

/// Draws what is yours, skinned, instanced or streamed, in one pass. GL is set up for it:
/// framebuffer, viewport, depth test, culling, and the pass's program with its uniforms and
/// textures. Bind vertices and draw: position, normal and uv are attributes 0 to 2. A program of
/// yours may draw instead that writes the same outputs. No GL state need be put back. Call nothing
/// of crevice but crevice_draw_call_matrix. A GL error and a C++ exception (CV6011) come back from
/// crevice_effect_render.
typedef void (*crevice_draw_callback)(const crevice_draw_call* call, void* user);

/// A matrix by its name in GLSL: "clip_from_model", "view_from_model" and those of the camera have
/// 16 floats by columns, "view_normal_from_model" has 9; or null. It lives as long as the call.
CREVICE_API const float* crevice_draw_call_matrix(const crevice_draw_call* call, const char* name);

/// A mesh, or what a callback draws, at a place.
typedef struct crevice_draw {
    size_t struct_size;
    const crevice_mesh* mesh;  ///< Of the effect's device; null where a callback draws.
    uint32_t first;            ///< First index, or vertex where the mesh has no indices.
    uint32_t count;            ///< Of them, 3 for each triangle; 0: all from `first` on.

    /// Called in place of the mesh, in every pass that draws the scene; null draws the mesh.
    crevice_draw_callback callback;
    void* user;  ///< Handed to the callback. Yours, to live as long as it is drawn.

    double world_from_model[16];  ///< All 0: 1, at the origin.
    int material;                 ///< Into the materials, from 0.

    /// A sphere around all that is drawn, in model space. A draw outside of what a pass shows is
    /// left out of it, and AO is computed within spheres alone. A radius of 0 or below: not known.
    float bounds_center[3];
    float bounds_radius;

    /// All of it is a surface without a back of its own, seen from either side: a leaf, cloth, the
    /// ground. No pass culls it, and light passes behind it. What has an alpha_cutoff is one in any
    /// case, and so is each connected surface with open edges of a mesh of crevice_mesh_create.
    bool sheet;

    /// A number that changes whenever your buffers hold something else, or the callback draws
    /// something else. 0 with a callback: that may be with every frame.
    uint64_t revision;
} crevice_draw;

/// What is drawn: all draws of the scene, instead of those of before. Null and 0 draw nothing.
/// Cheap enough for each frame: allocates only where there are more than ever before. A frame
/// without a call looks at none of them until a pass draws them again.
///
/// Errors: CV6011 for a draw with neither mesh nor callback, with a mesh of another device, or with
/// indices past the mesh's. What no shader can draw, such as a matrix that is not finite or a
/// material that is not there, crevice_effect_render leaves out, with a warning CV6011.
CREVICE_API crevice_error* crevice_effect_set_draws(crevice_effect* effect,
                                                    const crevice_draw* draws, int count);

/// How a surface looks. Of it AO takes the normal map, and what an alpha test leaves; the rest is
/// for configs that light. Maps are textures of yours, read by uv and repeated, of one sample a
/// pixel; null for none. Of a layer or a part a copy is taken when it is set.
typedef struct crevice_material {
    size_t struct_size;
    float base_color[4];       ///< Linear, with alpha, [0, 1]. All 0: white and opaque.
    float specular[3];         ///< Colour of the highlight, linear, >= 0; 0 is matte.
    float shininess;           ///< Blinn-Phong exponent, above 0; 0 is 16.
    float ambient_dimming;     ///< Share of the ambient light that it does not reflect, [0, 1].
    float alpha_cutoff;        ///< Below this alpha a pixel is discarded, [0, 1]; 0 is opaque.
    float normal_scale;        ///< Of the normal map's x and y; 0 is 1.
    float occlusion_strength;  ///< Of the occlusion map, (0, 1]; 0 is 1.
    const crevice_texture* base_color_map;  ///< Linear; times `base_color`.
    const crevice_texture* normal_map;      ///< Tangent space, n * 0.5 + 0.5, y up.
    const crevice_texture* occlusion_map;   ///< Baked visibility in red: 1 is open.

    uint64_t revision;  ///< A number that changes whenever you draw into one of the maps.

    bool blended;  ///< Seen through by its alpha: takes no occlusion and casts none.
    bool unlit;    ///< For lighting/metallic_roughness: shows `base_color` as it is.

    // What lighting/metallic_roughness reads beside base_color, after glTF.
    float metallic;     ///< [0, 1]
    float smoothness;   ///< 1 less the roughness, [0, 1].
    float reflectance;  ///< What is no metal reflects of light from ahead, (0, 1]; 0 is 0.04.
    float emission[3];  ///< Light of its own, linear, >= 0.
    const crevice_texture* metallic_roughness_map;  ///< Roughness in green, metallic in blue.
    const crevice_texture* emission_map;            ///< Linear; times `emission`.
} crevice_material;

/// All materials, instead of those of before. Null and 0 leave one: white and opaque, which is the
/// default. Maps must live as long as they are drawn with, and cost nothing while they stay.
///
/// Errors: CV6011, with the reason, for a map that is not what it is said to be, or has several
/// samples; CV6014, CV6017, CV6004.
CREVICE_API crevice_error* crevice_effect_set_materials(crevice_effect* effect,
                                                        const crevice_material* materials,
                                                        int count);

typedef enum crevice_light_kind {
    CREVICE_POINT,        ///< Shines from `position` to all sides,
    CREVICE_DIRECTIONAL,  ///< ... along `direction` from far away,
    CREVICE_SPOT          ///< ... or from `position` in a cone about `direction`.
} crevice_light_kind;

/// A light in world space.
typedef struct crevice_light {
    size_t struct_size;
    crevice_light_kind kind;
    double position[3];  ///< In world space.
    float direction[3];  ///< The way that it shines, in world space, of any length. 0: (0, 0, -1).
    float color[3];      ///< Linear, >= 0; 0 is off.
    float attenuation[3];   ///< 1 / (x + y d + z d^2) at distance d. All 0: (1, 0, 0).
    float inner_angle_rad;  ///< Of a spot: off its direction, as far as it shines in full,
    float outer_angle_rad;  ///< ... and where it ends, [inner, pi]; 0 is 0.8.
} crevice_light;

/// All lights, instead of those of before: 16 at most, else a warning. Default: none.
///
/// Errors: CV6011 for an unknown kind; a warning when rendered for lights that are not finite.
CREVICE_API crevice_error* crevice_effect_set_lights(crevice_effect* effect,
                                                     const crevice_light* lights, int count);

/// The colour of the surroundings, linear: 3 floats >= 0, which configs scale. Default: 1, 1, 1.
CREVICE_API crevice_error* crevice_effect_set_ambient_light(crevice_effect* effect,
                                                            const float* color);

// ---- What comes out -----------------------------------------------------------------------------

/// A texture with what came out.
typedef struct crevice_output {
    size_t struct_size;

    /// The GLuint of a GL_TEXTURE_2D with one level, row 0 at the bottom: sample it, and neither
    /// write nor delete it. Good until the next call that renders, warms, resizes, reloads or sets:
    /// ask after each frame.
    uint32_t texture;
    const char* format;  ///< Such as "r8".
    int channels;        ///< 1 to 4.

    /// In pixels: that of the effect, unless the config scales it, and 1 x 1 where the output is
    /// constant (AO of intensity 0), so sample it by texture(), not texelFetch().
    int width, height;
} crevice_output;

/// How many outputs there are, and their names; 0 and "" where there is none such.
CREVICE_API int crevice_effect_output_count(const crevice_effect* effect);
CREVICE_API const char* crevice_effect_output_name(const crevice_effect* effect, int index);

/// Errors: CV2102 for an unknown name.
CREVICE_API crevice_error* crevice_effect_get_output(const crevice_effect* effect, const char* name,
                                                     crevice_output* output);

/// The same of one view, from 0. Errors: also CV6011 for a view that no frame has had.
CREVICE_API crevice_error* crevice_effect_get_view_output(const crevice_effect* effect, int view,
                                                          const char* name, crevice_output* output);

/// What an output is drawn into, and where in it.
typedef struct crevice_target {
    size_t struct_size;
    uint32_t framebuffer;  ///< The GLuint; 0 is the default one.
    uint32_t texture;      ///< A GL_TEXTURE_2D instead of a framebuffer, where it is not 0.
    int level;             ///< ... of which this level is drawn into.
    int x, y;              ///< The rectangle's lower left pixel.
    int width, height;     ///< Of the rectangle, in pixels, above 0.
    int view;              ///< Whose output it is, from 0.

    /// Multiplies what is there instead, channel by channel but for alpha: AO darkens pictures so.
    bool multiply;
} crevice_target;

/// Draws an output into a rectangle of a framebuffer or texture of yours, scaled: one channel, as
/// AO has, as grey, two as red and green, alpha 1 where it has none. To half the size, each pixel
/// is the mean of four. The rest stays as it is.
///
/// Errors: CV2209 for an unknown name, CV6011 for a rectangle without pixels or one that leaves the
/// target, and for a view that no frame has had, CV6005 where GL draws into no such target, CV6004,
/// CV6017. What leaves the default framebuffer is lost: GL tells no size of it.
CREVICE_API crevice_error* crevice_effect_present(crevice_effect* effect, const char* name,
                                                  const crevice_target* target);

/// Reads an output of view 0 into width * height * channels floats, rows from the bottom up. Waits
/// for the GPU: for tests and tools.
///
/// Errors: CV2102, CV7006 for another `count`, CV6004.
CREVICE_API crevice_error* crevice_effect_read_output(const crevice_effect* effect,
                                                      const char* name, float* pixels,
                                                      size_t count);

/// The red of an output's first pixel two or three frames ago, read without a wait: of outputs that
/// are one number, such as "doubt_rmse", the error that the picture's AO is expected to have. The
/// first call has crevice_effect_render read it from then on. `known` is false, and `value` as it
/// was, before it is there, and where the output is not drawn: ask for it in crevice_effect_desc.
CREVICE_API crevice_error* crevice_effect_get_value(crevice_effect* effect, const char* name,
                                                    float* value, bool* known);

// ---- What a frame costs -------------------------------------------------------------------------

/// Has crevice_effect_render measure from now on what each pass takes on the GPU. Nothing waits, so
/// it may stay on. Default: off. A warning CV6018 (crevice_effect_warnings) says that there is no
/// timer to be trusted, as on software renderers: there are no times then.
CREVICE_API crevice_error* crevice_effect_set_timing(crevice_effect* effect, bool on);

/// What a pass took on the GPU.
typedef struct crevice_pass_time {
    size_t struct_size;
    const char* name;     ///< Of the pass in the config. Good until the next call that renders,
                          ///< resizes, reloads or sets.
    double milliseconds;  ///< All views together: 0 where it did not run, below 0 where it is void.
} crevice_pass_time;

/// How many passes were measured in the latest frame whose times are in, one to four frames later;
/// 0 before there is any, and again after a new plan.
CREVICE_API int crevice_effect_pass_time_count(const crevice_effect* effect);

/// Of one of them, in the order in which they run. Errors: CV6011.
CREVICE_API crevice_error* crevice_effect_get_pass_time(const crevice_effect* effect, int index,
                                                        crevice_pass_time* time);

// ---- A time budget: the level that fits ---------------------------------------------------------

/// What a governor is made of. <crevice/governor.h> says how it decides.
typedef struct crevice_governor_desc {
    size_t struct_size;
    /// A file of `crevice choose --write-front`, or its JSON text; null for the levels of the baked
    /// effect that the effect was made of. Otherwise required.
    const char* front;
    double budget_ms;   ///< GPU time that a frame of the effect may take, above 0. Required.
    double most_error;  ///< Levels of a larger error are not used; 0: all are.
    double share;       ///< Of the budget, within which a better level must stay; 0 is 0.9.
    int wait;           ///< Frames for which it must be predicted to, up to 1000; 0 is 30.
} crevice_governor_desc;

/// Draws the level of a front that fits the budget from now on, in place of the config, with the
/// folder, patch and outputs of the effect. Programs of all levels are made here, and the first
/// frame warms each. What is set holds for all levels. crevice_effect_reload ends it.
///
/// Warns with CV6018 where the GPU's time cannot be measured, as on software renderers: hand over
/// times of your own, by crevice_effect_add_time.
///
/// Errors: those of crevice_effect_create for each level; CV1201 and CV3xxx for the front, CV4001
/// for numbers out of range, CV2102 for levels that take different textures or draws.
CREVICE_API crevice_error* crevice_effect_govern(crevice_effect* effect,
                                                 const crevice_governor_desc* desc);

/// What a frame took, where the GPU's time cannot be measured; `level` is the one that it was drawn
/// at, below 0 the present one. What is not above 0 counts for nothing. Errors: CV6011.
CREVICE_API crevice_error* crevice_effect_add_time(crevice_effect* effect, double milliseconds,
                                                   int level);

/// Goes on with another budget, above 0. Errors: CV4001, CV6011.
CREVICE_API crevice_error* crevice_effect_set_budget(crevice_effect* effect, double milliseconds);

/// What the governor does.
typedef struct crevice_governor_report {
    size_t struct_size;
    int level;            ///< That is drawn next, from 0.
    const char* config;   ///< Its config. Until the effect is reloaded or governed again.
    double milliseconds;  ///< Its latest time; 0 before there is one.
    double predicted_ms;  ///< What it is predicted to take; above the budget: no level fits.
    double error;         ///< The bench's; 0: not known.
    double estimate;      ///< The value of "doubt_rmse", where the effect draws it; or 0.
} crevice_governor_report;

/// Errors: CV6011 for an effect that is not governed.
CREVICE_API crevice_error* crevice_effect_get_governor(const crevice_effect* effect,
                                                       crevice_governor_report* report);

// ---- What there is to set: for user interfaces --------------------------------------------------

/// A number or vector that crevice_effect_set_param sets.
typedef struct crevice_param {
    size_t struct_size;
    const char* name;
    const char* label;    ///< For people; the name where it has none.
    const char* group;    ///< The heading to put it under.
    const char* unit;     ///< "scene units", "pixels", "1" ...
    const char* tooltip;  ///< One sentence: what it does, and what a higher value costs.
    int components;       ///< Floats, 1 to 4.
    bool integer;         ///< Takes whole numbers alone.
    bool compiles;        ///< Each new value compiles shaders: not for a slider that is dragged.
    double min, max;      ///< Of each component, inclusive; others are errors. 1e30: no bound.
    double soft_max;      ///< Upper end of a slider.
    double step;          ///< Of a slider; 0 for none.
    float default_value[4];
    float value[4];  ///< As it is now.
} crevice_param;

/// How many there are, 0 of null; and one of them. Errors: CV6011 for an index past the last.
CREVICE_API int crevice_effect_param_count(const crevice_effect* effect);
CREVICE_API crevice_error* crevice_effect_get_param(const crevice_effect* effect, int index,
                                                    crevice_param* param);

/// A choice that crevice_effect_set_feature makes.
typedef struct crevice_feature {
    size_t struct_size;
    const char* name;
    bool boolean;              ///< Its words are "false" and "true".
    const char* const* words;  ///< What it may be set to.
    int word_count;
    int default_word;     ///< Into `words`.
    int word;             ///< As it is now.
    const char* label;    ///< For people; the name where it has none.
    const char* tooltip;  ///< One sentence: what it does, and what it costs.
} crevice_feature;

/// How many there are, 0 of null; and one of them. Errors: CV6011 for an index past the last.
CREVICE_API int crevice_effect_feature_count(const crevice_effect* effect);
CREVICE_API crevice_error* crevice_effect_get_feature(const crevice_effect* effect, int index,
                                                      crevice_feature* feature);

/// What the config wants of its host.
typedef struct crevice_import {
    size_t struct_size;
    const char* name;

    /// "texture" (crevice_effect_set_texture), "camera" (_set_projection and _set_view),
    /// "draw_list"
    /// (_set_draws and _set_materials) or "lights" (_set_lights and _set_ambient_light).
    const char* type;
    const char* format;  ///< Of a texture: the one whose steps shaders allow for.
    bool optional;       ///< It draws without.
} crevice_import;

/// How many there are, 0 of null; and one of them. Errors: CV6011 for an index past the last.
CREVICE_API int crevice_effect_import_count(const crevice_effect* effect);
CREVICE_API crevice_error* crevice_effect_get_import(const crevice_effect* effect, int index,
                                                     crevice_import* import);

/// All that was set, as the smallest JSON patch over the config: {"params": {"radius": {"default":
/// 0.8}}}, or {} where nothing was. Give it to crevice_effect_create, or write "format" and
/// "extends" in front of it for a config of its own. Of the effect, until the next such call.
CREVICE_API crevice_error* crevice_effect_get_patch(crevice_effect* effect, const char** patch);

#ifdef __cplusplus
}
#endif

#endif
