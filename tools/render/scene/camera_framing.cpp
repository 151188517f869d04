// SPDX-License-Identifier: MIT
#include "tools/render/scene/camera_framing.h"

#include "core/base/text.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kDefaultFov = 50.0;  // degrees, vertical

// What frames the scene, and from which side.
const std::pair<const char*, glm::dvec3> kFrames[] = {
    {"frame", kThreeQuarter},   {"frame=iso", kThreeQuarter}, {"frame=front", {0, 0, 1}},
    {"frame=back", {0, 0, -1}}, {"frame=left", {-1, 0, 0}},   {"frame=right", {1, 0, 0}},
    {"frame=top", {0, 1, 0}}};

constexpr double kFramingFov = 35.0;  // degrees: less would flatten, more would bend what is near
constexpr double kMargin = 1.05;      // of free room around the framed scene

// In front of it, as a part of its size: nothing then looks more than three times as large for
// being near.
constexpr double kLeastRoom = 0.5;

// The view seen from above or from the side: what is at `across` and `along` the axis towards the
// eye fits between two lines that meet in the eye.
struct Wedge {
    double tangent;  // of half of its angle
    double high = -1e300;
    double low = 1e300;

    void add(double across, double along)
    {
        high = std::max(high, across + along * tangent);
        low = std::min(low, across - along * tangent);
    }
    double middle() const { return (high + low) / 2.0; }
    double apex() const { return (high - low) / (2.0 * tangent); }  // the nearest place of the eye
    bool operator==(const Wedge& other) const { return high == other.high && low == other.low; }
};

// What is seen along one direction: turned so that it is -z.
struct SeenCorners {
    glm::dmat3 turned_from_world;
    Wedge horizontal, vertical;
    Bounds turned = {};

    void add(const glm::dvec3& world)
    {
        const glm::dvec3 corner = turned_from_world * world;
        turned.add(corner);
        horizontal.add(corner.x, corner.z);
        vertical.add(corner.y, corner.z);
    }
    bool operator==(const SeenCorners& other) const
    {
        return turned == other.turned && horizontal == other.horizontal &&
               vertical == other.vertical;
    }
};

// What the text of a camera may say, and how many numbers each part has.
constexpr std::pair<const char*, int> kParts[] = {{"eye", 3},  {"at", 3},    {"up", 3},
                                                  {"fov", 1},  {"ortho", 1}, {"shift", 2},
                                                  {"near", 1}, {"far", 1}};

// What it says, by name.
struct CameraText {
    std::map<std::string, glm::dvec3> parts = {};

    bool has(const char* part) const { return parts.count(part) > 0; }
    glm::dvec3 get(const char* part, const glm::dvec3& otherwise) const
    {
        return has(part) ? parts.at(part) : otherwise;
    }
    double number(const char* part) const { return get(part, glm::dvec3(0.0)).x; }
};

Diagnostic unreadable(const std::string& what)
{
    return {Code::usage, what,
            "write --camera 'eye=4,2,6;at=0,1,0;fov=50'; up, ortho, shift, near and far may "
            "follow"};
}

Diagnostic impossible(const std::string& what, const std::string& help)
{
    return {Code::out_of_range, what, help};
}

// Reads `count` numbers with commas between them.
Status readNumbers(const std::string& key, const std::string& text, int count, glm::dvec3& numbers)
{
    std::string_view rest = text;
    for (int k = 0; k < count; ++k) {
        const std::optional<double> number = takeNumber(rest);
        const bool last = k + 1 == count;
        if (!number || (last ? !rest.empty() : rest.substr(0, 1) != ","))
            return unreadable("the camera's " + key + " '" + text + "' is not " +
                              (count == 1   ? "a number"
                               : count == 2 ? "two numbers joined by a comma"
                                            : "three numbers joined by commas"));
        if (!last) rest.remove_prefix(1);
        numbers[k] = *number;
        if (!std::isfinite(numbers[k]))
            return Diagnostic{Code::not_finite,
                              "the camera's " + key + " '" + text + "' is not finite",
                              "write plain numbers"};
    }
    return {};
}

Status readEntry(const std::string& key, const std::string& value, CameraText& camera)
{
    std::vector<std::string> names;
    for (const auto& [name, count] : kParts) {
        if (key == name) return readNumbers(key, value, count, camera.parts[key]);
        names.push_back(name);
    }
    return Diagnostic{Code::usage, "a camera has no '" + key + "'",
                      suggestName(key, names, "parts of a camera")};
}

// Any direction will do where the wanted one runs along the view.
glm::dmat4 lookAt(const glm::dvec3& eye, const glm::dvec3& at, glm::dvec3 up)
{
    const glm::dvec3 forward = glm::normalize(at - eye);
    const double length = glm::length(up);
    if (!(glm::length(glm::cross(forward, up)) > 1e-6 * length))
        up = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    return glm::lookAt(eye, at, up);
}

Result<SceneCamera> cameraOf(const std::string& name, const CameraText& text, const Bounds& bounds)
{
    if (!text.has("eye")) return unreadable("the camera has no eye");
    const glm::dvec3 eye = text.get("eye", {}), at = text.get("at", bounds.center());
    if (eye == at) return impossible("the camera's eye is where it looks at", "move eye or at");
    SceneCamera camera;
    camera.name = name;
    camera.orthographic = text.has("ortho");
    if (text.has("fov") && camera.orthographic)
        return unreadable("the camera has both fov and ortho");
    const double fov = text.get("fov", glm::dvec3(kDefaultFov)).x;
    if (!(fov > 0.0 && fov < 180.0))
        return impossible("the camera's fov is outside (0, 180) degrees", "50 is a common one");
    if (camera.orthographic && !(text.number("ortho") > 0.0))
        return impossible("the camera's ortho height is not above 0", "give it in scene units");
    camera.near_distance = text.number("near");
    camera.far_distance = text.number("far");
    if (text.has("near") && !(camera.near_distance > 0.0) && !camera.orthographic)
        return impossible("the camera's near distance is not above 0",
                          "leave it out to fit the scene");
    if (text.has("far") && !(camera.far_distance > camera.near_distance))
        return impossible("the camera's far distance is not above the near one",
                          "leave it out to fit the scene");
    if (text.has("far") && !text.has("near"))
        return impossible("the camera has a far distance and no near one", "give near as well");
    camera.view_from_world = lookAt(eye, at, text.get("up", {0, 1, 0}));
    if (camera.orthographic) camera.half_height = text.number("ortho") / 2.0;
    camera.fov_y_rad = fov * kDegree;
    camera.shift = text.get("shift", glm::dvec3(0.0));
    return camera;
}

Result<SceneCamera> parseCamera(const std::string& text, const Bounds& bounds)
{
    CameraText camera;
    for (const std::string_view part : split(text, ';')) {
        if (part.empty()) continue;
        const std::string entry(part);
        const std::size_t equals = entry.find('=');
        if (equals == std::string::npos)
            return unreadable("the camera's part '" + entry + "' is not name=value");
        const Status status = readEntry(entry.substr(0, equals), entry.substr(equals + 1), camera);
        if (!status) return status.diagnostics();
    }
    return cameraOf(text, camera, bounds);
}

// Whether the box of some mesh reaches into the view: no side of the view has all of it beyond.
bool mayShow(const SceneCamera& camera, const Scene& scene, const Bounds& bounds, double aspect)
{
    const Extent extent = {static_cast<int>(std::lround(1000 * aspect)), 1000};
    const glm::dmat4 clip_from_world =
        glm::dmat4(clipFromView(camera, extent, bounds)) * camera.view_from_world;
    std::vector<Bounds> boxes;
    for (const MeshDesc& mesh : scene.meshes) boxes.push_back(MeshCorners(mesh).box);
    const auto reaches = [&](const SceneInstance& each) {
        const Bounds& box = boxes[each.mesh];
        int beyond[6] = {};
        for (int k = 0; k < 8 && !box.empty(); ++k) {
            const glm::dvec4 at = clip_from_world * glm::dvec4(each.place(box.corner(k)), 1.0);
            for (int axis = 0; axis < 3; ++axis) {
                beyond[2 * axis] += at[axis] > at.w;
                beyond[2 * axis + 1] += at[axis] < -at.w;
            }
        }
        return !box.empty() && std::find(beyond, beyond + 6, 8) == beyond + 6;
    };
    return scene.instances.empty() ||
           std::any_of(scene.instances.begin(), scene.instances.end(), reaches);
}

}  // namespace

SceneCamera frameScene(const Scene& scene, double aspect, const glm::dvec3& side)
{
    SceneCamera camera;
    camera.name = "framing";
    camera.fov_y_rad = kFramingFov * kDegree;
    const glm::dvec3 towards_eye = glm::normalize(side);
    const glm::dmat3 turned_from_world = lookAt(towards_eye, glm::dvec3(0.0), {0, 1, 0});
    const double tan_y = std::tan(camera.fov_y_rad / 2.0) / kMargin;
    SeenCorners seen = {turned_from_world, {tan_y * aspect}, {tan_y}};
    scene.addCorners(seen);
    const auto& [matrix, horizontal, vertical, turned] = seen;
    if (turned.empty()) return camera;
    const double room = turned.diagonal() > 0.0 ? kLeastRoom * turned.diagonal() : 1.0;
    const glm::dvec3 eye = {horizontal.middle(), vertical.middle(),
                            std::max({horizontal.apex(), vertical.apex(), turned.max.z + room})};
    const glm::dvec3 world_eye = glm::transpose(turned_from_world) * eye;
    camera.view_from_world = lookAt(world_eye, world_eye - towards_eye, {0, 1, 0});
    return camera;
}

Result<SceneCamera> chooseCamera(const Scene& scene, const Bounds& bounds, const std::string& text,
                                 double aspect)
{
    if (text.empty()) {
        for (const SceneCamera& camera : scene.cameras)
            if (mayShow(camera, scene, bounds, aspect)) return camera;
        return frameScene(scene, aspect);
    }
    std::vector<std::string> names;
    for (const SceneCamera& camera : scene.cameras) {
        if (camera.name == text) return camera;
        names.push_back(camera.name);
    }
    for (const auto& [name, side] : kFrames) {
        if (text == name) return frameScene(scene, aspect, side);
        names.emplace_back(name);
    }
    if (text.find('=') != std::string::npos && !startsWith(text, "frame="))
        return parseCamera(text, bounds);
    return Diagnostic{
        Code::camera_missing, "the scene '" + scene.name + "' has no camera '" + text + "'",
        suggestName(text, names, "cameras") + "; or write --camera 'eye=4,2,6;at=0,1,0;fov=50'"};
}

std::string cameraText(const SceneCamera& camera, const Bounds& bounds)
{
    const auto number = [](double value) { return significant(value + 0.0, 7); };
    const auto point = [&](const glm::dvec3& at) {
        return number(at.x) + "," + number(at.y) + "," + number(at.z);
    };
    const glm::dmat4 world_from_view = glm::inverse(camera.view_from_world);
    const glm::dvec3 eye = world_from_view[3];
    const SceneCamera planes = withPlanes(camera, bounds);
    return "eye=" + point(eye) + ";at=" + point(eye - glm::dvec3(world_from_view[2])) +
           ";up=" + point(glm::dvec3(world_from_view[1])) +
           (camera.orthographic ? ";ortho=" + number(2 * camera.half_height)
                                : ";fov=" + number(glm::degrees(camera.fov_y_rad))) +
           (camera.shift != glm::dvec2(0.0)
                ? ";shift=" + number(camera.shift.x) + "," + number(camera.shift.y)
                : "") +
           ";near=" + number(planes.near_distance) + ";far=" + number(planes.far_distance);
}

}  // namespace crevice
