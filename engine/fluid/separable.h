// fluid/separable.h: direct solves on a box.
//
// The Laplacian of a box is a sum of one operator for each axis, and their eigenvectors are waves: cosines where a quantity goes
// on evenly beyond the walls, sines where oddly, both where periodic. So an equation in the Laplacian falls apart into one number
// for each product of three waves. The change to waves and back is one small dense matrix for each axis; up to 64 cells that is
// as fast as fast transforms or faster, for it runs at the speed of multiplication, and any wave costs alike. Every wave is
// either symmetric or antisymmetric about the middle, so the halves are folded and half of the work is left; and where all those of
// a half are so about its own middle, as cosines are again and again, that half is folded in turn.
//
// Sums are taken in one fixed order. A mirrored input gives the mirrored output to the bit.
#pragma once
#include <array>
#include <span>

#include "fluid/ghosts.h"

namespace thaum::fluid {

/// Some places of an axis that follow one another.
struct CellRange {
    int first{}, count{};
};

/// The waves along one axis, orthonormal. Folding some places makes a place and its mirror image into their sum, which stays in the
/// lower half with the middle, and their difference in the upper one; what has been folded belongs to one matrix for each of the
/// dense places, of as many waves.
struct Waves {
    int start{};                     ///< the first cell or face that is not given by the edge
    int count{};                     ///< of cells, and of waves
    std::vector<double> angle{};     ///< rad per cell, wave by wave
    std::vector<CellRange> folds{};  ///< one after another; first of all the whole
    std::vector<CellRange> dense{};
    std::vector<std::vector<float>> forth{};   ///< of each dense places: [place][wave]
    std::vector<std::vector<float>> back{};    ///< [wave][place]
    std::vector<std::vector<double>> exact{};  ///< back, before it was rounded
};

Waves make_waves(int cells, Edge edge, GhostRule rule);

/// Symbols of differences: minus the eigenvalue of a wave times h^2.
/// Of the gradient's divergence on the staggered grid, order 2 or 4.
double pressure_symbol(double angle, int order);
/// Of the second difference that viscosity takes.
double laplace_symbol(double angle, int order);

/// -> the field whose Laplacian (of the pressure) is given; both without ghosts, x contiguous. The mean is left out.
class PressureSolver {
public:
    PressureSolver(const Lattice& lattice, int order);
    void solve(std::span<float> field);

private:
    std::array<Waves, 3> waves_;
    std::vector<float> along_z_;      ///< symbols by the wave along z
    std::vector<float> by_x_, by_y_;  ///< symbols of the waves across z, in the order of a plane: [x][y]
    float scale_;
    std::vector<float> scratch_;
};

/// du/dt = nu lap u over a time, exactly: each wave decays at its own rate. Viscosity is the same everywhere.
class Diffusion {
public:
    Diffusion(const Lattice& lattice, int order);
    /// part: nu dt / h^2, >= 0. lid: as Settings say; where it is not 0 the edges across x and z do not hold. Ghosts of the velocity
    /// are left as they are.
    void diffuse(double part, double lid, std::array<Samples, 3>& velocity);

private:
    void component(double part, const std::array<Waves, 3>& waves, Samples& u);

    Lattice lattice_;
    int order_;
    std::array<std::array<Waves, 3>, 3> waves_;  ///< of each component
    std::vector<float> packed_, turned_;
};

}  // namespace thaum::fluid
