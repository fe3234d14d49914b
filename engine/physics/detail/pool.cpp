// A block of n bytes comes from the free list of the smallest size class that holds it. There are four size
// classes for each doubling of the size, so at most a fifth is wasted. If the list is empty, a block is cut
// from the current slab. A block too large for a slab gets a slab of its own, and returns to its list like
// any other. The header before a block stores its class, because Bullet frees by address alone. One lock is
// enough: a step makes some dozens of calls, and an uncontended lock costs less than a cache miss.
#include "physics/detail/pool.h"

#include <LinearMath/btAlignedAllocator.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>

#include "core/assert.h"
#include "core/sanitizers.h"
#include "physics/detail/memory.h"

namespace thaum::physics {
namespace detail {
namespace {

constexpr std::size_t alignment = 16;
constexpr std::size_t slab_bytes = std::size_t{1} << 20U;
constexpr std::size_t smallest = 64;  // size of the smallest block, including the header (bytes)
constexpr std::size_t classes = 4 * 40;

struct FreeBlock {
    FreeBlock* next;
};

/// Header in the `alignment` bytes before every block.
struct Header {
    std::size_t size_class;
};
static_assert(sizeof(Header) <= alignment && sizeof(FreeBlock) <= smallest - alignment);

std::size_t class_bytes(std::size_t size_class) {
    const std::size_t octave = smallest << (size_class / 4);
    return octave + octave / 4 * (size_class % 4);
}

std::size_t class_of(std::size_t bytes) {
    if (bytes <= smallest) return 0;
    const auto octave = static_cast<std::size_t>(std::bit_width((bytes - 1) / smallest) - 1);
    const std::size_t quarter = (smallest << octave) / 4;
    return 4 * octave + (bytes - (smallest << octave) + quarter - 1) / quarter;
}

struct Pool {
    std::mutex lock;
    std::array<FreeBlock*, classes> free{};
    std::byte* slab{};
    std::size_t slab_left{};
    MemoryUse use;
};

/// The pool is never destroyed, because a world in a static object may outlive every other static.
Pool& pool() {
    static Pool& the_pool = *new Pool;
    return the_pool;
}

std::byte* from_heap(std::size_t bytes, MemoryUse& use) {
    ++use.slabs;
    use.bytes += bytes;
    return static_cast<std::byte*>(::operator new (bytes, std::align_val_t{alignment}));
}

std::byte* cut(Pool& p, std::size_t bytes) {
    if (bytes > slab_bytes / 4) return from_heap(bytes, p.use);
    if (bytes > p.slab_left) {
        p.slab = from_heap(slab_bytes, p.use);
        p.slab_left = slab_bytes;
    }
    std::byte* block = p.slab;
    p.slab += bytes;
    p.slab_left -= bytes;
    return block;
}

[[maybe_unused]] void* pool_take(std::size_t bytes, int wanted_alignment) {
    THAUM_ASSERT(wanted_alignment <= static_cast<int>(alignment),
                 "Bullet asks for more than 16-byte alignment");
    Pool& p = pool();
    const std::scoped_lock held(p.lock);
    ++p.use.calls;
    const std::size_t size_class = class_of(bytes + alignment);
    std::byte* block = nullptr;
    if (FreeBlock* const reused = p.free[size_class]) {
        p.free[size_class] = reused->next;
        block = reinterpret_cast<std::byte*>(reused) - alignment;
    } else {
        block = cut(p, class_bytes(size_class));
    }
    new (block) Header{size_class};
    return block + alignment;
}

[[maybe_unused]] void pool_return(void* address) {
    if (!address) return;
    Pool& p = pool();
    const std::scoped_lock held(p.lock);
    const auto* header = reinterpret_cast<const Header*>(static_cast<std::byte*>(address) - alignment);
    const std::size_t size_class = header->size_class;
    p.free[size_class] = new (address) FreeBlock{p.free[size_class]};
}

[[maybe_unused]] void* heap_take(std::size_t bytes, int wanted_alignment) {
    Pool& p = pool();
    const std::scoped_lock held(p.lock);
    ++p.use.calls;
    const auto aligned = static_cast<std::size_t>(wanted_alignment);
    return std::aligned_alloc(aligned, (bytes + aligned - 1) / aligned * aligned);
}

[[maybe_unused]] void heap_return(void* address) { std::free(address); }

}  // namespace

void use_pool() {
    static const bool installed = [] {
        if constexpr (THAUM_ADDRESS_SANITIZER) {
            btAlignedAllocSetCustomAligned(heap_take, heap_return);
        } else {
            btAlignedAllocSetCustomAligned(pool_take, pool_return);
        }
        return true;
    }();
    static_cast<void>(installed);
}

}  // namespace detail

MemoryUse memory_use() {
    detail::Pool& p = detail::pool();
    const std::scoped_lock held(p.lock);
    return p.use;
}

}  // namespace thaum::physics
