// core/double2.h: sums and products of doubles together with what rounding takes from them, about 106 bits in all. Made of
// +, - and * alone and without fused operations, so that every processor computes the same bits.
//
// T. J. Dekker, A floating-point technique for extending the available precision (1971).
#pragma once
#include <bit>
#include <cstdint>

namespace thaum::det {

/// A number as the sum of two doubles: the second is at most half an ulp of the first.
struct Double2 {
    double high;
    double low;
};

inline Double2 sum_of(double a, double b) {
    const double sum = a + b;
    const double from_b = sum - a;
    return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// The upper 26 bits of the mantissa: the product of two such numbers is exact.
inline double upper_half(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0x7ffffff});
}

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
