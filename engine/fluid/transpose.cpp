#include "fluid/transpose.h"

#include "fluid/eight.h"

namespace thaum::fluid {
namespace {

using Choice = int __attribute__((vector_size(32)));

/// Rows r and r + distance exchange half of what they hold.
inline void exchange(const Eight* in, Eight* out, int distance, const Choice& low, const Choice& high) {
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) {
        if ((r & distance) != 0) continue;
        out[r] = __builtin_shuffle(in[r], in[r + distance], low);
        out[r + distance] = __builtin_shuffle(in[r], in[r + distance], high);
    }
}

void transpose_tile(const float* from, std::ptrdiff_t from_pitch, float* to, std::ptrdiff_t to_pitch) {
    Eight row[8];
    Eight turned[8];
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) row[r] = load(from + r * from_pitch);
    exchange(row, turned, 4, Choice{0, 1, 2, 3, 8, 9, 10, 11}, Choice{4, 5, 6, 7, 12, 13, 14, 15});
    exchange(turned, row, 2, Choice{0, 1, 8, 9, 4, 5, 12, 13}, Choice{2, 3, 10, 11, 6, 7, 14, 15});
    exchange(row, turned, 1, Choice{0, 8, 2, 10, 4, 12, 6, 14}, Choice{1, 9, 3, 11, 5, 13, 7, 15});
#pragma GCC unroll 8
    for (int r = 0; r < 8; ++r) store(to + r * to_pitch, turned[r]);
}

}  // namespace

void transpose(const Matrix<const float>& from, const Matrix<float>& to, std::ptrdiff_t rows,
               std::ptrdiff_t columns) {
    const auto whole_rows = rows / 8 * 8;
    const auto whole_columns = columns / 8 * 8;
    for (std::ptrdiff_t r = 0; r < whole_rows; r += 8)
        for (std::ptrdiff_t c = 0; c < whole_columns; c += 8)
            transpose_tile(from.first + r * from.pitch + c, from.pitch, to.first + c * to.pitch + r,
                           to.pitch);
    for (std::ptrdiff_t r = 0; r < rows; ++r)
        for (std::ptrdiff_t c = r < whole_rows ? whole_columns : 0; c < columns; ++c)
            to.first[c * to.pitch + r] = from.first[r * from.pitch + c];
}

}  // namespace thaum::fluid
