// SPDX-License-Identifier: MIT
// Structs of other versions, as programs have them that were built with another header: cut short
// at every size, and longer than this library's.
#include "tests/c_api/c_scene.h"
#include "tests/support/watched_gl.h"

#include <cstddef>
#include <cstring>
#include <functional>

using namespace crevice;

namespace {

constexpr char kGarbage = '\xAA';
constexpr std::size_t kLonger = 40, kLargest = 4096, kFirst = sizeof(std::size_t);

#define END(type, member) (offsetof(type, member) + sizeof(type::member))

/// A struct in memory of its own, where `behind` bytes of garbage follow it.
std::unique_ptr<char[]> memoryOf(std::size_t size, std::size_t behind)
{
    const std::size_t bytes = std::max(size, kFirst) + behind;
    std::unique_ptr<char[]> memory(new char[bytes]);
    std::memset(memory.get(), kGarbage, bytes);
    std::memcpy(memory.get(), &size, kFirst);
    return memory;
}

bool possible(std::size_t size) { return size > kFirst && size <= kLargest && size % kFirst == 0; }

/// A struct that is handed over.
struct Taken {
    template <class Struct, class Call>
    Taken(const Struct& all, std::size_t needs, Call make)
        : full(reinterpret_cast<const char*>(&all), reinterpret_cast<const char*>(&all + 1)),
          needed(needs),
          call([make](const char* given) { return make(reinterpret_cast<const Struct*>(given)); })
    {
    }

    /// The code of what is said of the first bytes and of zeros after them.
    int code(std::size_t size, std::size_t behind) const
    {
        const auto given = memoryOf(size, behind);
        for (std::size_t i = kFirst; i < size; ++i) given[i] = i < full.size() ? full[i] : 0;
        return codeOf(call(given.get()));
    }

    std::vector<char> full;
    std::size_t needed;  ///< The least size that has all members which `full` sets.
    std::function<crevice_error*(const char*)> call;
};

/// A member of a later version is passed over where it is zero, and refused where it is set.
void check(const Taken& each)
{
    for (const std::size_t behind : {0, 64})
        for (std::size_t size = 0; size <= each.full.size() + kLonger; ++size) {
            INFO(size << " bytes before " << behind);
            const int code = each.code(size, behind);
            CHECK((code == 0) == (possible(size) && size >= each.needed));
            if (!possible(size)) CHECK(code == 6011);
        }
    CHECK(each.code(kLargest + kFirst, 0) == 6011);
    Taken unknown = each;
    unknown.full.resize(each.full.size() + kLonger);
    unknown.full.back() = 1;
    CHECK(unknown.code(unknown.full.size(), 0) == 6011);
}

/// A struct that is filled in.
struct Given {
    template <class Struct, class Call>
    Given(const Struct&, Call get)
        : size(sizeof(Struct)),
          call([get](char* into) { return get(reinterpret_cast<Struct*>(into)); })
    {
    }

    /// Fills in a struct of that size; the bytes behind it stay as they were.
    std::unique_ptr<char[]> filled(std::size_t with, std::size_t behind) const
    {
        auto into = memoryOf(with, behind);
        CHECK(call(into.get()) == possible(with));
        CHECK(std::memcmp(into.get(), &with, kFirst) == 0);
        const char* const end = into.get() + std::max(with, kFirst);
        CHECK(std::count(end, end + behind, kGarbage) == static_cast<std::ptrdiff_t>(behind));
        return into;
    }

    std::size_t size;
    std::function<bool(char*)> call;
};

/// What is known is the same at every size, and what is not is zero.
void check(const Given& each)
{
    const auto full = each.filled(each.size, 0);
    for (const std::size_t behind : {0, 64})
        for (std::size_t size = 0; size <= each.size + kLonger; ++size) {
            INFO(size << " bytes before " << behind);
            const auto into = each.filled(size, behind);
            std::size_t same = kFirst;
            while (same < size && into[same] == (same < each.size ? full[same] : 0)) ++same;
            if (possible(size)) CHECK(same == size);
        }
}

/// Whether an object is made exactly where there is no error; it is destroyed.
template <class Object, class Desc>
auto making(crevice_error* (*make)(crevice_device*, const Desc*, Object**),
            void (*destroy)(Object*), crevice_device* device)
{
    return [=](const Desc* desc) {
        Object* made = nullptr;
        crevice_error* error = make(device, desc, &made);
        CHECK((error == nullptr) == (made != nullptr));
        destroy(made);
        return error;
    };
}

void* find(const char* name, void* gl)
{
    return gl ? static_cast<WatchedGl*>(gl)->loader()(name) : nullptr;
}

crevice_error* makeDevice(crevice_device*, const crevice_device_desc* desc, crevice_device** made)
{
    return crevice_device_create(desc, made);
}

/// Whether each number is there, or was cut off and so is 0: this device takes any size.
bool isCut(Extent heard, Extent whole)
{
    return (heard.width == whole.width || heard.width == 0) &&
           (heard.height == whole.height || heard.height == 0);
}

bool wentWell(crevice_error* error) { return codeOf(error) == 0; }

}  // namespace

TEST_CASE_METHOD(CViews, "C API: a struct of another version is taken at its own size")
{
    WatchedGl gl;
    need(crevice_effect_render(effect));
    crevice_device_desc device_desc = {};
    device_desc.loader = find;
    device_desc.user = &gl;
    crevice_effect_desc effect_desc = {};
    effect_desc.config = "mobile";
    effect_desc.width = effect_desc.height = 8;
    crevice_target target = {};
    target.width = target.height = 8;
    crevice_mesh_desc mesh_desc = {};
    mesh_desc.positions = kTriangle;
    mesh_desc.vertex_count = 3;
    crevice_host_mesh host = {};
    host.position.buffer = 1;
    host.vertex_count = 3;
    crevice_light light = {};
    light.color[0] = 1;
    material.shininess = 1;
    const Taken all[] = {
        {device_desc, END(crevice_device_desc, user),
         making(makeDevice, crevice_device_destroy, &device)},
        {effect_desc, END(crevice_effect_desc, height),
         making(crevice_effect_create, crevice_effect_destroy, &device)},
        {mesh_desc, END(crevice_mesh_desc, vertex_count),
         making(crevice_mesh_create, crevice_mesh_destroy, &device)},
        {host, END(crevice_host_mesh, vertex_count),
         making(crevice_mesh_adopt, crevice_mesh_destroy, &device)},
        {texture, 0,
         [&](auto* given) {
             crevice_error* error = crevice_effect_set_texture(effect, "depth", given);
             if (!error) CHECK(isCut(hearing->texture.extent, {4, 4}));
             return error;
         }},
        {target, 0,
         [&](auto* given) {
             crevice_error* error = crevice_effect_present(effect, "ao", given);
             if (!error) CHECK(isCut(hearing->target.extent, {8, 8}));
             return error;
         }},
        {draw, END(crevice_draw, mesh),
         [&](auto* given) { return crevice_effect_set_draws(effect, given, 1); }},
        {material, 0, [&](auto* given) { return crevice_effect_set_materials(effect, given, 1); }},
        {light, 0, [&](auto* given) { return crevice_effect_set_lights(effect, given, 1); }},
        {view, 0, [&](auto* given) { return crevice_effect_set_views(effect, given, 1); }},
    };
    for (const Taken& each : all) {
        INFO("struct " << &each - all);
        check(each);
    }
}

TEST_CASE_METHOD(CViews, "C API: a struct of another version is filled in at its own size")
{
    crevice_error* mistake = crevice_effect_resize(effect, -1, 1);
    recording->setTimers(std::vector<double>(kMaxTimers, 0.5));
    need(crevice_effect_set_timing(effect, true));
    draw.callback = [](const crevice_draw_call*, void*) {};  // in every frame
    setDraw();
    for (int i = 0; i < 6; ++i) need(crevice_effect_render(effect));
    const Given all[] = {
        {crevice_diagnostic(), [&](auto* into) { return crevice_error_get(mistake, 0, into); }},
        {crevice_device_info(),
         [&](auto* into) { return wentWell(crevice_device_get_info(&device, into)); }},
        {crevice_output(),
         [&](auto* into) { return wentWell(crevice_effect_get_output(effect, "ao", into)); }},
        {crevice_param(),
         [&](auto* into) { return wentWell(crevice_effect_get_param(effect, 0, into)); }},
        {crevice_feature(),
         [&](auto* into) { return wentWell(crevice_effect_get_feature(effect, 0, into)); }},
        {crevice_import(),
         [&](auto* into) { return wentWell(crevice_effect_get_import(effect, 0, into)); }},
        {crevice_pass_time(),
         [&](auto* into) { return wentWell(crevice_effect_get_pass_time(effect, 0, into)); }},
    };
    for (const Given& each : all) {
        INFO("struct " << &each - all);
        check(each);
    }
    crevice_error_free(mistake);
}
