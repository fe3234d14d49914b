// fluid/detail/sums.h: sums and maxima over all cells or over those with fluid. Sums are in double and in one
// fixed order.
#pragma once
#include <span>

#include "core/team.h"
#include "fluid/rows.h"

namespace thaum::fluid {

double total(const Lattice& lattice, const Samples& samples);
double dot(const Lattice& lattice, const Samples& a, const Samples& b);
double dot(const Rows& rows, const Samples& a, const Samples& b);
/// Sum over all places of a times b times weight.
double dot(const Rows& rows, const Samples& a, const Samples& b, const Samples& weight);
/// Largest absolute value. If there is a NaN, the result is NaN.
double largest(const Lattice& lattice, const Samples& samples);
double largest(const Rows& rows, const Samples& samples);
/// Largest absolute value of all components.
double largest(const Rows& rows, const std::array<Samples, 3>& velocity);

/// Largest absolute value, over all places, of a times b.
double max_product(const Rows& rows, const Samples& a, const Samples& b);

/// Intensity of segregation of a density >= 0 over `cells` cells with fluid (Danckwerts 1952), 0 to 1: its
/// variance, divided by the variance that the same amount would have if each cell were either empty or at the
/// highest density. It is 1 if every cell is one or the other.
///
/// It is computed in two parts, the first of which threads may do in different layers at the same time.
/// `of_rows` has an element for each row.
struct SegregationOfRow {
    Floats8 sum, square, most;
};
void segregation_of_rows(const Rows& rows, Layers layers, const Samples& density,
                         std::span<SegregationOfRow> of_rows);
double segregation(const Rows& rows, double cells, std::span<const SegregationOfRow> of_rows);

/// Largest components of a velocity, and half its square.
struct VelocityNorms {
    double half_square{};     ///< half the sum of squares over all faces (m^2/s^2)
    double largest{};         ///< largest absolute value of any component (m/s)
    double sum_of_largest{};  ///< sum over the axes of the largest component along each (m/s)
};

/// Norms of a velocity. In the sum, each face is weighted by its share (null: all have weight 1). With the
/// open shares at solids (parts of faces that no solid covers) as weights, the sum is the energy that a
/// projection lowers. Small openings then contribute little, however fast the flow in them is.
VelocityNorms velocity_norms(const Rows& rows, const std::array<Samples, 3>& velocity,
                             const std::array<Samples, 3>* shares, Team& team);

}  // namespace thaum::fluid
