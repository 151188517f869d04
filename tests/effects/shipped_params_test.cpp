// SPDX-License-Identifier: MIT
// Every param of every shipped config at values that cannot be, and at the ends of its range.
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "core/config/values.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <cmath>
#include <limits>

using namespace crevice;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What a param must not be, with the code that says so.
std::vector<std::pair<float, Code>> badValues(const ParamDesc& param)
{
    const auto low = static_cast<float>(param.min), high = static_cast<float>(param.max);
    std::vector<std::pair<float, Code>> bad = {
        {NAN, Code::not_finite},
        {kInfinity, Code::not_finite},
        {-kInfinity, Code::not_finite},
        {-std::numeric_limits<float>::max(), Code::out_of_range},
        {std::numeric_limits<float>::max(), Code::out_of_range},
        {std::nextafter(std::nextafter(low, -kInfinity), -kInfinity), Code::out_of_range},
        {std::nextafter(std::nextafter(high, kInfinity), kInfinity), Code::out_of_range}};
    if (param.type == ParamType::int_) bad.emplace_back(low + 0.5f, Code::out_of_range);
    return bad;
}

Status setAll(Renderer& renderer, const ParamDesc& param, float value)
{
    const std::vector<float> values(componentCount(param.type), value);
    return renderer.setParam(param.name, values.data(), static_cast<int>(values.size()));
}

}  // namespace

TEST_CASE("What no param of a shipped config may be is refused in every frame, and changes none")
{
    for (const Subject& subject : subjects()) {
        RecordingDevice device;
        Frame frame;
        frame.lights.resize(1);
        auto renderer =
            need(Renderer::create(device, descriptionOf(subject), {{64, 36}}, traitsOf(frame)));
        frame.camera_cut = true;
        need(renderer->render(frame));
        const int attempts = device.attempts();
        const Values before = valuesOf(renderer->description());
        const std::vector<ParamDesc> params = renderer->description().params;
        for (const ParamDesc& param : params) {
            for (const auto& [value, code] : badValues(param)) {
                INFO(subject.config << " " << subject.variant << " " << param.name << " " << value);
                const Status status = setAll(*renderer, param, value);
                REQUIRE(status.diagnostics().size() == 1);
                CHECK(status.diagnostics()[0].code == code);
                CHECK(status.diagnostics()[0].pointer == "/params/" + param.name);
                need(renderer->render(frame));
            }
        }
        CHECK(valuesOf(renderer->description()).params == before.params);
        CHECK(device.attempts() == attempts);
        CHECK(device.misuse().empty());
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
