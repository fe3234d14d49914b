// physics/memory.h: where Bullet's memory comes from.
//
// Bullet allocates and frees small blocks in every step. All of them come from one pool of free lists, which grows by
// whole slabs and never gives one back: once a scene is warm, a step asks the heap for nothing. The pool belongs to the
// process, since Bullet's hook does; any number of worlds on any number of threads may use it. Under AddressSanitizer
// every block is taken from the heap instead, so that a wrong access is seen.
#pragma once
#include <cstdint>

namespace thaum::physics {

struct MemoryUse {
    std::uint64_t calls{};  ///< blocks that Bullet asked for so far
    std::uint64_t slabs{};  ///< times the pool asked the heap; constant once warm
    std::uint64_t bytes{};  ///< in all slabs
};

MemoryUse memory_use();

}  // namespace thaum::physics
