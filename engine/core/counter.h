// core/counter.h: counts of one thread that others may read.
#pragma once
#include <atomic>
#include <cstdint>

namespace thaum {

/// One more. Only one thread counts.
inline void count(std::atomic<std::uint64_t>& counter) {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

}  // namespace thaum
