// SPDX-License-Identifier: MIT
// Framing a scene, and reading a camera from the command line.
#include "tools/render/scene/camera_framing.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace crevice {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kDefaultFov = 50.0;  // degrees, vertical

// Towards the eye: from the right, from above, mostly from the front.
const glm::dvec3 kThreeQuarter = {0.55, 0.45, 1.0};

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

// What the text of a camera says, before it is made into one.
struct CameraText {
    glm::dvec3 eye = glm::dvec3(0.0);
    bool has_eye = false;
    glm::dvec3 at = glm::dvec3(0.0);
    glm::dvec3 up = {0, 1, 0};
    double fov = kDefaultFov;
    bool has_fov = false;
    double ortho = 0.0;
    bool has_ortho = false;
    glm::dvec2 shift = glm::dvec2(0.0);
    double near_distance = 0.0;
    bool has_near = false;
    double far_distance = 0.0;
    bool has_far = false;
};

Diagnostic unreadable(const std::string& what)
{
    Diagnostic error = {Code::usage, what};
    error.help =
        "write --camera 'eye=4,2,6;at=0,1,0;fov=50'; up, ortho, shift, near and far may "
        "follow";
    return error;
}

Diagnostic impossible(Code code, const std::string& what, const std::string& help)
{
    Diagnostic error = {code, what};
    error.help = help;
    return error;
}

Diagnostic impossible(const std::string& what, const std::string& help)
{
    return impossible(Code::out_of_range, what, help);
}

// Reads `count` numbers with commas between them.
Status readNumbers(const std::string& key, const std::string& text, int count, double* numbers)
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
            return impossible(Code::not_finite,
                              "the camera's " + key + " '" + text + "' is not finite",
                              "write plain numbers");
    }
    return {};
}

Status readEntry(const std::string& key, const std::string& value, CameraText& camera)
{
    struct Known {
        const char* name;
        int count;
        double* numbers;
        bool* given;
    };
    bool ignored = false;
    const Known known[] = {{"eye", 3, &camera.eye.x, &camera.has_eye},
                           {"at", 3, &camera.at.x, &ignored},
                           {"up", 3, &camera.up.x, &ignored},
                           {"fov", 1, &camera.fov, &camera.has_fov},
                           {"ortho", 1, &camera.ortho, &camera.has_ortho},
                           {"shift", 2, &camera.shift.x, &ignored},
                           {"near", 1, &camera.near_distance, &camera.has_near},
                           {"far", 1, &camera.far_distance, &camera.has_far}};
    std::vector<std::string> names;
    for (const Known& entry : known) {
        names.push_back(entry.name);
        if (key != entry.name) continue;
        *entry.given = true;
        return readNumbers(key, value, entry.count, entry.numbers);
    }
    Diagnostic error = {Code::usage, "a camera has no '" + key + "'"};
    error.help = suggestName(key, names, "parts of a camera");
    return error;
}

Status readCameraText(const std::string& text, CameraText& camera)
{
    for (const std::string_view part : split(text, ';')) {
        if (part.empty()) continue;
        const std::string entry(part);
        const std::size_t equals = entry.find('=');
        if (equals == std::string::npos)
            return unreadable("the camera's part '" + entry + "' is not name=value");
        const std::string key = entry.substr(0, equals);
        const Status status = readEntry(key, entry.substr(equals + 1), camera);
        if (!status) return status;
    }
    return {};
}

Status checkCamera(const CameraText& camera)
{
    if (!camera.has_eye) return unreadable("the camera has no eye");
    if (camera.eye == camera.at)
        return impossible("the camera's eye is where it looks at", "move eye or at");
    if (camera.has_fov && camera.has_ortho) return unreadable("the camera has both fov and ortho");
    if (!(camera.fov > 0.0 && camera.fov < 180.0))
        return impossible("the camera's fov is outside (0, 180) degrees", "50 is a common one");
    if (camera.has_ortho && !(camera.ortho > 0.0))
        return impossible("the camera's ortho height is not above 0", "give it in scene units");
    if (camera.has_near && !(camera.near_distance > 0.0) && !camera.has_ortho)
        return impossible("the camera's near distance is not above 0",
                          "leave it out to fit the scene");
    if (camera.has_far && !(camera.far_distance > camera.near_distance))
        return impossible("the camera's far distance is not above the near one",
                          "leave it out to fit the scene");
    if (camera.has_far && !camera.has_near)
        return impossible("the camera has a far distance and no near one", "give near as well");
    return {};
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

Result<SceneCamera> parseCamera(const std::string& text, const Bounds& bounds)
{
    CameraText parts;
    parts.at = bounds.center();
    if (Status status = readCameraText(text, parts); !status) return status.diagnostics();
    if (Status status = checkCamera(parts); !status) return status.diagnostics();
    SceneCamera camera;
    camera.name = text;
    camera.view_from_world = lookAt(parts.eye, parts.at, parts.up);
    camera.orthographic = parts.has_ortho;
    camera.half_height = parts.has_ortho ? parts.ortho / 2.0 : camera.half_height;
    camera.fov_y_rad = parts.fov * kDegree;
    camera.shift = parts.shift;
    camera.near_distance = parts.near_distance;
    camera.far_distance = parts.far_distance;
    return camera;
}

}  // namespace

SceneCamera frameScene(const Scene& scene, double aspect)
{
    SceneCamera camera;
    camera.name = "framing";
    camera.fov_y_rad = kFramingFov * kDegree;
    const glm::dvec3 towards_eye = glm::normalize(kThreeQuarter);
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
    if (text.empty())
        return scene.cameras.empty() ? frameScene(scene, aspect) : scene.cameras.front();
    std::vector<std::string> names;
    for (const SceneCamera& camera : scene.cameras) {
        if (camera.name == text) return camera;
        names.push_back(camera.name);
    }
    if (text.find('=') != std::string::npos) return parseCamera(text, bounds);
    Diagnostic error = {Code::camera_missing,
                        "the scene '" + scene.name + "' has no camera '" + text + "'"};
    error.help = suggestName(text, names, "cameras") + "; or write eye=4,2,6;at=0,1,0;fov=50";
    return error;
}

}  // namespace crevice
