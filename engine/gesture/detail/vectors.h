// gesture/detail/vectors.h: vectors of four or eight numbers for vector instructions of the processor.
//
// Arrays of such vectors in this folder have no initialiser where every element is written anyway, because
// clearing a long array takes longer than the arithmetic.
#pragma once
#include <cstdint>
#include <cstring>

namespace thaum::gesture {

using Floats4 = float __attribute__((vector_size(16)));
using Floats8 = float __attribute__((vector_size(32)));
using Ints4 = std::int32_t __attribute__((vector_size(16)));
using Ints8 = std::int32_t __attribute__((vector_size(32)));

template <class Vector>
inline Vector load(const void* from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

template <class Vector>
inline void store(void* to, Vector v) {
    std::memcpy(to, &v, sizeof v);
}

}  // namespace thaum::gesture
