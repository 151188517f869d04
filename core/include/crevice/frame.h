// SPDX-License-Identifier: MIT
// What the host supplies for a frame: camera, draw list, materials, lights, textures.
//
// GLSL sees them under these names. All vectors are in view space unless the name says otherwise:
// x points right and y up on the picture, and the view looks along -z. Where the host's projection
// flips, turns or is left-handed, its own view space is another.
//
//   camera     mat4 clip_from_view, view_from_clip, view_from_world, world_from_view;
//              mat4 view_from_window (from uv and depth as a texture holds it, 0..1 each);
//              mat3 view_from_host (from the view space of the host's matrices)
//   draw list  mat4 clip_from_model, view_from_model; mat3 view_normal_from_model (inverse
//              transpose); vec4 base_color; float alpha_cutoff; vec3 specular; float shininess;
//              float material_ambient, normal_scale (0 without a map), occlusion_strength;
//              float metallic, roughness, reflectance, unlit; vec3 emission;
//              sampler2D base_color_map, normal_map, occlusion_map, metallic_roughness_map,
//              emission_map (white when the material has none)
//   lights     int light_count; vec4 light_position[MAX_LIGHTS] (w 1: a point, w 0: the direction
//              towards the light); vec3 light_color[MAX_LIGHTS];
//              vec3 light_attenuation[MAX_LIGHTS] (1 / (x + y d + z d^2));
//              vec4 light_cone[MAX_LIGHTS] (of a spot clamp(dot(xyz, towards) + w, 0, 1)^2 shines,
//              where `towards` is the unit vector to the light); vec3 ambient_light
//   history    float history_valid (1, or 0 where there is no last frame: the first one of a plan
//              that cannot go on with histories, and the one after a cut); mat4
//              previous_view_from_view, previous_clip_from_view (from this frame's view space to
//              the last one's); int frame_index, [0, 1024)
//   pass       vec2 viewport_size, in pixels of the pass; vec2 view_size, in those of the view; int
//              first_layer (of the volumes that it draws, 0 elsewhere); mat3 ray_from_pixel (of the
//              camera: from a place in the pass's pixels and 1 to x and y of view space at z = 1,
//              of a perspective view, and of parallel rays at any z)
//
// A frame may have further views, such as the right eye: the plan then runs once for each, and
// camera, lights and the matrices of the last frame are those of the view at hand.
#pragma once

#include <crevice/device.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace crevice {

// The libraries are built with GLM's packed float types; aligned ones have other offsets.
static_assert(sizeof(glm::vec3) == 12 && alignof(glm::vec4) == 4 && alignof(glm::dmat4) == 8,
              "crevice's structs hold packed GLM types: include <crevice/effect.h> alone, which "
              "has no GLM types, or build this file without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

enum class ImportType { camera, draw_list, lights, texture };

/// What the host supplies. A camera, draw list and lights give the uniforms listed in
/// <crevice/frame.h>; a texture is a sampler of the import's name.
struct ImportDesc : Named {
    ImportType type = ImportType::texture;
    bool optional = false;  ///< Absent is allowed: 0 for a texture, no lights, nothing drawn.
    std::string format = "depth24";  ///< Of a texture: the format whose resolution it has.
};

/// Numbers made on load. A kernel is a `uniform vec3 name[COUNT]`, a noise a small texture.
struct GeneratorDesc : Named {
    std::string generator;         ///< "sphere_kernel", "hemisphere_kernel", "rotation_noise", ...
    int count = 16;                ///< Offsets of a kernel, or pixels along a side of a noise.
    std::string shape = "ball";    ///< Where the offsets of a kernel lie: "ball", "cube", "rays".
    std::string lengths = "even";  ///< How their lengths grow: "even", "linear", "quadratic".
    unsigned seed = 1;
};

/// Lights that one frame may have: 16 take 48 of the 224 uniform vectors every device has.
constexpr int kMaxLights = 16;

/// A right-handed view, which looks along -z, or a left-handed one, which mirrors and looks along
/// +z; and any projection that OpenGL can express, flipped, turned or off-centre too.
/// What is placed in the world is double, so that a scene a million radii from the origin keeps its
/// shape: only matrices relative to the camera become float.
struct Camera {
    glm::dmat4 view_from_world = glm::dmat4(1.0);
    glm::mat4 clip_from_view = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};

    /// The clip control that `clip_from_view` is made for and the host's textures were drawn with.
    /// Default: as the host's is when the frame is rendered; that of OpenGL for all else.
    std::optional<ClipControl> clip_control = {};

    /// The depth range that the host's depth was drawn with. Default: as the host's is when the
    /// frame is rendered, where a pass reads depth of the host's; else (0, 1).
    std::optional<DepthRange> depth_range = {};

    /// True when the last row of `clip_from_view` is (0, 0, 0, 1), or a multiple of it.
    bool orthographic() const;

    /// True when made for a view along +z: w grows with z, or a box of parallel rays lies there.
    bool leftHanded() const;

    /// True when what is farther has less depth. Passes test and clear depth the other way then.
    bool reversedDepth() const;
};

/// Light in world space.
struct Light {
    bool directional = false;
    glm::dvec3 position = glm::dvec3(0.0);            ///< Of a point light.
    glm::vec3 direction = glm::vec3(0.0f, 0.0f, -1);  ///< Of a directional light or spot.
    glm::vec3 color = glm::vec3(1.0f);                ///< Linear, >= 0.
    glm::vec3 attenuation = glm::vec3(1.0f, 0, 0);    ///< Constant, linear (1/unit), quadratic.
    bool spot = false;                                ///< A point light that shines in a cone.
    float inner_angle_rad = 0.0f;  ///< Of a spot: off its direction, as far as it shines in full.
    float outer_angle_rad = 0.8f;  ///< ... and where it ends, [inner, pi].
};

struct Material {
    glm::vec4 base_color = glm::vec4(1.0f);  ///< Linear.
    TextureId base_color_map = {};           ///< Null means white.
    glm::vec3 specular = glm::vec3(0.0f);    ///< Colour of the highlight; 0 is matte.
    float shininess = 16.0f;                 ///< Blinn-Phong exponent, > 0.
    float ambient = 1.0f;                    ///< Share of the ambient light it reflects, [0, 1].
    float alpha_cutoff = 0.0f;        ///< Below this alpha a pixel is discarded; 0 is opaque.
    TextureId normal_map = {};        ///< Tangent space, n * 0.5 + 0.5, y up; null is flat.
    float normal_scale = 1.0f;        ///< Of the map's x and y.
    TextureId occlusion_map = {};     ///< Baked visibility in red; null is open.
    float occlusion_strength = 1.0f;  ///< [0, 1]; 0 is open.
    bool blended = false;  ///< Seen through by its alpha: takes no occlusion and casts none.
    // What lighting/metallic_roughness reads beside base_color, after glTF.
    float metallic = 0.0f;      ///< [0, 1]
    float roughness = 1.0f;     ///< [0, 1]
    float reflectance = 0.04f;  ///< What is no metal reflects of light from ahead, [0, 1].
    TextureId metallic_roughness_map = {};  ///< Roughness in green, metallic in blue, as factors.
    glm::vec3 emission = glm::vec3(0.0f);   ///< Light of its own, linear, >= 0.
    TextureId emission_map = {};            ///< Null means white.
    bool unlit = false;                     ///< Shows base_color as it is, without any light.

    bool operator==(const Material& other) const;
};

class ValueTable;

/// A draw that the host does by itself. GL is set up as the pass wants it: framebuffer, viewport,
/// depth test, culling, and the pass's program with all of its uniforms and textures. What is left
/// to do is to bind vertices and draw: position, normal and uv are at locations 0 to 2. Another
/// program may be used that writes the same outputs. No state need be put back.
struct DrawCall {
    const char* pass;          ///< Its name in the config.
    std::uint32_t program;     ///< The API's own name (GLuint) of the pass's program.
    const ValueTable& values;  ///< For `matrix` alone.

    /// A matrix of the camera or the draw by its name in GLSL, such as "clip_from_model", as
    /// glUniformMatrix4fv or glUniformMatrix3fv takes it; null for a name that is none.
    const float* matrix(std::string_view name) const;
};

/// `host` is DrawItem::host.
using DrawCallback = void (*)(const DrawCall& call, void* host);

/// A mesh at a place. Seen from outside its triangles run counter-clockwise: back faces and layers
/// of depth tell by that where a body ends.
struct DrawItem {
    MeshId mesh = {};
    std::uint32_t first = 0;  ///< First index.
    std::uint32_t count = 0;  ///< Indices.
    glm::dmat4 world_from_model = glm::dmat4(1.0);
    int material = 0;  ///< Into Frame::materials.

    /// A sphere around all that is drawn, in model space. Of an item that lies outside of what a
    /// pass shows nothing is then drawn, and occlusion is computed within what spheres cover. A
    /// radius below 0 means that none is known.
    glm::vec3 bounds_center = glm::vec3(0.0f);
    float bounds_radius = -1.0f;

    /// All of it is a surface without a back of its own, seen from either side: a leaf, cloth, the
    /// ground. No pass culls it, so that its back is its front, and light passes behind it. What
    /// has an alpha_cutoff is one in any case, and so are triangles that sheetsOf finds in `mesh`.
    bool sheet = false;

    /// Draws in the place of `mesh`, `first` and `count`, in every pass that draws the scene: so
    /// that skinned, instanced or streamed geometry stays the host's. Null draws the mesh.
    DrawCallback callback = nullptr;
    void* host = nullptr;  ///< Passed on to `callback`.

    /// A number that changes whenever the host's buffers hold something else, or `callback` draws
    /// something else. 0 with a callback: that may be with every frame.
    std::uint64_t revision = 0;

    bool operator==(const DrawItem& other) const;
};

/// A texture for an import of that name.
struct ImportedTexture {
    std::string name;
    TextureId texture = {};

    /// A number that changes whenever the host draws into the texture, or puts another under the
    /// same id; passes that read it then run again. 0 means that it may change with every frame.
    std::uint64_t revision = 0;
};

/// A further view of the same scene.
struct FrameView {
    Camera camera;
    std::vector<ImportedTexture> textures;  ///< Its own, such as its depth; else the frame's.
};

/// What lengths such as "5%" and "40px" are relative to, in scene units; 0 is not known.
struct SceneScale {
    double diagonal = 0;  ///< Of the box around the scene: that of "%".
    double distance = 0;  ///< Median one, along the view's axis, of what is seen: that of "px".
};

/// A frame's input. The host keeps it and changes it in place, so that a steady frame allocates
/// nothing. What is the same as in the last frame is not drawn again: camera, lights, draws and
/// materials are compared, and what meshes and textures hold is known by `revision`.
struct Frame {
    Camera camera;
    std::vector<DrawItem> draws;
    std::vector<Material> materials;
    std::vector<Light> lights;  ///< Those past kMaxLights are left out; the plan warns.
    glm::vec3 ambient_light = glm::vec3(1.0f);  ///< Colour of the surroundings; configs scale it.
    std::vector<ImportedTexture> textures;
    std::vector<FrameView> other_views;  ///< From 1 on, orthographic or reversed if `camera` is.
    SceneScale scale = {};               ///< Lengths follow it from frame to frame.
    /// To be changed when a mesh, or a material's texture, that was drawn before holds something
    /// else now: ids of what was destroyed are given out again.
    std::uint64_t revision = 0;
    /// A number that changes whenever `draws` or `materials` do: while it stays, they are not
    /// looked at until a pass draws them again. 0: they are compared in each frame.
    std::uint64_t draws_revision = 0;
    bool camera_cut = false;  ///< The last frame no longer applies: histories are cleared.
    /// How far the world's origin has moved since the last frame, in scene units: what was at p is
    /// at p - origin_shift now, in all matrices of this frame. So a host that keeps its origin near
    /// the camera keeps histories. What is not finite is a cut.
    glm::dvec3 origin_shift = glm::dvec3(0.0);
};

/// The camera of a view: 0 is `frame.camera`. Requires 0 <= view <= other_views.size().
const Camera& cameraOf(const Frame& frame, std::size_t view);

/// How near and far a camera sees along its axis, in scene units. Two that differ by less than a
/// factor of two in each are equal, so that a frame is not planned again while a camera zooms or
/// its planes move a little; far planes past 2^20 near ones, lost in a float matrix, count as none.
struct CameraRange {
    double near_distance = 0;  ///< 0 of an orthographic camera,
    /// ... and this its planes' distance. Infinite without a far plane; 0 where nothing is known.
    double far_distance = 0;
    /// A length covers zoom / 2 of the view's height at distance 1, or anywhere if orthographic.
    double zoom = 0;
    double depth_share = 1;  ///< What the planes lie apart in window depth.

    bool operator==(const CameraRange& other) const;
};

/// Of the projection as it is: off-centre, reversed, infinite or orthographic.
CameraRange rangeOf(const Camera& camera);

/// Where the draws in view lie, by their bounds, as a plan is made: no move plans again, or warns.
struct DrawRange {
    /// Mean distance along the view's axis, each draw's by how much of the view it covers; 0 where
    /// that is not known: without draws, or where one has no bounds.
    double distance = 0;
    /// How far apart floats are at the largest coordinate of a vertex, in scene units.
    double vertex_step = 0;
};

/// Of the first view. Requires that the camera is one that can be drawn with.
DrawRange rangeOf(const std::vector<DrawItem>& draws, const Camera& camera);

/// What a plan may depend on, drawn from a frame. Conditions name them as in the comments.
struct SceneTraits {
    int lights = 0;                 ///< scene.lights
    bool alpha_tested = false;      ///< scene.alpha_tested
    bool specular = false;          ///< scene.specular
    bool textured = false;          ///< scene.textured: some material has a base_color_map
    bool orthographic = false;      ///< camera.orthographic
    bool turned = false;            ///< camera.turned: a host's view space is not that of shaders
    bool reversed_depth = false;    ///< camera.reversed_depth: what is farther has less depth
    bool normal_mapped = false;     ///< scene.normal_mapped: some material has a normal_map
    bool baked_occlusion = false;   ///< scene.baked_occlusion: some material has an occlusion_map
    bool material_ambient = false;  ///< scene.material_ambient: some `ambient` is below 1
    bool blended = false;           ///< scene.blended: some material is
    bool metal_mapped = false;      ///< scene.metal_mapped: some has a metallic_roughness_map
    bool emission_mapped = false;   ///< scene.emission_mapped: some has an emission_map
    int views = 1;                  ///< camera.views
    CameraRange camera = {};        ///< Formats are chosen by it, and no condition sees it.
    DrawRange draws = {};           ///< Plans warn by it; no condition and no comparison sees it.
    SceneScale scale = {};          ///< The same, but that lengths follow it.

    bool operator==(const SceneTraits& other) const;
};

SceneTraits traitsOf(const Frame& frame);

enum class TimingMethod {
    wall_clock,  ///< CPU and GPU together, waiting for the GPU after each pass: no two overlap.
    gpu_timer,   ///< The GPU alone, nothing waiting.
    /// The processor time of the process, all threads together, waiting as with `wall_clock`.
    processor_time,
};

/// All in milliseconds. Compare only figures of one method.
struct FrameTimes {
    TimingMethod method = TimingMethod::wall_clock;

    /// In the order of the plan's passes, each with all views together: 0 of a pass that did not
    /// run. Negative where the GPU's timer gave no valid result.
    std::vector<double> pass_ms = {};

    /// By a clock: all of the frame, with what lies between the passes. By the GPU's timer: the
    /// sum of the passes, or -1 when one of them is void; then draw again.
    double total_ms = 0;

    std::uint64_t count = 0;  ///< Of Renderer::times: frames since the plan was made, this one too.
};

}  // namespace crevice
