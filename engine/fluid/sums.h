// fluid/sums.h: what is summed over all cells, or those with fluid, in double and one fixed order, and the largest of them.
#pragma once
#include "fluid/rows.h"

namespace thaum::fluid {

double total(const Lattice& lattice, const Samples& samples);
double dot(const Lattice& lattice, const Samples& a, const Samples& b);
double dot(const Rows& rows, const Samples& a, const Samples& b);
/// The largest size of a value; of NaNs, one.
double largest(const Lattice& lattice, const Samples& samples);
double largest(const Rows& rows, const Samples& samples);
/// Of all components.
double largest(const Rows& rows, const std::array<Samples, 3>& velocity);

/// What a velocity comes to.
struct VelocityNorms {
    double half_square{};     ///< summed over cells (m^2/s^2)
    double largest{};         ///< component (m/s)
    double sum_of_largest{};  ///< over the components (m/s)
};

VelocityNorms velocity_norms(const Rows& rows, const std::array<Samples, 3>& velocity);

}  // namespace thaum::fluid
