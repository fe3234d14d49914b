// core/detail/double2.h: double-double arithmetic: a number is a double plus its
// rounding error, about 106 bits in all.
//
// It uses only +, - and *, without fused operations, so every processor computes the same bits.
//
// T. J. Dekker, A floating-point technique for extending the available precision (1971).
#pragma once
#include <bit>
#include <cstdint>

namespace thaum::det {

/// A number as the sum of two doubles. `low` is at most half an ulp of `high`.
struct Double2 {
    double high;
    double low;
};

/// The rounded sum of two doubles and its exact rounding error.
inline Double2 sum_of(double a, double b) {
    const double sum = a + b;
    const double from_b = sum - a;
    return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// Keeps the upper 26 bits of the mantissa. The product of two such numbers is exact.
inline double upper_half(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

/// The rounded product of two doubles and its rounding error.
inline Double2 product_of(double a, double b) {
    const double product = a * b;
    const double a_high = upper_half(a), b_high = upper_half(b);
    const double a_low = a - a_high, b_low = b - b_high;
    return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline Double2 operator+(Double2 a, Double2 b) {
    const Double2 sum = sum_of(a.high, b.high);
    return sum_of(sum.high, sum.low + (a.low + b.low));
}

inline Double2 operator*(Double2 a, Double2 b) {
    const Double2 product = product_of(a.high, b.high);
    return sum_of(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace thaum::det
