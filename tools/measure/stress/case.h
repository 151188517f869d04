// SPDX-License-Identifier: MIT
// The cases of `crevice stress`: a small scene, what is varied, and what must come out.
//
// A case is one entry of a table (in tools/measure/stress/cases). Its steps lie on both sides of an
// ordinary one; walking away from that, the first step that fails is the breakdown point.
#pragma once

#include "tools/measure/stress/limits.h"
#include "tools/render/scene/scene.h"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <functional>

namespace crevice {

/// What must come out of each step. Finite values in every target of every pass, and occlusion in
/// [0, 1], are asked of all.
enum class Expectation {
    sound,  ///< No more than that.
    open,   ///< A flat plane: a mean of 0.999 or more, no pixel of the middle below 0.95.
    one,    ///< Exactly 1 everywhere.
    /// The picture of the ordinary step, within the case's limit: as a mean, or where pixels are
    /// spoiled the largest change anywhere else.
    same,
    /// From the ordinary step on, each picture as bright as the one before, the last open.
    opens,
    darkens,  ///< Each picture as dark as the one before.
    settles,  ///< The next frame of the same is the same picture.
    dims,     ///< The ordinary step's colour, as linear light, times the occlusion.
};

/// A frame before the one that counts.
struct StressFrame {
    Camera camera = {};
    glm::dvec3 moved = glm::dvec3(0.0);   ///< The scene's last object, off its place.
    glm::dvec3 origin = glm::dvec3(0.0);  ///< Of the host's coordinates, in the scene's.
    bool cut = false;                     ///< Told that what was before does not apply.
    int times = 1;
};

/// What one frame of a step needs.
struct StressShot {
    Scene scene = {};
    Camera camera = {};
    Extent extent = {};
    double radius = 0.5;  ///< Scene units; what the config's param is set to.
    /// Further params or features, "intensity=0"; a config without one of them is left out.
    std::vector<std::string> settings = {};
    int samples = 0;           ///< Depth taps a pixel; 0: the config's own.
    bool keep_no_ops = false;  ///< No pass is left out because of a param's value.
    bool draws = false;        ///< Asks about the config's own draws.

    /// Drawn before, first to last, for what a config keeps from frame to frame; where that is
    /// empty and nothing is cut, three frames of the same.
    std::vector<StressFrame> before = {};
    bool cut = false;  ///< Told that `before` does not apply.

    std::string output = "ao";  ///< What is looked at.

    /// What the config runs over, one of the names in tools/measure/stress/geometry.h; empty: its
    /// own.
    std::string geometry = {};

    /// When set, depth and normals come from a host, which draws them through `host_camera` and
    /// then does this to them.
    std::function<void(Image& depth, Image& normal)> host = {};
    Camera host_camera = {};

    /// How the format of the depth resolves what is seen. `distances` are those along the view axis
    /// of what each pixel shows, 0 where that is nothing; without them `farthest` stands for all.
    Image distances = {};
    double farthest = 0;  ///< 0: does not matter.
    double middle = 0;    ///< What the middle shows, where that is nearer; 0: as far as that.
    double near_distance = 0.1;
    double far_distance = 100;

    /// From the ordinary picture's plane, [-1, 1], to where this one shows the same.
    glm::dmat2 turned = glm::dmat2(1.0);
    glm::dvec2 moved = glm::dvec2(0.0);  ///< After that.
    int border_px = 0;  ///< At left and right, where what lies off the screen may differ.
    /// Means over such squares are compared: noise that stays with pixels evens out.
    int block_px = 1;

    /// Pixels, counted from the lower left, about which the pictures may differ, as far as
    /// `reach_px`.
    std::vector<glm::ivec2> spoiled = {};
    int reach_px = 0;
};

struct StressStep {
    double value = 0;
    std::string label = {};
};

/// What a sentence about a breakdown point has figures of.
enum class Quantity {
    label,    ///< The step's label.
    screens,  ///< The radius on screen over the picture's height.
    pixels,   ///< The radius on screen.
};

/// Where a case breaks, in what a user thinks in.
struct StressCondition {
    /// "where the radius is taller than {} screens": {} is the figure of the last step that holds;
    /// of kinds, the labels of all that fail.
    std::string_view where = {};
    Quantity quantity = Quantity::label;

    StressCondition(const char* condition = "", Quantity figure = Quantity::label)
        : where(condition),
          quantity(figure)
    {
    }
};

struct StressCase {
    std::string name;
    std::string what;  ///< One sentence.
    std::string unit;  ///< Of the swept value; empty where the steps are kinds, not amounts.
    std::vector<StressStep> steps;
    std::size_t ordinary = 0;  ///< Into `steps`.
    Expectation expectation = Expectation::sound;
    std::function<StressShot(double value, Extent size)> shot = nullptr;
    StressCondition up = {};    ///< Breaking towards the last step; of kinds, at any.
    StressCondition down = {};  ///< Towards the first; empty where that is the ordinary one.
    /// Of `same`, `dims`: mean change. Of `opens`, `darkens`: what noise may do.
    double limit = kSameChange;
};

/// All of them.
const std::vector<StressCase>& stressCases();

}  // namespace crevice
