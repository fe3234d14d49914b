// Counts every `new` of the test program, in any thread. It is a file of its own because the compiler warns
// of the `free` if it sees both sides of a `new`.
#include <atomic>
#include <cstdlib>
#include <new>

#include "core/sanitizers.h"
#include "unit/carving_rig.h"

namespace {
std::atomic<std::size_t> carving_count{0};
}

std::size_t thaum::field::allocations() { return carving_count.load(); }

#if !THAUM_THREAD_SANITIZER  // which has operators of its own, so nothing is counted there

void* operator new(std::size_t size) {
    carving_count.fetch_add(1, std::memory_order_relaxed);
    if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

#endif
