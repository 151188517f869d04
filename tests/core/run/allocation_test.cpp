// SPDX-License-Identifier: MIT
// Steady frames allocate no memory. Counts every operator new of the program.
#include "tests/core/run/allocations.h"

#include "tests/support/renderer_rig.h"

#include <crevice/effect.h>
#include <crevice/governor.h>

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};
std::atomic<long> bytes{0};

long sizeOf(void* memory) { return static_cast<long>(malloc_usable_size(memory)); }

void* allocate(std::size_t size) noexcept
{
    ++allocations;
    void* memory = std::malloc(size ? size : 1);
    bytes += sizeOf(memory);
    return memory;
}

void release(void* memory) noexcept
{
    bytes -= sizeOf(memory);
    std::free(memory);
}

void* allocateOrThrow(std::size_t size)
{
    if (void* memory = allocate(size)) return memory;
    throw std::bad_alloc();
}

}  // namespace

// All that a sanitizer would otherwise replace by its own: a mixture would not match.
void* operator new(std::size_t size) { return allocateOrThrow(size); }
void* operator new[](std::size_t size) { return allocateOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }

long crevice::allocationCount() { return allocations; }
long crevice::allocatedBytes() { return bytes; }

using namespace crevice;

namespace {

/// Allocations while `work` runs.
template <class Work>
long allocationsOf(Work work)
{
    const long before = allocationCount();
    work();
    return allocationCount() - before;
}

}  // namespace

TEST_CASE("Allocations are counted")
{
    CHECK(allocationsOf([] { std::vector<int>(100); }) == 1);
    const long before = allocatedBytes();
    auto memory = std::make_unique<std::vector<int>>(100);
    const long during = allocatedBytes();
    memory.reset();
    const long after = allocatedBytes();
    CHECK(during - before >= 400);
    CHECK(after == before);
}

TEST_CASE("A frame allocates nothing while camera, draws, lights and params move")
{
    Rig rig;
    rig.draw();
    rig.device.clearLog();
    bool ok = true;
    const long count = allocationsOf([&] {
        rig.frame.camera.view_from_world[3][0] = 2.0f;
        rig.frame.camera.clip_from_view[1][1] *= 1.1f;
        rig.frame.camera.clip_from_view[2][2] *= 1.1f;
        rig.frame.draws[0].world_from_model[3][1] = 1.0f;
        rig.frame.lights[0].position.x = 7.0f;
        ok = rig.renderer->setParam("radius", 3.0f).ok();
        ok = rig.renderer->setParam("intensity", 3.0f).ok() && ok;
        ok = rig.renderer->render(rig.frame).ok() && ok;
    });
    CHECK(count == 0);
    CHECK(ok);
}

TEST_CASE("A frame that a governor watches allocates nothing at the level that it keeps")
{
    RecordingDevice device;
    device.setTimers({0.1});
    Effect effect = need(Effect::create(device, "mobile", {64, 36}, {"ao"}));
    need(effect.govern({{{"mobile_low"}, {}, 1}, {{"mobile"}, {}, 2}}, {1000}));
    const auto show = [&](int frames) {
        bool ok = true;
        for (int i = 0; i < frames; ++i) {
            device.clearLog();
            effect.frame().camera.clip_from_view[3][3] += 0.001f;
            ok = effect.render().ok() && ok;
        }
        return ok;
    };
    CHECK(show(40));
    CHECK(effect.governor()->report().ms > 0);
    bool ok = false;
    CHECK(allocationsOf([&] { ok = show(10); }) == 0);
    CHECK(ok);
}

TEST_CASE("A frame's traits are found without allocating")
{
    Rig rig;
    CHECK(allocationsOf([&] { traitsOf(rig.frame); }) == 0);
}
