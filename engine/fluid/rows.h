// fluid/rows.h: the parts of a lattice that hold fluid, row by row along x. Solid cells are not
// visited. They keep their initial zeros in every array that is written only through these rows.
#pragma once
#include "fluid/lattice.h"

namespace thaum::fluid {

/// Part of a lattice row between its first and its last group of eight cells with fluid.
struct Row {
    /// Index of the row's first cell, a multiple of eight cells after the start of the lattice row.
    std::ptrdiff_t at{};
    /// Number of cells: a multiple of eight, or as many as reach the end of the lattice row; 0 if all cells
    /// are solid.
    std::ptrdiff_t count{};
};

/// The rows of a lattice that hold fluid.
struct Rows {
    Lattice lattice{};
    std::vector<Row> rows{};  ///< row j of layer k has the index k * lattice.cells[1] + j
    /// For those lattice rows whose fluid is so near to one end that ghost cells there mirror it: the indices
    /// at which the rows start.
    std::vector<std::ptrdiff_t> rows_near_sides{};
    bool complete{};  ///< true: every row contains all cells of its lattice row

    /// The part of row j of layer k that may hold fluid.
    Row at(int j, int k) const {
        const auto across = static_cast<std::size_t>(lattice.cells[1]);
        return rows[static_cast<std::size_t>(k) * across + static_cast<std::size_t>(j)];
    }
};

/// Rows that contain all cells.
Rows whole_rows(const Lattice& lattice);
/// Sum of the open shares (parts that no solid covers) of the six faces of each cell. `open` has one array
/// for each component, including ghost cells.
Samples openness(const Lattice& lattice, const std::array<Samples, 3>& open);
/// For each lattice row, the part that contains all cells with a value above 0.
Rows rows_above_zero(const Lattice& lattice, const Samples& values);
/// Sets the samples in the rows to 0.
void clear(const Rows& rows, Samples& samples);
/// Sets the samples of those rows that lie in some layers to 0.
void clear(const Rows& rows, Layers layers, Samples& samples);

/// Calls `visit` with each Row that holds fluid, in one, some or all layers.
template <class Visit>
void each_row(const Rows& rows, int k, Visit&& visit) {
    for (int j = 0; j < rows.lattice.cells[1]; ++j)
        if (const Row row = rows.at(j, k); row.count > 0) visit(row);
}
template <class Visit>
void each_row(const Rows& rows, Layers layers, Visit&& visit) {
    for (int k = layers.first; k < layers.end; ++k) each_row(rows, k, visit);
}
template <class Visit>
void each_row(const Rows& rows, Visit&& visit) {
    for (const Row& row : rows.rows)
        if (row.count > 0) visit(row);
}

}  // namespace thaum::fluid
