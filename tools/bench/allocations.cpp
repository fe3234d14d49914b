#include "tools/bench/allocations.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include "core/sanitizers.h"

#if defined(__GLIBC__) && !THAUM_ADDRESS_SANITIZER && !THAUM_THREAD_SANITIZER
#define THAUM_COUNT_ALLOCATIONS 1
#else
#define THAUM_COUNT_ALLOCATIONS 0
#endif

namespace {

std::atomic<std::uint64_t> allocations{0};

#if THAUM_COUNT_ALLOCATIONS
void count_one() { allocations.fetch_add(1, std::memory_order_relaxed); }
#endif

}  // namespace

#if THAUM_COUNT_ALLOCATIONS
extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the C library's own names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

void* malloc(std::size_t size) {
    count_one();
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    count_one();
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    count_one();
    return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
    count_one();
    return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    count_one();
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    const bool power_of_two = alignment != 0 && (alignment & (alignment - 1)) == 0;
    if (!power_of_two || alignment % sizeof(void*) != 0) return EINVAL;
    count_one();
    void* const got = __libc_memalign(alignment, size);
    if (got == nullptr) return ENOMEM;
    *memory = got;
    return 0;
}

}  // extern "C"
#endif

namespace thaum::bench {

bool allocations_are_counted() { return THAUM_COUNT_ALLOCATIONS != 0; }

std::uint64_t allocation_count() { return allocations.load(std::memory_order_relaxed); }

}  // namespace thaum::bench
