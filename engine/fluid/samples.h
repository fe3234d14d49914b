// fluid/samples.h: memory for the samples of one quantity on a lattice.
//
// The first cell of each row is aligned to a vector and to a cache line, so no vector of the row's cells
// crosses a line. The heap returns large arrays at the start of a page. If all arrays had the same offset in
// their pages, the arrays of one step could evict each other from the first-level cache. Each array therefore
// starts at another offset, computed from its page number.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace thaum::fluid {

/// Number of layers of ghost cells on each side of a lattice.
inline constexpr int ghosts = 3;

/// Allocator of sample arrays, which keeps their beginnings apart in the cache.
template <class T>
struct SamplesAllocator {
    /// Type that std::allocator_traits requires.
    using value_type = T;

    static constexpr std::size_t line = 64, page = 4096;  ///< sizes of a cache line and of a page (bytes)
    /// Bytes from the start of a cache line to the first value. The first cell, `ghosts` values later,
    /// is then at the start of the next line.
    static constexpr std::size_t before = line - ghosts * sizeof(T);

    SamplesAllocator() = default;
    template <class U>
    explicit SamplesAllocator(const SamplesAllocator<U>&) {}

    T* allocate(std::size_t count) {
        void* const block = ::operator new (count * sizeof(T) + page + line, std::align_val_t{line});
        // The odd factor 29 spreads pages with any regular spacing over different lines.
        const std::size_t lines = std::bit_cast<std::uintptr_t>(block) / page * 29 % (page / line);
        std::byte* const first = static_cast<std::byte*>(block) + lines * line + before;
        // There is room for the pointer because `before` is larger than a pointer.
        std::memcpy(first - sizeof block, &block, sizeof block);
        return static_cast<T*>(static_cast<void*>(first));
    }
    void deallocate(T* first, std::size_t) noexcept {
        void* block = nullptr;
        std::memcpy(&block, static_cast<std::byte*>(static_cast<void*>(first)) - sizeof block, sizeof block);
        ::operator delete (block, std::align_val_t{line});
    }
    friend bool operator==(const SamplesAllocator&, const SamplesAllocator&) { return true; }
};

/// One value for each cell, including ghosts; Lattice::at gives the index.
using Samples = std::vector<float, SamplesAllocator<float>>;

}  // namespace thaum::fluid

// Instantiated once, in samples.cpp.
extern template class std::vector<float, thaum::fluid::SamplesAllocator<float>>;
