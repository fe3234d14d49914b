#include "core/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

#include "core/memory.h"

namespace thaum {

// The kernel takes only whole pages, and only those that lie in this memory as a whole are asked for.
void ask_for_large_pages(void* memory, std::size_t bytes) {
    const std::size_t into_page = reinterpret_cast<std::uintptr_t>(memory) % large_page_bytes;
    const std::size_t before = (large_page_bytes - into_page) % large_page_bytes;
    if (bytes < before + large_page_bytes) return;
    const std::size_t whole = (bytes - before) / large_page_bytes * large_page_bytes;
    madvise(static_cast<std::byte*>(memory) + before, whole, MADV_HUGEPAGE);
}

}  // namespace thaum
