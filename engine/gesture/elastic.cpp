#include "gesture/elastic.h"

#include <algorithm>

#include "gesture/detail/vectors.h"

namespace thaum::gesture {
namespace {

constexpr float far = 1e30F;  // a value larger than any sum of costs

/// Type that holds the lanes (numbers of different templates) that are computed together: as many as fit in a
/// register. Lanes do not affect one another, so their number does not change the results.
#ifdef __AVX__
using Wide = Floats8;
using WideBits = Ints8;
#else
using Wide = Floats4;
using WideBits = Ints4;
#endif
constexpr std::size_t width = sizeof(Wide) / sizeof(float);

/// The smaller of two numbers that are not negative. Their bits compare in the same order as the numbers, and
/// the processor can compare integers while it adds floats.
inline Wide smaller_of(Wide a, Wide b) {
    const auto x = reinterpret_cast<WideBits>(a), y = reinterpret_cast<WideBits>(b);
    return reinterpret_cast<Wide>(x < y ? x : y);
}

/// The strokes that are compared with the eight templates in the lanes. OneStroke gives all lanes the same
/// stroke, EightStrokes gives each its own (in the layout of EightShapes). `from` leaves out the lanes before
/// a given one.
struct OneStroke {
    const float* values;
    OneStroke from(std::size_t) const { return *this; }
    Wide at(std::size_t place) const { return values[place] + Wide{}; }
};
struct EightStrokes {
    const float* values;
    EightStrokes from(std::size_t lane) const { return {values + lane}; }
    Wide at(std::size_t place) const { return load<Wide>(values + place * lanes); }
};

/// Costs of matching one point of a stroke to one of a template, lane by lane (template by template), times
/// `robustness`. Only the final sum of costs is divided by `robustness`, which saves a multiplication for
/// each pair of points. As it is a power of two, this changes no bit.
template <std::size_t channels>
inline Wide cost_of(const std::array<Wide, channels>& p, const float* q) {
    Wide squares = p[0] - load<Wide>(q);
    squares *= squares;
    for (std::size_t c = 1; c < channels; ++c) {
        const Wide d = p[c] - load<Wide>(q + c * lanes);
        squares += d * d;
    }
    return squares / (1 / robustness + squares);
}

template <std::size_t points, std::size_t channels, class Strokes>
void warp(Strokes stroke, const float* eight, float* result) {
    const Wide infinite = far + Wide{};
    // One row of the table of dynamic time warping: least sum of costs up to each point of the template. The
    // sums for the next point of the stroke replace them.
    std::array<Wide, points + 2> row;
    row.fill(infinite);
    row[0] = Wide{};
    for (std::size_t i = 1; i <= points; ++i) {
        std::array<Wide, channels> p;
        for (std::size_t c = 0; c < channels; ++c) p[c] = stroke.at((i - 1) * channels + c);
        const std::size_t low = i > warp_band ? i - warp_band : 1, high = std::min(points, i + warp_band);
        Wide before = row[low - 1], left = infinite;
        const float* q = eight + (low - 1) * channels * lanes;
#pragma GCC unroll 7
        for (std::size_t j = low; j <= high; ++j, q += channels * lanes) {
            const Wide above = row[j];
            left = cost_of<channels>(p, q) + smaller_of(smaller_of(before, above), left);
            before = above;
            row[j] = left;
        }
        row[0] = infinite;
    }
    const Wide sum = row[points] / (robustness * static_cast<float>(points));
    store(result, sum);
}

template <std::size_t points, class Strokes>
std::array<float, lanes> distances_of(Strokes stroke, const EightOf<points>& eight, std::size_t channels) {
    std::array<float, lanes> result{};
    for (std::size_t lane = 0; lane < lanes; lane += width) {
        if (channels == planar_channels) {
            warp<points, planar_channels>(stroke.from(lane), eight.values.data() + lane,
                                          result.data() + lane);
        } else {
            warp<points, solid_channels>(stroke.from(lane), eight.values.data() + lane, result.data() + lane);
        }
    }
    return result;
}

#ifdef __AVX__
/// Four values of each of eight templates. Element k has those of template k and then those of template k +
/// 4.
using FourOfEight = std::array<Floats8, 4>;

inline FourOfEight load_four(const std::array<const float*, lanes>& values, std::size_t place) {
    FourOfEight rows;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto low = load<Floats4>(values[k] + place), high = load<Floats4>(values[k + 4] + place);
        rows[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    }
    return rows;
}

/// Transposes four values of each template, from index `place` on, so that the values of all templates are
/// adjacent.
inline void transpose_four(const std::array<const float*, lanes>& values, std::size_t place, float* to) {
    const auto [a, b, c, d] = load_four(values, place);
    const Floats8 ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
                  ab2 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
                  cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
                  cd2 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    store(to, __builtin_shufflevector(ab, cd, 0, 1, 8, 9, 4, 5, 12, 13));
    store(to + lanes, __builtin_shufflevector(ab, cd, 2, 3, 10, 11, 6, 7, 14, 15));
    store(to + 2 * lanes, __builtin_shufflevector(ab2, cd2, 0, 1, 8, 9, 4, 5, 12, 13));
    store(to + 3 * lanes, __builtin_shufflevector(ab2, cd2, 2, 3, 10, 11, 6, 7, 14, 15));
}
#else
/// Transposes four values of each template, from index `place` on, so that the values of all templates are
/// adjacent. This version is for processors without registers of eight floats, on which the version with
/// vectors of eight floats would be much slower.
inline void transpose_four(const std::array<const float*, lanes>& values, std::size_t place, float* to) {
    for (std::size_t k = 0; k < lanes; k += 4, to += 4) {
        const auto a = load<Floats4>(values[k] + place), b = load<Floats4>(values[k + 1] + place),
                   c = load<Floats4>(values[k + 2] + place), d = load<Floats4>(values[k + 3] + place);
        const Floats4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                      ab2 = __builtin_shufflevector(a, b, 2, 6, 3, 7),
                      cd = __builtin_shufflevector(c, d, 0, 4, 1, 5),
                      cd2 = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        store(to, __builtin_shufflevector(ab, cd, 0, 1, 4, 5));
        store(to + lanes, __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
        store(to + 2 * lanes, __builtin_shufflevector(ab2, cd2, 0, 1, 4, 5));
        store(to + 3 * lanes, __builtin_shufflevector(ab2, cd2, 2, 3, 6, 7));
    }
}
#endif

template <std::size_t points>
void transpose(EightOf<points>& eight, std::size_t channels, const std::array<const float*, lanes>& values) {
    // A copy, so that the compiler need not load the pointers again after each store.
    const auto from = values;
    for (std::size_t i = 0; i < points * channels; i += 4) transpose_four(from, i, &eight.values[i * lanes]);
}

}  // namespace

void set_lanes(EightShapes& eight, std::size_t channels, const std::array<const float*, lanes>& values) {
    transpose(eight, channels, values);
}

void set_lanes(EightFineShapes& eight, std::size_t channels, const std::array<const float*, lanes>& values) {
    transpose(eight, channels, values);
}

std::array<float, lanes> elastic_distances(const Shape& stroke, const EightShapes& eight) {
    return distances_of(OneStroke{stroke.values.data()}, eight, stroke.channels);
}

std::array<float, lanes> elastic_distances(const FineShape& stroke, const EightFineShapes& eight,
                                           std::size_t channels) {
    return distances_of(OneStroke{stroke.data()}, eight, channels);
}

std::array<float, lanes> elastic_distances(const EightShapes& strokes, const EightShapes& eight,
                                           std::size_t channels) {
    return distances_of(EightStrokes{strokes.values.data()}, eight, channels);
}

std::array<float, lanes> elastic_distances(const EightFineShapes& strokes, const EightFineShapes& eight,
                                           std::size_t channels) {
    return distances_of(EightStrokes{strokes.values.data()}, eight, channels);
}

}  // namespace thaum::gesture
