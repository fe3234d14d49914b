// core/large_pages.h: large pages of memory for arrays that come from another allocator than that of
// core/memory.h.
#pragma once
#include <cstddef>

namespace thaum {

/// Asks the kernel for large pages (core/memory.h) for memory that was not written yet, such as that which a
/// std::vector has reserved. This saves page faults. If the kernel refuses, the pages stay small.
void ask_for_large_pages(void* memory, std::size_t bytes);

}  // namespace thaum
