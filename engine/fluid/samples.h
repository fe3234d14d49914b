// fluid/samples.h: memory for the values of one quantity on a lattice.
//
// Cells begin at the boundary of a vector and of a line of the cache, so that no vector of a row's own values crosses
// a line. Memory for large arrays begins at a page; were all at the same offset within it, those of one step could
// drive each other out of the nearest cache. So each array begins elsewhere within its page, by the number of that
// page.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

namespace thaum::fluid {

inline constexpr int ghosts = 3;

template <class T>
struct SamplesAllocator {
    using value_type = T;

    static constexpr std::size_t line = 64, page = 4096;  ///< bytes
    /// From the beginning of a line to the first value, so that the first cell, `ghosts` behind it, stands at the
    /// beginning of the next line.
    static constexpr std::size_t before = line - ghosts * sizeof(T);

    SamplesAllocator() = default;
    template <class U>
    explicit SamplesAllocator(const SamplesAllocator<U>&) {}

    T* allocate(std::size_t count) {
        void* const block = ::operator new (count * sizeof(T) + page + line, std::align_val_t{line});
        // An odd factor takes pages that follow one another in any steps to different lines.
        const std::size_t lines = std::bit_cast<std::uintptr_t>(block) / page * 29 % (page / line);
        std::byte* const first = static_cast<std::byte*>(block) + lines * line + before;
        // There is room for it: `before` is larger than a pointer.
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

/// One value for each cell, ghosts included, as Lattice::at counts.
using Samples = std::vector<float, SamplesAllocator<float>>;

}  // namespace thaum::fluid
