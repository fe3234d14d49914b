// fluid/detail/separable.h: direct solvers on a box, by separation of variables.
//
// The Laplacian of a box is a sum of one operator for each axis. The eigenvectors of these operators
// are waves: cosines where a quantity is even beyond the walls, sines where it is odd, both where it is
// periodic. An equation in the Laplacian therefore reduces to one number for each product of three
// waves.
//
// The transform to waves and back is one small dense matrix for each axis. Up to 64 cells this is at
// least as fast as fast Fourier transforms, and the time does not depend on the kind of wave. Every
// wave is symmetric or antisymmetric about the middle, so folding the two halves saves half of the
// work. A half whose waves are again symmetric about its own middle, as with cosines, is folded again.
//
// Sums are taken in one fixed order. A mirrored input gives exactly the mirrored output, bit for bit.
#pragma once
#include <array>
#include <span>

#include "core/team.h"
#include "fluid/ghosts.h"

namespace thaum::fluid {

/// A range of consecutive cells or faces along an axis.
struct CellRange {
    int first{}, count{};
};

/// The orthonormal waves along one axis, and how to transform to them. Folding a range replaces each
/// place and its mirror image by their sum and difference. Sums are stored in the lower half, together
/// with the middle, and differences in the upper half. After all folds each dense range has a matrix of
/// its own, with as many waves as places.
struct Waves {
    int start{};                  ///< first cell or face whose value is not fixed by the side of the box
    int count{};                  ///< number of places (cells or faces), which is also the number of waves
    std::vector<double> angle{};  ///< phase per cell of each wave (rad)
    /// Ranges to fold (to replace mirrored places by their sums and differences), in this order: first the
    /// whole axis, then halves of ranges that were folded before.
    std::vector<CellRange> folds{};
    /// Ranges that remain after all folds, replacements of mirrored places by their sums and differences.
    std::vector<CellRange> dense{};
    std::vector<std::vector<float>>
        forth{};  ///< matrices from places to waves, one for each dense range: [place][wave]
    std::vector<std::vector<float>>
        back{};  ///< matrices from waves to places, one for each dense range: [wave][place]
    std::vector<std::vector<double>> exact{};  ///< `back` in double precision
};

Waves make_waves(int cells, Edge edge, GhostRule rule);

/// The symbol of an operator for a wave is minus the eigenvalue, times h^2.
///
/// Symbol of the divergence of the gradient on the staggered grid, of order 2 or 4.
double pressure_symbol(double angle, int order);
/// Symbol of the second difference used for viscosity.
double laplace_symbol(double angle, int order);

/// Solves the Poisson equation of pressure: on input a field is the Laplacian that is wanted, on output the
/// potential that has it. The field has no ghost cells, x contiguous. The mean of the result is zero.
///
/// A solve has three parts, in this order. Threads with different seats (numbers in a team, core/team.h) may
/// do different layers or blocks of the same part at the same time.
class PressureSolver {
public:
    PressureSolver(const Lattice& lattice, int order);
    /// Transforms the given layers to waves along x and y.
    void to_waves(std::span<float> field, Layers layers, unsigned seat);
    /// Number of blocks into which the columns along z are divided.
    int blocks() const;
    /// Solves the equation in the columns of blocks `first` to `end` - 1: to waves along z, and back.
    void divide(std::span<float> field, int first, int end) const;
    /// Transforms the given layers from waves along x and y back to values.
    void from_waves(std::span<float> field, Layers layers, unsigned seat);

private:
    std::ptrdiff_t plane() const { return std::ptrdiff_t{waves_[0].count} * waves_[1].count; }

    std::array<Waves, 3> waves_;
    std::vector<float> along_z_;      ///< symbols (minus eigenvalue times h^2) of the waves along z
    std::vector<float> by_x_, by_y_;  ///< symbols of the waves along x and y, in the order of a plane: [x][y]
    float scale_;
    /// A layer for each thread, by its seat (number in the team).
    std::array<std::vector<float>, Team::max_threads> scratch_;
};

/// Solves du/dt = nu lap u over a time exactly: each wave decays at its own rate. The viscosity nu must
/// be uniform.
class Diffusion {
public:
    Diffusion(const Lattice& lattice, int order);
    /// Diffuses a velocity. `part` is nu dt / h^2, >= 0. `lid` is the speed along x of the wall at the top of
    /// y (m/s); if it is not 0, the edges across x and z must not be no-slip. The ghosts of the velocity are
    /// not changed. Allocates memory if `part` is another than in the last call.
    void diffuse(double part, double lid, std::array<Samples, 3>& velocity);

private:
    using Matrices =
        std::vector<std::vector<float>>;  ///< one for each dense range of the waves along an axis

    void make_matrices(double part);
    void component(const std::array<Waves, 3>& waves, const std::array<Matrices, 3>& matrices, Samples& u);

    Lattice lattice_;
    int order_;
    std::array<std::array<Waves, 3>, 3> waves_;  ///< waves of each component along each axis
    /// For each component along each axis, the matrices that transform to waves, let the waves decay as
    /// viscosity does while nu dt / h^2 is part_, and transform back.
    std::array<std::array<Matrices, 3>, 3> matrices_;
    double part_ = -1;  ///< value of nu dt / h^2 for which matrices_ are made; -1: none yet
    std::vector<float> packed_, turned_;
};

}  // namespace thaum::fluid
