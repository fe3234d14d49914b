// core/random.h: the only source of randomness in a match. Each subsystem has one generator, whose state is
// in the World, the container of all state of a match.
//
// SplitMix64 (Steele, Lea, Flood 2014). Its state is one 64-bit word, so a generator is stored as a
// component, plain data in the World.
#pragma once
#include <cstdint>

namespace thaum {

/// State of one generator.
struct Random {
    std::uint64_t state{};

    /// Returns 64 random bits.
    std::uint64_t next() {
        state += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }

    /// Uniform in [0, 1), with 53 random bits.
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Uniform in [0, n), for n > 0. The bias of the multiplication is below n / 2^64.
    std::uint64_t below(std::uint64_t n) {
        __extension__ using Wide = unsigned __int128;
        return static_cast<std::uint64_t>((static_cast<Wide>(next()) * n) >> 64U);
    }
};

/// Creates a generator for one subsystem. Two streams of one seed never have the same initial state.
constexpr Random random_stream(std::uint64_t seed, std::uint64_t stream) {
    return Random{seed ^ (stream * 0xd1342543de82ef95ULL + 0x632be59bd9b4e019ULL)};
}

}  // namespace thaum
