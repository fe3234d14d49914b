#include "fluid/detail/separable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/maths.h"
#include "fluid/detail/part_of_row.h"
#include "fluid/detail/transpose.h"
#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

// ---- waves -----------------------------------------------------------------------------------------------

struct Wave {
    double angle;  ///< phase per cell (rad)
    bool cosine;
};

/// All waves (eigenvectors of the second difference, separable.h) along an axis of n cells. Place i (from 0)
/// lies at i + 1/2 (cell centres) or at i + 1 (faces between walls).
std::vector<Wave> waves_of(int n, Edge edge, GhostRule rule) {
    std::vector<Wave> result;
    if (edge == Edge::periodic) {
        for (int k = 0; 2 * k < n; ++k) result.push_back({2 * pi * k / n, true});
        for (int k = 1; 2 * k <= n; ++k) result.push_back({2 * pi * k / n, false});
    } else if (rule == GhostRule::even) {
        for (int k = 0; k < n; ++k) result.push_back({pi * k / n, true});
    } else {
        const int most = rule == GhostRule::odd ? n : n - 1;
        for (int k = 1; k <= most; ++k) result.push_back({pi * k / n, false});
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

/// Shortest range of places that is folded, that is, replaced by sums and differences of mirrored places.
/// Folding a shorter one would take longer than the work it saves.
constexpr int min_fold = 8;
constexpr double symmetry_error = 1e-9;

/// The values of a wave at each place.
struct SampledWave {
    double angle;
    std::vector<double> values;
};

/// Whether a wave equals `sign` times its own mirror image about the middle of a range of places.
bool mirrored(const SampledWave& column, const CellRange& places, double sign) {
    const double* here = column.values.data() + places.first;
    for (int i = 0; i < places.count; ++i) {
        const double low = here[i], high = here[places.count - 1 - i];
        if (std::abs(low - sign * high) > symmetry_error) return false;
    }
    return true;
}

void add_dense(const std::vector<SampledWave>& columns, const CellRange& places, Waves& waves) {
    const auto n = columns.size();
    std::vector<double> exact(n * n);
    std::vector<float> forth(n * n);
    std::vector<float> back(n * n);
    for (std::size_t k = 0; k < n; ++k) {
        waves.angle.push_back(columns[k].angle);
        for (std::size_t i = 0; i < n; ++i) {
            exact[k * n + i] = columns[k].values[static_cast<std::size_t>(places.first) + i];
            back[k * n + i] = forth[i * n + k] = static_cast<float>(exact[k * n + i]);
        }
    }
    waves.dense.push_back(places);
    waves.exact.push_back(std::move(exact));
    waves.forth.push_back(std::move(forth));
    waves.back.push_back(std::move(back));
}

/// Folds a range of places (replaces mirrored places by their sums and differences), then its halves, as long
/// as each wave is symmetric or antisymmetric about the middle. There are as many waves as places.
void fold_waves(const std::vector<SampledWave>& columns, const CellRange& places, Waves& waves) {
    if (places.count == 0) return;
    std::vector<SampledWave> symmetric;
    std::vector<SampledWave> antisymmetric;
    for (const SampledWave& column : columns) {
        if (mirrored(column, places, 1)) symmetric.push_back(column);
        if (mirrored(column, places, -1)) antisymmetric.push_back(column);
    }
    const bool splits = symmetric.size() + antisymmetric.size() == columns.size();
    if (!splits || (!waves.folds.empty() && places.count < min_fold)) {
        add_dense(columns, places, waves);
        return;
    }
    waves.folds.push_back(places);
    const int half = (places.count + 1) / 2;
    fold_waves(symmetric, {places.first, half}, waves);
    fold_waves(antisymmetric, {places.first + half, places.count - half}, waves);
}

// ---- transform to waves and back -------------------------------------------------------------------------

/// Number of columns of an array that are transformed together, so that vector instructions are used fully.
constexpr std::ptrdiff_t wide = 16;

/// The least multiple of `wide` that is >= n.
std::ptrdiff_t whole_blocks(std::ptrdiff_t n) { return (n + wide - 1) / wide * wide; }

/// out[r] = sum over d of matrix[d][r] in[d], for `rows` values of r at once; every row has `wide`
/// values.
template <int rows>
inline void multiply_block(const float* matrix, std::ptrdiff_t pitch, int depth, const Floats8* in,
                           Floats8* out) {
    Floats8 low[rows];
    Floats8 high[rows];
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

/// Multiplies `in` by a matrix of n x n elements, stored as matrix[in][out].
void multiply(const float* matrix, int n, const Floats8* in, Floats8* out) {
    int r = 0;
    for (; n - r >= 6 && n - r != 8; r += 6) multiply_block<6>(matrix + r, n, n, in, out + 2 * r);
    for (; r + 4 <= n; r += 4) multiply_block<4>(matrix + r, n, n, in, out + 2 * r);
    for (; r + 2 <= n; r += 2) multiply_block<2>(matrix + r, n, n, in, out + 2 * r);
    for (; r < n; ++r) multiply_block<1>(matrix + r, n, n, in, out + 2 * r);
}

/// Rows of `width` values, at most `wide`. Consecutive rows are `pitch` apart in memory.
struct RowBlock {
    float* first;
    std::ptrdiff_t pitch;
    std::size_t width;
};

/// Copies one row of a block. `whole` means that the width equals `wide`, a compile-time constant, which is
/// faster.
template <bool whole>
inline void load_row(const RowBlock& rows, int row, Floats8* to) {
    const float* from = rows.first + row * rows.pitch;
    if constexpr (whole) {
        std::memcpy(to, from, sizeof(float) * wide);
    } else {
        to[0] = to[1] = zero8;
        copy_part(from, to, rows.width);
    }
}

template <bool whole>
inline void store_row(const RowBlock& rows, int row, const Floats8* from) {
    float* to = rows.first + row * rows.pitch;
    if constexpr (whole) {
        std::memcpy(to, from, sizeof(float) * wide);
    } else {
        copy_part(from, to, rows.width);
    }
}

/// Replaces each place and its mirror image by their sum and their difference.
inline void fold(const CellRange& places, Floats8* values) {
    for (int low = places.first, high = low + places.count - 1; low < high; ++low, --high) {
        for (int v = 0; v < 2; ++v) {
            const Floats8 a = values[2 * low + v];
            const Floats8 b = values[2 * high + v];
            values[2 * low + v] = a + b;
            values[2 * high + v] = b - a;
        }
    }
}

inline void unfold(const CellRange& places, Floats8* values) {
    for (int low = places.first, high = low + places.count - 1; low < high; ++low, --high) {
        for (int v = 0; v < 2; ++v) {
            const Floats8 a = values[2 * low + v];
            const Floats8 b = values[2 * high + v];
            values[2 * low + v] = a - b;
            values[2 * high + v] = a + b;
        }
    }
}

/// Direction of a transform. `through` goes to waves and back by one matrix from places to places, with folds
/// before and after it.
enum class TransformDirection : std::uint8_t { to_waves, from_waves, through };

/// The matrices of a transform, [in][out]: one for each dense range, a range of places that remains after all
/// folds.
struct DenseTransform {
    const Waves& waves;
    const std::vector<std::vector<float>>& matrices;
};

template <TransformDirection direction, bool from_whole, bool to_whole>
void change_columns(const DenseTransform& by, const RowBlock& from, const RowBlock& to) {
    const Waves& waves = by.waves;
    Floats8 given[2 * max_cells];
    Floats8 found[2 * max_cells];
    for (int i = 0; i < waves.count; ++i) load_row<from_whole>(from, i, given + 2 * i);
    if constexpr (direction != TransformDirection::from_waves)
        for (const CellRange& places : waves.folds) fold(places, given);
    for (std::size_t d = 0; d < waves.dense.size(); ++d) {
        const CellRange& places = waves.dense[d];
        multiply(by.matrices[d].data(), places.count, given + 2 * places.first, found + 2 * places.first);
    }
    if constexpr (direction != TransformDirection::to_waves)
        for (auto places = waves.folds.rbegin(); places != waves.folds.rend(); ++places)
            unfold(*places, found);
    for (int i = 0; i < waves.count; ++i) store_row<to_whole>(to, i, found + 2 * i);
}

/// Arrays of columns side by side, whose rows are `pitch` apart in memory.
struct Columns {
    float* first;
    std::ptrdiff_t pitch;
};

/// Transforms each of `width` columns, that is, along the outer index; `to` may be the same array. Rows whose
/// pitch leaves room for whole blocks of columns are read and written to the end of the last block, which is
/// faster.
template <TransformDirection direction>
void change(const DenseTransform& by, const Columns& from, const Columns& to, std::ptrdiff_t width) {
    std::ptrdiff_t c = 0;
    for (; c + wide <= width; c += wide)
        change_columns<direction, true, true>(by, {from.first + c, from.pitch, wide},
                                              {to.first + c, to.pitch, wide});
    if (c == width) return;
    const auto left = static_cast<std::size_t>(width - c);
    const RowBlock in{from.first + c, from.pitch, left}, out{to.first + c, to.pitch, left};
    const bool from_whole = from.pitch >= c + wide, to_whole = to.pitch >= c + wide;
    if (from_whole)
        change_columns<direction, true, false>(by, in, out);
    else if (to_whole)
        change_columns<direction, false, true>(by, in, out);
    else
        change_columns<direction, false, false>(by, in, out);
}

/// Solves a Poisson equation on waves: each product of three waves, one for each axis, is multiplied by scale
/// / ((along + outer) + inner), where the three terms belong to the three waves.
struct SpectralDivision {
    float scale;
    const float* along;          ///< term of each wave along the columns
    const float *outer, *inner;  ///< terms of each column, by its waves along the two other axes
};

template <bool whole>
void divide_columns(const Waves& waves, const SpectralDivision& by, const RowBlock& block,
                    std::ptrdiff_t column) {
    Floats8 given[2 * max_cells];
    Floats8 found[2 * max_cells];
    for (int i = 0; i < waves.count; ++i) load_row<whole>(block, i, given + 2 * i);
    for (const CellRange& places : waves.folds) fold(places, given);
    for (std::size_t d = 0; d < waves.dense.size(); ++d) {
        const CellRange& places = waves.dense[d];
        multiply(waves.forth[d].data(), places.count, given + 2 * places.first, found + 2 * places.first);
    }
    for (std::ptrdiff_t v = 0; v < 2; ++v) {
        const Floats8 outer = load(by.outer + column + 8 * v), inner = load(by.inner + column + 8 * v);
        for (int i = 0; i < waves.count; ++i) found[2 * i + v] *= by.scale / ((by.along[i] + outer) + inner);
    }
    // The first value belongs to the constant wave. It is the mean, which the equation does not determine.
    if (column == 0) found[0][0] = 0;
    for (std::size_t d = 0; d < waves.dense.size(); ++d) {
        const CellRange& places = waves.dense[d];
        multiply(waves.back[d].data(), places.count, found + 2 * places.first, given + 2 * places.first);
    }
    for (auto places = waves.folds.rbegin(); places != waves.folds.rend(); ++places) unfold(*places, given);
    for (int i = 0; i < waves.count; ++i) store_row<whole>(block, i, given + 2 * i);
}

/// Transforms columns `c` to `end` - 1 of values[count][width] to waves, multiplies each wave by its factor
/// in `by`, and transforms back. `c` is a multiple of `wide`.
void divide_range(const Waves& waves, const SpectralDivision& by, const Columns& values, std::ptrdiff_t c,
                  std::ptrdiff_t end) {
    const std::ptrdiff_t width = values.pitch;
    for (; c + wide <= end; c += wide) divide_columns<true>(waves, by, {values.first + c, width, wide}, c);
    if (c < end)
        divide_columns<false>(waves, by, {values.first + c, width, static_cast<std::size_t>(end - c)}, c);
}

DenseTransform forth(const Waves& waves) { return {waves, waves.forth}; }
DenseTransform back(const Waves& waves) { return {waves, waves.back}; }

/// Matrix that transforms to waves, multiplies each wave k by factor[k] and transforms back; its elements are
/// the sum over k of wave_k[i] factor[k] wave_k[j]. Momentum is the sum over all places, so each row must
/// keep its sum. The rounding error of a row is therefore added to its smallest element, where float has the
/// finest resolution.
std::vector<float> damped(const std::vector<double>& waves, std::span<const double> factor) {
    const std::size_t n = factor.size();
    std::vector<float> result(n * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = std::span(result).subspan(i * n, n);
        double lost = 0;
        for (std::size_t j = 0; j < n; ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < n; ++k) sum += factor[k] * waves[k * n + i] * waves[k * n + j];
            row[j] = static_cast<float>(sum);
            lost += sum - static_cast<double>(row[j]);
        }
        *std::ranges::min_element(row, {}, [](float x) { return std::abs(x); }) += static_cast<float>(lost);
    }
    return result;
}

}  // namespace

Waves make_waves(int cells, Edge edge, GhostRule rule) {
    const auto all = waves_of(cells, edge, rule);
    const bool faces = edge != Edge::periodic && rule == GhostRule::through_wall;
    Waves result{.start = faces ? 1 : 0, .count = static_cast<int>(all.size())};
    std::vector<SampledWave> columns;
    for (const Wave& wave : all)
        columns.push_back({wave.angle, column(wave, result.count, faces ? 1.0 : 0.5)});
    fold_waves(columns, {0, result.count}, result);
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
    : scale_(static_cast<float>(-lattice.h * lattice.h)) {
    for (auto& scratch : scratch_)
        scratch.resize(static_cast<std::size_t>(lattice.cells[0] * whole_blocks(lattice.cells[1])));
    std::array<std::vector<float>, 3> symbols;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        waves_[axis] = make_waves(lattice.cells[axis], lattice.edges[axis], GhostRule::even);
        for (const double angle : waves_[axis].angle)
            symbols[axis].push_back(static_cast<float>(pressure_symbol(angle, order)));
    }
    for (const float x : symbols[0]) {
        by_x_.insert(by_x_.end(), symbols[1].size(), x);
        by_y_.insert(by_y_.end(), symbols[1].begin(), symbols[1].end());
    }
    // The arrays are padded because vectors of the last columns are read past their end.
    for (auto* by : {&by_x_, &by_y_}) by->resize(by->size() + wide, 1.0F);
    along_z_ = symbols[2];
}

void PressureSolver::to_waves(std::span<float> field, Layers layers, unsigned seat) {
    const std::ptrdiff_t nx = waves_[0].count;
    const std::ptrdiff_t ny = waves_[1].count;
    const std::ptrdiff_t pitch = whole_blocks(ny);
    const Columns turned{scratch_[seat].data(), pitch};
    for (int k = layers.first; k < layers.end; ++k) {
        float* here = field.data() + k * plane();
        change<TransformDirection::to_waves>(forth(waves_[1]), {here, nx}, {here, nx}, nx);
        transpose({here, nx}, {turned.first, pitch}, ny, nx);
        change<TransformDirection::to_waves>(forth(waves_[0]), turned, {here, ny}, ny);
    }
}

int PressureSolver::blocks() const { return static_cast<int>(whole_blocks(plane()) / wide); }

void PressureSolver::divide(std::span<float> field, int first, int end) const {
    divide_range(waves_[2], {scale_, along_z_.data(), by_x_.data(), by_y_.data()}, {field.data(), plane()},
                 first * wide, std::min(end * wide, plane()));
}

void PressureSolver::from_waves(std::span<float> field, Layers layers, unsigned seat) {
    const std::ptrdiff_t nx = waves_[0].count;
    const std::ptrdiff_t ny = waves_[1].count;
    const std::ptrdiff_t pitch = whole_blocks(ny);
    const Columns turned{scratch_[seat].data(), pitch};
    for (int k = layers.first; k < layers.end; ++k) {
        float* here = field.data() + k * plane();
        change<TransformDirection::from_waves>(back(waves_[0]), {here, ny}, turned, ny);
        transpose({turned.first, pitch}, {here, nx}, nx, ny);
        change<TransformDirection::from_waves>(back(waves_[1]), {here, nx}, {here, nx}, nx);
    }
}

Diffusion::Diffusion(const Lattice& lattice, int order) : lattice_(lattice), order_(order) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto rule = ghost_rules_of_velocity(lattice, axis);
        for (std::size_t across = 0; across < 3; ++across)
            waves_[axis][across] = make_waves(lattice.cells[across], lattice.edges[across], rule[across]);
    }
    packed_.resize(static_cast<std::size_t>(lattice.cells[0]) * static_cast<std::size_t>(lattice.cells[1]) *
                   static_cast<std::size_t>(lattice.cells[2]));
    turned_.resize(static_cast<std::size_t>(lattice.cells[0]) * static_cast<std::size_t>(lattice.cells[1]));
}

void Diffusion::diffuse(double part, double lid, std::array<Samples, 3>& velocity) {
    const auto carried = [&](int j) { return static_cast<float>(lid * (j + 0.5) / lattice_.cells[1]); };
    const auto add_carried = [&](float sign) {
        each_row(lattice_, [&](std::ptrdiff_t at) {
            const auto j = (at - lattice_.first) % lattice_.stride[2] / lattice_.stride[1];
            float* row = velocity[0].data() + at;
            for (int i = 0; i < lattice_.cells[0]; ++i) row[i] += sign * carried(static_cast<int>(j));
        });
    };
    // The linear profile of a moving wall's steady flow is subtracted, because diffusion does not
    // change it.
    if (lid != 0) add_carried(-1);
    if (part != part_) make_matrices(part);
    for (std::size_t axis = 0; axis < 3; ++axis) component(waves_[axis], matrices_[axis], velocity[axis]);
    if (lid != 0) add_carried(1);
}

void Diffusion::make_matrices(double part) {
    part_ = part;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t across = 0; across < 3; ++across) {
            const Waves& waves = waves_[axis][across];
            std::vector<double> factor;
            for (const double angle : waves.angle)
                factor.push_back(det::exp(-part * laplace_symbol(angle, order_)));
            auto& matrices = matrices_[axis][across];
            matrices.clear();
            for (std::size_t d = 0; d < waves.dense.size(); ++d) {
                const CellRange& places = waves.dense[d];
                matrices.push_back(damped(waves.exact[d],
                                          std::span(factor).subspan(static_cast<std::size_t>(places.first),
                                                                    static_cast<std::size_t>(places.count))));
            }
        }
    }
}

void Diffusion::component(const std::array<Waves, 3>& waves, const std::array<Matrices, 3>& matrices,
                          Samples& u) {
    const std::array<DenseTransform, 3> tables{
        {{waves[0], matrices[0]}, {waves[1], matrices[1]}, {waves[2], matrices[2]}}};
    const std::ptrdiff_t nx = waves[0].count;
    const std::ptrdiff_t ny = waves[1].count;
    const std::ptrdiff_t nz = waves[2].count;
    const std::ptrdiff_t plane = nx * ny;
    float* values = packed_.data();
    float* turned = turned_.data();
    const auto row_of = [&](std::ptrdiff_t j, std::ptrdiff_t k) {
        return u.data() + lattice_.at(waves[0].start, waves[1].start + static_cast<int>(j),
                                      waves[2].start + static_cast<int>(k));
    };
    for (std::ptrdiff_t k = 0; k < nz; ++k) {
        float* here = values + k * plane;
        for (std::ptrdiff_t j = 0; j < ny; ++j) std::copy_n(row_of(j, k), nx, here + j * nx);
        change<TransformDirection::through>(tables[1], {here, nx}, {here, nx}, nx);
        transpose({here, nx}, {turned, ny}, ny, nx);
        change<TransformDirection::through>(tables[0], {turned, ny}, {turned, ny}, ny);
        transpose({turned, ny}, {here, nx}, nx, ny);
    }
    change<TransformDirection::through>(tables[2], {values, plane}, {values, plane}, plane);
    for (std::ptrdiff_t k = 0; k < nz; ++k)
        for (std::ptrdiff_t j = 0; j < ny; ++j) std::copy_n(values + k * plane + j * nx, nx, row_of(j, k));
}

}  // namespace thaum::fluid
