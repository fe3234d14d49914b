// fluid/detail/part_of_row.h: copies a few values at the end of a row. How many is not known at compile time,
// so a compiler would call memcpy for them, which takes longer than the copy itself.
#pragma once
#include <cstddef>
#include <cstring>

#include "fluid/floats8.h"

namespace thaum::fluid {

/// Copies `number` floats, a power of two, if that bit of `count` is set, and moves both addresses on.
template <std::size_t number>
inline void copy_bit(const std::byte*& from, std::byte*& to, std::size_t count) {
    if ((count & number) == 0) return;
    std::memcpy(to, from, number * sizeof(float));
    from += number * sizeof(float);
    to += number * sizeof(float);
}

/// Copies `count` floats, fewer than 16.
inline void copy_part(const void* from, void* to, std::size_t count) {
    const auto* in = static_cast<const std::byte*>(from);
    auto* out = static_cast<std::byte*>(to);
    copy_bit<8>(in, out, count);
    copy_bit<4>(in, out, count);
    copy_bit<2>(in, out, count);
    copy_bit<1>(in, out, count);
}

/// Reads eight values, or only the first `left` of them and zeros if the row ends after so many samples.
inline Floats8 load_within_row(const float* from, std::ptrdiff_t left) {
    if (left >= 8) return load(from);
    Floats8 values{};
    copy_part(from, &values, static_cast<std::size_t>(left));
    return values;
}

/// Writes eight values, or only the first `left` of them if the row ends after so many samples.
inline void store_within_row(float* to, const Floats8& values, std::ptrdiff_t left) {
    if (left >= 8) {
        store(to, values);
    } else {
        copy_part(&values, to, static_cast<std::size_t>(left));
    }
}

}  // namespace thaum::fluid
