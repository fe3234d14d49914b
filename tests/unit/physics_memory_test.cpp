// Tests that steps of the physics, and rebuilds of its world, do not allocate from the heap once the pool is
// large enough.
#include "physics/detail/memory.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <thread>

#include "core/sanitizers.h"
#include "unit/physics_scenes.h"

namespace {
std::atomic<std::uint64_t> heap_calls{0};
}

#if !THAUM_ADDRESS_SANITIZER && !THAUM_THREAD_SANITIZER
#define THAUM_COUNTS_HEAP 1
void* operator new(std::size_t bytes) {
    ++heap_calls;
    if (void* p = std::malloc(bytes)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#else
#define THAUM_COUNTS_HEAP 0
#endif

namespace thaum::physics {
namespace {

using namespace scenes;

void kick(Physics& physics, int tick) {
    if (tick % 300 == 0) physics.apply_central_impulse(10 + static_cast<Key>(tick / 300) % 14, {9, 12, 5});
}

TEST(PhysicsMemory, AWarmStepDoesNotAllocate) {
    if (!THAUM_COUNTS_HEAP) GTEST_SKIP() << "sanitizers replace the heap, so it cannot be counted";
    const std::uint64_t calls = memory_use().calls;
    Physics physics;
    add_pile(physics);
    EXPECT_GT(memory_use().calls, calls) << "Bullet does not use the pool at all";
    for (int tick = 0; tick < 6000; ++tick) {
        kick(physics, tick);
        physics.step(dt);
    }
    const std::uint64_t slabs = memory_use().slabs;
    const std::uint64_t heap = heap_calls;
    for (int tick = 0; tick < 6000; ++tick) {
        kick(physics, tick);
        physics.step(dt);
    }
    EXPECT_EQ(memory_use().slabs, slabs);
    EXPECT_EQ(heap_calls, heap);
}

TEST(PhysicsMemory, NearbyDoesNotAllocate) {
    if (!THAUM_COUNTS_HEAP) GTEST_SKIP() << "sanitizers replace the heap, so it cannot be counted";
    Physics physics({}, {hills(16, 1)});
    add_pile(physics);
    physics.add(99, {.shape = Shape::mesh}, at({}));
    std::array<Nearby, 8> found{};
    const std::uint64_t heap = heap_calls, calls = memory_use().calls;
    for (int i = 0; i < 100; ++i) EXPECT_GT(physics.nearby({0.1 * i - 5, 0, 0.3}, 2, found).count, 0U);
    EXPECT_EQ(heap_calls, heap);
    EXPECT_EQ(memory_use().calls, calls);
}

TEST(PhysicsMemory, RebuildsReuseThePool) {
    if (!THAUM_COUNTS_HEAP) GTEST_SKIP() << "sanitizers replace the heap, so it cannot be counted";
    Physics physics;
    add_pile(physics);
    const auto keyframe = [&] {
        for (int tick = 0; tick < 256; ++tick) {
            kick(physics, tick);
            physics.step(dt);
        }
        physics.rebuild();
    };
    for (int i = 0; i < 4; ++i) keyframe();
    const std::uint64_t slabs = memory_use().slabs;
    for (int i = 0; i < 10; ++i) keyframe();
    EXPECT_EQ(memory_use().slabs, slabs);
}

TEST(PhysicsMemory, WorldsOnSeveralThreadsAgree) {
    std::array<std::uint64_t, 4> hashes{};
    {
        std::vector<std::jthread> threads;
        for (std::uint64_t& hash : hashes) {
            threads.emplace_back([&hash] {
                Physics physics;
                add_pile(physics);
                for (int tick = 0; tick < 800; ++tick) {
                    kick(physics, tick);
                    physics.step(dt);
                    if (tick == 400) physics.rebuild();
                }
                hash = hash_of(physics, {10, 15, 23, 30, 31});
            });
        }
    }
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes[0]);
}

}  // namespace
}  // namespace thaum::physics
