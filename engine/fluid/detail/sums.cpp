#include "fluid/detail/sums.h"

#include <algorithm>
#include <bit>

namespace thaum::fluid {
namespace {

/// Number of partial sums in which numbers are added, so that additions can be vectorised.
constexpr std::ptrdiff_t lanes = 8;

void each_whole_row(const Lattice& lattice, auto&& visit) {
    each_row(lattice, [&](std::ptrdiff_t at) { visit(Row{at, lattice.cells[0]}); });
}
void each_whole_row(const Rows& rows, auto&& visit) { each_row(rows, visit); }

/// Cells that are not in Rows hold zeros, so leaving them out changes no bit of the sum.
double sum_over(const auto& where, auto&& term) {
    std::array<double, lanes> sums{};
    each_whole_row(where, [&](Row row) {
        const std::ptrdiff_t whole = row.count / lanes * lanes;
        for (std::ptrdiff_t i = 0; i < whole; i += lanes)
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
                sums[static_cast<std::size_t>(lane)] += term(row.at + i + lane);
        for (std::ptrdiff_t i = whole; i < row.count; ++i) sums[0] += term(row.at + i);
    });
    double sum = 0;
    for (const double part : sums) sum += part;
    return sum;
}

double product(const auto& where, const Samples& a, const Samples& b) {
    return sum_over(where, [x = a.data(), y = b.data()](std::ptrdiff_t i) {
        return static_cast<double>(x[i]) * static_cast<double>(y[i]);
    });
}

/// Magnitude of a float as an integer that compares in the same order. Unlike a float comparison, this
/// can be vectorised.
std::uint32_t size_of(float value) { return std::bit_cast<std::uint32_t>(value) & 0x7fffffffU; }
double of_size(std::uint32_t size) { return static_cast<double>(std::bit_cast<float>(size)); }

double max_over(const auto& where, auto&& term) {
    std::uint32_t most = 0;
    each_whole_row(where, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; ++i) most = std::max(most, size_of(term(i)));
    });
    return of_size(most);
}

double max_of(const auto& where, const Samples& samples) {
    return max_over(where, [value = samples.data()](std::ptrdiff_t i) { return value[i]; });
}

}  // namespace

double total(const Lattice& lattice, const Samples& samples) {
    return sum_over(lattice,
                    [values = samples.data()](std::ptrdiff_t i) { return static_cast<double>(values[i]); });
}

double dot(const Lattice& lattice, const Samples& a, const Samples& b) { return product(lattice, a, b); }
double dot(const Rows& rows, const Samples& a, const Samples& b) { return product(rows, a, b); }

double dot(const Rows& rows, const Samples& a, const Samples& b, const Samples& weight) {
    return sum_over(rows, [x = a.data(), y = b.data(), w = weight.data()](std::ptrdiff_t i) {
        return static_cast<double>(w[i]) * static_cast<double>(x[i]) * static_cast<double>(y[i]);
    });
}

double largest(const Lattice& lattice, const Samples& samples) { return max_of(lattice, samples); }
double largest(const Rows& rows, const Samples& samples) { return max_of(rows, samples); }
double largest(const Rows& rows, const std::array<Samples, 3>& velocity) {
    double most = 0;
    for (const Samples& component : velocity) most = std::max(most, largest(rows, component));
    return most;
}

double max_product(const Rows& rows, const Samples& a, const Samples& b) {
    return max_over(rows, [x = a.data(), y = b.data()](std::ptrdiff_t i) { return x[i] * y[i]; });
}

double segregation(const Rows& rows, double cells, const Samples& density) {
    Floats8 most{};
    double sum = 0, square = 0;
    each_row(rows, [&](Row row) {
        const float* value = density.data() + row.at;
        const std::ptrdiff_t whole = row.count / lanes * lanes;
        Floats8 row_sum{}, row_square{};
        const auto add = [&](const Floats8& q) {
            row_sum += q;
            row_square += q * q;
            most = q > most ? q : most;
        };
        for (std::ptrdiff_t i = 0; i < whole; i += lanes) add(load(value + i));
        for (std::ptrdiff_t i = whole; i < row.count; ++i) add(Floats8{value[i]});
        for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) {
            sum += static_cast<double>(row_sum[lane]);
            square += static_cast<double>(row_square[lane]);
        }
    });
    double highest = 0;
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
        highest = std::max(highest, static_cast<double>(most[lane]));
    const double mean = sum / cells, of_body = mean * (highest - mean);
    return of_body > 0 ? std::max(0.0, square / cells - mean * mean) / of_body : 0;
}

VelocityNorms velocity_norms(const Rows& rows, const std::array<Samples, 3>& velocity,
                             const std::array<Samples, 3>* shares) {
    VelocityNorms result;
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::uint32_t most = 0;
        const float* u = velocity[axis].data();
        const auto square_at = [&](std::ptrdiff_t i) {
            most = std::max(most, size_of(u[i]));
            return static_cast<double>(u[i]) * static_cast<double>(u[i]);
        };
        if (shares == nullptr)
            sum += sum_over(rows, square_at);
        else
            sum += sum_over(rows, [&, share = (*shares)[axis].data()](std::ptrdiff_t i) {
                return static_cast<double>(share[i]) * square_at(i);
            });
        result.largest = std::max(result.largest, of_size(most));
        result.sum_of_largest += of_size(most);
    }
    result.half_square = 0.5 * sum;
    return result;
}

}  // namespace thaum::fluid
