// SPDX-License-Identifier: MIT
// Faults in what a plan's passes tell the device, which is all that compile and run come to: stress
// finds them. Faults in shaders are planted by tests/faults/shaders.sh.
#include "tests/support/catch.h"
#include "tests/support/gl_fixture.h"

#include "tools/measure/stress/run.h"
#include "tools/render/device/forwarding_device.h"

#include <crevice/shipped.h>

#include <cstring>
#include <functional>
#include <set>

using namespace crevice;

namespace {

/// Departs from what it is told wherever a fault is set.
class FaultyDevice : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;

    std::function<void(PassInfo&)> pass = [](PassInfo&) {};
    std::function<void(StateDesc&)> state = [](StateDesc&) {};
    std::function<void(SamplerDesc&)> sampler = [](SamplerDesc&) {};
    std::function<void(TextureDesc&)> texture = [](TextureDesc&) {};
    std::string uniform;  ///< `change` is done to its floats.
    std::function<void(float*, int)> change = [](float*, int) {};
    bool first_only = false;  ///< The second sampler reads the first one's texture.

    Result<TextureId> createTexture(const TextureDesc& desc) override
    {
        TextureDesc changed = desc;
        texture(changed);
        return device_.createTexture(changed);
    }
    void beginPass(const PassInfo& info) override
    {
        PassInfo changed = info;
        pass(changed);
        device_.beginPass(changed);
    }
    void setProgram(ProgramId id, const StateDesc& desc) override
    {
        program_ = id;
        StateDesc changed = desc;
        state(changed);
        device_.setProgram(id, changed);
    }
    void setTexture(int location, int unit, TextureId id, const SamplerDesc& desc) override
    {
        SamplerDesc changed = desc;
        sampler(changed);
        if (unit == 0) first_ = id;
        device_.setTexture(location, unit, first_only && unit < 2 ? first_ : id, changed);
    }
    void setUniform(int location, GlslType type, int count, const void* data) override
    {
        for (const UniformInfo& info : device_.uniforms(program_)) {
            if (info.location != location || info.name != uniform) continue;
            const int floats = type == GlslType::mat4 ? 16 : 1;
            std::vector<float> values(floats);
            std::memcpy(values.data(), data, floats * sizeof(float));
            change(values.data(), floats);
            return device_.setUniform(location, type, count, values.data());
        }
        device_.setUniform(location, type, count, data);
    }

private:
    ProgramId program_ = {};
    TextureId first_ = {};
};

/// Cases that fail on the device, in the quick subset.
std::set<std::string> failing(Device& device)
{
    StressOptions options;
    options.configs = {"gtao"};
    options.quick = true;
    options.cases = {"offset", "near_far", "plane_grazing", "views", "meshes"};
    const std::vector<StressTask> tasks = need(planStress(options, shippedSources()));
    StressRunner meter(device, shippedSources(), "");
    std::vector<StressRecord> records;
    for (const StressTask& task : tasks) {
        records.push_back(meter.measure(task, {96, 54}).record);
        records.back().key = stepTitle(task);
    }
    std::set<std::string> names;
    for (const StressSeries& series : seriesOf(records))
        if (findBreakdown(*series.stress, series.steps).failures > 0)
            names.insert(series.stress->name);
    return names;
}

struct DeviceFault {
    const char* what;
    std::function<void(FaultyDevice&)> plant;
};

/// Every uniform of that name keeps the first value that it was given.
void stick(FaultyDevice& device, const char* uniform)
{
    device.uniform = uniform;
    device.change = [first = std::vector<float>()](float* values, int count) mutable {
        if (first.empty()) first.assign(values, values + count);
        std::copy(first.begin(), first.end(), values);
    };
}

const DeviceFault kFaults[] = {
    {"clears left out",
     [](FaultyDevice& device) {
         device.pass = [](PassInfo& pass) {
             pass.depth_load = LoadOp::discard;
             for (LoadOp& load : pass.color_load) load = LoadOp::discard;
         };
     }},
    {"depth cleared to near",
     [](FaultyDevice& device) { device.pass = [](PassInfo& pass) { pass.clear_depth = 0.5f; }; }},
    {"no depth test",
     [](FaultyDevice& device) {
         device.state = [](StateDesc& state) { state.depth_test = Compare::always; };
     }},
    {"front faces culled",
     [](FaultyDevice& device) {
         device.state = [](StateDesc& state) { state.cull = Cull::front; };
     }},
    {"half of the pass's area",
     [](FaultyDevice& device) {
         device.pass = [](PassInfo& pass) {
             pass.within_area = true;
             pass.area = {0, 0, {(pass.extent.width + 1) / 2, pass.extent.height}};
         };
     }},
    {"depth in 16 bits",
     [](FaultyDevice& device) {
         device.texture = [](TextureDesc& texture) {
             if (formatInfo(texture.format).format_class == FormatClass::depth)
                 texture.format = Format::depth16;
         };
     }},
    {"a sampler reads another's texture", [](FaultyDevice& device) { device.first_only = true; }},
    {"radius stuck at its first value", [](FaultyDevice& device) { stick(device, "radius"); }},
    {"camera stuck at its first place",
     [](FaultyDevice& device) { stick(device, "clip_from_model"); }},
    {"intensity halved",
     [](FaultyDevice& device) {
         device.uniform = "intensity";
         device.change = [](float* values, int) { *values *= 0.5f; };
     }},
};

}  // namespace

TEST_CASE("Stress finds faults in what passes tell the device")
{
    GlFixture gl;
    const std::set<std::string> ordinary = failing(*gl.device);
    REQUIRE(ordinary.count("offset") + ordinary.count("near_far") == 0);
    for (const DeviceFault& fault : kFaults) {
        FaultyDevice faulty(*gl.device);
        fault.plant(faulty);
        std::string found;
        for (const std::string& name : failing(faulty))
            if (ordinary.count(name) == 0) found += " " + name;
        INFO(fault.what);
        CHECK(found != "");
    }
}
