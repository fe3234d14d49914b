#include "fluid/detail/transpose.h"

#include <algorithm>

#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

/// Combines two rows of a matrix: low_of takes the elements of both whose index lacks the bit `distance`,
/// high_of those whose index has it.
template <int distance>
inline Floats8 low_of(const Floats8& a, const Floats8& b) {
    if constexpr (distance == 4) return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    if constexpr (distance == 2) return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    if constexpr (distance == 1) return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
template <int distance>
inline Floats8 high_of(const Floats8& a, const Floats8& b) {
    if constexpr (distance == 4) return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    if constexpr (distance == 2) return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    if constexpr (distance == 1) return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}

/// One of three passes that transpose eight rows: exchanges blocks of `distance` elements between the rows r
/// and r + distance.
template <int distance>
inline void exchange(const Floats8* in, Floats8* out) {
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) {
        if ((r & distance) != 0) continue;
        out[r] = low_of<distance>(in[r], in[r + distance]);
        out[r + distance] = high_of<distance>(in[r], in[r + distance]);
    }
}

void transpose_tile(const float* from, std::ptrdiff_t from_pitch, float* to, std::ptrdiff_t to_pitch) {
    Floats8 row[8];
    Floats8 turned[8];
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) row[r] = load(from + r * from_pitch);
    exchange<4>(row, turned);
    exchange<2>(turned, row);
    exchange<1>(row, turned);
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) store(to + r * to_pitch, turned[r]);
}

}  // namespace

void transpose(const Matrix<const float>& from, const Matrix<float>& to, std::ptrdiff_t rows,
               std::ptrdiff_t columns) {
    if (rows < 8 || columns < 8) {
        for (std::ptrdiff_t r = 0; r < rows; ++r)
            for (std::ptrdiff_t c = 0; c < columns; ++c)
                to.first[c * to.pitch + r] = from.first[r * from.pitch + c];
        return;
    }
    // The last tiles are placed so that they end where the matrix ends. Elements that they share with the
    // tiles before are written twice.
    for (std::ptrdiff_t next_r = 0; next_r < rows; next_r += 8) {
        const std::ptrdiff_t r = std::min(next_r, rows - 8);
        for (std::ptrdiff_t next_c = 0; next_c < columns; next_c += 8) {
            const std::ptrdiff_t c = std::min(next_c, columns - 8);
            transpose_tile(from.first + r * from.pitch + c, from.pitch, to.first + c * to.pitch + r,
                           to.pitch);
        }
    }
}

}  // namespace thaum::fluid
