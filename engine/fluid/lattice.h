// fluid/lattice.h: the grid that every quantity of a fluid stands on.
//
// Cubic cells of edge h fill a box from (0, 0, 0) m. Values of one quantity stand in one array of float, x contiguous, with three
// cells more on every side, so that no stencil asks where it is; what these hold follows from the edges of the box:
//
//     periodic    the other side
//     wall        the mirror image: odd for the velocity through the wall, for that along it even (free slip) or odd (no slip)
//
// Velocities stand on the faces of cells (Harlow and Welch 1965): component a of cell (i, j, k) on its low face across a. With
// walls the high face of the last cell is the low face of the cell beyond it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "fluid/floats8.h"
#include "fluid/samples.h"

namespace thaum::fluid {

using Cells = std::array<int, 3>;

enum class Edge : std::uint8_t { periodic, free_slip, no_slip };
using Edges = std::array<Edge, 3>;

inline constexpr int cells_most = 256;  ///< along one axis

struct Lattice {
    Cells cells{};                           ///< along x, y, z
    Edges edges{};                           ///< of the two sides across x, y, z
    double h{};                              ///< m, the edge of a cell
    std::array<std::ptrdiff_t, 3> stride{};  ///< from a cell to the next one along x (always 1), y, z
    std::ptrdiff_t first{};                  ///< where cell (0, 0, 0) stands
    std::size_t size{};                      ///< of an array, ghosts included

    std::ptrdiff_t at(int i, int j, int k) const { return first + i + j * stride[1] + k * stride[2]; }
};

/// cells >= 1 each.
inline Lattice make_lattice(Cells cells, double h, Edges edges) {
    Lattice result{.cells = cells, .edges = edges, .h = h};
    // Rows of whole vectors; more at the end, so that the last one may be read past.
    const std::ptrdiff_t row = round_up_to_8(cells[0] + 2 * ghosts);
    result.stride = {1, row, row * (cells[1] + 2 * ghosts)};
    result.first = ghosts * (result.stride[0] + result.stride[1] + result.stride[2]);
    result.size = static_cast<std::size_t>(result.stride[2] * (cells[2] + 2 * ghosts) + 8);
    return result;
}

inline Samples make_samples(const Lattice& lattice) { return Samples(lattice.size, 0.0F); }

/// Calls with where the first cell of each row along x stands, of one layer or of all.
template <class Visit>
void each_row(const Lattice& lattice, int k, Visit&& visit) {
    for (int j = 0; j < lattice.cells[1]; ++j) visit(lattice.at(0, j, k));
}
template <class Visit>
void each_row(const Lattice& lattice, Visit&& visit) {
    for (int k = 0; k < lattice.cells[2]; ++k) each_row(lattice, k, visit);
}

/// Calls with i, j, k of each cell and where it stands.
template <class Visit>
void each_cell(const Lattice& lattice, Visit&& visit) {
    for (int k = 0; k < lattice.cells[2]; ++k)
        for (int j = 0; j < lattice.cells[1]; ++j)
            for (int i = 0; i < lattice.cells[0]; ++i)
                visit(i, j, k, static_cast<std::size_t>(lattice.at(i, j, k)));
}

}  // namespace thaum::fluid
