// SPDX-License-Identifier: MIT
// Baked effects: that their plans are those of the configs, what is said of what is not in them,
// and that no bytes do harm.
#include <crevice/baked.h>
#include <crevice/compile.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "core/bake/pack.h"
#include "core/bake/records.h"
#include "core/config/values.h"
#include "tests/support/baked.h"
#include "tests/support/renderer_rig.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <random>

using namespace crevice;

namespace {

BakeOptions usualBake()
{
    BakeOptions options;
    options.scene = usualTraits();
    return options;
}

/// The plan as text, without the keys of programs, whose texts differ.
std::string planText(const Description& description, const SceneTraits& traits,
                     const DeviceCaps& caps, const CompileOptions& options)
{
    Plan plan = need(compile(description, traits, caps, options));
    for (PlanProgram& program : plan.programs) program.key = program.label;
    return toText(plan);
}

/// What devices and cameras differ in: formats, sizes of textures, samples, steps of depth.
std::vector<DeviceCaps> devices()
{
    std::vector<DeviceCaps> all = {usualCaps(), usualCaps(), usualCaps()};
    all[1].equal_attachments = true;
    for (const Format format : {Format::rgb10_a2, Format::r16f, Format::rgba16f})
        all[1].renderable[static_cast<int>(format)] = false;
    all[2].max_texture_size = 1024;  // in which the guard band ends
    for (std::uint32_t& counts : all[2].sample_counts) counts = 1u << 1;
    return all;
}

std::vector<SceneTraits> cameras()
{
    std::vector<SceneTraits> all(3, usualTraits());
    all[1].camera = {0.1, 1e6, 1.7};
    all[2].camera = {10, 500, 40};
    all[2].views = 2;
    return all;
}

/// On each device with another camera and size; `all`: each with each.
void checkPlans(const Description& config, const Description& baked, bool all)
{
    const std::vector<Extent> sizes = {{960, 540}, {37, 1001}, {1200, 700}};
    for (std::size_t i = 0; i < (all ? 27 : 3); ++i) {
        const DeviceCaps caps = devices()[i % 3];
        const SceneTraits traits = cameras()[all ? i / 3 % 3 : i];
        const CompileOptions options = {sizes[all ? i / 9 : i]};
        if (compile(config, traits, caps, options))  // some devices have no format of positions
            CHECK(planText(config, traits, caps, options) ==
                  planText(baked, traits, caps, options));
    }
}

/// Both, with every param that is no define at other values, and back.
void checkParams(Description config, Description baked)
{
    for (std::size_t i = 0; i < config.params.size(); ++i) {
        const ParamDesc& param = config.params[i];
        const std::array<float, 4> before = param.value;
        std::set<float> values = {static_cast<float>(param.min), static_cast<float>(param.max)};
        for (const PassDesc& pass : config.passes)
            for (const NoOpDesc& no_op : pass.no_op)
                if (no_op.name == param.name) values.insert(no_op.at);
        for (const float value : values) {
            INFO(param.name << " " << value);
            if (std::abs(value) > 64 && param.bind == Bind::define) continue;
            config.params[i].value = baked.params[i].value = {value, value, value, value};
            const CompileOptions options = {{256, 144}};
            if (compile(config, usualTraits(), usualCaps(), options))
                CHECK(planText(config, usualTraits(), usualCaps(), options) ==
                      planText(baked, usualTraits(), usualCaps(), options));
        }
        config.params[i].value = baked.params[i].value = before;
    }
}

Result<Plan> planned(const Description& description, SceneTraits traits = usualTraits())
{
    return compile(description, traits, usualCaps(), {{256, 144}});
}

std::string firstOf(const Diagnostics& diagnostics)
{
    return diagnostics.empty() ? "" : toText(diagnostics.front());
}

/// Draws what can be read of the bytes; what cannot must be an error.
void drawHostile(const std::string& bytes)
{
    const auto baked = readBaked(bytes.data(), bytes.size());
    if (!baked) {
        CHECK(hasErrors(baked.diagnostics()));
        return;
    }
    for (const BakedConfig& each : *baked) {
        RecordingDevice device;
        Frame frame;
        frame.lights.resize(1);
        auto renderer = Renderer::create(device, each.description, {{64, 36}}, traitsOf(frame));
        if (renderer) (void)(*renderer)->render(frame);
        renderer = Diagnostic{};
        CHECK(device.misuse().empty());
        CHECK(device.live() == 0);
    }
}

/// With the checksum of what it holds now, so that reading goes on behind it.
std::string sealed(std::string bytes)
{
    ContentHash hash;
    hash.addBytes(bytes.data() + kHeaderBytes, bytes.size() - kHeaderBytes);
    const std::uint64_t value = hash.value();
    std::memcpy(&bytes[kHeaderBytes - sizeof value], &value, sizeof value);
    return bytes;
}

std::string packedFile(const std::string& records)
{
    const std::string packed = pack(records);
    const auto count = static_cast<std::uint32_t>(records.size());
    const std::uint64_t words = vocabulary();
    std::string bytes(kMagic, sizeof kMagic);
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(&words), sizeof words);
    return sealed(bytes + std::string(8, '\0') + packed);
}

}  // namespace

TEST_CASE("A baked effect plans as its config does: devices, cameras, sizes, views")
{
    for (const Subject& subject : subjects()) {
        INFO(subject.config << " " << subject.variant);
        const Description config = descriptionOf(subject);
        checkPlans(config, throughBytes(config, usualBake()), nightly());
    }
}

TEST_CASE("A baked effect plans as its config does at every param's ends and no-ops")
{
    for (const Subject& subject : sampledSubjects()) {
        INFO(subject.config << " " << subject.variant);
        const Description config = descriptionOf(subject);
        checkParams(config, throughBytes(config, usualBake()));
    }
}

TEST_CASE("A baked effect has what was listed, and names what was not")
{
    const Description config = descriptionOf({"mobile"});
    BakeOptions options = usualBake();
    options.values = {{"display", {"lit", "ao_only"}}};
    options.traits = {{"camera.reversed_depth", {"false", "true"}}};
    Description baked = throughBytes(config, options);
    const int display = indexOf(baked.features, "display");
    REQUIRE(display >= 0);
    for (const int word : {0, 2}) {
        baked.features[static_cast<std::size_t>(display)].value = word;
        SceneTraits reversed = usualTraits();
        reversed.reversed_depth = true;
        CHECK(planned(baked).ok());
        CHECK(planned(baked, reversed).ok());
    }
    baked.features[static_cast<std::size_t>(display)].value = 1;
    const auto missing = planned(baked);
    REQUIRE_FALSE(missing);
    CHECK(firstOf(missing.diagnostics()) ==
          "error CV2301: 'mobile' was not baked for display no_ao, but for display lit or ao_only\n"
          "  help: bake it with --values display=lit,ao_only,no_ao --trait "
          "camera.reversed_depth=false,true\n");
    SceneTraits turned = usualTraits();
    turned.orthographic = true;
    baked.features[static_cast<std::size_t>(display)].value = 0;
    CHECK(has(firstOf(planned(baked, turned).diagnostics()),
              "--trait camera.orthographic=false,true"));
    CHECK(has(firstOf(compile(baked, usualTraits(), usualCaps(), {{64, 64}, {"ao"}}).diagnostics()),
              "bake it with --output ao"));
}

TEST_CASE("Words of a level that are baked are set as in the config")
{
    Description config = descriptionOf({"quality"});
    BakeOptions options = usualBake();
    options.values = {{"quality", {"low", "medium", "high"}}};
    Description baked = throughBytes(config, options);
    for (const int word : {1, 2, 3})
        for (Description* each : {&config, &baked}) {
            each->features[static_cast<std::size_t>(indexOf(each->features, "quality"))].value =
                word;
            applyLevel(*each, "quality");
            if (each == &baked)
                CHECK(planText(config, usualTraits(), usualCaps(), {{256, 144}}) ==
                      planText(baked, usualTraits(), usualCaps(), {{256, 144}}));
        }
}

TEST_CASE("Baking is the same each time, and says what cannot be baked")
{
    const Description config = descriptionOf({"mobile_low"});
    CHECK(bakedBytes(config, usualBake()) == bakedBytes(config, usualBake()));
    const auto refused = [&](const BakeOptions& options) {
        const auto bytes = bake({{"mobile_low", {}, 0, 0, config}}, options);
        REQUIRE_FALSE(bytes);
        return firstOf(bytes.diagnostics());
    };
    BakeOptions options = usualBake();
    options.values = {{"displai", {"lit"}}};
    CHECK(has(refused(options), "did you mean 'display'?"));
    options.values = {{"display", {"lti"}}};
    CHECK(has(refused(options), "did you mean 'lit'?"));
    options.values = {{"steps", {"many"}}};
    CHECK(has(refused(options), "no value of param 'steps'"));
    options.values = {{"steps", {"100000"}}};
    CHECK(has(refused(options), "CV4001"));
    options.values = {};
    options.traits = {{"camera.orthographc", {"true"}}};
    CHECK(has(refused(options), "did you mean 'camera.orthographic'?"));
    options.traits = {{"camera.orthographic", {"2"}}};
    CHECK(has(refused(options), "write true or false"));
    options.traits = {};
    options.outputs = {"a0"};
    CHECK(has(refused(options), "CV2209"));
}

TEST_CASE("Values that decide nothing are named when an effect is baked")
{
    BakeOptions options = usualBake();
    options.values = {{"radius", {"1", "2"}}, {"display", {"lit"}}};
    const auto bytes = bake({{"mobile", {}, 0, 0, descriptionOf({"mobile"})}}, options);
    REQUIRE(bytes);
    REQUIRE(bytes.diagnostics().size() == 1);
    CHECK(has(firstOf(bytes.diagnostics()), "'radius' decides no plan of 'mobile'"));
}

TEST_CASE("What is packed comes back")
{
    std::mt19937 random(7);
    for (const std::size_t size : {0, 1, 3, 4, 5, 100, 70000}) {
        std::string bytes;
        while (bytes.size() < size)
            bytes += random() % 3 == 0 ? std::string(random() % 40, 'a')
                                       : std::string(1, static_cast<char>(random() % 5));
        const std::string packed = pack(bytes);
        CHECK(unpack(packed, bytes.size()) == bytes);
        CHECK((bytes.size() < 100 || packed.size() < bytes.size()));
        if (size > 4) CHECK_FALSE(unpack(packed, bytes.size() - 1).has_value());
        CHECK_FALSE(unpack(packed, bytes.size() + 1).has_value());
    }
}

TEST_CASE("Bytes that are no baked effect are errors")
{
    const std::string bytes = bakedBytes(descriptionOf({"mobile_low"}), usualBake());
    const auto code = [](const std::string& read) {
        const auto baked = readBaked(read.data(), read.size());
        return baked ? Code{} : baked.diagnostics().front().code;
    };
    CHECK(readBaked(bytes.data(), bytes.size()).ok());
    CHECK(readBaked(nullptr, 7).diagnostics().front().code == Code::baked_broken);
    CHECK(code("") == Code::baked_broken);
    CHECK(code("{\"format\": 1}") == Code::baked_broken);
    std::string other = bytes;
    other[7] = '9';
    CHECK(code(other) == Code::baked_version);
    other = bytes;
    other[13] ^= 1;
    CHECK(code(other) == Code::baked_version);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97)
        CHECK(code(bytes.substr(0, size)) == Code::baked_broken);
    for (std::size_t at = kHeaderBytes; at < bytes.size(); at += 1 + bytes.size() / 97) {
        other = bytes;
        other[at] ^= 0x10;
        CHECK(code(other) == Code::baked_broken);
    }
    CHECK(code(bytes + "x") == Code::baked_broken);
}

TEST_CASE("Bytes of a baked effect that were changed, checksum and all, do no harm")
{
    std::mt19937 random(11);
    for (const char* config :
         {"mobile+geometry/host_depth", "balanced_temporal", "baked", "vxao"}) {
        const std::string bytes =
            bakedBytes(need(decode(need(loadConfig(shippedSources(), {config})), shippedSources())),
                       usualBake());
        std::uint32_t count = 0;
        std::memcpy(&count, &bytes[8], sizeof count);
        const std::string records = *unpack(std::string_view(bytes).substr(kHeaderBytes), count);
        const int times = nightly() ? 25000 : 400;
        for (int i = 0; i < times; ++i) {
            std::string changed = i % 4 == 0 ? bytes : records;
            const std::size_t from = i % 4 == 0 ? kHeaderBytes : 0;
            for (unsigned flips = 1 + random() % 3; flips > 0; --flips) {
                const std::size_t at = from + random() % (changed.size() - from);
                const unsigned how = random() % 4;
                if (how == 0) changed[at] = static_cast<char>(random());
                if (how == 1) changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
                if (how == 2) changed.erase(at, 1 + random() % 3);
                if (how == 3) changed.insert(at, 1, static_cast<char>(random() % 256));
            }
            drawHostile(i % 4 == 0 ? sealed(changed) : packedFile(changed));
        }
    }
}
