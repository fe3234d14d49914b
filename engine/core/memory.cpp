#include "core/memory.h"

#include <malloc.h>
#include <sys/mman.h>

#include <new>

namespace thaum {
namespace {

constexpr std::align_val_t small_alignment{64}, large_alignment{large_page_bytes};

std::size_t whole_pages(std::size_t bytes) {
    return (bytes + large_page_bytes - 1) / large_page_bytes * large_page_bytes;
}

}  // namespace

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int own_mapping_from = 32 << 20,
                  given_back_from = 256 << 20;  // in bytes; glibc limits own_mapping_from to 32 MiB
    mallopt(M_MMAP_THRESHOLD, own_mapping_from);
    mallopt(M_TRIM_THRESHOLD, given_back_from);
#endif
}

// The size is rounded up to whole large pages, so that the array shares none with other data. Pages that are
// never written use no memory. If the kernel refuses the request, the array has small pages.
void* allocate_array(std::size_t bytes) {
    if (bytes < large_page_bytes) return ::operator new(bytes, small_alignment);
    void* const array = ::operator new(whole_pages(bytes), large_alignment);
    madvise(array, whole_pages(bytes), MADV_HUGEPAGE);
    return array;
}

void free_array(void* array, std::size_t bytes) noexcept {
    ::operator delete(array, bytes < large_page_bytes ? small_alignment : large_alignment);
}

}  // namespace thaum
