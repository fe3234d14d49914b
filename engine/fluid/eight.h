// fluid/eight.h: eight floats side by side. Spelt out where a compiler's own vectors hang on what it can prove; the arithmetic is that
// of floats, whatever the processor.
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace thaum::fluid {

using Eight = float __attribute__((vector_size(32)));
inline constexpr Eight none{};

/// From anywhere: no alignment is asked.
inline Eight load(const float* from) {
    Eight result;
    std::memcpy(&result, from, sizeof result);
    return result;
}

inline void store(float* to, const Eight& values) { std::memcpy(to, &values, sizeof values); }

/// At least `count` values, in whole eights.
inline void copy_eights(const float* from, float* to, std::ptrdiff_t count) {
    for (std::ptrdiff_t i = 0; i < count; i += 8) store(to + i, load(from + i));
}

/// Integers that compare like the sizes of floats; those of NaNs are the largest.
using EightSizes = std::int32_t __attribute__((vector_size(32)));

inline EightSizes sizes_of(const Eight& values) {
    return std::bit_cast<EightSizes>(values) & std::numeric_limits<std::int32_t>::max();
}
inline EightSizes larger_sizes(const EightSizes& a, const EightSizes& b) { return a > b ? a : b; }

inline double largest_of(const EightSizes& sizes) {
    std::int32_t most = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane) most = sizes[lane] > most ? sizes[lane] : most;
    return static_cast<double>(std::bit_cast<float>(most));
}

/// The least multiple of eight that is not below n. A row of the lattice may be written so far: what is beyond it are ghosts.
inline std::ptrdiff_t whole_eights(std::ptrdiff_t n) { return (n + 7) / 8 * 8; }

}  // namespace thaum::fluid
