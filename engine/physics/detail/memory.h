// physics/detail/memory.h: statistics of Bullet's memory pool.
//
// Bullet allocates and frees small blocks in every step. All of them come from one pool of free lists.
// The pool grows by whole slabs and never returns one, so steps soon stop allocating from the heap.
// Bullet's hook is global, so the pool belongs to the process; any number of worlds on any number of
// threads may use it. Under AddressSanitizer every block comes from the heap instead, so that wrong
// accesses are detected.
#pragma once
#include <cstdint>

namespace thaum::physics {

/// Use of the pool since the start of the process.
struct MemoryUse {
    std::uint64_t calls{};  ///< number of blocks that Bullet has requested
    std::uint64_t slabs{};  ///< number of allocations from the heap; constant after the first steps
    std::uint64_t bytes{};  ///< total size of all slabs (bytes)
};

/// Current statistics of the pool.
MemoryUse memory_use();

}  // namespace thaum::physics
