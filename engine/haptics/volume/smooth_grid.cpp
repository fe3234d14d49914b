#include "haptics/volume/smooth_grid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/doubles4.h"

namespace thaum::haptics {
namespace {

constexpr std::size_t smooth_taps = 8;
using SmoothRow = std::array<double, smooth_taps>;

/// The samples along one axis that the smoothing kernel uses, with their weights for value and slope.
struct SmoothTaps {
    std::array<std::ptrdiff_t, smooth_taps> offset{};
    SmoothRow value{}, slope{};
    int first{}, count{};  ///< index of the first sample used, and number of samples along the axis
    bool whole{};          ///< the kernel does not reach beyond the first or the last sample
    bool adjacent{};       ///< true: `whole` is true, and the samples follow each other in memory
};

/// Weights of eight samples, from the weights `w` of four averages. Each average is over five neighbouring
/// samples, weighted 1 : 4 : 6 : 4 : 1.
SmoothRow spread(const std::array<double, 4>& w) {
    constexpr std::array<double, 5> binomial{1.0 / 16, 4.0 / 16, 6.0 / 16, 4.0 / 16, 1.0 / 16};
    SmoothRow result{};
    for (std::size_t i = 0; i < w.size(); ++i) {
        for (std::size_t j = 0; j < binomial.size(); ++j) result[i + j] += w[i] * binomial[j];
    }
    return result;
}

/// Gives the weights of samples beyond the border to their mirror images at the border sample, so that each
/// gradient beyond counts as its image. For the slope along this axis, a sample beyond is then as much above
/// the border sample as its image is below. For slopes along the other axes, it equals its image.
void mirror(SmoothTaps& taps) {
    const auto tap_of = [&](int sample) {
        return static_cast<std::size_t>(std::clamp(sample, 0, taps.count - 1) - taps.first);
    };
    for (std::size_t tap = 0; tap < smooth_taps; ++tap) {
        const int sample = taps.first + static_cast<int>(tap), border = std::clamp(sample, 0, taps.count - 1);
        if (sample == border) continue;
        const double value = std::exchange(taps.value[tap], 0), slope = std::exchange(taps.slope[tap], 0);
        const std::size_t image = tap_of(2 * border - sample);
        taps.value[image] += value;
        taps.slope[image] -= slope;
        taps.slope[tap_of(border)] += 2 * slope;
    }
}

/// Computes the samples and weights for a place x (in samples from the first one). `per_metre` is the number
/// of samples in a metre (1/m).
SmoothTaps smooth_taps_at(double x, int count, std::ptrdiff_t stride, double per_metre) {
    const double inside = std::clamp(x, 0.0, static_cast<double>(count - 1));
    const int low = std::min(static_cast<int>(inside), std::max(count - 2, 0));
    const double t = inside - low, u = 1 - t;
    SmoothTaps taps;
    taps.value = spread({u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                         (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6});
    taps.slope = spread({-u * u / 2, (3 * t * t - 4 * t) / 2, (4 * u - 3 * u * u) / 2, t * t / 2});
    for (std::size_t i = 0; i < smooth_taps; ++i) {
        taps.offset[i] = std::clamp(low - 3 + static_cast<int>(i), 0, count - 1) * stride;
        taps.slope[i] *= per_metre;
    }
    taps.first = low - 3;
    taps.count = count;
    taps.whole = low >= 3 && low + 4 < count;
    taps.adjacent = stride == 1 && taps.whole;
    return taps;
}

/// A number for each of the eight samples along x, as two vectors of four.
struct SmoothLanes {
    Doubles4 low{}, high{};

    void add(double weight, const SmoothLanes& other) {
        low += weight * other.low;
        high += weight * other.high;
    }
    SmoothRow row() const { return {low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]}; }
};

template <class T>
SmoothLanes samples_of(const T* row, const SmoothTaps& x, const field::ShownRange& shown = {}) {
    SmoothLanes lanes;
    for (std::size_t i = 0; i < 4; ++i) {
        lanes.low[i] = static_cast<double>(shown(static_cast<float>(row[x.offset[i]])));
        lanes.high[i] = static_cast<double>(shown(static_cast<float>(row[x.offset[i + 4]])));
    }
    return lanes;
}

template <class T>
SmoothLanes adjacent_samples(const T* row) {
    // Not an alias: GCC would ignore its attribute, because T is a parameter.
    typedef T Samples4 __attribute__((vector_size(4 * sizeof(T))));
    Samples4 low, high;
    std::memcpy(&low, row, sizeof low);
    std::memcpy(&high, row + 4, sizeof high);
    return {__builtin_convertvector(low, Doubles4), __builtin_convertvector(high, Doubles4)};
}

/// Weighted sums over y and z for each of the eight samples along x. The sum along x comes last, so that
/// vector instructions handle the eight samples at once.
struct SmoothSums {
    SmoothLanes value{}, along_y{}, along_z{};
};

/// Computes the sums of the samples' differences from `base`, so that equal samples give exact zeros (as in
/// field::Grid). `lanes_of` gives the samples of a row along x.
template <class T, class LanesOf>
SmoothSums sums_of(const T* first, double base, const SmoothTaps& y, const SmoothTaps& z, LanesOf lanes_of) {
    SmoothSums sums;
    for (std::size_t k = 0; k < smooth_taps; ++k) {
        SmoothLanes value, along_y;
        for (std::size_t j = 0; j < smooth_taps; ++j) {
            SmoothLanes samples = lanes_of(first + (z.offset[k] + y.offset[j]));
            samples.low -= base;
            samples.high -= base;
            value.add(y.value[j], samples);
            along_y.add(y.slope[j], samples);
        }
        sums.value.add(z.value[k], value);
        sums.along_y.add(z.value[k], along_y);
        sums.along_z.add(z.slope[k], value);
    }
    return sums;
}

field::Scalar scalar_of(const SmoothSums& sums, double base, const SmoothTaps& x) {
    const SmoothRow value = sums.value.row(), along_y = sums.along_y.row(), along_z = sums.along_z.row();
    field::Scalar result;
    for (std::size_t i = 0; i < smooth_taps; ++i) {
        result.value += x.value[i] * value[i];
        result.gradient += vec3(x.slope[i] * value[i], x.value[i] * along_y[i], x.value[i] * along_z[i]);
    }
    result.value += base;
    return result;
}

/// Value and gradient, from the grid's first sample and the weights along each axis.
template <class T>
field::Scalar weighted_sum(const T* first, const field::ShownRange& shown, const SmoothTaps& x,
                           const SmoothTaps& y, const SmoothTaps& z) {
    const auto middle = static_cast<float>(first[x.offset[3] + y.offset[3] + z.offset[3]]);
    const auto as_stored = [&](const T* row) {
        return x.adjacent ? adjacent_samples(row + x.offset[0]) : samples_of(row, x);
    };
    const field::Scalar result = scalar_of(sums_of(first, middle, y, z, as_stored), middle, x);
    // A sample that is not finite makes the result not finite. Only then is the result computed again, with
    // such samples replaced by what a picture shows for them; that takes longer.
    if (std::isfinite(result.value)) return result;
    const auto as_shown = [&](const T* row) { return samples_of(row, x, shown); };
    const double base = shown(middle);
    return scalar_of(sums_of(first, base, y, z, as_shown), base, x);
}

/// Value and gradient at a place. `mirrored`: each gradient beyond the border counts as its mirror image.
field::Scalar read(const SmoothGrid& from, vec3 place, bool mirrored) {
    const field::Grid& grid = from.grid;
    if (!grid.has_samples() || !is_finite(place)) return {};
    const vec3 at = (place - grid.origin) / grid.spacing, per_metre = 1.0 / grid.spacing;
    SmoothTaps x = smooth_taps_at(at.x, grid.count[0], grid.stride[0], per_metre.x);
    SmoothTaps y = smooth_taps_at(at.y, grid.count[1], grid.stride[1], per_metre.y);
    SmoothTaps z = smooth_taps_at(at.z, grid.count[2], grid.stride[2], per_metre.z);
    const auto sum = [&] {
        return grid.with_samples([&](const auto* first) { return weighted_sum(first, from.shown, x, y, z); });
    };
    field::Scalar here = sum();
    if (!mirrored || (x.whole && y.whole && z.whole)) return here;
    for (SmoothTaps* taps : {&x, &y, &z}) mirror(*taps);
    here.gradient = sum().gradient;
    return here;
}

}  // namespace

field::Scalar SmoothGrid::operator()(vec3 place) const { return read(*this, place, true); }

field::Scalar SmoothGrid::ending_level(vec3 place) const { return read(*this, place, false); }

field::SampleBox SmoothGrid::sample_box() const {
    const vec3 half = 0.5 * grid.spacing * vec3(grid.count[0] - 1, grid.count[1] - 1, grid.count[2] - 1);
    field::SampleBox box{.bounded = grid.has_samples() && *std::ranges::min_element(grid.count) >= 2,
                         .drawn = grid,
                         .averages = averages,
                         .coarse_steps = coarse_steps,
                         .shown = shown,
                         .middle = grid.origin + half,
                         .half = half,
                         .spacing = grid.spacing};
    box.drawn.kernel = field::Kernel::linear;
    return box;
}

}  // namespace thaum::haptics
