// core/counter.h: counters that one thread increments and other threads may read.
#pragma once
#include <atomic>
#include <cstdint>

namespace thaum {

/// Increments a counter. Only one thread may call this for a given counter.
inline void count(std::atomic<std::uint64_t>& counter) {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

}  // namespace thaum
