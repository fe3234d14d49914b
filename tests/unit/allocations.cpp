// Counts every `new` of the test program. These operators have a file of their own, because a compiler that
// compiles them together with code that calls them warns that `free` does not fit `new`.
#include "unit/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/sanitizers.h"

namespace {
std::atomic<std::size_t> allocation_count{0};
}

std::size_t thaum::test::allocations() { return allocation_count.load(); }

#if !THAUM_THREAD_SANITIZER

void* operator new(std::size_t size) {
    allocation_count.fetch_add(1, std::memory_order_relaxed);
    if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

#endif
