// core/large_pages.h: asks the kernel for large pages of memory, for arrays that were not made by
// allocate_array of core/memory.h, which asks for them by itself.
#pragma once
#include <cstddef>

namespace thaum {

/// Asks the kernel for large pages (2 MiB instead of 4 KiB) for memory that was not written yet, such as that
/// which a std::vector has reserved. This saves page faults. If the kernel refuses, the pages stay small.
void ask_for_large_pages(void* memory, std::size_t bytes);

}  // namespace thaum
