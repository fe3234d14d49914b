// fluid/floats8.h: vectors of eight floats. They are explicit because a compiler vectorises a loop only
// if it can prove that this is safe. The arithmetic is that of float on every processor.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace thaum::fluid {

/// Eight floats of one vector register.
using Floats8 = float __attribute__((vector_size(32)));
inline constexpr Floats8 zero8{};

/// Reads eight floats; the address needs no alignment.
inline Floats8 load(const float* from) {
    Floats8 result;
    std::memcpy(&result, from, sizeof result);
    return result;
}

/// Writes eight floats to any address.
inline void store(float* to, const Floats8& values) { std::memcpy(to, &values, sizeof values); }

/// The larger value in each lane.
inline Floats8 larger(const Floats8& a, const Floats8& b) { return a > b ? a : b; }
/// The smaller value in each lane.
inline Floats8 smaller(const Floats8& a, const Floats8& b) { return a < b ? a : b; }

/// Copies `count` values, rounded up to a multiple of eight.
inline void copy_by_8(const float* from, float* to, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) store(to + i, load(from + i));
}

/// Magnitudes of floats as integers that compare in the same order. NaNs compare as the largest.
using Magnitudes8 = std::int32_t __attribute__((vector_size(32)));

/// Magnitudes of eight floats, as integers in the same order of size.
inline Magnitudes8 magnitudes_of(const Floats8& values) {
    return std::bit_cast<Magnitudes8>(values) & std::numeric_limits<std::int32_t>::max();
}
/// The larger magnitude in each lane.
inline Magnitudes8 larger_magnitudes(const Magnitudes8& a, const Magnitudes8& b) { return a > b ? a : b; }

/// Whether a comparison holds in some lane.
inline bool any_of(const Magnitudes8& lanes) {
    int any = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) any |= lanes[lane];
    return any != 0;
}

/// The largest of the eight magnitudes, as a number.
inline double max_of(const Magnitudes8& sizes) {
    std::int32_t most = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) most = sizes[lane] > most ? sizes[lane] : most;
    return static_cast<double>(std::bit_cast<float>(most));
}

/// The least multiple of eight that is >= n. Rows of a lattice may be written up to this length, because
/// ghost cells follow them.
inline std::ptrdiff_t round_up_to_8(std::ptrdiff_t n) { return (n + 7) / 8 * 8; }

}  // namespace thaum::fluid
