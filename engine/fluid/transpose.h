// fluid/transpose.h: rows for columns, eight by eight at once.
#pragma once
#include <cstddef>

namespace thaum::fluid {

template <class T>
struct Matrix {
    T* first;
    std::ptrdiff_t pitch;  ///< from a row to the next one
};

/// from[rows][columns] -> to[columns][rows]
void transpose(const Matrix<const float>& from, const Matrix<float>& to, std::ptrdiff_t rows,
               std::ptrdiff_t columns);

}  // namespace thaum::fluid
