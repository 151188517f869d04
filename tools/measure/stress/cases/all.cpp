// SPDX-License-Identifier: MIT
// All stress cases as one list, and what they share. A new case goes into another file of this
// folder.
#include "tools/measure/stress/cases/all.h"

#include "core/base/text.h"
#include "tools/show/plan/print.h"

#include <cmath>

namespace crevice {
namespace {

const Extent kShapes[] = {{256, 144}, {1, 1},    {1, 64},   {64, 1},   {3, 2},
                          {127, 93},  {2048, 1}, {1, 2048}, {5, 4096}, {255, 144}};

}  // namespace

std::vector<StressStep> steps(std::initializer_list<double> values)
{
    std::vector<StressStep> all;
    for (const double value : values) all.push_back({value, significant(value, 6)});
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
    for (const Extent shape : kShapes)
        all.push_back({static_cast<double>(all.size()), sizeText(shape)});
    return all;
}

Extent shapeOf(double kind) { return kShapes[static_cast<int>(kind)]; }

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

}  // namespace crevice
