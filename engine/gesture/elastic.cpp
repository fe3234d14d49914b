#include "gesture/elastic.h"

#include <algorithm>
#include <cstring>

namespace thaum::gesture {
namespace {

using Floats8 = float __attribute__((vector_size(32)));

constexpr float far = 1e30F;  // more than any sum of costs

inline Floats8 smaller(Floats8 a, Floats8 b) { return a < b ? a : b; }

inline Floats8 load8(const float* from) {
    Floats8 v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

/// One stroke for all lanes, or eight strokes in the layout of EightShapes.
struct OneStroke {
    const float* values;
    Floats8 at(std::size_t place) const { return values[place] + Floats8{}; }
};
struct EightStrokes {
    const float* values;
    Floats8 at(std::size_t place) const { return load8(values + place * lanes); }
};

template <std::size_t points, std::size_t channels, class Strokes>
void warp8(Strokes stroke, const float* eight, float* result) {
    const Floats8 infinite = far + Floats8{};
    std::array<Floats8, points + 2> rows[2];
    rows[0].fill(infinite);
    rows[1].fill(infinite);
    rows[0][0] = Floats8{};
    for (std::size_t i = 1; i <= points; ++i) {
        std::array<Floats8, channels> p;
        for (std::size_t c = 0; c < channels; ++c) p[c] = stroke.at((i - 1) * channels + c);
        auto& row = rows[i % 2];
        const auto& above = rows[(i + 1) % 2];
        const std::size_t low = i > warp_band ? i - warp_band : 1, high = std::min(points, i + warp_band);
        row[low - 1] = infinite;
        row[high + 1] = infinite;
        for (std::size_t j = low; j <= high; ++j) {
            const float* q = eight + (j - 1) * channels * lanes;
            Floats8 s{};
            for (std::size_t c = 0; c < channels; ++c) {
                const Floats8 d = p[c] - load8(q + c * lanes);
                s += d * d;
            }
            row[j] = s / (1 + robustness * s) + smaller(above[j - 1], smaller(above[j], row[j - 1]));
        }
        rows[0][0] = infinite;
    }
    const Floats8 sum = rows[points % 2][points] / static_cast<float>(points);
    std::memcpy(result, &sum, sizeof sum);
}

template <std::size_t points, class Strokes>
std::array<float, lanes> distances_of(Strokes stroke, const EightOf<points>& eight, std::size_t channels) {
    std::array<float, lanes> result{};
    if (channels == planar_channels) {
        warp8<points, planar_channels>(stroke, eight.values.data(), result.data());
    } else {
        warp8<points, solid_channels>(stroke, eight.values.data(), result.data());
    }
    return result;
}

template <std::size_t points>
void transpose(EightOf<points>& eight, std::size_t channels, const std::array<const float*, lanes>& values) {
    for (std::size_t i = 0; i < points * channels; i += lanes) {  // eight by eight
        std::array<Floats8, lanes> r, s;
        for (std::size_t k = 0; k < lanes; ++k) r[k] = load8(values[k] + i);
        for (std::size_t k = 0; k < 4; ++k) {
            s[2 * k] = __builtin_shufflevector(r[k], r[k + 4], 0, 8, 1, 9, 2, 10, 3, 11);
            s[2 * k + 1] = __builtin_shufflevector(r[k], r[k + 4], 4, 12, 5, 13, 6, 14, 7, 15);
        }
        for (int round = 0; round < 2; ++round) {
            r = s;
            for (std::size_t k = 0; k < 4; ++k) {
                s[2 * k] = __builtin_shufflevector(r[k], r[k + 4], 0, 8, 1, 9, 2, 10, 3, 11);
                s[2 * k + 1] = __builtin_shufflevector(r[k], r[k + 4], 4, 12, 5, 13, 6, 14, 7, 15);
            }
        }
        std::memcpy(&eight.values[i * lanes], s.data(), sizeof s);
    }
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
