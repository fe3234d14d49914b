#include "fluid/sums.h"

#include <algorithm>
#include <bit>

namespace thaum::fluid {
namespace {

/// Side by side, so that they are added at the speed of vectors.
constexpr std::ptrdiff_t lanes = 8;

template <class Term>
double sum_over(const Lattice& lattice, Term&& term) {
    std::array<double, lanes> sums{};
    const std::ptrdiff_t whole = lattice.cells[0] / lanes * lanes;
    each_row(lattice, [&](std::ptrdiff_t at) {
        for (std::ptrdiff_t i = 0; i < whole; i += lanes)
            for (std::ptrdiff_t lane = 0; lane < lanes; ++lane)
                sums[static_cast<std::size_t>(lane)] += term(at + i + lane);
        for (std::ptrdiff_t i = whole; i < lattice.cells[0]; ++i) sums[0] += term(at + i);
    });
    double sum = 0;
    for (const double part : sums) sum += part;
    return sum;
}

}  // namespace

double total(const Lattice& lattice, const Samples& samples) {
    return sum_over(lattice,
                    [values = samples.data()](std::ptrdiff_t i) { return static_cast<double>(values[i]); });
}

double dot(const Lattice& lattice, const Samples& a, const Samples& b) {
    return sum_over(lattice, [x = a.data(), y = b.data()](std::ptrdiff_t i) {
        return static_cast<double>(x[i]) * static_cast<double>(y[i]);
    });
}

double largest(const Lattice& lattice, const Samples& samples) {
    // As integers, which compare like the sizes of floats and, unlike these, side by side.
    std::uint32_t most = 0;
    const std::ptrdiff_t nx = lattice.cells[0];
    each_row(lattice, [&](std::ptrdiff_t at) {
        const float* row = samples.data() + at;
        for (std::ptrdiff_t i = 0; i < nx; ++i)
            most = std::max(most, std::bit_cast<std::uint32_t>(row[i]) & 0x7fffffffU);
    });
    return static_cast<double>(std::bit_cast<float>(most));
}

}  // namespace thaum::fluid
