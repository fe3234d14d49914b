// fluid/sums.h: sums and maxima over all cells or over those with fluid. Sums are in double and in one
// fixed order.
#pragma once
#include "fluid/rows.h"

namespace thaum::fluid {

double total(const Lattice& lattice, const Samples& samples);
double dot(const Lattice& lattice, const Samples& a, const Samples& b);
double dot(const Rows& rows, const Samples& a, const Samples& b);
/// Largest absolute value. If there is a NaN, the result is NaN.
double largest(const Lattice& lattice, const Samples& samples);
double largest(const Rows& rows, const Samples& samples);
/// Largest absolute value of all components.
double largest(const Rows& rows, const std::array<Samples, 3>& velocity);

/// Intensity of segregation of a density >= 0 over `cells` cells with fluid (Danckwerts 1952), 0 to 1: its variance,
/// divided by that of a body of its highest density with the same amount. 1: every cell has that density or none.
double segregation(const Rows& rows, double cells, const Samples& density);

/// Norms of a velocity.
struct VelocityNorms {
    double half_square{};     ///< half the sum of squares over all cells (m^2/s^2)
    double largest{};         ///< largest component (m/s)
    double sum_of_largest{};  ///< sum over the axes of the largest component along each (m/s)
};

VelocityNorms velocity_norms(const Rows& rows, const std::array<Samples, 3>& velocity);

}  // namespace thaum::fluid
