// SPDX-License-Identifier: MIT
// What holds for every shipped config before any GL: it loads, plans, and stays short.
// What a user may change in a shipped config: every switch that it offers, and every format.
// Shipped configs on a device without memory: nothing is left behind, what worked works on,
// and the next try is as good as if nothing had failed.
// Plans of shipped configs compared with the approved ones in tests/data/plans: five as
// `crevice explain NAME` prints them, of all others what they run and take, a line each.
// With CREVICE_APPROVE=1 it takes the new plans as the approved ones.
#include <crevice/compile.h>
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "core/base/text.h"
#include "core/run/dirty_passes.h"
#include "tests/support/failing_changes.h"
#include "tests/support/need.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace crevice;
namespace fs = std::filesystem;

namespace {

/// Plans changes one at a time: all of them of sampled subjects and at night, else each that
/// another subject had not.
struct Changes {
    std::set<std::string> planned = {};

    void check(const Subject& subject, const Description& changed, const std::string& what)
    {
        const auto same = [&](const Subject& each) {
            return each.config == subject.config && each.variant == subject.variant;
        };
        const std::vector<Subject> whole = sampledSubjects();
        const bool is_new = planned.insert(what).second;
        if (!is_new && std::none_of(whole.begin(), whole.end(), same)) return;
        const Result<Plan> plan =
            compile(changed, usualTraits(), usualCaps(), {{256, 144}, {}, {}});
        INFO(subject.config << " " << subject.variant << ": " << what << "\n"
                            << toText(plan.diagnostics()));
        CHECK(plan.ok());
    }
};

constexpr Extent kExtent = {64, 36};

struct Bench {
    RecordingDevice device;
    Frame frame;

    Bench()
    {
        const MeshDesc mesh = {"mesh", std::vector<Vertex>(3), {0, 1, 2}};
        frame.draws = {{need(device.createMesh(mesh)), 0, 3, glm::dmat4(1.0), 0}};
        frame.materials.resize(1);
        frame.lights.resize(1);
    }

    std::string draw(Renderer& renderer, const Frame& shown)
    {
        device.clearLog();
        need(renderer.render(shown));
        return device.log();
    }

    Result<std::unique_ptr<Renderer>> make(const Description& description)
    {
        return Renderer::create(device, description, {kExtent}, traitsOf(frame));
    }
};

Plan planned(const std::string& name)
{
    const Description description = need(loadDescription({name, {}, {}, {}}, shippedSources()));
    return need(compile(description, usualTraits(), usualCaps(), {kUsualExtent}));
}

std::string inOneLine(const std::string& name)
{
    const Plan plan = planned(name);
    return name + ": " + std::to_string(plan.textures.size()) + " textures, " +
           fixed(plan.texture_bytes, 0) + " bytes; " + joined(namesOf(plan.passes)) + "\n";
}

void checkApproved(const std::string& name, const std::string& now)
{
    const fs::path path = fs::path(CREVICE_SOURCE_DIR) / "tests/data/plans" / (name + ".txt");
    if (std::getenv("CREVICE_APPROVE")) {
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << now;
    }
    std::ostringstream approved;
    approved << std::ifstream(path, std::ios::binary).rdbuf();
    std::istringstream lines(now), approved_lines(approved.str());
    std::string line, wanted;
    while (std::getline(lines, line) && std::getline(approved_lines, wanted) && line == wanted) {
    }
    INFO("in " << path << ", from this line on:\n- " << wanted << "\n+ " << line << "\n"
               << "where that was meant, run it with CREVICE_APPROVE=1, which approves it");
    CHECK((now == approved.str()));
}

}  // namespace

TEST_CASE("A still frame of a config without history runs no pass, and the last one new runs alone")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        SceneTraits traits;
        traits.lights = 1;
        const Plan plan =
            need(compile(descriptionOf({name}), traits, generousCaps(), {{256, 144}}));
        const bool remembers =
            std::any_of(plan.targets.begin(), plan.targets.end(),
                        [](const PlanTarget& each) { return each.history_texture >= 0; });
        if (remembers) continue;
        PassCache cache(plan);
        const auto runs = [&cache](const std::vector<char>& changed) {
            const std::vector<char>& chosen = cache.choose(changed);
            return std::count(chosen.begin(), chosen.end(), 1);
        };
        std::vector<char> changed(plan.passes.size(), 1);
        runs(changed);
        changed.assign(changed.size(), 0);
        CHECK(runs(changed) == 0);
        changed.back() = 1;
        CHECK(runs(changed) == 1);
    }
}

TEST_CASE("Every shipped config plans on a full and on a bare device")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Description description = descriptionOf({name});
        need(compile(description, usualTraits(), generousCaps(), {{256, 144}, {}, {}}));
        const bool float_positions = findNamed(description.targets, "position") != nullptr;
        const Result<Plan> result = compile(description, {}, minimumCaps(), {{64, 64}, {}, {}});
        CHECK(result.ok() == !float_positions);
        if (!result.ok()) CHECK(result.diagnostics().front().code == Code::no_format);
    }
}

TEST_CASE(
    "Every attachment of a shipped config is as large as its pass, on a device that wants it so")
{
    DeviceCaps caps = generousCaps();
    caps.equal_attachments = true;
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Plan plan = need(compile(descriptionOf({name}), {}, caps, {{256, 144}, {}, {}}));
        for (const PlanPass& pass : plan.passes) {
            std::vector<PlanAttachment> attachments = pass.color;
            if (pass.has_depth) attachments.push_back(pass.depth);
            for (const PlanAttachment& each : attachments) {
                if (each.target < 0) continue;
                const PlanTarget& target = plan.targets[each.target];
                CHECK(plan.textures[target.texture].extent == pass.extent);
                CHECK(plan.textures[target.drawn_texture].extent == pass.extent);
            }
        }
    }
}

TEST_CASE("Every config says what it is in 25 lines or fewer, and every param what it does")
{
    for (const std::string& name : configNames(shippedSources())) {
        const std::string& text = shippedSources().find("configs/" + name + ".json")->text;
        const Description description = descriptionOf({name});
        INFO(name);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 25);
        CHECK(description.name == name);
        CHECK(!description.text.empty());
        for (const ParamDesc& param : description.params) {
            INFO(param.name);
            CHECK(!param.tooltip.empty());
            CHECK(!param.unit.empty());
        }
    }
}

TEST_CASE("Every feature that a shipped file declares says what it is called and does")
{
    for (const std::string& path : shippedSources().list()) {
        if (!endsWith(path, ".json")) continue;
        const Node document = need(parseDocument(shippedSources().find(path)));
        const Node* features = document.find("features");
        for (const Member& feature : features ? features->members : std::vector<Member>()) {
            if (!feature.value.find("type")) continue;  // a default of another file's
            INFO(path << " " << feature.key);
            CHECK(feature.value.find("label"));
            CHECK(feature.value.find("tooltip"));
        }
    }
}

TEST_CASE("Shipped configs with the least and the most of every count fit, or lack uniforms alone")
{
    for (const Subject& subject : subjects()) {
        for (const bool most : {false, true}) {
            INFO(subject.config << " " << subject.variant << (most ? " most" : " least"));
            const Description description = withCounts(descriptionOf(subject), most);
            const CompileOptions options = {{64, 36}};
            need(compile(description, usualTraits(), generousCaps(), options));
            const Result<Plan> usual = compile(description, usualTraits(), usualCaps(), options);
            if (usual) continue;
            CHECK(most);
            for (const Diagnostic& each : usual.diagnostics())
                if (each.severity == Severity::error) CHECK(each.pointer == "/params/samples");
        }
    }
}

TEST_CASE("Every switch that a shipped config offers can be turned to all its values")
{
    Changes changes;
    for (const Subject& subject : subjects()) {
        Description description = descriptionOf(subject);
        for (FeatureDesc& feature : description.features) {
            const int before = feature.value;
            for (std::size_t value = 0; value < feature.values.size(); ++value) {
                feature.value = static_cast<int>(value);
                changes.check(subject, description, feature.name + " " + feature.values[value]);
            }
            feature.value = before;
        }
    }
}

TEST_CASE("Every colour target of a shipped config may have another format")
{
    Changes changes;
    for (const Subject& subject : subjects()) {
        Description description = descriptionOf(subject);
        for (TargetDesc& target : description.targets) {
            const std::vector<Format> before = target.formats;
            if (formatInfo(before.front()).format_class == FormatClass::depth) continue;
            for (const Format format : {Format::r8, Format::r16f, Format::rgba8, Format::rgba16f}) {
                target.formats = {format};
                changes.check(subject, description, target.name + " as " + formatInfo(format).name);
            }
            target.formats = before;
        }
    }
}

TEST_CASE(
    "Shipped configs and variants that lack any object leave none behind, and draw with the next "
    "try")
{
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << " " << subject.variant);
        const Description description = descriptionOf(subject);
        Bench bench, other;
        std::unique_ptr<Renderer> renderer;
        const auto create = [&]() -> Status {
            auto made = bench.make(description);
            if (made) renderer = std::move(*made);
            return made.diagnostics();
        };
        CHECK(failEachObject(bench.device, create, [] {}) > 5);
        auto never_failed = need(other.make(description));
        CHECK(bench.draw(*renderer, bench.frame) == other.draw(*never_failed, other.frame));
        CHECK(bench.device.misuse().empty());
    }
}

TEST_CASE("The plan of every shipped config is the approved one")
{
    const std::vector<std::string> whole = {"balanced_temporal", "gtao", "high", "learnopengl",
                                            "mobile"};
    std::string others;
    for (const std::string& name : configNames(shippedSources()))
        if (!contains(whole, name)) others += inOneLine(name);
    for (const std::string& name : whole) checkApproved(name, toText(planned(name)));
    checkApproved("others", others);
}
