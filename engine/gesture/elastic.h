// gesture/elastic.h: elastic distance between shapes, for eight templates at once.
//
// Dynamic time warping with a band (Sakoe, Chiba 1978): points of the stroke are matched to points of the
// template in order, each at most `warp_band` places away from its own. The distance is the least sum of
// costs over all matchings, divided by the number of points. Two points at squared distance s cost s / (1 + 2
// s), at most 1/2 (Geman, McClure 1985). One wrong corner then cannot outweigh a good match of the rest.
#pragma once
#include <array>
#include <span>

#include "gesture/shape.h"

namespace thaum::gesture {

inline constexpr std::size_t warp_band = 3;
inline constexpr std::size_t lanes = 8;
inline constexpr float robustness = 2;

/// Eight templates side by side: value of channel c of point i of template k at
/// [(i * channels + c) * lanes + k].
template <std::size_t points>
struct alignas(32) EightOf {
    std::array<float, points * max_channels * lanes> values{};
};
/// Eight templates in the coarse form (24 points) in which all are compared first. The best of them are
/// compared again as EightFineShapes.
using EightShapes = EightOf<shape_points>;
/// Eight templates in the fine form (32 points), for the comparison of the best.
using EightFineShapes = EightOf<fine_points>;

/// Puts the values of eight templates side by side, one template in each lane. A template may be given
/// several times, to fill lanes that are not needed.
void set_lanes(EightShapes& eight, std::size_t channels, const std::array<const float*, lanes>& values);
void set_lanes(EightFineShapes& eight, std::size_t channels, const std::array<const float*, lanes>& values);

/// Distances of a stroke to eight templates with the same number of channels, each from 0 to 1/2 if no point
/// is matched twice. The same template gives the same bits in whichever lane it is.
std::array<float, lanes> elastic_distances(const Shape& stroke, const EightShapes& eight);
/// Distances of a stroke to eight templates, all in the fine form of a shape (32 points).
std::array<float, lanes> elastic_distances(const FineShape& stroke, const EightFineShapes& eight,
                                           std::size_t channels);

/// Distances of eight strokes to eight templates, stroke i to template i. Each has the same bits as if
/// elastic_distances had computed it for one stroke.
std::array<float, lanes> elastic_distances(const EightShapes& strokes, const EightShapes& eight,
                                           std::size_t channels);
std::array<float, lanes> elastic_distances(const EightFineShapes& strokes, const EightFineShapes& eight,
                                           std::size_t channels);

}  // namespace thaum::gesture
