// SPDX-License-Identifier: MIT
// All stress cases as one list, and what they share. A new case goes into another file of this
// folder.
#include "tools/measure/stress/cases/all.h"

#include "core/base/content_hash.h"
#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

struct Shape {
    const char* label;
    Extent size;
};

const Shape kShapes[] = {{"256x144", {256, 144}}, {"1x1", {1, 1}},       {"1x64", {1, 64}},
                         {"64x1", {64, 1}},       {"3x2", {3, 2}},       {"127x93", {127, 93}},
                         {"2048x1", {2048, 1}},   {"1x2048", {1, 2048}}, {"5x4096", {5, 4096}},
                         {"255x144", {255, 144}}};

void addImage(ContentHash& hash, const Image& image)
{
    hash.add(image.extent.width);
    hash.add(image.extent.height);
    hash.addBytes(image.pixels.data(), image.pixels.size() * sizeof(float));
}

template <class Matrix>
void addMatrix(ContentHash& hash, const Matrix& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) hash.add(matrix[column][row]);
}

void addCamera(ContentHash& hash, const Camera& camera)
{
    addMatrix(hash, camera.view_from_world);
    addMatrix(hash, camera.clip_from_view);
}

template <class Vector>
void addVector(ContentHash& hash, const Vector& vector)
{
    for (int i = 0; i < 3; ++i) hash.add(vector[i]);
}

void addScene(ContentHash& hash, const Scene& scene)
{
    for (const MeshDesc& mesh : scene.meshes) {
        hash.addBytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
        hash.addBytes(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    }
    for (const SceneInstance& instance : scene.instances) {
        hash.add(instance.mesh);
        addMatrix(hash, instance.world_from_model);
    }
    for (const SceneLight& scene_light : scene.lights) {
        addVector(hash, scene_light.light.position);
        addVector(hash, scene_light.light.direction);
        addVector(hash, scene_light.light.color);
        addVector(hash, scene_light.light.attenuation);
    }
    for (const SceneMaterial& material : scene.materials) {
        hash.add(material.shininess);
        addVector(hash, material.specular);
    }
}

void addFrame(ContentHash& hash, const StressFrame& frame)
{
    addCamera(hash, frame.camera);
    addVector(hash, frame.moved);
    addVector(hash, frame.origin);
    hash.add(frame.times);
}

}  // namespace

StressCase told(StressCase stress, StressWords words)
{
    stress.words = std::move(words);
    return stress;
}

std::vector<StressStep> steps(std::initializer_list<double> values)
{
    std::vector<StressStep> all;
    for (const double value : values) all.push_back({value, significant(value, 6)});
    return all;
}

std::vector<StressStep> taps(std::initializer_list<double> values)
{
    std::vector<StressStep> all = steps(values);
    for (StressStep& step : all)
        if (step.value < 0) step.label = "the most";
    return all;
}

std::vector<StressStep> decades(int first, int last)
{
    std::vector<StressStep> all;
    for (int power = first; power <= last; ++power)
        all.push_back({std::pow(10.0, power), "1e" + std::to_string(power)});
    return all;
}

std::vector<StressStep> kinds(std::initializer_list<const char*> labels)
{
    std::vector<StressStep> all;
    for (const char* label : labels) all.push_back({static_cast<double>(all.size()), label});
    return all;
}

std::vector<StressStep> shapes()
{
    std::vector<StressStep> all;
    for (const Shape& shape : kShapes)
        all.push_back({static_cast<double>(all.size()), shape.label});
    return all;
}

Extent shapeOf(double kind) { return kShapes[static_cast<int>(kind)].size; }

Extent sizeForTaps(double samples, Extent size)
{
    if (samples > 0) return size;
    return {(size.width + 3) / 4, (size.height + 3) / 4};
}

int noiseBlock(Extent size) { return std::max(size.width / 8, 1); }

std::vector<StressStep> nearFarSteps()
{
    return {{0, "1:1e1"}, {1, "0.1:316"}, {2, "0.01:1e4"}, {3, "1e-3:3e5"}, {4, "1e-4:1e7"}};
}

StressView nearFarView(double power)
{
    StressView view;
    view.near_distance = std::pow(10.0, -power);
    view.far_distance = std::pow(10.0, 1.0 + 1.5 * power);
    return view;
}

StressShot planeShot(const StressView& view, Extent size, double distance, double tilt_degrees)
{
    PlaneView plane = planeView(view, size, distance, tilt_degrees);
    StressShot shot;
    shot.scene = std::move(plane.scene);
    shot.distances = std::move(plane.distances);
    shot.camera = cameraOf(view, size);
    shot.extent = size;
    shot.near_distance = view.near_distance;
    shot.far_distance = view.far_distance;
    return shot;
}

StressShot sceneShot(const StressView& view, Extent size, Scene scene)
{
    constexpr double kSceneDepth = 4;  // of what is seen, past the origin
    StressShot shot;
    shot.scene = std::move(scene);
    shot.camera = cameraOf(view, size);
    shot.extent = size;
    shot.farthest = view.eye.z + kSceneDepth;
    shot.near_distance = view.near_distance;
    shot.far_distance = view.far_distance;
    return shot;
}

StressView testView()
{
    StressView view;
    view.eye = {0, 1, 5};
    return view;
}

const std::vector<StressCase>& stressCases()
{
    static const std::vector<StressCase> cases = [] {
        std::vector<StressCase> all = planeCases();
        for (const auto& list :
             {sameCases(), cameraCases(), frameCases(), extremeCases(), hostCases()})
            all.insert(all.end(), list.begin(), list.end());
        return all;
    }();
    return cases;
}

std::string hashOf(const StressShot& shot)
{
    ContentHash hash;
    addScene(hash, shot.scene);
    addCamera(hash, shot.camera);
    hash.add(shot.radius);
    for (const std::string& setting : shot.settings) hash.addText(setting);
    hash.add(shot.samples);
    hash.add(shot.keep_no_ops);
    addImage(hash, shot.distances);
    hash.add(shot.extent.width);
    hash.add(shot.extent.height);
    for (const double number :
         {shot.farthest, shot.middle, shot.near_distance, shot.far_distance, shot.coordinates})
        hash.add(number);
    for (int i = 0; i < 2; ++i) hash.add(shot.moved[i]);
    hash.add(shot.border_px);
    for (const StressFrame& frame : shot.before) addFrame(hash, frame);
    hash.add(shot.cut);
    hash.add(shot.view);
    if (shot.other_view) addCamera(hash, *shot.other_view);
    hash.addText(shot.output);
    for (int i = 0; i < 4; ++i) hash.add(shot.turned[i / 2][i % 2]);
    hash.add(shot.block_px);
    for (const glm::ivec2 at : shot.spoiled) {
        hash.add(at.x);
        hash.add(at.y);
    }
    hash.add(shot.reach_px);
    if (shot.host) addMatrix(hash, shot.host_camera.clip_from_view);
    return hash.hex();
}

double formatStep(Format format, double distance, const StressShot& shot)
{
    const double near = shot.near_distance, far = shot.far_distance;
    const auto floatStep = [distance](int bits) {
        return std::exp2(std::floor(std::log2(distance)) - bits);
    };
    if (shot.coordinates > 0) {
        // A vertex shader rounds the coordinates and each of the products that it makes of them.
        constexpr double kProducts = 16;
        const double rounding = kProducts * std::exp2(std::floor(std::log2(shot.coordinates)) - 23);
        StressShot near_by = shot;
        near_by.coordinates = 0;
        return std::max(rounding, formatStep(format, distance, near_by));
    }
    if (format == Format::rgba16f || format == Format::r16f) return floatStep(10);
    if (format == Format::rgba32f || format == Format::r32f) return floatStep(23);
    // Depths near 1, where most of them lie, are as fine in single float as in 24 bits.
    const double depths = format == Format::depth16 ? 65536.0 : 16777216.0;
    if (shot.camera.orthographic()) return (far - near) / depths;
    return distance * distance * (far - near) / (near * far * depths);
}

}  // namespace crevice
