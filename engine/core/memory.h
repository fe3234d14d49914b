// core/memory.h: memory for large arrays, and freed memory that stays in the process, so that the simulation
// and the renderer avoid page faults.
#pragma once
#include <cstddef>

namespace thaum {

/// Makes the allocator keep freed memory for the whole process. `main` calls this before anything else.
///
/// By default glibc returns large blocks to the kernel. The kernel must clear each page again when the memory
/// is next requested, at an unpredictable moment of the simulation. Without this call, drawing a picture in
/// software caused 900 page faults, which took a tenth of the drawing time. A World (the container of all
/// entities) that grows by doubling took either 13 or 36 ns an entity, depending on the position of the
/// heap's last block. Allocators other than glibc's are not affected.
void keep_freed_memory();

/// Size of a large page of x86-64 (bytes).
inline constexpr std::size_t large_page_bytes = std::size_t{2} << 20U;

/// Allocates an array aligned to 64 bytes. An array that is at least as large as a large page starts at a
/// large page and asks the kernel for large pages. This saves page faults and address look-ups of the
/// processor. Measured with `thaum bench ecs`: a World (the container of all entities) that grows to
/// 1,000,000 entities takes 52 ns instead of 138 for each, and random reads of a plain array of 16 MB take
/// 4.7 ns instead of 7.
void* allocate_array(std::size_t bytes);
/// Frees an array made by allocate_array with the same size.
void free_array(void* array, std::size_t bytes) noexcept;

/// Allocator for a std::vector that may become large.
template <class T>
struct ArrayAllocator {
    /// @{
    /// Members that std::allocator_traits requires.
    using value_type = T;
    ArrayAllocator() = default;
    template <class U>
    ArrayAllocator(const ArrayAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(allocate_array(n * sizeof(T))); }
    void deallocate(T* array, std::size_t n) noexcept { free_array(array, n * sizeof(T)); }
    bool operator==(const ArrayAllocator&) const { return true; }
    /// @}
};

}  // namespace thaum
