#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

#include "core/memory.h"

namespace thaum {

// The kernel accepts only whole pages, so pages of which only a part lies in this memory are left out.
void ask_for_large_pages(void* memory, std::size_t bytes) {
    const std::size_t into_page = reinterpret_cast<std::uintptr_t>(memory) % large_page_bytes;
    const std::size_t before = (large_page_bytes - into_page) % large_page_bytes;
    if (bytes < before + large_page_bytes) return;
    const std::size_t whole = (bytes - before) / large_page_bytes * large_page_bytes;
    madvise(static_cast<std::byte*>(memory) + before, whole, MADV_HUGEPAGE);
}

}  // namespace thaum
