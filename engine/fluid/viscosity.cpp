#include "fluid/viscosity.h"

#include <algorithm>

#include "fluid/eight.h"
#include "fluid/sample.h"
#include "fluid/transpose.h"

namespace thaum::fluid {
namespace {

/// The least way to a wall, in h. A place that is cut off along three axes loses its speed by the product of all three; were that
/// thousands, the pressure there would take minutes to settle.
constexpr double least_way = 0.2;
/// The speed in the middle of a face by that in the middle of its open part. Where it would be less, the face is dragged.
constexpr double least_factor = 0.25;
/// How firmly a dragged face is held, by dt nu / h^2 and the distance from its open middle to the wall in h.
constexpr float drag_factor = 8;
/// The most that the explicit half takes through a link between two open places, and to a wall. With both links of a place at their most
/// no wave grows in that half, so that energy only falls; between open places no value leaves the range of those before it.
constexpr float explicit_most = 0.25F;
constexpr float explicit_most_to_wall = 0.5F;

/// Slabs of lines side by side along x; lines along x stand side by side along y.
struct Slabs {
    std::size_t beside, outer;  ///< axes
    std::ptrdiff_t pitch;       ///< lines of one, in whole eights
};

Slabs slabs_along(const Lattice& lattice, std::size_t across) {
    const std::size_t beside = across == 0 ? 1 : 0;
    return {beside, 3 - across - beside, whole_eights(lattice.cells[beside])};
}

/// Lines side by side, how they are laid out and how they end. Row r holds place r of each, `row` behind that of
/// place r - 1.
struct Lines {
    float* value;
    const float* coefficient;  ///< as nodal_
    std::ptrdiff_t row;
    std::ptrdiff_t count;  ///< places along a line
    std::ptrdiff_t pitch;  ///< lines side by side, in whole eights
    Edge edge;
    bool through;  ///< the component goes along the line: it is 0 on the walls at both ends
    bool solid_holds;
    float lid;  ///< m/s, what the wall at the high end moves by
    std::span<const CutLink> cuts;
    std::ptrdiff_t skipped;  ///< places before the first of these lines, all closed
};

inline Eight larger(const Eight& a, const Eight& b) { return a > b ? a : b; }

/// Coefficient of the link between two places; closed ones count below 0.
inline Eight link(bool holds, const Eight& a, const Eight& b) {
    const Eight both = 0.5F * (a + b);
    const Eight one = holds ? larger(larger(a, b), none) : none;
    return ((a < none) | (b < none)) ? one : both;
}

/// The part of a link that is taken by the velocity before the step: half of it, which makes the step of second order in time.
inline Eight explicit_part(const Eight& whole, const Eight& most) {
    const Eight half = 0.5F * whole;
    return half < most ? half : most;
}

/// Of the link between two places.
inline Eight explicit_part(const Eight& whole, const Eight& a, const Eight& b) {
    const Eight most = ((a < none) | (b < none)) ? none + explicit_most_to_wall : none + explicit_most;
    return explicit_part(whole, most);
}

/// One value for each of the lines.
struct RowBuffers {
    float* closed;   ///< coefficients of closed places
    float* none;     ///< zeros
    float* link;     ///< to the next place
    float* below;    ///< the implicit part of the link from the place before
    float* flux;     ///< from the place before to this one, by the explicit half
    float* to_wall;  ///< the implicit part of the link to the wall at the low end
    float* ring;     ///< flux through the link between the ends, by the explicit half
};

/// What elimination leaves of each place's link to the next one, and of the ends of periodic lines.
struct Eliminated {
    float* upper;   ///< a row of zeros stands before the first one
    float* corner;  ///< likewise
};

/// The links to the walls at the low and high end, as multiples of the coefficient beside them.
std::array<float, 2> links_to_walls(const Lines& lines) {
    const float wall = lines.edge == Edge::no_slip ? 2.0F : 0.0F;
    if (lines.edge == Edge::periodic) return {};
    // The first place is the wall.
    if (lines.through) return {0, 1};
    return {wall, wall};
}

const float* coefficients_at(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r) {
    const bool wall = r == 0 && lines.through && lines.edge != Edge::periodic;
    return wall ? buffers.closed : lines.coefficient + r * lines.row;
}

/// Of place r to the next one, with those that a wall cuts.
void find_links(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r,
                std::span<const CutLink>& cuts) {
    const bool holds = lines.solid_holds || (lines.through && lines.edge != Edge::periodic);
    const float* own = coefficients_at(lines, buffers, r);
    const float* next = lines.coefficient + (r + 1) * lines.row;
    for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8)
        store(buffers.link + i, link(holds, load(own + i), load(next + i)));
    if (!holds) return;
    const std::ptrdiff_t first = (r + lines.skipped) * lines.pitch;
    std::size_t taken = 0;
    for (; taken < cuts.size() && cuts[taken].at < first + lines.pitch; ++taken)
        buffers.link[cuts[taken].at - first] *= cuts[taken].nearer;
    cuts = cuts.subspan(taken);
}

/// What the explicit and implicit half take through the walls at the low end, and through the link between the ends
/// of a ring.
template <bool ring>
void begin(const Lines& lines, const RowBuffers& buffers, const Eliminated& left) {
    const auto last = (lines.count - 1) * lines.row;
    const float multiple = links_to_walls(lines)[0];
    const float* own = coefficients_at(lines, buffers, 0);
    for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8) {
        const Eight whole = multiple * larger(load(own + i), none);
        const Eight part = explicit_part(whole, none + explicit_most_to_wall);
        const Eight value = load(lines.value + i);
        store(buffers.below + i, none);
        store(buffers.flux + i, -part * value);
        store(buffers.to_wall + i, whole - part);
        if constexpr (ring) {
            const Eight ends = link(lines.solid_holds, load(lines.coefficient + last + i), load(own + i));
            const Eight half = explicit_part(ends, none + explicit_most);
            store(buffers.ring + i, half * (value - load(lines.value + last + i)));
            // The matrix is that of open ends plus ends * (e0 - en)(e0 - en)^T.
            for (std::ptrdiff_t r = 1; r + 1 < lines.count; ++r)
                store(left.corner + r * lines.pitch + i, none);
            store(left.corner + i, ends - half);
            store(left.corner + (lines.count - 1) * lines.pitch + i, half - ends);
        }
    }
}

/// The explicit half of one place on each line, and its elimination from what the implicit half asks for.
template <bool ring, bool last>
void take_place(const Lines& lines, const RowBuffers& buffers, const Eliminated& left, std::ptrdiff_t r) {
    const auto w = lines.pitch;
    const float multiple = last ? links_to_walls(lines)[1] : 0;
    const float* own = coefficients_at(lines, buffers, r);
    const float* next = last ? nullptr : lines.coefficient + (r + 1) * lines.row;
    float* value = lines.value + r * lines.row;
    // Before the first place nothing stands.
    const float* before = r == 0 ? buffers.none : value - lines.row;
    const float* low_end = r == 0 ? buffers.to_wall : buffers.none;
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight here = load(value + i), coefficient = load(own + i);
        Eight whole, part, to_next, more = load(low_end + i);
        if constexpr (last) {
            whole = multiple * larger(coefficient, none);
            part = explicit_part(whole, none + explicit_most_to_wall);
            to_next = part * here;
        } else {
            whole = load(buffers.link + i);
            part = explicit_part(whole, coefficient, load(next + i));
            to_next = part * (here - load(value + lines.row + i));
        }
        Eight given = here + (load(buffers.flux + i) - to_next);
        if constexpr (last)
            if (lines.lid != 0) given += lines.lid * whole;
        if constexpr (ring) {
            if (r == 0) given -= load(buffers.ring + i);
            if constexpr (last) given += load(buffers.ring + i);
        }
        const Eight to_wall = whole - part;
        const Eight above = last ? none : to_wall;
        if constexpr (last) more = more + to_wall;
        const Eight below = load(buffers.below + i);
        const Eight kept = 1.0F - load(left.upper + (r - 1) * w + i);
        const Eight per = 1.0F / (1.0F + below * kept + above + more);
        const Eight open = coefficient < none ? none : per;
        const Eight found = (given + below * load(before + i)) * open;
        store(value + i, coefficient < none ? none : found);
        store(left.upper + r * w + i, above * open);
        store(buffers.flux + i, to_next);
        store(buffers.below + i, above);
        if constexpr (ring) {
            float* corner = left.corner + r * w + i;
            const Eight second = (load(corner) + below * load(corner - w)) * open;
            store(corner, coefficient < none ? none : second);
        }
    }
}

/// Both halves of the step for every line at once: tridiagonal systems by elimination, from the low end to the high
/// one and back.
template <bool ring>
void solve(const Lines& lines, const RowBuffers& buffers, const Eliminated& left) {
    const auto n = lines.count;
    const auto w = lines.pitch;
    std::span<const CutLink> cuts = lines.cuts;
    begin<ring>(lines, buffers, left);
    for (std::ptrdiff_t r = 0; r + 1 < n; ++r) {
        find_links(lines, buffers, r, cuts);
        take_place<ring, false>(lines, buffers, left, r);
    }
    take_place<ring, true>(lines, buffers, left, n - 1);
    for (std::ptrdiff_t r = n - 2; r >= 0; --r) {
        float* value = lines.value + r * lines.row;
        float* corner = left.corner + r * w;
        for (std::ptrdiff_t i = 0; i < w; i += 8) {
            const Eight upper = load(left.upper + r * w + i);
            store(value + i, load(value + i) + upper * load(value + lines.row + i));
            if constexpr (ring) store(corner + i, load(corner + i) + upper * load(corner + w + i));
        }
    }
    if constexpr (!ring) return;
    // Sherman and Morrison's correction by the second solution.
    const auto end = (n - 1) * w;
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight by = (load(lines.value + i) - load(lines.value + (n - 1) * lines.row + i)) /
                         (1.0F + load(left.corner + i) - load(left.corner + end + i));
        for (std::ptrdiff_t r = 0; r < n; ++r) {
            float* value = lines.value + r * lines.row + i;
            store(value, load(value) - by * load(left.corner + r * w + i));
        }
    }
}

}  // namespace

Viscosity::Viscosity(const Lattice& lattice, const Solids* solids, const SolidShare& solid)
    : lattice_(lattice),
      solids_(solids),
      rows_(solids != nullptr ? solids->rows() : whole_rows(lattice)),
      nodal_(lattice.size, -1.0F) {
    const auto [nx, ny, nz] = lattice.cells;
    const auto width = static_cast<std::size_t>(whole_eights(std::max(nx, ny)));
    const auto most = width * static_cast<std::size_t>(1 + std::max({nx, ny, nz}));
    for (auto* slab : {&value_, &coefficient_, &upper_, &corner_}) slab->assign(most, 0.0F);
    for (auto& row : rows_of_lines_) row.assign(width, 0.0F);
    closed_.assign(width, -1.0F);
    if (solids_ == nullptr) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        find_faces(solid, axis);
        for (std::size_t across = 0; across < 3; ++across) {
            find_cuts(solid, axis, across);
            find_wet(axis, across);
        }
    }
}

/// The place of a face's middle (m).
vec3 Viscosity::place_of(std::size_t axis, std::size_t at) const {
    const auto from = static_cast<std::ptrdiff_t>(at) - lattice_.at(-ghosts, -ghosts, -ghosts);
    const auto [x, y, z] = lattice_.stride;
    const std::ptrdiff_t i = from % y / x, j = from % z / y, k = from / z;
    const vec3 cell(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
    return lattice_.h * (cell - double(ghosts) + face_place(axis));
}

void Viscosity::find_faces(const SolidShare& solid, std::size_t axis) {
    const double h = lattice_.h;
    Samples& stands = stands_[axis];
    // Ghosts hold nothing that a step could depend on.
    stands = make_samples(lattice_);
    each_cell(lattice_, [&](int, int, int, std::size_t at) { stands[at] = solids_->open()[axis][at]; });
    for (const CutFace& face : solids_->cut_faces(axis)) {
        const double centre = distance_to_wall(solid, place_of(axis, face.at), h);
        const double middle = distance_to_wall(solid, face.middle, h);
        if (centre >= least_way * h && centre >= least_factor * middle)
            scaled_[axis].push_back({face.at, static_cast<float>(centre / std::max(middle, least_way * h))});
        else
            stands[face.at] = 0;
    }
    for (const CutFace& face : solids_->cut_faces(axis))
        if (!(stands[face.at] > 0)) dragged_[axis].push_back(dragged_face(solid, axis, face));
    kept_.resize(std::max(kept_.size(), dragged_[axis].size()));
}

/// By neighbours that grow in proportion to their distance from the wall: the least squares of what they are off by.
DraggedFace Viscosity::dragged_face(const SolidShare& solid, std::size_t axis, const CutFace& face) const {
    const double h = lattice_.h;
    const double middle = distance_to_wall(solid, face.middle, h);
    DraggedFace result{.at = face.at, .nearer = static_cast<float>(h / std::max(middle, least_way * h))};
    std::array<double, 6> away{};
    double squares = 0;
    for (std::size_t side = 0; side < 6; ++side) {
        const auto step = static_cast<std::size_t>(lattice_.stride[side / 2]);
        const auto at = result.from[side] = side % 2 == 0 ? face.at + step : face.at - step;
        if (stands_[axis][at] > 0) away[side] = distance_to_wall(solid, place_of(axis, at), h);
        squares += away[side] * away[side];
    }
    for (std::size_t side = 0; side < 6 && squares > 0; ++side)
        result.share[side] = static_cast<float>(std::min(middle * away[side] / squares, 1.0));
    return result;
}

void Viscosity::find_cuts(const SolidShare& solid, std::size_t axis, std::size_t across) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    const auto at = [&](const Cells& c) { return static_cast<std::size_t>(lattice_.at(c[0], c[1], c[2])); };
    const auto stands_at = [&](const Cells& c) { return stands_[axis][at(c)] > 0; };
    Cells low{};
    for (low[outer] = 0; low[outer] < lattice_.cells[outer]; ++low[outer]) {
        for (low[across] = 0; low[across] + 1 < lattice_.cells[across]; ++low[across]) {
            for (low[beside] = 0; low[beside] < lattice_.cells[beside]; ++low[beside]) {
                Cells high = low;
                ++high[across];
                if (stands_at(low) == stands_at(high)) continue;
                const vec3 first = place_of(axis, at(low)), second = place_of(axis, at(high));
                const double way = stands_at(low) ? way_to_wall(solid, first, second - first, 2)
                                                  : way_to_wall(solid, second, first - second, 2);
                cuts_[axis][across].push_back({low[outer], low[across] * pitch + low[beside],
                                               static_cast<float>(1 / std::max(way, least_way))});
            }
        }
    }
}

/// The places along the lines of each slab between which all open ones are, with a closed one at either end where there is one.
void Viscosity::find_wet(std::size_t axis, std::size_t across) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    const int n = lattice_.cells[across];
    Cells at{};
    for (at[outer] = 0; at[outer] < lattice_.cells[outer]; ++at[outer]) {
        int first = n, end = 0;
        for (at[across] = 0; at[across] < n; ++at[across]) {
            for (at[beside] = 0; at[beside] < lattice_.cells[beside]; ++at[beside]) {
                if (!(solids_->open()[axis][static_cast<std::size_t>(lattice_.at(at[0], at[1], at[2]))] > 0))
                    continue;
                first = std::min(first, at[across]);
                end = at[across] + 1;
            }
        }
        Places wet{std::max(first - 1, 0), 0};
        if (end > 0) wet.count = std::min(end + 1, n) - wet.first;
        if (end > 0 && lattice_.edges[across] == Edge::periodic) wet = {0, n};
        wet_[axis][across].push_back(wet);
    }
}

std::span<const CutLink> Viscosity::cuts_of(std::size_t axis, std::size_t across, int slab) const {
    const auto& cuts = cuts_[axis][across];
    return {std::ranges::lower_bound(cuts, slab, {}, &CutLink::slab),
            std::ranges::upper_bound(cuts, slab, {}, &CutLink::slab)};
}

void Viscosity::take(const Spread& spread, std::array<Samples, 3>& velocity) {
    for (std::size_t axis = 0; axis < 3; ++axis) component(spread, axis, velocity[axis]);
}

void Viscosity::component(const Spread& spread, std::size_t axis, Samples& u) {
    const auto s = lattice_.stride[axis];
    const auto half = static_cast<float>(0.5 * spread.dt / (spread.passes * lattice_.h * lattice_.h));
    const float* nu = spread.viscosity->data();
    const bool holds = solids_ != nullptr && spread.solid_holds;
    const float* open = holds                ? stands_[axis].data()
                        : solids_ != nullptr ? solids_->open()[axis].data()
                                             : nullptr;
    each_row(rows_, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            const Eight both = half * (load(nu + i - s) + load(nu + i));
            const Eight closed = none - 1.0F;
            const Eight share = open == nullptr ? closed + 2.0F : load(open + i);
            const Eight nodal = share > none ? both : closed;
            store(nodal_.data() + i, nodal);
            if (spread.force != nullptr) add_force(spread, axis, -1, nodal, i, u);
        }
    });
    if (holds) put_onto_lines(axis, u);
    for (int pass = 0; pass < spread.passes; ++pass)
        for (std::size_t across = 0; across < 3; ++across)
            along(spread, axis, pass % 2 == 0 ? across : 2 - across, u);
    if (holds) put_onto_faces(spread, axis, u);
    if (spread.force == nullptr) return;
    each_row(rows_, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
            add_force(spread, axis, 1, load(nodal_.data() + i), i, u);
    });
}

/// To eight places, of coefficients `nodal`: the part of what a force gave in this step that the explicit half would
/// have seen, had it been there from the start.
void Viscosity::add_force(const Spread& spread, std::size_t axis, float sign, const Eight& nodal,
                          std::ptrdiff_t at, Samples& u) {
    const auto half = 0.5F * sign * static_cast<float>(spread.dt);
    const Eight share = 2 * explicit_most < nodal ? 2 * explicit_most / nodal : none + 1.0F;
    const Eight more = half * share * load((*spread.force)[axis].data() + at);
    store(u.data() + at, load(u.data() + at) + (nodal < none ? none : more));
}

/// From the speeds in the middles of the open parts to those in the middles of the faces; dragged ones are set aside.
void Viscosity::put_onto_lines(std::size_t axis, Samples& u) {
    const auto& dragged = dragged_[axis];
    for (std::size_t i = 0; i < dragged.size(); ++i) {
        kept_[i] = u[dragged[i].at];
        u[dragged[i].at] = 0;
    }
    for (const ScaledFace& face : scaled_[axis]) u[face.at] *= face.factor;
}

/// And back; dragged ones follow what the lines have become.
void Viscosity::put_onto_faces(const Spread& spread, std::size_t axis, Samples& u) {
    const auto& dragged = dragged_[axis];
    const auto step = static_cast<std::size_t>(lattice_.stride[axis]);
    const Samples& nu = *spread.viscosity;
    const auto factor = static_cast<float>(0.5 * spread.dt / (lattice_.h * lattice_.h)) * drag_factor;
    for (std::size_t i = 0; i < dragged.size(); ++i) {
        const DraggedFace& face = dragged[i];
        float drawn = 0;
        for (std::size_t side = 0; side < 6; ++side) drawn += face.share[side] * u[face.from[side]];
        const float drag = factor * (nu[face.at - step] + nu[face.at]) * face.nearer;
        kept_[i] = (kept_[i] + drag * drawn) / (1 + drag);
    }
    for (std::size_t i = 0; i < dragged.size(); ++i) u[dragged[i].at] = kept_[i];
    for (const ScaledFace& face : scaled_[axis]) u[face.at] /= face.factor;
}

void Viscosity::along(const Spread& spread, std::size_t axis, std::size_t across, Samples& u) {
    const auto [beside, outer, w] = slabs_along(lattice_, across);
    const auto place = lattice_.stride[across], line = lattice_.stride[beside];
    const std::ptrdiff_t width = lattice_.cells[beside];
    Lines lines{.value = nullptr,
                .coefficient = nullptr,
                .row = line == 1 ? place : w,
                .count = lattice_.cells[across],
                .pitch = w,
                .edge = lattice_.edges[across],
                .through = axis == across,
                .solid_holds = spread.solid_holds,
                .lid = axis == 0 && across == 1 ? static_cast<float>(spread.lid) : 0.0F,
                .cuts = {},
                .skipped = 0};
    const bool ring = lines.edge == Edge::periodic;
    if (ring && lines.count == 1) return;
    auto& [none, link, below, flux, to_wall, ends] = rows_of_lines_;
    const RowBuffers buffers{closed_.data(), none.data(),    link.data(), below.data(),
                             flux.data(),    to_wall.data(), ends.data()};
    const Eliminated left{upper_.data() + w, corner_.data() + w};
    // Slabs of other widths have left something there.
    for (auto* rows : {&upper_, &corner_}) std::fill_n(rows->data(), w, 0.0F);
    for (int o = 0; o < lattice_.cells[outer]; ++o) {
        if (solids_ != nullptr) {
            const Places wet = wet_[axis][across][static_cast<std::size_t>(o)];
            if (wet.count == 0) continue;
            lines.skipped = wet.first;
            lines.count = wet.count;
        }
        const auto first = lattice_.first + o * lattice_.stride[outer] + lines.skipped * place;
        float* values = u.data() + first;
        const float* nodal = nodal_.data() + first;
        lines.cuts = cuts_of(axis, across, o);
        lines.value = line == 1 ? values : value_.data();
        lines.coefficient = line == 1 ? nodal : coefficient_.data();
        if (line != 1) {
            transpose({values, line}, {value_.data(), w}, width, lines.count);
            transpose({nodal, line}, {coefficient_.data(), w}, width, lines.count);
        }
        ring ? solve<true>(lines, buffers, left) : solve<false>(lines, buffers, left);
        if (line != 1) transpose({value_.data(), w}, {values, line}, lines.count, width);
    }
}

}  // namespace thaum::fluid
