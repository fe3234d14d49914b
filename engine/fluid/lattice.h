// fluid/lattice.h: the grid on which all quantities of a fluid are sampled.
//
// Cubic cells of edge length h fill a box from (0, 0, 0) m. The samples of one quantity are one array
// of float, x contiguous, with three ghost cells on every side, so that no stencil needs a special
// case. The edges of the box define the values of the ghosts:
//
//     periodic    the value from the opposite side
//     wall        the mirror image. The velocity through the wall is odd. The velocity along the wall is even
//                 (free slip) or odd (no slip).
//
// Velocities are sampled on the faces of cells (Harlow and Welch 1965). Component a of cell (i, j, k)
// lies on its low face across a. Beyond a wall, the low face of the first ghost cell is the high face
// of the last cell.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "fluid/floats8.h"
#include "fluid/samples.h"

namespace thaum::fluid {

/// Numbers of cells along x, y, z.
using Cells = std::array<int, 3>;

/// Kind of two opposite sides of the box.
enum class Edge : std::uint8_t { periodic, free_slip, no_slip };
/// Kind of the sides across x, y and z.
using Edges = std::array<Edge, 3>;

inline constexpr int max_cells = 256;  ///< largest number of cells along one axis

/// Layout of the samples of one quantity.
struct Lattice {
    Cells cells{};  ///< number of cells along x, y, z
    Edges edges{};  ///< kind of the two sides across x, y, z
    double h{};     ///< edge length of a cell (m)
    /// index distance from a cell to the next along x (always 1), y and z
    std::array<std::ptrdiff_t, 3> stride{};
    std::ptrdiff_t first{};  ///< index of cell (0, 0, 0)
    std::size_t size{};      ///< length of an array, including ghosts

    /// Index of the sample of cell (i, j, k). Ghosts are cells with numbers below 0 or from `cells` on.
    std::ptrdiff_t at(int i, int j, int k) const { return first + i + j * stride[1] + k * stride[2]; }
};

/// Makes a lattice; all `cells` must be >= 1.
inline Lattice make_lattice(Cells cells, double h, Edges edges) {
    Lattice result{.cells = cells, .edges = edges, .h = h};
    // Rows are padded to whole vectors of eight. The array has one vector more, so that the last row may be
    // read past its end.
    const std::ptrdiff_t row = round_up_to_8(cells[0] + 2 * ghosts);
    result.stride = {1, row, row * (cells[1] + 2 * ghosts)};
    result.first = ghosts * (result.stride[0] + result.stride[1] + result.stride[2]);
    result.size = static_cast<std::size_t>(result.stride[2] * (cells[2] + 2 * ghosts) + 8);
    return result;
}

/// Samples of a lattice, all 0.
inline Samples make_samples(const Lattice& lattice) { return Samples(lattice.size, 0.0F); }

/// Consecutive layers of cells across z: `first` to `end` - 1.
struct Layers {
    int first{}, end{};

    /// Whether the range contains this layer.
    bool contains(int layer) const { return layer >= first && layer < end; }
};

/// All layers of a lattice but its ghosts.
inline Layers all_layers(const Lattice& lattice) { return {0, lattice.cells[2]}; }

/// Calls `visit` with the index of the first cell of each row along x, in one, some or all layers.
template <class Visit>
void each_row(const Lattice& lattice, int k, Visit&& visit) {
    for (int j = 0; j < lattice.cells[1]; ++j) visit(lattice.at(0, j, k));
}
template <class Visit>
void each_row(const Lattice& lattice, Layers layers, Visit&& visit) {
    for (int k = layers.first; k < layers.end; ++k) each_row(lattice, k, visit);
}
template <class Visit>
void each_row(const Lattice& lattice, Visit&& visit) {
    each_row(lattice, all_layers(lattice), visit);
}

/// Calls `visit` with i, j, k and the index of each cell.
template <class Visit>
void each_cell(const Lattice& lattice, Visit&& visit) {
    for (int k = 0; k < lattice.cells[2]; ++k)
        for (int j = 0; j < lattice.cells[1]; ++j)
            for (int i = 0; i < lattice.cells[0]; ++i)
                visit(i, j, k, static_cast<std::size_t>(lattice.at(i, j, k)));
}

}  // namespace thaum::fluid
