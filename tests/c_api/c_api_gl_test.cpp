// SPDX-License-Identifier: MIT
// The C API beside the C++ facade, in one context: the same pictures, bit for bit.
#include <crevice/effect.h>

#include "tests/c_api/c_api.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <map>

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
    explicit Host(float step = 0.01f, crevice_device_desc desc = {})
    {
        std::vector<float> steps;
        for (int i = 0; i < kExtent.width * kExtent.height; ++i)
            steps.push_back(0.9f + step * static_cast<float>(i / 8 % 5));
        depth = depthTexture(gl, kExtent, steps);
        desc.struct_size = sizeof desc;
        desc.loader = find;
        desc.user = &testContext();
        need(crevice_device_create(&desc, &c_device));
    }
    ~Host()
    {
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

    /// An effect of the C API that has drawn the depth with radius 1.
    crevice_effect* drawn(const char* config, const char* folder = nullptr) const
    {
        crevice_effect_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.config = config;
        desc.folder = folder;
        desc.width = kExtent.width;
        desc.height = kExtent.height;
        crevice_effect* effect = nullptr;
        need(crevice_effect_create(c_device, &desc, &effect));
        const crevice_texture given = texture();
        const float radius = 1;
        need(crevice_effect_set_projection(effect, glm::value_ptr(projection)));
        need(crevice_effect_set_texture(effect, "depth", &given));
        need(crevice_effect_set_param(effect, "radius", &radius, 1));
        need(crevice_effect_render(effect));
        return effect;
    }

    std::vector<float> pixelsOf(const crevice_effect* effect) const
    {
        std::vector<float> pixels(kExtent.width * kExtent.height);
        need(crevice_effect_read_output(effect, "ao", pixels.data(), pixels.size()));
        return pixels;
    }

    /// What a view's AO is in a texture of the host's.
    std::vector<float> presented(crevice_effect* effect, int view)
    {
        const TextureId into = GlFixture::texture(Format::r8, kExtent);
        auto target = sized<crevice_target>();
        target.texture = device->nativeName(into);
        target.width = kExtent.width;
        target.height = kExtent.height;
        target.view = view;
        need(crevice_effect_present(effect, "ao", &target));
        std::vector<float> pixels = read(into).pixels;
        device->destroy(into);
        return pixels;
    }

    /// Draws with the C API and gives the pixels.
    std::vector<float> draw(const char* config, const char* folder = nullptr) const
    {
        crevice_effect* effect = drawn(config, folder);
        std::vector<float> pixels = pixelsOf(effect);
        crevice_effect_destroy(effect);
        return pixels;
    }

    /// Draws the same with the C++ facade.
    std::vector<float> drawByFacade()
    {
        Effect effect = crevice::need(Effect::create(*device, kConfig, kExtent));
        effect.setProjection(glm::value_ptr(projection));
        crevice::need(effect.setTexture("depth", depth, Format::depth32f, kExtent));
        crevice::need(effect.setParam("radius", 1));
        crevice::need(effect.render());
        return read(effect.output("ao")).pixels;
    }

    glm::mat4 projection = glm::perspective(glm::radians(60.0f), 16.0f / 9.0f, 0.1f, 100.0f);
    GLuint depth = 0;
    crevice_device* c_device = nullptr;
};

}  // namespace

TEST_CASE("The C API draws what the C++ facade draws, bit for bit")
{
    Host host;
    const std::vector<float> pixels = host.draw(kConfig);
    CHECK(*std::min_element(pixels.begin(), pixels.end()) < 0.9f);
    CHECK(pixels == host.drawByFacade());
}

TEST_CASE("Two views of the C API give what two effects give, bit for bit")
{
    Host left, right(0.02f);
    const std::vector<float> wanted = right.draw(kConfig);
    crevice_effect* effect = left.drawn(kConfig);
    const std::vector<float> first = left.pixelsOf(effect);
    CHECK(first != wanted);
    auto view = sized<crevice_view>();
    std::copy_n(glm::value_ptr(left.projection), 16, view.clip_from_view);
    need(crevice_effect_set_views(effect, &view, 1));
    const crevice_texture depth = right.texture();
    need(crevice_effect_set_view_texture(effect, 1, "depth", &depth));
    need(crevice_effect_render(effect));
    CHECK(left.pixelsOf(effect) == first);
    CHECK(left.presented(effect, 1) == wanted);
    CHECK(left.presented(effect, 0) == first);
    crevice_effect_destroy(effect);
}

TEST_CASE("The C API reads modules and configs in a folder of the host's own")
{
    const TemporaryFolder folder("c_api");
    folder.write("configs/mine.json", kConfig);
    Host host;
    const std::vector<float> pixels = host.draw("mine", folder.path.string().c_str());
    CHECK(pixels == host.draw(kConfig));
}

TEST_CASE("The C API reloads a file that was edited and keeps what was set")
{
    const TemporaryFolder folder("c_api_reload");
    const std::string file = folder.write("ao.json", kConfig);
    Host host;
    crevice_effect* effect = host.drawn(file.c_str());
    const std::vector<float> before = host.pixelsOf(effect);
    std::string edited = kConfig;
    folder.write("ao.json", edited.insert(edited.rfind('}'), R"(, "params": {"intensity": 2})"));
    need(crevice_effect_reload(effect, nullptr));
    need(crevice_effect_render(effect));
    CHECK(host.pixelsOf(effect) != before);
    crevice_param param = {};
    param.struct_size = sizeof param;
    float radius = 0;
    for (int i = 0; i < crevice_effect_param_count(effect); ++i) {
        need(crevice_effect_get_param(effect, i, &param));
        if (std::string(param.name) == "radius") radius = param.value[0];
    }
    CHECK(radius == 1);
    crevice_effect_destroy(effect);
}

TEST_CASE("The C API keeps programs where the host says")
{
    static std::map<std::string, std::vector<char>> kept;
    static int loaded = 0;
    kept.clear();
    loaded = 0;
    crevice_device_desc desc = {};
    desc.cache_load = [](const char* key, std::size_t* count, void*) -> const void* {
        const auto found = kept.find(key);
        if (found == kept.end()) return nullptr;
        ++loaded;
        *count = found->second.size();
        return found->second.data();
    };
    desc.cache_store = [](const char* key, const void* bytes, std::size_t count, void*) {
        const char* begin = static_cast<const char*>(bytes);
        kept[key] = std::vector<char>(begin, begin + count);
    };
    const std::vector<float> first = Host(0.01f, desc).draw(kConfig);
    const int loaded_first = loaded;
    const std::vector<float> second = Host(0.01f, desc).draw(kConfig);
    CHECK(first == second);
    CHECK(loaded - loaded_first >= static_cast<int>(kept.size()));
}

TEST_CASE("An exception of a host's callback is an error of the C API, and leaves no function")
{
    crevice_device_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.loader = [](const char*, void*) -> void* { throw 7; };
    crevice_device* device = nullptr;
    CHECK(codeOf(crevice_device_create(&desc, &device)) == static_cast<int>(Code::out_of_memory));
    CHECK(device == nullptr);
}

TEST_CASE("An effect of an abandoned device gives CV6016 and may be destroyed after it")
{
    Host host;
    crevice_effect* effect = host.drawn(kConfig);
    crevice_device_abandon(host.c_device);
    CHECK(codeOf(crevice_effect_render(effect)) == static_cast<int>(Code::context_lost));
    crevice_device_destroy(host.c_device);
    host.c_device = nullptr;
    crevice_effect_destroy(effect);
}
