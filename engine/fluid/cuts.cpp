#include "fluid/cuts.h"

#include <algorithm>
#include <cmath>

namespace thaum::fluid {
namespace {

constexpr int strips = 8;           ///< lines on a cut face along which the open length is measured
constexpr int pieces = 4;           ///< parts of a line, each searched for a wall
constexpr int halvings = 20;        ///< bisections to locate a crossing
constexpr int cells_looked_at = 3;  ///< search range along each axis for the distance to a wall (cells)

/// Position of the wall between an open place and a solid one, as a fraction of the distance.
double crossing(const SolidShare& solid, vec3 open_end, vec3 to_solid) {
    double open = 0, closed = 1;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (open + closed);
        (is_open(solid, open_end + middle * to_solid) ? open : closed) = middle;
    }
    return 0.5 * (open + closed);
}

/// Open length of a line and its first moment about the start, both relative to the length of the line.
struct OpenLength {
    double length{}, moment{};
};

OpenLength open_length(const SolidShare& solid, vec3 from, vec3 along) {
    OpenLength result;
    bool before = is_open(solid, from);
    for (int i = 0; i < pieces; ++i) {
        const vec3 low = from + along * (double(i) / pieces), step = along * (1.0 / pieces);
        const bool after = is_open(solid, low + step);
        double first = 0, last = 1;
        if (before && !after) last = crossing(solid, low, step);
        if (!before && after) first = 1 - crossing(solid, low + step, -step);
        if (before || after) {
            const double length = (last - first) / pieces;
            result.length += length;
            result.moment += length * (i + 0.5 * (first + last)) / pieces;
        }
        before = after;
    }
    return result;
}

}  // namespace

OpenPart open_part(const SolidShare& solid, vec3 low, std::size_t axis, double h) {
    vec3 first(0), second(0);
    first[static_cast<int>((axis + 1) % 3)] = h;
    second[static_cast<int>((axis + 2) % 3)] = h;
    int open = 0;
    for (const double a : {0.0, 0.5, 1.0})
        for (const double b : {0.0, 0.5, 1.0}) open += is_open(solid, low + first * a + second * b) ? 1 : 0;
    if (open == 0) return {0, low};
    if (open == 9) return {1, low + 0.5 * (first + second)};
    double area = 0;
    vec3 moment(0);
    for (int strip = 0; strip < strips; ++strip) {
        const vec3 from = low + second * ((strip + 0.5) / strips);
        const OpenLength found = open_length(solid, from, first);
        area += found.length / strips;
        moment += ((from - low) * found.length + first * found.moment) / double(strips);
    }
    if (!(area > 0)) return {0, low};
    return {std::min(area, 1.0), low + moment / area};
}

double way_to_wall(const SolidShare& solid, vec3 from, vec3 step, int parts_most) {
    for (int part = 0; part < parts_most; ++part) {
        const vec3 here = from + double(part) * step;
        if (!is_open(solid, here + step)) return part + crossing(solid, here, step);
    }
    return parts_most;
}

double distance_to_wall(const SolidShare& solid, vec3 place, double h) {
    if (!is_open(solid, place)) return 0;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 step(0);
        step[axis] = h;
        const double way = std::min(way_to_wall(solid, place, step, cells_looked_at),
                                    way_to_wall(solid, place, -step, cells_looked_at));
        if (way < cells_looked_at) sum += 1 / std::max(way * way, 1e-12);
    }
    return sum > 0 ? std::min(h / std::sqrt(sum), 4 * h) : 4 * h;
}

}  // namespace thaum::fluid
