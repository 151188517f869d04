// SPDX-License-Identifier: MIT
// The C API beside the C++ facade, in one context: the same pictures, bit for bit.
#include <crevice/effect.h>

#include "tests/c_api/c_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace {

constexpr Extent kExtent = {64, 36};

const char* const kConfig = R"({ "format": 1, "name": "ao",
    "extends": ["geometry/host_depth", "ssao/gtao", "filter/bilateral_normal"] })";

void* find(const char* name, void* context)
{
    return static_cast<Context*>(context)->loader()(name);
}

/// Steps of depth, as a host's texture, and a device of either API.
struct Host : GlFixture {
    explicit Host(crevice_device_desc desc = {})
    {
        std::vector<float> steps;
        for (int i = 0; i < kExtent.width * kExtent.height; ++i)
            steps.push_back(0.9f + 0.01f * static_cast<float>(i / 8 % 5));
        depth = depthTexture(gl, kExtent, steps);
        desc.struct_size = sizeof desc;
        desc.loader = find;
        desc.user = &testContext();
        need(crevice_device_create(&desc, &c_device));
    }
    ~Host()
    {
        crevice_effect_destroy(effect);
        crevice_device_destroy(c_device);
        gl.DeleteTextures(1, &depth);
    }

    crevice_texture texture() const
    {
        auto made = sized<crevice_texture>();
        made.name = depth;
        made.format = "depth32f";
        made.width = kExtent.width;
        made.height = kExtent.height;
        return made;
    }

    /// What an effect of the C API draws of the depth with radius 1.
    std::vector<float> draw(const char* config = kConfig, const char* folder = nullptr)
    {
        auto desc = sized<crevice_effect_desc>();
        desc.config = config;
        desc.folder = folder;
        desc.width = kExtent.width;
        desc.height = kExtent.height;
        crevice_effect_destroy(effect);
        need(crevice_effect_create(c_device, &desc, &effect));
        const crevice_texture given = texture();
        const float radius = 1;
        need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
        need(crevice_effect_set_texture(effect, "depth", &given));
        need(crevice_effect_set_param(effect, "radius", &radius, 1));
        return drawAgain();
    }

    std::vector<float> drawAgain() const
    {
        need(crevice_effect_render(effect));
        std::vector<float> pixels(kExtent.width * kExtent.height);
        need(crevice_effect_read_output(effect, "ao", pixels.data(), pixels.size()));
        return pixels;
    }

    glm::mat4 projection = glm::perspective(glm::radians(60.0f), 16.0f / 9.0f, 0.1f, 100.0f);
    GLuint depth = 0;
    crevice_device* c_device = nullptr;
    crevice_effect* effect = nullptr;
};

}  // namespace

TEST_CASE("The C API draws what the C++ facade draws, bit for bit")
{
    Host host;
    const std::vector<float> pixels = host.draw();
    CHECK(*std::min_element(pixels.begin(), pixels.end()) < 0.9f);
    Effect effect = need(Effect::create(*host.device, kConfig, kExtent));
    effect.setProjection(glm::value_ptr(host.projection));
    need(effect.setTexture("depth", host.depth, Format::depth32f, kExtent));
    need(effect.setParam("radius", 1));
    need(effect.render());
    CHECK(pixels == host.read(effect.output("ao")).pixels);
}

TEST_CASE("The C API reads configs in a folder of the host's, and an edited file again")
{
    const TemporaryFolder folder("c_api");
    const std::string file = folder.write("configs/mine.json", kConfig);
    Host host;
    const std::vector<float> before = host.draw("mine", folder.path.string().c_str());
    CHECK(before == host.draw());
    CHECK(before == host.draw(file.c_str()));
    std::string edited = kConfig;
    edited.insert(edited.rfind('}'), R"(, "params": {"intensity": 2})");
    folder.write("configs/mine.json", edited);
    need(crevice_effect_reload(host.effect, nullptr));
    CHECK(host.drawAgain() != before);
    auto param = sized<crevice_param>();
    float radius = 0;
    for (int i = 0; i < crevice_effect_param_count(host.effect); ++i) {
        need(crevice_effect_get_param(host.effect, i, &param));
        if (std::string(param.name) == "radius") radius = param.value[0];
    }
    CHECK(radius == 1);  // what was set is kept
}

TEST_CASE("The C API keeps programs where the host says")
{
    struct Kept {
        std::map<std::string, std::vector<char>> programs;
        std::size_t loaded = 0;
    } kept;
    crevice_device_desc desc = {};
    desc.cache_user = &kept;
    desc.cache_load = [](const char* key, std::size_t* count, void* user) -> const void* {
        Kept& all = *static_cast<Kept*>(user);
        const auto found = all.programs.find(key);
        if (found == all.programs.end()) return nullptr;
        ++all.loaded;
        *count = found->second.size();
        return found->second.data();
    };
    desc.cache_store = [](const char* key, const void* bytes, std::size_t count, void* user) {
        const char* begin = static_cast<const char*>(bytes);
        static_cast<Kept*>(user)->programs[key] = std::vector<char>(begin, begin + count);
    };
    const std::vector<float> first = Host(desc).draw();
    const std::size_t loaded_first = kept.loaded;
    CHECK(first == Host(desc).draw());
    CHECK(kept.loaded - loaded_first >= kept.programs.size());
}

TEST_CASE("An exception of a host's callback is an error of the C API, and leaves no function")
{
    auto desc = sized<crevice_device_desc>();
    desc.loader = [](const char*, void*) -> void* { throw 7; };
    crevice_device* device = nullptr;
    CHECK(codeOf(crevice_device_create(&desc, &device)) == static_cast<int>(Code::out_of_memory));
    CHECK(device == nullptr);
}
