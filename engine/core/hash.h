// core/hash.h: the only 64-bit hash of the project (XXH3), for states, files and blocks.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace thaum {

/// XXH3 hash of bytes (64 bits), the same on every machine. Different seeds give unrelated hashes.
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed = 0);

/// XXH3 hash of bytes that come in pieces. It equals `hash_bytes` of all of them in one piece.
class HashOfPieces {
public:
    HashOfPieces();
    /// Appends bytes.
    void add(std::span<const std::byte> bytes);
    /// Hash of all bytes so far.
    std::uint64_t value() const;

private:
    alignas(64) std::array<std::byte, 576> state_;  // the library's state, so that this header needs none
};

/// Combines two hashes or small numbers. The order of the arguments matters.
constexpr std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b) {
    // Mixes a before b is added, so that exchanging a and b gives another hash.
    std::uint64_t z = (a + 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
    z = ((z ^ (z >> 32U)) + b) * 0xd6e8feb86659fd93ULL;
    return z ^ (z >> 32U);
}

/// Hash of the bytes of a value, which must have no padding.
template <class T>
requires std::is_trivially_copyable_v<T> std::uint64_t hash_value(const T& value, std::uint64_t seed = 0) {
    return hash_bytes(std::as_bytes(std::span(&value, 1)), seed);
}

}  // namespace thaum
