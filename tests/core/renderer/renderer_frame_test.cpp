// SPDX-License-Identifier: MIT
// What shaders see of a frame, and which frames are refused.
#include <crevice/renderer.h>

#include "core/frame/frame_math.h"
#include "tests/support/renderer_rig.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <sstream>

using namespace crevice;

namespace {

glm::vec3 sentVector(const Rig& rig, const char* name)
{
    const std::vector<float> values = rig.device.lastUniform(name);
    REQUIRE(values.size() >= 3);
    return {values[0], values[1], values[2]};
}

float difference(const glm::mat4& a, const glm::mat4& b)
{
    float largest = 0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return largest;
}

void look(Frame& frame)
{
    frame.camera.view_from_world =
        glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0));
    frame.camera.clip_from_view = glm::perspective(1.0f, 2.0f, 0.1f, 100.0f);
    frame.draws[0].world_from_model =
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(1, 0, 2)), glm::vec3(2, 1, 0.5f));
}

// The normal of a plane spanned by two tangents, after the matrix moved them.
void checkNormal(const glm::mat4& matrix)
{
    const glm::mat3 linear(matrix);
    const glm::vec3 u(1, 2, -1), v(0.5f, -1, 3);
    const glm::vec3 sent = normalMatrix(matrix) * glm::cross(u, v);
    const float length = glm::length(sent);
    CHECK(std::isfinite(length));
    CHECK(length > 0.01f);
    CHECK(std::abs(glm::dot(sent / length, glm::normalize(linear * u))) < 1e-5f);
    CHECK(std::abs(glm::dot(sent / length, glm::normalize(linear * v))) < 1e-5f);
    // What pointed away from the surface still does.
    CHECK(glm::dot(sent, linear * glm::cross(u, v)) > 0);
}

/// Has the rig's geometry pass cull `cull`, in the scene of its frame.
void cullGeometry(Rig& rig, Cull cull)
{
    Description description = rigDescription();
    for (PassDesc& pass : description.passes)
        if (pass.name == "geometry") pass.state.cull = cull;
    rig.use(description);
}

/// What is culled of each draw of the next frame, by its first letter.
std::string culledOf(Rig& rig)
{
    std::istringstream lines(rig.draw());
    std::string order;
    char cull = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find("cull ");
        if (at != line.npos) cull = line[at + 5];
        if (line.find("draw ") == 0) order += cull;
    }
    return order;
}

}  // namespace

TEST_CASE("Shaders get the camera's matrices and their inverses")
{
    Rig rig;
    look(rig.frame);
    rig.draw();
    const glm::mat4 clip_from_view = sentMatrix(rig, "clip_from_view");
    const glm::mat4 view_from_world = sentMatrix(rig, "view_from_world");
    CHECK(clip_from_view == rig.frame.camera.clip_from_view);
    CHECK(view_from_world == glm::mat4(rig.frame.camera.view_from_world));
    CHECK(difference(sentMatrix(rig, "view_from_clip") * clip_from_view, glm::mat4(1)) < 1e-4f);
    const glm::vec4 middle = sentMatrix(rig, "view_from_window") * glm::vec4(0.5f, 0.5f, 0.75f, 1);
    CHECK(glm::length(middle - sentMatrix(rig, "view_from_clip") * glm::vec4(0, 0, 0.5f, 1)) <
          1e-5f);
    CHECK(difference(sentMatrix(rig, "world_from_view") * view_from_world, glm::mat4(1)) < 1e-5f);
}

TEST_CASE("A scene far from the origin reaches shaders as it does near it")
{
    Rig rig;
    look(rig.frame);
    rig.draw();
    const glm::mat4 view_from_model = sentMatrix(rig, "view_from_model");
    const glm::mat4 clip_from_model = sentMatrix(rig, "clip_from_model");
    // In float the distance of camera and model would be lost.
    const glm::dvec3 far_away(1e7, 3e6, -7e6);
    glm::dmat4& view_from_world = rig.frame.camera.view_from_world;
    view_from_world = glm::translate(view_from_world, -far_away);
    rig.frame.draws[0].world_from_model[3] += glm::dvec4(far_away, 0);
    rig.draw();
    CHECK(difference(sentMatrix(rig, "view_from_model"), view_from_model) < 1e-6f);
    CHECK(difference(sentMatrix(rig, "clip_from_model"), clip_from_model) < 1e-6f);
}

TEST_CASE("What is mirrored is culled the other way round")
{
    Rig rig;
    look(rig.frame);
    cullGeometry(rig, Cull::back);
    DrawItem mirrored = rig.frame.draws[0];
    mirrored.world_from_model = glm::scale(mirrored.world_from_model, glm::dvec3(1, 1, -1));
    rig.frame.draws = {rig.frame.draws[0], mirrored, rig.frame.draws[0]};
    CHECK(culledOf(rig) == "bfb");
    rig.frame.draws.pop_back();
    CHECK(culledOf(rig) == "bf");
    rig.frame.camera.clip_from_view[1][1] *= -1;  // a picture that is upside down
    CHECK(culledOf(rig) == "fb");
    rig.frame.camera.view_from_world = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)) *
                                       rig.frame.camera.view_from_world;  // both mirror
    CHECK(culledOf(rig) == "bf");
    rig.frame.camera.clip_from_view[1][1] *= -1;
    CHECK(culledOf(rig) == "fb");  // the view alone
}

TEST_CASE("Nothing of a sheet is culled")
{
    Rig rig;
    look(rig.frame);
    rig.frame.materials.push_back(rig.frame.materials[rig.frame.draws[0].material]);
    rig.frame.materials.back().alpha_cutoff = 0.5f;
    DrawItem body = rig.frame.draws[0], sheet = body, leaf = body;
    sheet.sheet = true;
    leaf.material = static_cast<int>(rig.frame.materials.size()) - 1;
    rig.frame.draws = {body, sheet, leaf, body};
    cullGeometry(rig, Cull::front);
    CHECK(culledOf(rig) == "fnnf");
}

TEST_CASE("Of a mesh with sheets these are drawn once more, from their other side")
{
    Rig rig;
    look(rig.frame);
    MeshDesc mesh = makeBox({-1, -1, -1}, {1, 1, 1});
    const auto body = static_cast<std::uint32_t>(mesh.indices.size());
    for (const std::uint32_t corner : {0, 1, 2}) {
        mesh.vertices.push_back(mesh.vertices[corner]);
        mesh.vertices.back().position[1] += 5;
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()) - 1);
    }
    DrawItem& item = rig.frame.draws[0];
    item.mesh = need(rig.device.createMesh(mesh));
    cullGeometry(rig, Cull::front);
    const auto culled = [&](std::uint32_t first, std::uint32_t count) {
        item.first = first;
        item.count = count;
        return culledOf(rig);
    };
    CHECK(culled(0, body + 3) == "fb");
    CHECK(culled(0, body) == "f");
    CHECK(culled(body, 3) == "n");
    mesh.may_have_sheets = false;
    item.mesh = need(rig.device.createMesh(mesh));
    CHECK(culled(0, body + 3) == "f");
}

TEST_CASE("Normals stay normal to what they stand on, turned, stretched, mirrored, tiny and huge")
{
    const glm::mat4 one(1.0f);
    checkNormal(glm::rotate(one, 1.0f, glm::vec3(1, 2, 3)));
    for (const glm::vec3 by :
         {glm::vec3(10, 0.1f, 1), {-1, 1, 1}, glm::vec3(1e-12f), glm::vec3(1e12f)})
        checkNormal(glm::scale(one, by));
}

TEST_CASE("A normal matrix keeps rotations, and survives what has no inverse")
{
    const glm::mat4 rotation = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(1, 1, 0));
    const glm::mat4 scaled = glm::scale(rotation, glm::vec3(5.0f));
    CHECK(difference(glm::mat4(normalMatrix(scaled)), rotation) < 1e-6f);
    const glm::mat4 flat = glm::scale(glm::mat4(1), glm::vec3(1, 0, 1));
    CHECK(glm::distance(glm::normalize(normalMatrix(flat) * glm::vec3(0, 1, 0)),
                        glm::vec3(0, 1, 0)) < 1e-6f);
    CHECK(std::isfinite(normalMatrix(glm::dmat4(0.0))[0][0]));
}

TEST_CASE("Each draw gets its own values, and a draw of nothing is skipped")
{
    Rig rig;
    rig.frame.materials.push_back({});
    rig.frame.materials[1].base_color = glm::vec4(0.5f, 0.25f, 0.125f, 1);
    rig.frame.draws.push_back({rig.mesh, 3, 3, glm::mat4(1.0f), 1});
    rig.frame.draws.push_back({{}, 0, 0, glm::mat4(1.0f), 77});
    const std::string log = rig.draw();
    CHECK(occurrences(log, "setUniform base_color ") == 2);
    CHECK(has(log, "setUniform base_color 0.5 0.25 0.125 1"));
    CHECK(has(log, "draw mesh 'cube' 0..6"));
    CHECK(has(log, "draw mesh 'cube' 3..6"));
    CHECK(occurrences(log, "draw mesh") == 2);
    CHECK(occurrences(log, "setUniform radius") == 1);
}

TEST_CASE("A material without a map is white, one with a map is that")
{
    Rig rig;
    CHECK(has(rig.draw(), "setTexture base_color_map unit 0 <- texture 'white'"));
    const TextureId bricks = rig.device.adoptTexture({9, "bricks", Format::rgba8, {4, 4}}).value();
    rig.frame.materials[0].base_color_map = bricks;
    CHECK(has(rig.draw(), "base_color_map unit 0 <- texture 'bricks' linear repeat"));
}

TEST_CASE("Lights reach the shader in view space")
{
    Rig rig;
    look(rig.frame);
    rig.frame.lights.resize(2);
    rig.frame.lights[0].position = glm::vec3(1, 2, 3);
    rig.frame.lights[0].color = glm::vec3(4, 5, 6);
    rig.frame.lights[1].directional = true;
    rig.frame.lights[1].direction = glm::vec3(0, -10, 0);
    rig.draw();
    const glm::mat4 view_from_world = rig.frame.camera.view_from_world;
    const std::vector<float> sent = rig.device.lastUniform("light_position");
    REQUIRE(sent.size() == 4 * kMaxLights);
    const glm::vec4 point = view_from_world * glm::vec4(1, 2, 3, 1);
    const glm::vec4 towards = view_from_world * glm::vec4(0, 1, 0, 0);
    for (int i = 0; i < 4; ++i) {
        CHECK(sent[i] == Approx(point[i]).margin(1e-6));
        CHECK(sent[4 + i] == Approx(towards[i]).margin(1e-6));
    }
    CHECK(rig.device.lastUniform("light_count") == std::vector<float>{2});
    CHECK(sentVector(rig, "light_color") == glm::vec3(4, 5, 6));
    CHECK(sentVector(rig, "light_attenuation") == glm::vec3(1, 0, 0));
    CHECK(sentVector(rig, "ambient_light") == rig.frame.ambient_light);
}

TEST_CASE("Of more lights than there is room for the first are taken")
{
    Rig rig;
    rig.frame.lights.resize(kMaxLights + 5);
    rig.draw();
    CHECK(rig.device.lastUniform("light_count") == std::vector<float>{float(kMaxLights)});
}

TEST_CASE(
    "A spot's cone is 1 within its inner angle, 0 beyond the outer, and no other light has one")
{
    Light light;
    light.direction = {0, 0, -2};
    const glm::dmat4 place(1.0);
    CHECK(coneInView(light, place) == glm::vec4(0, 0, 0, 1));
    light.spot = true;
    light.inner_angle_rad = 0.3f;
    light.outer_angle_rad = 0.6f;
    const auto shines = [&](float angle) {
        const glm::vec3 towards(std::sin(angle), 0, std::cos(angle));
        const glm::vec4 cone = coneInView(light, place);
        return glm::dot(glm::vec3(cone), towards) + cone.w;
    };
    CHECK(shines(0.29f) > 1.0f);
    CHECK(shines(0.61f) < 0.0f);
    CHECK(shines(0.45f) == Approx(0.5).margin(0.1));
    light.outer_angle_rad = light.inner_angle_rad;
    CHECK(shines(0.29f) > 1.0f);
    CHECK(shines(0.31f) < 0.0f);
    light.directional = true;
    CHECK(coneInView(light, place) == glm::vec4(0, 0, 0, 1));
}

TEST_CASE("An optional import that is absent is black, one that is there is taken")
{
    Rig rig;
    CHECK(has(rig.draw(), "<- texture 'black'"));
    const TextureId decal = rig.device.adoptTexture({3, "sticker", Format::rgba8, {4, 4}}).value();
    rig.frame.textures = {{"other", {}}, {"decal", decal}};
    CHECK(has(rig.draw(), "setTexture decal unit 2 <- texture 'sticker' nearest clamp"));
    rig.frame.textures[1].texture = {};
    CHECK(has(rig.draw(), "<- texture 'black'"));
}

TEST_CASE("Passes load, clear and store as the plan says, and sample as the config says")
{
    Rig rig;
    const std::string log = rig.draw();
    CHECK(has(log,
              "beginPass geometry 64x32 color0 clear 0 0 0 0 store "
              "color1 clear 0.25 0 0 1 store depth clear 1 store\n"));
    CHECK(has(log, "beginPass occlusion 32x16 color0 discard store\n"));
    CHECK(has(log, "setProgram 'geometry' depth_test less depth_write"));
    CHECK(has(log, "setTexture noise unit 2 <- texture 'noise' nearest repeat"));
    CHECK(has(log, "setTexture source unit 0 <- texture 'ao' linear clamp"));
}

TEST_CASE("A frame that no shader could draw is refused, and the last picture stays")
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const glm::mat4 one(1), lens = glm::perspective(1.0f, 1.5f, 0.1f, 10.0f),
                            box = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 0.0f, 9.0f),
                            dependent(0.1f, 0.2f, 0.3f, 0.7f, 0.2f, 0.4f, 0.6f, 1.4f, 0.3f, 0.1f,
                                      0.9f, 0.2f, 0.5f, 0.5f, 0.1f, 0.3f);
    glm::mat4 bad = one, leaning = box;
    bad[2][2] = kNan;
    leaning[2][1] = 0.5f;
    const char* const behind =
        "has w below 0 for what lies in front, along -z: nothing would be seen";
    const std::pair<glm::mat4, const char*> projections[] = {
        {bad, "is not finite"},
        {glm::scale(one, glm::vec3(1, 0, 1)), "has no inverse"},
        {dependent, "has no inverse"},
        {glm::perspectiveLH(1.0f, 1.5f, 0.1f, 10.0f), behind},
        {lens * -1.0f, behind},  // which maps points as the positive one does
        {box * -1.0f, behind},
        {lens * glm::lookAt(glm::vec3(1, 2, 3), {}, {0, 1, 0}),
         "does not project along its z axis"},
        {lens * glm::translate(one, glm::vec3(0, 0, -1)), "does not project along its z axis"},
        {leaning, "does not project along its z axis"},
        {glm::orthoLH_NO(-1.0f, 1.0f, -1.0f, 1.0f, 0.0f, 9.0f),
         "shows a box that lies along +z, behind"},
    };
    Rig rig;
    rig.draw();
    const auto refused = [&rig](const std::string& what) {
        INFO(what);
        rig.device.clearLog();
        const Status status = rig.renderer->render(rig.frame);
        REQUIRE(codeOf(status) == Code::bad_input);
        CHECK(status.diagnostics().front().message == "the camera's " + what);
        CHECK(rig.device.log().empty());
    };
    for (const auto& [projection, what] : projections) {
        rig.frame.camera.clip_from_view = projection;
        refused(std::string("clip_from_view ") + what);
    }
    rig.frame.camera.clip_from_view = lens;
    rig.frame.camera.view_from_world[3][0] = std::numeric_limits<float>::infinity();
    refused("view_from_world is not finite");
}
