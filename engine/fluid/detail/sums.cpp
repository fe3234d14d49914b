#include "fluid/detail/sums.h"

#include <algorithm>
#include <cstring>

#include "core/doubles4.h"

namespace thaum::fluid {
namespace {

using Floats4 = float __attribute__((vector_size(16)));

/// Reads four floats as doubles.
Doubles4 load_4(const float* from) {
    Floats4 values;
    std::memcpy(&values, from, sizeof values);
    return __builtin_convertvector(values, Doubles4);
}

void each_whole_row(const Lattice& lattice, auto&& visit) {
    each_row(lattice, [&](std::ptrdiff_t at) { visit(Row{at, lattice.cells[0]}); });
}
void each_whole_row(const Rows& rows, auto&& visit) { each_row(rows, visit); }

/// Sum of the terms of all cells. `term`, called with an index, returns the terms of that cell and of the
/// next three. They are added in eight partial sums. Cells that are not in Rows hold zeros, so leaving them
/// out changes no bit of the sum.
double sum_over(const auto& where, auto&& term) {
    Doubles4 low{}, high{};
    each_whole_row(where, [&](Row row) {
        const std::ptrdiff_t whole = row.count / 8 * 8;
        for (std::ptrdiff_t i = 0; i < whole; i += 8) {
            low += term(row.at + i);
            high += term(row.at + i + 4);
        }
        for (std::ptrdiff_t i = whole; i < row.count; ++i) low[0] += term(row.at + i)[0];
    });
    double sum = 0;
    for (const Doubles4& part : {low, high})
        for (std::ptrdiff_t lane = 0; lane < 4; ++lane) sum += part[lane];
    return sum;
}

double product(const auto& where, const Samples& a, const Samples& b) {
    return sum_over(where,
                    [x = a.data(), y = b.data()](std::ptrdiff_t i) { return load_4(x + i) * load_4(y + i); });
}

/// Largest magnitude of the terms of all cells. `term`, called with an index, returns the terms of that cell
/// and of the next seven.
double max_over(const auto& where, auto&& term) {
    Magnitudes8 most{};
    each_whole_row(where, [&](Row row) {
        const std::ptrdiff_t whole = row.count / 8 * 8;
        for (std::ptrdiff_t i = 0; i < whole; i += 8)
            most = larger_magnitudes(most, magnitudes_of(term(row.at + i)));
        if (whole == row.count) return;
        const Magnitudes8 last = magnitudes_of(term(row.at + whole));
        for (std::ptrdiff_t lane = 0; lane < row.count - whole; ++lane)
            most[lane] = last[lane] > most[lane] ? last[lane] : most[lane];
    });
    return max_of(most);
}

double max_of_samples(const auto& where, const Samples& samples) {
    return max_over(where, [value = samples.data()](std::ptrdiff_t i) { return load(value + i); });
}

}  // namespace

double total(const Lattice& lattice, const Samples& samples) {
    return sum_over(lattice, [values = samples.data()](std::ptrdiff_t i) { return load_4(values + i); });
}

double dot(const Lattice& lattice, const Samples& a, const Samples& b) { return product(lattice, a, b); }
double dot(const Rows& rows, const Samples& a, const Samples& b) { return product(rows, a, b); }

double dot(const Rows& rows, const Samples& a, const Samples& b, const Samples& weight) {
    return sum_over(rows, [x = a.data(), y = b.data(), w = weight.data()](std::ptrdiff_t i) {
        return load_4(w + i) * load_4(x + i) * load_4(y + i);
    });
}

double largest(const Lattice& lattice, const Samples& samples) { return max_of_samples(lattice, samples); }
double largest(const Rows& rows, const Samples& samples) { return max_of_samples(rows, samples); }
double largest(const Rows& rows, const std::array<Samples, 3>& velocity) {
    double most = 0;
    for (const Samples& component : velocity) most = std::max(most, largest(rows, component));
    return most;
}

double max_product(const Rows& rows, const Samples& a, const Samples& b) {
    return max_over(rows,
                    [x = a.data(), y = b.data()](std::ptrdiff_t i) { return load(x + i) * load(y + i); });
}

void segregation_of_rows(const Rows& rows, Layers layers, const Samples& density,
                         std::span<SegregationOfRow> of_rows) {
    const int ny = rows.lattice.cells[1];
    for (int r = layers.first * ny; r < layers.end * ny; ++r) {
        const Row row = rows.rows[static_cast<std::size_t>(r)];
        const float* value = density.data() + row.at;
        const std::ptrdiff_t whole = row.count / 8 * 8;
        SegregationOfRow found{};
        const auto add = [&](const Floats8& q) {
            found.sum += q;
            found.square += q * q;
            found.most = larger(q, found.most);
        };
        for (std::ptrdiff_t i = 0; i < whole; i += 8) add(load(value + i));
        for (std::ptrdiff_t i = whole; i < row.count; ++i) add(Floats8{value[i]});
        of_rows[static_cast<std::size_t>(r)] = found;
    }
}

double segregation(const Rows& rows, double cells, std::span<const SegregationOfRow> of_rows) {
    Floats8 most{};
    double sum = 0, square = 0;
    for (std::size_t r = 0; r < of_rows.size(); ++r) {
        if (rows.rows[r].count == 0) continue;
        most = larger(of_rows[r].most, most);
        for (std::ptrdiff_t lane = 0; lane < 8; ++lane) {
            sum += static_cast<double>(of_rows[r].sum[lane]);
            square += static_cast<double>(of_rows[r].square[lane]);
        }
    }
    double highest = 0;
    for (std::ptrdiff_t lane = 0; lane < 8; ++lane)
        highest = std::max(highest, static_cast<double>(most[lane]));
    const double mean = sum / cells, of_body = mean * (highest - mean);
    return of_body > 0 ? std::max(0.0, square / cells - mean * mean) / of_body : 0;
}

VelocityNorms velocity_norms(const Rows& rows, const std::array<Samples, 3>& velocity,
                             const std::array<Samples, 3>* shares, Team& team) {
    std::array<double, 3> sums{}, most{};
    team.each(6, [&](int slice, unsigned) {
        const auto axis = static_cast<std::size_t>(slice / 2);
        const float* u = velocity[axis].data();
        const auto square_at = [u](std::ptrdiff_t i) { return load_4(u + i) * load_4(u + i); };
        if (slice % 2 != 0)
            most[axis] = largest(rows, velocity[axis]);
        else if (shares == nullptr)
            sums[axis] = sum_over(rows, square_at);
        else
            sums[axis] = sum_over(rows, [&, share = (*shares)[axis].data()](std::ptrdiff_t i) {
                return load_4(share + i) * square_at(i);
            });
    });
    VelocityNorms result;
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sum += sums[axis];
        result.largest = std::max(result.largest, most[axis]);
        result.sum_of_largest += most[axis];
    }
    result.half_square = 0.5 * sum;
    return result;
}

}  // namespace thaum::fluid
