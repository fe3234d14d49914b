// fluid/rows.h: where on a lattice there is fluid, row by row along x. What is solid is not visited, and stays what it was made:
// zero, in every array that only these rows are written of.
#pragma once
#include "fluid/lattice.h"

namespace thaum::fluid {

/// The part of a row from the first to the last eight cells with any fluid.
struct Row {
    std::ptrdiff_t at{};  ///< where its first cell stands: whole eights from where the lattice's row begins
    std::ptrdiff_t count{};  ///< cells: whole eights, or as far as the lattice goes; 0: all is solid
};

struct Rows {
    Lattice lattice{};
    std::vector<Row> rows{};  ///< row j of layer k at k * lattice.cells[1] + j
    /// Where the lattice's rows begin that have fluid so near to one of their ends that ghosts mirror it.
    std::vector<std::ptrdiff_t> at_sides{};
    bool all{};  ///< every row is whole

    Row at(int j, int k) const {
        const auto across = static_cast<std::size_t>(lattice.cells[1]);
        return rows[static_cast<std::size_t>(k) * across + static_cast<std::size_t>(j)];
    }
};

/// All cells.
Rows whole_rows(const Lattice& lattice);
/// The sum of the open shares of the six faces round each cell; of each component, ghosts included.
Samples openness(const Lattice& lattice, const std::array<Samples, 3>& open);
/// Of the cells whose value is above 0.
Rows rows_above_zero(const Lattice& lattice, const Samples& values);
/// Sets the samples in the rows to 0.
void clear(const Rows& rows, Samples& samples);

/// Calls with each Row that has any fluid, of one layer or of all.
template <class Visit>
void each_row(const Rows& rows, int k, Visit&& visit) {
    for (int j = 0; j < rows.lattice.cells[1]; ++j)
        if (const Row row = rows.at(j, k); row.count > 0) visit(row);
}
template <class Visit>
void each_row(const Rows& rows, Visit&& visit) {
    for (const Row& row : rows.rows)
        if (row.count > 0) visit(row);
}

}  // namespace thaum::fluid
