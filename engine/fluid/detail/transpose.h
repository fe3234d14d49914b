// fluid/detail/transpose.h: transposes a matrix in tiles of eight by eight.
#pragma once
#include <cstddef>

namespace thaum::fluid {

template <class T>
struct Matrix {
    T* first;
    std::ptrdiff_t pitch;  ///< index distance from a row to the next
};

/// Writes from[rows][columns] to to[columns][rows].
void transpose(const Matrix<const float>& from, const Matrix<float>& to, std::ptrdiff_t rows,
               std::ptrdiff_t columns);

}  // namespace thaum::fluid
