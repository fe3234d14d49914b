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

/// How lines are laid out in the samples, and how they end.
struct Lines {
    std::ptrdiff_t count;  ///< places along a line
    std::ptrdiff_t width;  ///< lines side by side
    std::ptrdiff_t pitch;  ///< the same in whole eights
    std::ptrdiff_t place;  ///< from a place to the next one, in the samples
    std::ptrdiff_t line;   ///< from a line to the next one
    Edge edge;
    bool through;  ///< the component goes along the line: it is 0 on the walls at both ends
    bool solid_holds;
    float lid;  ///< m/s, what the wall at the high end moves by
    std::span<const CutLink> cuts;
    std::ptrdiff_t skipped;  ///< places before the first of these lines, all closed
};

inline Eight larger(const Eight& a, const Eight& b) { return a > b ? a : b; }

/// Coefficient of the link between two places; closed ones count below 0.
template <bool holds>
inline Eight link(const Eight& a, const Eight& b) {
    const Eight both = 0.5F * (a + b);
    const Eight one = holds ? larger(larger(a, b), none) : none;
    return (a < none) | (b < none) ? one : both;
}

inline Eight link(const Lines& lines, const float* a, const float* b) {
    return lines.solid_holds ? link<true>(load(a), load(b)) : link<false>(load(a), load(b));
}

/// Rows of lines side by side, in whole eights. Before the first row of values, links and uppers stands one of zeros.
struct Slab {
    float* value;
    float* coefficient;
    float* link;   ///< to the next place
    float* upper;  ///< what elimination leaves of that
    float* corner;
    std::array<float*, 2> end;  ///< the links to the walls at both ends; a row each
};

void find_links(const Lines& lines, const Slab& slab) {
    const auto last = (lines.count - 1) * lines.pitch;
    for (std::ptrdiff_t i = 0; i < last; i += 8)
        store(slab.link + i, link(lines, slab.coefficient + i, slab.coefficient + i + lines.pitch));
    std::fill_n(slab.link + last, lines.pitch, 0.0F);
    if (lines.solid_holds)
        for (const CutLink& cut : lines.cuts) slab.link[cut.at - lines.skipped * lines.pitch] *= cut.nearer;
}

/// The part of a link that is taken by the velocity before the step: half of it, which makes the step of second order in time.
inline Eight explicit_part(const Eight& whole, const Eight& most) {
    const Eight half = 0.5F * whole;
    return half < most ? half : most;
}

inline Eight explicit_part_to_wall(const float* link) {
    return explicit_part(load(link), none + explicit_most_to_wall);
}

/// Of the link from a place to the next one.
inline Eight explicit_part(const Lines& lines, const Slab& slab, std::ptrdiff_t at) {
    const Eight a = load(slab.coefficient + at), b = load(slab.coefficient + at + lines.pitch);
    const Eight most = (a < none) | (b < none) ? none + explicit_most_to_wall : none + explicit_most;
    return explicit_part(load(slab.link + at), most);
}

/// The explicit half of the step.
void take_explicit_half(const Lines& lines, const Slab& slab) {
    const auto w = lines.pitch;
    const auto last = (lines.count - 1) * w;
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        Eight from_before = -explicit_part_to_wall(slab.end[0] + i) * load(slab.value + i);
        for (std::ptrdiff_t at = i; at < last; at += w) {
            const Eight value = load(slab.value + at);
            const Eight to_next = explicit_part(lines, slab, at) * (value - load(slab.value + at + w));
            store(slab.value + at, value + (from_before - to_next));
            from_before = to_next;
        }
        const Eight value = load(slab.value + last + i);
        const Eight to_wall = explicit_part_to_wall(slab.end[1] + i) * value;
        store(slab.value + last + i, value + (from_before - to_wall));
    }
}

/// Leaves in the links what the implicit half takes.
void leave_implicit_half(const Lines& lines, const Slab& slab) {
    const auto last = (lines.count - 1) * lines.pitch;
    for (std::ptrdiff_t i = 0; i < last; i += 8)
        store(slab.link + i, load(slab.link + i) - explicit_part(lines, slab, i));
    for (float* end : slab.end)
        for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8)
            store(end + i, load(end + i) - explicit_part_to_wall(end + i));
}

/// Forward elimination and back substitution of every line at once.
void eliminate(const Lines& lines, const Slab& slab, float* value) {
    const auto n = lines.count;
    const auto w = lines.pitch;
    for (std::ptrdiff_t r = 0; r < n; ++r) {
        for (std::ptrdiff_t i = r * w; i < (r + 1) * w; i += 8) {
            const auto lane = i - r * w;
            const Eight low = r == 0 ? load(slab.end[0] + lane) : none;
            const Eight more = r == n - 1 ? low + load(slab.end[1] + lane) : low;
            const Eight own = load(slab.coefficient + i);
            const Eight above = load(slab.link + i);
            const Eight below = load(slab.link + i - w);
            const Eight kept = 1.0F - load(slab.upper + i - w);
            const Eight per = 1.0F / (1.0F + below * kept + above + more);
            const Eight open = own < none ? none : per;
            store(slab.upper + i, above * open);
            const Eight found = (load(value + i) + below * load(value + i - w)) * open;
            store(value + i, own < none ? none : found);
        }
    }
    for (std::ptrdiff_t i = (n - 1) * w - 8; i >= 0; i -= 8)
        store(value + i, load(value + i) + load(slab.upper + i) * load(value + i + w));
}

/// The link between the ends of periodic lines, of two places at least, in the explicit half.
void take_explicit_ring(const Lines& lines, const Slab& slab) {
    const auto last = (lines.count - 1) * lines.pitch;
    float* flux = slab.corner;
    for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8) {
        const Eight whole = link(lines, slab.coefficient + last + i, slab.coefficient + i);
        const Eight half = explicit_part(whole, none + explicit_most);
        store(flux + i, half * (load(slab.value + i) - load(slab.value + last + i)));
    }
    take_explicit_half(lines, slab);
    for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8) {
        store(slab.value + i, load(slab.value + i) - load(flux + i));
        store(slab.value + last + i, load(slab.value + last + i) + load(flux + i));
    }
}

/// Such lines in the implicit half: Sherman and Morrison's correction by a second solution.
void solve_ring(const Lines& lines, const Slab& slab) {
    const auto w = lines.pitch;
    const auto last = (lines.count - 1) * w;
    // The matrix is that of open ends plus ends * (e0 - en)(e0 - en)^T.
    std::fill_n(slab.corner, last + w, 0.0F);
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight whole = link(lines, slab.coefficient + last + i, slab.coefficient + i);
        const Eight ends = whole - explicit_part(whole, none + explicit_most);
        store(slab.corner + i, ends);
        store(slab.corner + last + i, -ends);
    }
    eliminate(lines, slab, slab.value);
    eliminate(lines, slab, slab.corner);
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight by = (load(slab.value + i) - load(slab.value + last + i)) /
                         (1.0F + load(slab.corner + i) - load(slab.corner + last + i));
        for (std::ptrdiff_t at = i; at <= last + i; at += w)
            store(slab.value + at, load(slab.value + at) - by * load(slab.corner + at));
    }
}

/// The links to the walls at both ends, by multiples of the first and last place's own coefficient.
void set_ends(const Lines& lines, const Slab& slab, const std::array<float, 2>& multiples) {
    const std::array<std::ptrdiff_t, 2> row{0, (lines.count - 1) * lines.pitch};
    for (std::size_t end = 0; end < 2; ++end)
        for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8)
            store(slab.end[end] + i, multiples[end] * larger(load(slab.coefficient + row[end] + i), none));
}

/// The links of all places, to each other and to the walls at both ends.
void find_all_links(const Lines& lines, const Slab& slab) {
    const float wall = lines.edge == Edge::no_slip ? 2.0F : 0.0F;
    Lines to_wall = lines;
    if (lines.edge == Edge::periodic) {
        set_ends(lines, slab, {});
    } else if (lines.through) {
        // The first place is the wall.
        std::fill_n(slab.coefficient, lines.pitch, -1.0F);
        to_wall.solid_holds = true;
        set_ends(lines, slab, {0, 1});
    } else {
        set_ends(lines, slab, {wall, wall});
    }
    find_links(to_wall, slab);
}

/// What a moving wall at the high end draws along, in the implicit half.
void add_lid(const Lines& lines, const Slab& slab) {
    const auto last = (lines.count - 1) * lines.pitch;
    for (std::ptrdiff_t i = 0; i < lines.width; ++i) slab.value[last + i] += lines.lid * slab.end[1][i];
}

void solve(const Lines& lines, const Slab& slab) {
    const bool ring = lines.edge == Edge::periodic;
    if (ring && lines.count == 1) return;
    find_all_links(lines, slab);
    ring ? take_explicit_ring(lines, slab) : take_explicit_half(lines, slab);
    if (lines.lid != 0) add_lid(lines, slab);
    leave_implicit_half(lines, slab);
    ring ? solve_ring(lines, slab) : eliminate(lines, slab, slab.value);
}

}  // namespace

Viscosity::Viscosity(const Lattice& lattice, const Solids* solids, const SolidShare& solid)
    : lattice_(lattice),
      solids_(solids),
      rows_(solids != nullptr ? solids->rows() : whole_rows(lattice)),
      nodal_(lattice.size, -1.0F) {
    const auto [nx, ny, nz] = lattice.cells;
    const auto width = whole_eights(std::max(nx, ny));
    const auto most = static_cast<std::size_t>(width * (1 + std::max({nx, ny, nz})));
    for (auto* slab : {&value_, &coefficient_, &link_, &upper_, &corner_}) slab->assign(most, 0.0F);
    for (auto* row : {&low_end_, &high_end_}) row->assign(static_cast<std::size_t>(width), 0.0F);
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
            store(nodal_.data() + i, share > none ? both : closed);
        }
    });
    if (spread.force != nullptr) add_force(spread, axis, -1, u);
    if (holds) put_onto_lines(axis, u);
    for (int pass = 0; pass < spread.passes; ++pass)
        for (std::size_t across = 0; across < 3; ++across)
            along(spread, axis, pass % 2 == 0 ? across : 2 - across, u);
    if (holds) put_onto_faces(spread, axis, u);
    if (spread.force != nullptr) add_force(spread, axis, 1, u);
}

/// The part of what a force gave in this step that the explicit half would have seen, had it been there from the start.
void Viscosity::add_force(const Spread& spread, std::size_t axis, float sign, Samples& u) const {
    const float* force = (*spread.force)[axis].data();
    const auto half = 0.5F * sign * static_cast<float>(spread.dt);
    each_row(rows_, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            const Eight r = load(nodal_.data() + i);
            const Eight share = 2 * explicit_most < r ? 2 * explicit_most / r : none + 1.0F;
            const Eight more = half * share * load(force + i);
            store(u.data() + i, load(u.data() + i) + (r < none ? none : more));
        }
    });
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
    Lines lines{.count = lattice_.cells[across],
                .width = lattice_.cells[beside],
                .pitch = w,
                .place = lattice_.stride[across],
                .line = lattice_.stride[beside],
                .edge = lattice_.edges[across],
                .through = axis == across,
                .solid_holds = spread.solid_holds,
                .lid = axis == 0 && across == 1 ? static_cast<float>(spread.lid) : 0.0F,
                .cuts = {},
                .skipped = 0};
    const Slab slab{value_.data() + w, coefficient_.data() + w, link_.data() + w,
                    upper_.data() + w, corner_.data() + w,      {low_end_.data(), high_end_.data()}};
    for (auto* rows : {&value_, &link_, &upper_, &corner_}) std::fill_n(rows->data(), w, 0.0F);
    for (int o = 0; o < lattice_.cells[outer]; ++o) {
        if (solids_ != nullptr) {
            const Places wet = wet_[axis][across][static_cast<std::size_t>(o)];
            if (wet.count == 0) continue;
            lines.skipped = wet.first;
            lines.count = wet.count;
        }
        const auto first = lattice_.first + o * lattice_.stride[outer] + lines.skipped * lines.place;
        float* values = u.data() + first;
        const float* nodal = nodal_.data() + first;
        lines.cuts = cuts_of(axis, across, o);
        if (lines.line == 1) {
            for (std::ptrdiff_t r = 0; r < lines.count; ++r) {
                copy_eights(values + r * lines.place, slab.value + r * w, w);
                copy_eights(nodal + r * lines.place, slab.coefficient + r * w, w);
            }
            solve(lines, slab);
            for (std::ptrdiff_t r = 0; r < lines.count; ++r)
                copy_eights(slab.value + r * w, values + r * lines.place, w);
        } else {
            transpose({values, lines.line}, {slab.value, w}, lines.width, lines.count);
            transpose({nodal, lines.line}, {slab.coefficient, w}, lines.width, lines.count);
            solve(lines, slab);
            transpose({slab.value, w}, {values, lines.line}, lines.count, lines.width);
        }
    }
}

}  // namespace thaum::fluid
