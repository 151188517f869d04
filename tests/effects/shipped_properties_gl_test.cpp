// SPDX-License-Identifier: MIT
// What holds for every estimator alone and for every shipped config and variant, in the scenes and
// through the cameras of stress cases. Those that `crevice stress` judges, it judges whole.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/measure/stress/case.h"
#include "tools/measure/stress/figures.h"

#include <algorithm>
#include <map>

using namespace crevice;

namespace {

// No power of two, as the squares of turned cameras are none: software GL compiles programs again
// where that changes.
constexpr Extent kExtent = {126, 72};

/// One of what is asked.
struct Asked {
    std::string name;
    Description description, none;  ///< With its intensity, and with none.
    bool alone = false;       ///< An estimator without a filter, which every case is asked of.
    bool open = true;         ///< It finds planes open.
    float least_open = 1;     ///< ... each pixel of them, if not for a filter's rounding.
    double same = 0.002;      ///< Mean change that is none: kSameChange, if not for such steps.
    double mirrored = 0.015;  ///< Noise and directions are not mirrored along.
};

/// Kernels without normals probe inside every wall, and find it grey; those without guards find
/// steps of the stored positions.
bool openOnWalls(const Description& description)
{
    const FeatureDesc* guards = findNamed(description.features, "guards");
    if (guards && guards->value == 0) return false;
    for (const PassDesc& pass : description.passes)
        for (const Reference& color : pass.color)
            if (color.name == "ao") {
                const ShaderDesc* shader = findNamed(description.shaders, pass.shader.name);
                const std::string& text = description.files.at(shader->fragment.name)->text;
                return text.find("SURFACE_WITHOUT_NORMAL") == std::string::npos;
            }
    return true;
}

std::vector<Asked> estimators()
{
    std::vector<Asked> all;
    for (const Module& module : shippedEstimators()) {
        const GivenConfig config({"geometry/depth_normal", module.name});
        all.push_back({module.name, config.description(), config.description({"intensity=0"}), true,
                       module.reads_normals});
    }
    return all;
}

/// As they ship, but for counts of taps that software GL takes seconds for, and contrast, which
/// clips all but creases to white.
std::vector<Asked> configs()
{
    std::vector<Asked> all;
    for (const Subject& subject : subjects()) {
        Description description = descriptionOf(subject);
        std::vector<std::string> overrides;
        if (findNamed(description.params, "contrast")) overrides.push_back("contrast=1");
        const ParamDesc* slices = findNamed(description.params, "slices");
        if (slices && slices->value[0] > 8)
            overrides.insert(overrides.end(), {"slices=4", "steps=8"});
        description = descriptionOf(subject, overrides);
        const bool open = openOnWalls(description);
        overrides.push_back("intensity=0");
        all.push_back({subject.config + " " + subject.variant, std::move(description),
                       descriptionOf(subject, overrides), false, open, 0.95f,
                       open ? 0.002 : 0.003});
    }
    return all;
}

/// A built-in scene, and shots of stress cases, on one device.
class Shots : public SceneRig {
public:
    explicit Shots(const char* built_in) : SceneRig(built_in, kExtent) {}

    const StressShot& shot(const char* name, const char* label) { return set(name, label).shot; }

    /// What such a step shows.
    Image step(Description description, const char* name, const char* label,
               const char* output = "ao")
    {
        const Set& seen = set(name, label);
        extent = seen.shot.extent;
        for (ParamDesc& param : description.params)
            if (param.name == "radius")
                param.value[0] = static_cast<float>(seen.shot.radius);
            else if (param.unit == "scene units" && name == std::string("units"))
                param.value[0] *= std::stof(label);
        const Image image = draw(description, seen.frame, output);
        INFO(name << ", " << label);
        CHECK(allVisibility(image));
        return image;
    }

    /// The picture of a step is that of the case's ordinary one, and that is no such picture.
    void checkSame(const Description& description, const char* name, const char* label,
                   double limit)
    {
        const StressCase& stress = caseOf(name);
        const Image plain = step(description, name, stress.steps[stress.ordinary].label.c_str());
        const Image image = step(description, name, label);
        const double change = changeBetween(plain, image, shot(name, label)).change;
        INFO(name << ", " << label);
        CHECK(change < limit);
        CHECK(mean(plain) < 0.99);
    }

private:
    struct Set {
        StressShot shot;
        UploadedScene scene;
        Frame frame;
    };

    static const StressCase& caseOf(const char* name)
    {
        for (const StressCase& stress : stressCases())
            if (stress.name == name) return stress;
        FAIL("no case " << name);
        return stressCases().front();
    }

    const Set& set(const char* name, const char* label)
    {
        const auto known = sets_.find(std::string(name) + label);
        if (known != sets_.end()) return known->second;
        const StressCase& stress = caseOf(name);
        const auto step = std::find_if(stress.steps.begin(), stress.steps.end(),
                                       [&](const StressStep& each) { return each.label == label; });
        REQUIRE(step != stress.steps.end());
        StressShot shot = stress.shot(step->value, kExtent);
        UploadedScene on_device = need(UploadedScene::upload(*device, shot.scene));
        Frame seen = makeFrame(on_device, SceneCamera(), shot.extent);
        seen.camera = shot.camera;
        seen.camera_cut = true;
        return sets_
            .emplace(std::string(name) + label,
                     Set{std::move(shot), std::move(on_device), std::move(seen)})
            .first->second;
    }

    std::map<std::string, Set> sets_;
};

/// However planes lie to the camera.
void checkPlane(Shots& shots, const Asked& asked, const char* name, const char* label)
{
    const Image ao = shots.step(asked.description, name, label);
    if (!asked.open) return;
    INFO(name << ", " << label);
    CHECK(least(ao) >= asked.least_open);
}

/// Where a floor meets a wall, in the middle of the picture.
void checkCorner(Shots& shots, const Asked& asked)
{
    const Image ao = shots.step(asked.description, "zoom", "60");
    const int middle = ao.extent.height / 2;
    CHECK(meanOfRows(ao, middle - 2, middle + 2) < meanOfRows(ao, 3, 9) - 0.05);
}

/// What more of an estimator than of a config is asked: whatever the radius and the size.
void checkAlone(Shots& shots, const Asked& asked)
{
    const Description& description = asked.description;
    if (asked.open) CHECK(least(shots.step(description, "radius_to_zero", "1e-6")) == 1.0f);
    double last = 1;
    for (const char* radius : {"0.1", "0.4", "0.8"}) {
        const double now = mean(shots.step(description, "corner_radius", radius));
        CHECK(now < last + asked.same);
        last = now;
    }
    for (const char* size : {"1x1", "1x64", "3x2", "127x93"})
        shots.step(description, "sizes", size);
    shots.extent = kExtent;
    const std::string corner = "eye=0,200,200;at=0,0,0;";
    const Image narrow = shots.draw(description, shots.frame(corner + "fov=0.81"));
    const Image orthographic = shots.draw(description, shots.frame(corner + "ortho=4"));
    CHECK(mean(orthographic) < 0.99);
    CHECK(meanChange(narrow, orthographic) < 0.01);
    shots.checkSame(description, "projection", "reversed", asked.same);
    shots.checkSame(description, "units", "1e-3", asked.same);
}

void check(Shots& shots, const Asked& asked, std::size_t number)
{
    INFO(asked.name);
    checkPlane(shots, asked, "plane_grazing", "30");
    checkPlane(shots, asked, "plane_grazing", asked.alone ? "75" : "60");
    checkCorner(shots, asked);
    shots.checkSame(asked.description, "units", "1e3", asked.same);
    const double noise = asked.alone ? asked.mirrored : 0.02;  // of tiles, which stay with pixels
    shots.checkSame(asked.description, "off_centre", "32", noise);
    shots.checkSame(asked.description, "mirrored", "by a matrix", asked.mirrored);
    if (asked.alone) checkAlone(shots, asked);
    const char* const orientations[] = {"flipped in y",        "flipped in x",  "turned by 90",
                                        "turned by 180",       "turned by 270", "left-handed",
                                        "from 0 to 1 in depth"};
    for (std::size_t i = 0; i < std::size(orientations); ++i)  // of each config one
        if (asked.alone || nightly() || number % std::size(orientations) == i)
            shots.checkSame(asked.description, "orientation", orientations[i], asked.mirrored);
    CHECK(least(shots.step(asked.none, "units", "1e0")) == 1.0f);
}

}  // namespace

TEST_CASE("Estimators find planes open and corners dark, whatever the camera, units and sizes")
{
    Shots shots("corner");
    for (const Asked& asked : estimators()) check(shots, asked, 0);
}

TEST_CASE("Shipped configs find planes open and corners dark, and draw pictures that are not black")
{
    Shots shots("corner");
    std::size_t number = 0;
    for (const Asked& asked : configs()) {
        check(shots, asked, number++);
        INFO(asked.name);
        const double visible = mean(shots.step(asked.description, "units", "1e0"));
        CHECK((visible > 0.2 && visible < 0.999));
        const Image color = shots.step(asked.description, "units", "1e0", "color");
        CHECK(shareBelow(color, 0.02f, 1.0) < 0.01);
    }
}
