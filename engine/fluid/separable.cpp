#include "fluid/separable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/maths.h"
#include "fluid/transpose.h"

namespace thaum::fluid {
namespace {

// ---- waves ----------------------------------------------------------------------------------------------------------

struct Wave {
    double angle;  ///< rad per cell
    bool cosine;
    bool symmetric;
};

/// Of the places at i + 1/2 (cells) or i + 1 (faces between walls), i from 0.
std::vector<Wave> waves_of(int n, Edge edge, Beyond beyond) {
    std::vector<Wave> result;
    if (edge == Edge::periodic) {
        for (int k = 0; 2 * k < n; ++k) result.push_back({2 * pi * k / n, true, true});
        for (int k = 1; 2 * k <= n; ++k) result.push_back({2 * pi * k / n, false, false});
    } else if (beyond == Beyond::even) {
        for (int k = 0; k < n; ++k) result.push_back({pi * k / n, true, k % 2 == 0});
    } else {
        const int most = beyond == Beyond::odd ? n : n - 1;
        for (int k = 1; k <= most; ++k) result.push_back({pi * k / n, false, k % 2 == 1});
    }
    return result;
}

std::vector<double> column(const Wave& wave, int count, double offset) {
    std::vector<double> result;
    double square = 0;
    for (int i = 0; i < count; ++i) {
        const double phase = wave.angle * (i + offset);
        result.push_back(wave.cosine ? det::cos(phase) : det::sin(phase));
        square += result.back() * result.back();
    }
    for (double& value : result) value /= std::sqrt(square);
    return result;
}

std::vector<float> transposed(const std::vector<float>& matrix, std::size_t rows, std::size_t columns) {
    std::vector<float> result(matrix.size());
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c) result[c * rows + r] = matrix[r * columns + c];
    return result;
}

// ---- the change to waves and back -----------------------------------------------------------------------------------

/// Columns that are changed together.
constexpr std::ptrdiff_t wide = 16;
using Vector = float __attribute__((vector_size(32)));

/// out[r] = sum over d of matrix[d][r] in[d], for `rows` at once; every row is `wide` long.
template <int rows>
inline void multiply_block(const float* matrix, std::ptrdiff_t pitch, int depth, const Vector* in,
                           Vector* out) {
    Vector low[rows];
    Vector high[rows];
    // Unrolled, so that the sums stay in registers.
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
        low[r] = matrix[r] * in[0];
        high[r] = matrix[r] * in[1];
    }
    for (int d = 1; d < depth; ++d) {
        matrix += pitch;
#pragma GCC unroll 8
        for (int r = 0; r < rows; ++r) {
            low[r] += matrix[r] * in[2 * d];
            high[r] += matrix[r] * in[2 * d + 1];
        }
    }
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
        out[2 * r] = low[r];
        out[2 * r + 1] = high[r];
    }
}

/// matrix[n][n]
void multiply(const float* matrix, int n, const Vector* in, Vector* out) {
    int r = 0;
    for (; r + 6 <= n; r += 6) multiply_block<6>(matrix + r, n, n, in, out + 2 * r);
    for (; r + 4 <= n; r += 4) multiply_block<4>(matrix + r, n, n, in, out + 2 * r);
    for (; r + 2 <= n; r += 2) multiply_block<2>(matrix + r, n, n, in, out + 2 * r);
    for (; r < n; ++r) multiply_block<1>(matrix + r, n, n, in, out + 2 * r);
}

/// Rows of up to `wide` values, each `pitch` from the next one in memory.
struct Rows {
    float* first;
    std::ptrdiff_t pitch;
};

template <bool whole>
inline void load(const Rows& rows, int row, std::size_t width, Vector* to) {
    if constexpr (!whole) to[0] = to[1] = Vector{};
    std::memcpy(to, rows.first + row * rows.pitch, sizeof(float) * (whole ? std::size_t{wide} : width));
}

template <bool whole>
inline void store(const Rows& rows, int row, std::size_t width, const Vector* from) {
    std::memcpy(rows.first + row * rows.pitch, from, sizeof(float) * (whole ? std::size_t{wide} : width));
}

struct Halves {
    Vector symmetric[cells_most];  // two for each of half of the cells
    Vector antisymmetric[cells_most];
};

template <bool full>
void to_waves(const Waves& waves, const Rows& from, const Rows& to, std::size_t width) {
    const int n = waves.count;
    const int whole = (n + 1) / 2;
    const int half = n / 2;
    Halves folded;
    Halves found;
    for (int i = 0; i < half; ++i) {
        Vector a[2];
        Vector b[2];
        load<full>(from, i, width, a);
        load<full>(from, n - 1 - i, width, b);
        for (int v = 0; v < 2; ++v) {
            folded.symmetric[2 * i + v] = a[v] + b[v];
            folded.antisymmetric[2 * i + v] = a[v] - b[v];
        }
    }
    if (whole > half) load<full>(from, half, width, folded.symmetric + 2 * half);
    multiply(waves.symmetric.data(), whole, folded.symmetric, found.symmetric);
    multiply(waves.antisymmetric.data(), half, folded.antisymmetric, found.antisymmetric);
    for (int k = 0; k < whole; ++k) store<full>(to, k, width, found.symmetric + 2 * k);
    for (int k = 0; k < half; ++k) store<full>(to, whole + k, width, found.antisymmetric + 2 * k);
}

template <bool full>
void from_waves(const Waves& waves, const Rows& from, const Rows& to, std::size_t width) {
    const int n = waves.count;
    const int whole = (n + 1) / 2;
    const int half = n / 2;
    Halves given;
    Halves found;
    for (int k = 0; k < whole; ++k) load<full>(from, k, width, given.symmetric + 2 * k);
    for (int k = 0; k < half; ++k) load<full>(from, whole + k, width, given.antisymmetric + 2 * k);
    multiply(waves.symmetric_back.data(), whole, given.symmetric, found.symmetric);
    multiply(waves.antisymmetric_back.data(), half, given.antisymmetric, found.antisymmetric);
    for (int i = 0; i < half; ++i) {
        Vector a[2];
        Vector b[2];
        for (int v = 0; v < 2; ++v) {
            a[v] = found.symmetric[2 * i + v] + found.antisymmetric[2 * i + v];
            b[v] = found.symmetric[2 * i + v] - found.antisymmetric[2 * i + v];
        }
        store<full>(to, i, width, a);
        store<full>(to, n - 1 - i, width, b);
    }
    if (whole > half) store<full>(to, half, width, found.symmetric + 2 * half);
}

enum class Way : std::uint8_t { to_waves, from_waves };

/// Along the outer index of from[count][width]; `to` may be the same.
template <Way way>
void change(const Waves& waves, float* from, float* to, std::ptrdiff_t width) {
    std::ptrdiff_t c = 0;
    for (; c + wide <= width; c += wide) {
        if constexpr (way == Way::to_waves)
            to_waves<true>(waves, {from + c, width}, {to + c, width}, wide);
        else
            from_waves<true>(waves, {from + c, width}, {to + c, width}, wide);
    }
    if (c == width) return;
    const auto left = static_cast<std::size_t>(width - c);
    if constexpr (way == Way::to_waves)
        to_waves<false>(waves, {from + c, width}, {to + c, width}, left);
    else
        from_waves<false>(waves, {from + c, width}, {to + c, width}, left);
}

}  // namespace

Waves make_waves(int cells, Edge edge, Beyond beyond) {
    const auto all = waves_of(cells, edge, beyond);
    const bool faces = edge != Edge::periodic && beyond == Beyond::through_wall;
    Waves result{.start = faces ? 1 : 0, .count = static_cast<int>(all.size())};
    const auto whole = static_cast<std::size_t>((result.count + 1) / 2);
    const auto half = static_cast<std::size_t>(result.count / 2);
    for (const bool symmetric : {true, false}) {
        auto& back = symmetric ? result.symmetric_back : result.antisymmetric_back;
        const auto kept = symmetric ? whole : half;
        for (const Wave& wave : all) {
            if (wave.symmetric != symmetric) continue;
            const auto values = column(wave, result.count, faces ? 1.0 : 0.5);
            result.angle.push_back(wave.angle);
            for (std::size_t i = 0; i < kept; ++i) back.push_back(static_cast<float>(values[i]));
        }
    }
    result.symmetric = transposed(result.symmetric_back, whole, whole);
    result.antisymmetric = transposed(result.antisymmetric_back, half, half);
    return result;
}

double pressure_symbol(double angle, int order) {
    const double once = det::sin(angle / 2);
    const double root = order == 2 ? once : (27 * once - det::sin(3 * angle / 2)) / 24;
    return 4 * root * root;
}

double laplace_symbol(double angle, int order) {
    const double once = 2 - 2 * det::cos(angle);
    return order == 2 ? once : (16 * once - (2 - 2 * det::cos(2 * angle))) / 12;
}

PressureSolver::PressureSolver(const Lattice& lattice, int order)
    : scale_(static_cast<float>(-lattice.h * lattice.h)),
      scratch_(static_cast<std::size_t>(lattice.cells[0]) * static_cast<std::size_t>(lattice.cells[1])) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        waves_[axis] = make_waves(lattice.cells[axis], lattice.edges[axis], Beyond::even);
        for (const double angle : waves_[axis].angle)
            symbols_[axis].push_back(static_cast<float>(pressure_symbol(angle, order)));
    }
}

void PressureSolver::solve(std::span<float> field) {
    const std::ptrdiff_t nx = waves_[0].count;
    const std::ptrdiff_t ny = waves_[1].count;
    const std::ptrdiff_t nz = waves_[2].count;
    const std::ptrdiff_t plane = nx * ny;
    float* values = field.data();
    float* turned = scratch_.data();
    for (std::ptrdiff_t k = 0; k < nz; ++k) {
        float* here = values + k * plane;
        change<Way::to_waves>(waves_[1], here, here, nx);
        transpose({here, nx}, {turned, ny}, ny, nx);
        change<Way::to_waves>(waves_[0], turned, here, ny);
    }
    change<Way::to_waves>(waves_[2], values, values, plane);
    for (std::ptrdiff_t k = 0; k < nz; ++k) {
        for (std::ptrdiff_t i = 0; i < nx; ++i) {
            const float outer =
                symbols_[2][static_cast<std::size_t>(k)] + symbols_[0][static_cast<std::size_t>(i)];
            float* row = values + k * plane + i * ny;
            const float* symbols = symbols_[1].data();
            for (std::ptrdiff_t j = 0; j < ny; ++j) row[j] *= scale_ / (outer + symbols[j]);
        }
    }
    values[0] = 0;
    change<Way::from_waves>(waves_[2], values, values, plane);
    for (std::ptrdiff_t k = 0; k < nz; ++k) {
        float* here = values + k * plane;
        change<Way::from_waves>(waves_[0], here, turned, ny);
        transpose({turned, ny}, {here, nx}, nx, ny);
        change<Way::from_waves>(waves_[1], here, here, nx);
    }
}

}  // namespace thaum::fluid
