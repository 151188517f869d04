// SPDX-License-Identifier: MIT
// Scenes in CPU memory: what a file or a built-in name gives, before any device sees it.
//
// Right-handed, y is up, lengths in the scene's own units. Nothing here depends on GL, so the
// device upload and the ray tracer start from the same triangles.
#pragma once

#include <crevice/frame.h>

#include <optional>

namespace crevice {

/// An axis-aligned box in world space; empty (min above max) until something is added.
struct Bounds {
    glm::dvec3 min = glm::dvec3(1e300);
    glm::dvec3 max = glm::dvec3(-1e300);

    void add(const glm::dvec3& point);
    bool empty() const { return min.x > max.x; }
    bool operator==(const Bounds& other) const { return min == other.min && max == other.max; }
    glm::dvec3 center() const { return min * 0.5 + max * 0.5; }
    double diagonal() const;             ///< Length from corner to corner; 0 when empty.
    glm::dvec3 corner(int index) const;  ///< Bits 0, 1, 2 of `index` choose max in x, y, z.
};

struct SceneMaterial {
    std::string name = {};
    glm::vec4 base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);  ///< Linear; times the texture.
    int base_color_texture = -1;           ///< Into Scene::textures; -1 for none.
    glm::vec3 specular = glm::vec3(0.0f);  ///< Colour of the highlight; 0 is matte.
    float shininess = 16.0f;               ///< Blinn-Phong exponent, > 0.
    float alpha_cutoff = 0.0f;             ///< Below this alpha is a hole; 0 is opaque.
    int normal_texture = -1;               ///< Into Scene::textures; tangent space, y up.
    float normal_scale = 1.0f;             ///< Of its x and y.
    int occlusion_texture = -1;            ///< Into Scene::textures; baked visibility in red.
    float occlusion_strength = 1.0f;       ///< [0, 1]; 0 is open.
    bool blended = false;                  ///< Seen through: it takes and casts no occlusion.
    float metallic = 0.0f;                 ///< [0, 1]
    float roughness = 1.0f;                ///< [0, 1]
    float reflectance = 0.04f;             ///< Of what is no metal, from ahead.
    int metallic_roughness_texture = -1;   ///< Into Scene::textures; in blue and green, factors.
    glm::vec3 emission = glm::vec3(0.0f);  ///< Linear, >= 0; times the texture.
    int emission_texture = -1;             ///< Into Scene::textures.
    bool unlit = false;                    ///< Shows its colour as it is, without any light.
};

/// Four channels, linear, in [0, 1].
struct SceneTexture {
    std::string name;
    Image image;
};

/// A mesh at a place.
struct SceneInstance {
    int mesh = 0;  ///< Into Scene::meshes.
    glm::dmat4 world_from_model = glm::dmat4(1.0);
    int material = 0;  ///< Into Scene::materials.

    /// In the world, of a point of the mesh.
    glm::dvec3 place(const glm::dvec3& point) const
    {
        return world_from_model * glm::dvec4(point, 1.0);
    }
};

/// The corners of a mesh's triangles, each once, and their box; vertices of no triangle are none.
struct MeshCorners {
    explicit MeshCorners(const MeshDesc& mesh);

    std::vector<glm::vec3> places = {};
    Bounds box = {};
};

struct SceneCamera {
    std::string name = {};
    glm::dmat4 view_from_world = glm::dmat4(1.0);
    bool orthographic = false;
    double fov_y_rad = 0.87;   ///< Of a perspective view: top to bottom, in (0, pi).
    double half_height = 1.0;  ///< Of an orthographic view: centre to top, scene units.
    /// Off-centre: how far right of and above the axis the picture's centre lies, parts of its
    /// width and height.
    glm::dvec2 shift = glm::dvec2(0.0);
    double near_distance = 0.0;  ///< Scene units; when `far_distance` is 0 both follow the
    double far_distance = 0.0;   ///< scene's bounds, but a near distance above 0 is kept.
};

struct SceneLight {
    std::string name;
    Light light;
};

struct Scene {
    std::string name = {};
    std::vector<MeshDesc> meshes = {};
    std::vector<SceneInstance> instances = {};
    std::vector<SceneInstance> blended = {};  ///< Seen through: they take and cast no occlusion.
    std::vector<SceneMaterial> materials = {};
    std::vector<SceneTexture> textures = {};
    std::vector<SceneCamera> cameras = {};
    std::vector<SceneLight> lights = {};
    glm::vec3 ambient_light = glm::vec3(1.0f);  ///< Colour from all around; configs scale it.

    /// The box around every triangle of every instance, blended ones too; see `addCorners` for its
    /// cost.
    Bounds bounds() const;

    /// Adds the place in the world of each corner of each triangle of each instance to `hull`,
    /// which has `add(place)` and is equal to a copy of it that has not grown. Walks the vertices
    /// of all meshes, and those of an instance where its mesh's box would make the hull grow.
    template <class Hull>
    void addCorners(Hull& hull) const
    {
        std::vector<MeshCorners> corners;
        for (const MeshDesc& mesh : meshes) corners.emplace_back(mesh);
        // One of each first, within which most others lie.
        const std::vector<SceneInstance>* const lists[] = {&instances, &blended};
        for (const auto* list : lists)
            for (const SceneInstance& each : *list)
                if (!corners[each.mesh].places.empty())
                    hull.add(each.place(corners[each.mesh].places[0]));
        for (const auto* list : lists)
            for (const SceneInstance& each : *list) {
                Hull grown = hull;
                const MeshCorners& mesh = corners[each.mesh];
                for (int k = 0; k < 8 && !mesh.places.empty(); ++k)
                    grown.add(each.place(mesh.box.corner(k)));
                if (grown == hull) continue;
                for (const glm::vec3& corner : mesh.places) hull.add(each.place(corner));
            }
    }
};

/// With the near and far distances that the camera leaves open: they enclose `bounds` with a hair
/// to spare, and a near distance is then at least a thousandth of the far one.
SceneCamera withPlanes(const SceneCamera& camera, const Bounds& bounds);

/// OpenGL's clip space, z in [-1, 1], of the camera with those planes.
glm::mat4 clipFromView(const SceneCamera& camera, Extent extent, const Bounds& bounds);

/// Which axis of a file points up; `guess` is z for STL, which has no custom, and y for others.
enum class Up { guess, y, z };

/// What reading a file may do, and how it is taken.
struct ImportOptions {
    /// Every format that Assimp knows, and not glTF 2.0, OBJ, FBX, PLY, STL and 3DS alone.
    bool any_format = false;
    double time_s = 0;  ///< At most; 0 leaves 3 s and another for each MiB of the file.
    /// Folders beside the file's own, files below which it may name.
    std::vector<std::string> roots = {};
    std::optional<double> pose_s = {};  ///< A time of a glTF file's animation; nothing is at rest.
    /// By name, or number from 0: the animation of that time and the scene, of those in a glTF
    /// file. Empty for its first animation, and for the scene that the file names.
    std::string animation = {}, file_scene = {};
    Up up = Up::guess;
    bool blended_solid = false;  ///< Surfaces that are seen through stay, as others.
};

/// A built-in scene or a file: glTF 2.0, OBJ, FBX, PLY, STL, 3DS. A name without a
/// folder and an extension is a built-in one. What is left out (broken triangles, textures that
/// cannot be read, what glTF has and crevice does not draw) is reported in warnings. A file without
/// lights gets one, so that it can be seen.
///
/// Errors: CV7001 no such file or name, CV7002 unreadable, CV7003 no triangle in it, CV6009 no
/// memory.
Result<Scene> loadScene(const std::string& name_or_file, const ImportOptions& options = {});

/// The file alone; what `loadScene` does for paths. No default light, no look at built-in names.
/// The file is read in a process of its own, so that one that crashes its reader, or keeps it for
/// ever, is an error.
Result<Scene> importScene(const std::string& path, const ImportOptions& options = {});

/// Triangles of all instances.
long long triangleCount(const Scene& scene);

}  // namespace crevice
