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

template <std::size_t channels, class Strokes>
void warp8(Strokes stroke, const float* eight, float* result) {
    const Floats8 infinite = far + Floats8{};
    std::array<Floats8, shape_points + 2> rows[2];
    rows[0].fill(infinite);
    rows[1].fill(infinite);
    rows[0][0] = Floats8{};
    for (std::size_t i = 1; i <= shape_points; ++i) {
        std::array<Floats8, channels> p;
        for (std::size_t c = 0; c < channels; ++c) p[c] = stroke.at((i - 1) * channels + c);
        auto& row = rows[i % 2];
        const auto& above = rows[(i + 1) % 2];
        const std::size_t low = i > warp_band ? i - warp_band : 1,
                          high = std::min(shape_points, i + warp_band);
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
    const Floats8 sum = rows[shape_points % 2][shape_points] / static_cast<float>(shape_points);
    std::memcpy(result, &sum, sizeof sum);
}

}  // namespace

void set_lanes(EightShapes& eight, std::size_t channels, const std::array<const float*, lanes>& values) {
    for (std::size_t i = 0; i < shape_points * channels; i += lanes) {  // transposes eight by eight
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

std::array<float, lanes> elastic_distances(const Shape& stroke, const EightShapes& eight) {
    std::array<float, lanes> result{};
    if (stroke.channels == planar_channels) {
        warp8<planar_channels>(OneStroke{stroke.values.data()}, eight.values.data(), result.data());
    } else {
        warp8<solid_channels>(OneStroke{stroke.values.data()}, eight.values.data(), result.data());
    }
    return result;
}

std::array<float, lanes> elastic_distances(const EightShapes& strokes, const EightShapes& eight,
                                           std::size_t channels) {
    std::array<float, lanes> result{};
    if (channels == planar_channels) {
        warp8<planar_channels>(EightStrokes{strokes.values.data()}, eight.values.data(), result.data());
    } else {
        warp8<solid_channels>(EightStrokes{strokes.values.data()}, eight.values.data(), result.data());
    }
    return result;
}

}  // namespace thaum::gesture
