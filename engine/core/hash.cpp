#include "core/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <new>

namespace thaum {

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed) {
    return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

HashOfPieces::HashOfPieces() {
    static_assert(sizeof(XXH3_state_t) <= sizeof state_ && alignof(XXH3_state_t) <= 64);
    XXH3_64bits_reset(new (state_.data()) XXH3_state_t);
}

void HashOfPieces::add(std::span<const std::byte> bytes) {
    XXH3_64bits_update(std::launder(reinterpret_cast<XXH3_state_t*>(state_.data())), bytes.data(),
                       bytes.size());
}

std::uint64_t HashOfPieces::value() const {
    return XXH3_64bits_digest(std::launder(reinterpret_cast<const XXH3_state_t*>(state_.data())));
}

}  // namespace thaum
