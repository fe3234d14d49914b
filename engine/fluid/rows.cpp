#include "fluid/rows.h"

#include <algorithm>

namespace thaum::fluid {

Rows whole_rows(const Lattice& lattice) {
    Rows result{.lattice = lattice, .complete = true};
    each_row(lattice, [&](std::ptrdiff_t at) {
        result.rows.push_back({at, lattice.cells[0]});
        result.rows_near_sides.push_back(at);
    });
    return result;
}

Samples openness(const Lattice& lattice, const std::array<Samples, 3>& open) {
    Samples sum = make_samples(lattice);
    each_cell(lattice, [&](int, int, int, std::size_t at) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum[at] += open[axis][at] + open[axis][at + static_cast<std::size_t>(lattice.stride[axis])];
    });
    return sum;
}

Rows rows_above_zero(const Lattice& lattice, const Samples& values) {
    Rows result = whole_rows(lattice);
    result.rows_near_sides.clear();
    result.complete = false;
    for (Row& row : result.rows) {
        const float* value = values.data() + row.at;
        std::ptrdiff_t first = 0, end = row.count;
        while (end > 0 && !(value[end - 1] > 0)) --end;
        while (first < end && !(value[first] > 0)) ++first;
        if (end > 0 && (first <= ghosts || end >= row.count - ghosts))
            result.rows_near_sides.push_back(row.at);
        const std::ptrdiff_t start = first / 8 * 8;
        row = {row.at + start, std::min(round_up_to_8(end), row.count) - start};
    }
    return result;
}

void clear(const Rows& rows, Samples& samples) { clear(rows, all_layers(rows.lattice), samples); }

void clear(const Rows& rows, Layers layers, Samples& samples) {
    each_row(rows, layers, [&](Row row) { std::fill_n(samples.data() + row.at, row.count, 0.0F); });
}

}  // namespace thaum::fluid
