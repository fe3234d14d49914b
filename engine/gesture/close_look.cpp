#include "gesture/close_look.h"

#include <algorithm>

namespace thaum::gesture {
namespace {

/// Distances by which the start and the end of the examined part of the motion (the window) are moved in the
/// three rounds of the search, as shares of its length.
constexpr std::array look_steps{0.08F, 0.04F, 0.02F};
constexpr std::size_t shapes_per_step = 4;
// A part of the motion (window) that ends at most this many points after its first is not compared.
constexpr std::size_t fewest_points = 4;
constexpr float not_compared = 1e9F;

/// Directions in which the start and the end of a window (examined part of the motion) move to its eight
/// neighbours.
constexpr std::array<std::pair<int, int>, lanes> neighbours{
    {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};

/// The first point that lies at least `by` of arc length after the point `from`; before it if `by` is
/// negative.
std::size_t point_at(const ShapeSpace& points, std::size_t from, float by) {
    const auto begin = points.length.begin(), end = begin + static_cast<std::ptrdiff_t>(points.count);
    const auto found = std::lower_bound(begin, end, points.length[from] + by);
    return std::min(static_cast<std::size_t>(found - begin), points.count - 1);
}

}  // namespace

void CloseLook::begin(std::size_t first, std::size_t last, const RecogniserSpace::Survivor& match) {
    kind_ = recogniser_.fine_template(match, template_);
    first_ = first;
    last_ = last;
    std::array<const float*, lanes> same;
    same.fill(template_.data());
    set_lanes(templates_, kind_.channels.depth ? solid_channels : planar_channels, same);
    distance_ = not_compared;
    round_ = made_ = 0;
    active_ = true;
}

void CloseLook::look_at_centre(ShapeSpace& points) {
    if (!make_fine_shape(points, first_, last_, kind_, shapes_[0])) return;
    const std::size_t channels = kind_.channels.depth ? solid_channels : planar_channels;
    distance_ = elastic_distances(shapes_[0], templates_, channels)[0];
}

void CloseLook::make_neighbour(ShapeSpace& points) {
    const float step = look_steps[round_ - 1] * (points.length[last_] - points.length[first_]);
    const auto [start, end] = neighbours[made_];
    auto& place = places_[made_];
    place.first = start == 0 ? first_ : point_at(points, first_, static_cast<float>(start) * step);
    place.last = end == 0 ? last_ : point_at(points, last_, static_cast<float>(end) * step);
    place.is_shape = place.last > place.first + fewest_points &&
                     make_fine_shape(points, place.first, place.last, kind_, shapes_[made_]);
    ++made_;
}

/// Moves the window (examined part of the motion) to the best of its eight neighbours, if that one is nearer
/// to the template.
void CloseLook::compare() {
    const std::size_t channels = kind_.channels.depth ? solid_channels : planar_channels;
    std::array<const float*, lanes> values;
    for (std::size_t k = 0; k < lanes; ++k) values[k] = shapes_[k].data();
    set_lanes(strokes_, channels, values);
    const auto distances = elastic_distances(strokes_, templates_, channels);
    for (std::size_t k = 0; k < lanes; ++k) {
        if (!places_[k].is_shape || !(distances[k] < distance_)) continue;
        distance_ = distances[k];
        first_ = places_[k].first;
        last_ = places_[k].last;
    }
}

bool CloseLook::step(ShapeSpace& points) {
    if (round_ == 0) {
        look_at_centre(points);
        active_ = distance_ < not_compared;
        ++round_;
    } else if (made_ < lanes) {
        for (std::size_t k = 0; k < shapes_per_step; ++k) make_neighbour(points);
    } else {
        compare();
        made_ = 0;
        active_ = round_++ < look_steps.size();
    }
    return !active_;
}

}  // namespace thaum::gesture
