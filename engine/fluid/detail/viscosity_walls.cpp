#include <algorithm>

#include "fluid/detail/viscosity.h"
#include "fluid/sample.h"

// Finds where walls cut the lines of samples along which the viscous solver works. This is done once, when
// the solver is made.
namespace thaum::fluid {
namespace {

/// Smallest distance to a wall that is used; nearer walls count as this far (cells). A wall brakes a place
/// (sample of the velocity) by a factor that grows as it comes nearer, and walls along three axes by the
/// product of three. If that product were thousands, the pressure would take minutes to settle.
constexpr double min_way = 0.2;
/// Smallest ratio of the velocity at the centre of a face to that at the centre of its open part. A face with
/// a smaller ratio has its centre about in the solid. It gets a drag instead of viscous links to its
/// neighbours (DraggedFace).
constexpr double min_factor = 0.25;

}  // namespace

/// Centre of a face (m).
vec3 Viscosity::position_of(std::size_t axis, std::size_t at) const {
    const auto from = static_cast<std::ptrdiff_t>(at) - lattice_.at(-ghosts, -ghosts, -ghosts);
    const auto [x, y, z] = lattice_.stride;
    const std::ptrdiff_t i = from % y / x, j = from % z / y, k = from / z;
    const vec3 cell(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    return lattice_.h * (cell - double(ghosts) + face_place(axis));
}

void Viscosity::find_faces(const SolidShare& solid, std::size_t axis) {
    const double h = lattice_.h;
    Samples& on_line = on_lines_[axis];
    // The ghost cells are set to 0, so that no step can depend on them.
    on_line = make_samples(lattice_);
    each_cell(lattice_, [&](int, int, int, std::size_t at) { on_line[at] = solids_->open()[axis][at]; });
    for (const CutFace& face : solids_->cut_faces(axis)) {
        const double centre = distance_to_wall(solid, position_of(axis, face.at), h);
        const double middle = distance_to_wall(solid, face.middle, h);
        if (centre >= min_way * h && centre >= min_factor * middle)
            scaled_[axis].push_back({face.at, static_cast<float>(centre / std::max(middle, min_way * h))});
        else
            on_line[face.at] = 0;
    }
    for (const CutFace& face : solids_->cut_faces(axis))
        if (!(on_line[face.at] > 0)) dragged_[axis].push_back(dragged_face(solid, axis, face));
    dragged_speeds_[axis].resize(dragged_[axis].size());
}

/// Describes a cut face that is dragged. Its neighbours' weights are those of a least-squares fit of a
/// velocity that grows in proportion to the distance from the wall.
DraggedFace Viscosity::dragged_face(const SolidShare& solid, std::size_t axis, const CutFace& face) const {
    const double h = lattice_.h;
    const double middle = distance_to_wall(solid, face.middle, h);
    DraggedFace result{.at = face.at, .nearer = static_cast<float>(h / std::max(middle, min_way * h))};
    std::array<double, 6> away{};
    double squares = 0;
    for (std::size_t side = 0; side < 6; ++side) {
        const auto step = static_cast<std::size_t>(lattice_.stride[side / 2]);
        const auto at = result.from[side] = side % 2 == 0 ? face.at + step : face.at - step;
        if (on_lines_[axis][at] > 0) away[side] = distance_to_wall(solid, position_of(axis, at), h);
        squares += away[side] * away[side];
    }
    for (std::size_t side = 0; side < 6 && squares > 0; ++side)
        result.share[side] = static_cast<float>(std::min(middle * away[side] / squares, 1.0));
    return result;
}

void Viscosity::find_cuts(const SolidShare& solid, std::size_t axis, std::size_t across) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    auto& nearer = nearer_[axis][across];
    nearer.assign(static_cast<std::size_t>(lattice_.cells[outer] * lattice_.cells[across] * pitch), 1.0F);
    const auto at = [&](const Cells& c) { return static_cast<std::size_t>(lattice_.at(c[0], c[1], c[2])); };
    const auto is_on_line = [&](const Cells& c) { return on_lines_[axis][at(c)] > 0; };
    Cells low{};
    for (low[outer] = 0; low[outer] < lattice_.cells[outer]; ++low[outer]) {
        for (low[across] = 0; low[across] + 1 < lattice_.cells[across]; ++low[across]) {
            for (low[beside] = 0; low[beside] < lattice_.cells[beside]; ++low[beside]) {
                Cells high = low;
                ++high[across];
                if (is_on_line(low) == is_on_line(high)) continue;
                const vec3 first = position_of(axis, at(low)), second = position_of(axis, at(high));
                const double way = is_on_line(low) ? way_to_wall(solid, first, second - first, 2)
                                                   : way_to_wall(solid, second, first - second, 2);
                const std::ptrdiff_t place = low[outer] * lattice_.cells[across] + low[across];
                nearer[static_cast<std::size_t>(place * pitch + low[beside])] =
                    static_cast<float>(1 / std::max(way, min_way));
            }
        }
    }
}

/// For each slab (layer of parallel lines), finds the range of places along its lines that contains all
/// places outside solids, with one closed place at either end, and the range of lines with such places.
void Viscosity::find_open_ranges(std::size_t axis, std::size_t across) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    const int n = lattice_.cells[across];
    Cells at{};
    for (at[outer] = 0; at[outer] < lattice_.cells[outer]; ++at[outer]) {
        int first = n, end = 0, first_line = lattice_.cells[beside], end_line = 0;
        for (at[across] = 0; at[across] < n; ++at[across]) {
            for (at[beside] = 0; at[beside] < lattice_.cells[beside]; ++at[beside]) {
                if (!(solids_->open()[axis][static_cast<std::size_t>(lattice_.at(at[0], at[1], at[2]))] > 0))
                    continue;
                first = std::min(first, at[across]);
                end = at[across] + 1;
                first_line = std::min(first_line, at[beside]);
                end_line = std::max(end_line, at[beside] + 1);
            }
        }
        first_line = first_line / 8 * 8;
        const int lines = static_cast<int>(round_up_to_8(end_line - first_line));
        OpenRange open{{std::max(first - 1, 0), 0},
                       {first_line, std::min(lines, lattice_.cells[beside] - first_line)}};
        if (end > 0) open.places.count = std::min(end + 1, n) - open.places.first;
        if (end > 0 && lattice_.edges[across] == Edge::periodic) open.places = {0, n};
        open_ranges_[axis][across].push_back(open);
    }
}

}  // namespace thaum::fluid
