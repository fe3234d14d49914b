// Counts every `new` of the test program, in any thread. It is a file of its own because the compiler warns
// of the `free` if it sees both sides of a `new`. The thread sanitizer brings a `new` of its own, which clang does not
// let us replace; the tests that count run in the other builds too.
#include <atomic>
#include <cstdlib>
#include <new>

#include "core/sanitizers.h"
#include "unit/input_log_samples.h"

namespace {
std::atomic<std::size_t> count{0};
}

std::size_t thaum::input::samples::allocations() { return count.load(); }

#if !THAUM_THREAD_SANITIZER
void* operator new(std::size_t size) {
    count.fetch_add(1, std::memory_order_relaxed);
    if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif
