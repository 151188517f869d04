// SPDX-License-Identifier: MIT
// The warnings of plans about the precision of formats and vertices, against what changes, over
// random set-ups.
//
// A set-up is a small scene in other units through a config: seen from within or from afar, through
// planes, formats and projections of any kind. It is drawn as it is, and again in 32 bits between
// ordinary planes. It changed where the mean change is more than half a step of 8 bits; a warning
// is false where it is less than an eighth. Scenes have occlusion to lose.
#include "core/base/text.h"
#include "tests/support/nightly.h"
#include "tests/support/picture.h"
#include "tools/measure/stress/limits.h"
#include "tools/measure/stress/scenes.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

using namespace crevice;

namespace {

constexpr Extent kExtent = {96, 64};
constexpr double kUnseenChange = 0.0005;
constexpr double kLeastRecall = 0.99;
constexpr double kMostFalse = 0.05;

class Random {
public:
    explicit Random(unsigned seed) : bits_(seed) {}
    double uniform(double from, double to) { return from + (to - from) * (bits_() / 4294967296.0); }
    double powerOfTen(double from, double to) { return std::pow(10.0, uniform(from, to)); }
    bool once(int in) { return uniform(0, in) < 1; }
    Format of(std::initializer_list<Format> all)
    {
        return all.begin()[static_cast<std::size_t>(uniform(0, static_cast<double>(all.size())))];
    }

private:
    std::mt19937 bits_;
};

struct Subject {
    const char* config;
    const char* variant = "";
    const char* geometry = "";
};

enum class Kind { depth, view_depth, position, vertices };

struct Group {
    Kind kind;
    const char* name;
    std::vector<Subject> subjects;
};

std::vector<Group> groups()
{
    const std::vector<Subject> depth = {{"gtao"},           {"mobile"},   {"hbao"},
                                        {"hemisphere_box"}, {"sao"},      {"bitmask"},
                                        {"hbao_plus"},      {"balanced"}, {"sphere_bilateral"},
                                        {"ssdo"},           {"high"},     {"habr", "sound"}};
    const std::vector<Subject> position = {{"learnopengl"},
                                           {"learnopengl", "sound"},
                                           {"thesis"},
                                           {"thesis", "sound"},
                                           {"lettier", "sound"},
                                           {"ogldev45", "sound"},
                                           {"hemisphere_box", "", kPositionGeometry},
                                           {"gtao", "", kPositionGeometry},
                                           {"ssdo", "", kPositionGeometry}};
    std::vector<Subject> all = depth;
    all.insert(all.end(), position.begin(), position.end());
    return {{Kind::depth, "window depth", depth},
            {Kind::view_depth,
             "view depth",
             {{"gtao", "", kLinearGeometry}, {"hemisphere_box", "", kLinearGeometry}}},
            {Kind::position, "positions", position},
            {Kind::vertices, "vertices", all}};
}

struct Setup {
    Scene scene, exact_scene;
    StressView view, exact_view;
    Format depth = Format::none, colour = Format::none;  // none: the config's own
    double unit = 1, radius = 0.5;
};

// Boxes on a floor before two walls.
Scene randomScene(Random& random)
{
    Scene scene = testScene();
    if (random.once(2)) return scene;
    scene.meshes.resize(3);
    scene.instances.resize(3);
    for (int i = 0; i < 12; ++i) {
        const auto x = static_cast<float>(random.uniform(0.1, 1));
        const auto y = static_cast<float>(random.uniform(0.2, 2));
        const auto z = static_cast<float>(random.uniform(0.1, 1));
        scene.meshes.push_back(makeBox({-x, 0, -z}, {x, y, z}));
        scene.meshes.back().label = "box";
        const glm::dvec3 place(random.uniform(-2.3, 2.5), -0.01, random.uniform(-2.4, 1.5));
        SceneInstance instance;
        instance.mesh = static_cast<int>(scene.meshes.size()) - 1;
        instance.world_from_model =
            glm::rotate(glm::translate(glm::dmat4(1.0), place), random.uniform(0, 6.3), {0, 1, 0});
        scene.instances.push_back(instance);
    }
    return scene;
}

// From among the objects or from afar, both with ordinary planes. Returns half of what is seen of
// the height.
double chooseView(Random& random, Setup& setup)
{
    const bool within = random.once(2);
    const double distance = within ? random.uniform(4, 5) : random.powerOfTen(1.2, 2);
    const double half =
        within ? distance * std::tan(glm::radians(random.uniform(20, 32))) : random.uniform(2, 4);
    const double pitch = within ? random.uniform(0, 15) : random.uniform(5, 40);
    const double yaw = random.uniform(-35, within ? 10 : 35);
    const glm::dmat4 pitched = glm::rotate(glm::dmat4(1.0), glm::radians(pitch), {1, 0, 0});
    setup.scene = placed(setup.scene, glm::rotate(pitched, glm::radians(yaw), {0, 1, 0}));
    setup.view.eye = {0, 1, distance};
    setup.view.fov_degrees = 2 * glm::degrees(std::atan(half / distance));
    setup.view.near_distance = within ? 0.3 : 0.1 * distance;
    setup.view.far_distance = distance + 40;
    return half;
}

void choosePlanes(Random& random, StressView& view, StressView& exact, double half)
{
    view.reversed = random.once(6);
    view.infinite = random.once(6);
    if (random.once(6)) {
        view.half_height = exact.half_height = half;
        view.infinite = false;
        view.far_distance *= random.powerOfTen(0, 6);
        return;
    }
    view.near_distance *= random.powerOfTen(-6, 0);
    view.far_distance *= random.powerOfTen(0, 4);
}

void scale(StressView& view, double unit)
{
    view.eye *= unit;
    view.near_distance *= unit;
    view.far_distance *= unit;
    view.half_height *= unit;
}

// The scene and its eye far from the origin, in the vertices.
void moveVertices(Random& random, Setup& setup)
{
    const double turn = random.uniform(0, 6.3), z = random.uniform(-1, 1);
    const glm::dvec3 flat(std::cos(turn), std::sin(turn), 0);
    const glm::dvec3 towards = flat * std::sqrt(1 - z * z) + glm::dvec3(0, 0, z);
    const glm::dvec3 offset = towards * setup.radius * random.powerOfTen(1, 7);
    setup.exact_scene = baked(setup.scene);
    setup.scene = baked(placed(setup.scene, glm::translate(glm::dmat4(1.0), offset)));
    setup.view.eye += offset;
}

Setup randomSetup(Random& random, Kind kind)
{
    Setup setup;
    setup.scene = randomScene(random);
    const double half = chooseView(random, setup);
    setup.exact_view = setup.view;
    if (kind != Kind::vertices) {
        choosePlanes(random, setup.view, setup.exact_view, half);
        setup.depth = random.of({Format::depth16, Format::depth24, Format::depth32f});
    }
    setup.colour = kind == Kind::position     ? random.of({Format::rgba16f, Format::rgba32f})
                   : kind == Kind::view_depth ? random.of({Format::r16f, Format::r32f})
                                              : Format::rgba32f;
    setup.unit = random.powerOfTen(-2, 2);
    const double height = 2 * half * setup.unit;
    setup.radius = height * random.powerOfTen(-1.1, -0.5);
    setup.scene = placed(setup.scene, glm::scale(glm::dmat4(1.0), glm::dvec3(setup.unit)));
    scale(setup.view, setup.unit);
    scale(setup.exact_view, setup.unit);
    setup.exact_scene = setup.scene;
    if (kind == Kind::vertices) moveVertices(random, setup);
    return setup;
}

struct Drawn {
    Image ao;
    bool warned;
};

class Stage {
public:
    Drawn draw(const Subject& subject, const Setup& setup, bool exact)
    {
        const UploadedScene scene =
            need(UploadedScene::upload(*gl_.device, exact ? setup.exact_scene : setup.scene));
        Frame frame = makeFrame(scene, SceneCamera(), kExtent);
        frame.camera = cameraOf(exact ? setup.exact_view : setup.view, kExtent);
        const Description description = describe(subject, setup, exact);
        const CompileOptions options = {kExtent, {"ao"}, {}};
        const SceneTraits traits = traitsOf(frame);
        const Result<Plan> plan = compile(description, traits, gl_.device->caps(), options);
        REQUIRE(plan.ok());
        auto& renderer = renderers_[subject.config + std::string(subject.geometry)];
        if (renderer)
            need(renderer->reload(description, options));
        else
            renderer = need(Renderer::create(*gl_.device, description, options, traits));
        need(renderer->render(frame));
        return {gl_.read(renderer->output("ao")), !plan.diagnostics().empty()};
    }

private:
    Description describe(const Subject& subject, const Setup& setup, bool exact)
    {
        ConfigOptions options;
        options.config = subject.config;
        options.variant = subject.variant;
        Description description =
            need(loadDescription(options, substitutes_.over(subject.geometry)));
        for (TargetDesc& target : description.targets) {
            if (formatInfo(target.formats[0]).format_class == FormatClass::depth) {
                if (exact) target.formats = {Format::depth32f};
                if (!exact && setup.depth != Format::none) target.formats = {setup.depth};
            }
            if (target.semantic == Semantic::view_position)
                target.formats = {exact ? Format::rgba32f : setup.colour};
            if (target.semantic == Semantic::view_depth)
                target.formats = {exact ? Format::r32f : setup.colour};
        }
        for (ParamDesc& param : description.params) {
            if (param.semantic == ParamSemantic::length)
                param.value[0] = static_cast<float>(setup.radius);
            else if (param.unit == "scene units")
                param.value[0] *= static_cast<float>(setup.unit);
        }
        return description;
    }

    GlFixture gl_;
    Substitutes substitutes_{shippedSources()};
    std::map<std::string, std::unique_ptr<Renderer>> renderers_;
};

struct Tally {
    int setups = 0, changed = 0, missed = 0, warned = 0, false_alarms = 0;

    double recall() const { return changed > 0 ? 1 - double(missed) / changed : 1; }
    // Among fewer than a hundred, one alone is no sign of less.
    bool tellsLess() const { return missed > std::max(1.0, (1 - kLeastRecall) * changed); }
    double falseShare() const { return warned > 0 ? double(false_alarms) / warned : 0; }
    void add(bool has_warned, bool has_changed, bool unchanged)
    {
        ++setups;
        changed += has_changed;
        missed += has_changed && !has_warned;
        warned += has_warned;
        false_alarms += has_warned && unchanged;
    }
    Tally& operator+=(const Tally& other)
    {
        setups += other.setups;
        changed += other.changed;
        missed += other.missed;
        warned += other.warned;
        false_alarms += other.false_alarms;
        return *this;
    }
};

void count(Stage& stage, const Subject& subject, const Setup& setup, Tally& tally)
{
    const Drawn exact = stage.draw(subject, setup, true);
    if (1 - mean(exact.ao) < kLeastExact) return;
    const Drawn drawn = stage.draw(subject, setup, false);
    const double change = meanChange(exact.ao, drawn.ao);
    tally.add(drawn.warned, change > kSameChange, change < kUnseenChange);
}

Tally tallyOf(Stage& stage, const Group& group, Random& random, int setups, std::size_t configs)
{
    Tally tally;
    for (int i = 0; i < setups; ++i) {
        const Subject& subject = group.subjects[i % std::min(configs, group.subjects.size())];
        const Setup setup = randomSetup(random, group.kind);
        count(stage, subject, setup, tally);
    }
    return tally;
}

void print(const char* name, const Tally& tally)
{
    std::printf("| %s | %d | %d | %s %% | %d | %s %% |\n", name, tally.setups, tally.changed,
                fixed(100 * tally.recall(), 1).c_str(), tally.warned,
                fixed(100 * tally.falseShare(), 1).c_str());
}

}  // namespace

TEST_CASE("What changes a picture is foretold, and little that does not")
{
    // By day few configs in fewer set-ups: compiling them takes longest.
    const std::size_t configs = nightly() ? 100 : 3;
    Stage stage;
    Random random(1);
    Tally all;
    for (const Group& group : groups()) {
        const Tally tally = tallyOf(stage, group, random, nightly() ? 600 : 40, configs);
        print(group.name, tally);
        CAPTURE(group.name, tally.changed, tally.missed, tally.warned, tally.false_alarms);
        CHECK(tally.changed >= 10);
        CHECK_FALSE(tally.tellsLess());
        all += tally;
    }
    print("all", all);
    CHECK_FALSE(all.tellsLess());
    CHECK(all.falseShare() < kMostFalse);
}
