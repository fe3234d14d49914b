#include "fluid/detail/viscosity.h"

#include <algorithm>
#include <span>

#include "fluid/detail/transpose.h"
#include "fluid/detail/viscous_links.h"
#include "fluid/floats8.h"

namespace thaum::fluid {
namespace {

/// Strength of the drag on a dragged face (a cut face whose centre lies in the solid or close to it): this
/// factor times nu dt / h^2, divided by the distance from the centre of the open part to the wall (cells).
constexpr float drag_factor = 8;
/// Largest coefficient that acts in the explicit half of a step, for a link (coupling of two places by
/// viscosity) between open places, and for one to a wall. With both links of a place at this limit no wave
/// grows in that half, so energy only falls. Between open places all values stay within their previous range.
constexpr float max_explicit_link = 0.25F;
constexpr float max_explicit_wall_link = 0.5F;

/// Parallel lines of velocities, which are solved together: where they lie in memory, and what is at their
/// ends. Row r has the r-th velocity of every line, and begins `row` values after row r - 1.
struct Lines {
    float* value;
    /// Viscous coefficients dt nu / (passes h^2) of the places (samples of the velocity), where passes is the
    /// number of equal parts of the step; below 0 in solids.
    const float* coefficient;
    std::ptrdiff_t row;
    std::ptrdiff_t count;  ///< number of places (velocity samples) along a line
    std::ptrdiff_t pitch;  ///< number of parallel lines, rounded up to a multiple of eight
    Edge edge;
    bool through;  ///< true: the component is parallel to the line, so it is 0 on the walls at both ends
    bool no_slip_at_solids;
    bool varies;  ///< whether the viscosity differs between places
    /// Largest coefficient of a link (coupling of two places), not counting links that a wall shortens.
    float max_link;
    float lid;  ///< speed of the wall at the high end (m/s)
    /// Factor of each link, the viscous coupling of a velocity sample to the next one on its line:
    /// [sample][line]. Where a wall cuts the link, it is the spacing of the samples divided by the distance
    /// from the sample in the fluid to the wall, because a near wall brakes more; else 1. Null: all are 1.
    const float* nearer;
    std::ptrdiff_t nearer_row;  ///< index distance from the factors of one sample to those of the next
};

/// The part of a link's coefficient (of the viscous coupling of two places) that acts on the velocity before
/// the step: half of it, for second order in time, but at most `most`.
inline Floats8 explicit_part(const Floats8& whole, const Floats8& most) {
    const Floats8 half = 0.5F * whole;
    return half < most ? half : most;
}

/// The part of the coefficient of the link between two places that acts on the velocity before the step. Its
/// limit depends on whether one of the places is closed (in a solid).
inline Floats8 explicit_part(const Floats8& whole, const Floats8& a, const Floats8& b) {
    const Floats8 most =
        ((a < zero8) | (b < zero8)) ? zero8 + max_explicit_wall_link : zero8 + max_explicit_link;
    return explicit_part(whole, most);
}

/// Largest coefficient dt nu / (passes h^2) that a link (coupling of two places by viscosity) may have in
/// each of the equal passes of a step.
float max_coefficient(const Lattice& lattice, const ViscousStep& step) {
    return static_cast<float>(step.thickest * step.dt / (step.passes * lattice.h * lattice.h));
}

/// The lines along one direction on which one component of the velocity is solved. The caller sets their
/// arrays for each slab (layer of parallel lines).
Lines lines_along(const Lattice& lattice, const ViscousStep& step, std::size_t axis, std::size_t across) {
    const Slabs slabs = slabs_along(lattice, across);
    const bool adjacent = lattice.stride[slabs.beside] == 1;  // false: the slab is transposed before it is
                                                              // solved
    return {.value = nullptr,
            .coefficient = nullptr,
            .row = adjacent ? lattice.stride[across] : slabs.pitch,
            .count = lattice.cells[across],
            .pitch = slabs.pitch,
            .edge = lattice.edges[across],
            .through = axis == across,
            .no_slip_at_solids = step.no_slip_at_solids,
            .varies = step.varies,
            .max_link = max_coefficient(lattice, step),
            .lid = axis == 0 && across == 1 ? static_cast<float>(step.lid) : 0.0F,
            .nearer = nullptr,
            .nearer_row = slabs.pitch};
}

/// Scratch rows with one value for each of the parallel lines that are solved together.
struct RowBuffers {
    float* closed;   ///< coefficients below 0, which mark closed places (in a solid)
    float* zeros;    ///< a row of zeros
    float* below;    ///< implicit part of the link (viscous coupling) from the previous place
    float* flux;     ///< momentum that the velocity before the step brings from the previous place
    float* to_wall;  ///< implicit part of the link (viscous coupling) to the wall at the low end
    /// Momentum that the velocity before the step carries from one end of periodic lines to the other.
    float* ring;
};

/// Results of eliminating the tridiagonal systems: the factor with which each place's value depends on the
/// next place's, and the second solution for periodic lines.
struct EliminationFactors {
    float* upper;   ///< factor of the next place's value for each place, preceded by a row of zeros
    float* corner;  ///< second solution, which closes periodic lines, preceded by a row of zeros
};

/// Viscous coefficients of the links between a line and the walls at its low and high end, as multiples of
/// the coefficient of the place nearest to the wall.
std::array<float, 2> links_to_walls(const Lines& lines) {
    const float wall = lines.edge == Edge::no_slip ? 2.0F : 0.0F;
    if (lines.edge == Edge::periodic) return {};
    // The first place lies on the low wall itself, so it needs no link to that wall.
    if (lines.through) return {0, 1};
    return {wall, wall};
}

/// Viscous coefficients of place r of each line. For r before the first or after the last place, these are
/// marks of closed places, or, on periodic lines, the coefficients at the other end.
const float* coefficients_at(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r) {
    if (r < 0 || r >= lines.count) {
        if (lines.edge != Edge::periodic) return buffers.closed;
        r = (r % lines.count + lines.count) % lines.count;
    }
    const bool wall = r == 0 && lines.through && lines.edge != Edge::periodic;
    return wall ? buffers.closed : lines.coefficient + r * lines.row;
}

/// Viscous coefficients of the six places around the link (viscous coupling) from place r to the next place.
/// After the last place of a periodic line comes the first.
LinkRows rows_around(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r) {
    LinkRows rows{};
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = coefficients_at(lines, buffers, r - 2 + static_cast<std::ptrdiff_t>(i));
    return rows;
}

/// Whether viscosity varies and place r may hold an interface (border of two fluids) on at least one of the
/// lines.
bool may_hold_interface(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r) {
    if (!lines.varies) return false;
    const PlacesAround rows{coefficients_at(lines, buffers, r - 2), coefficients_at(lines, buffers, r - 1),
                            coefficients_at(lines, buffers, r + 1), coefficients_at(lines, buffers, r + 2)};
    auto any = interface_between(rows, 0);
    for (std::ptrdiff_t i = 8; i < lines.pitch; i += 8) any |= interface_between(rows, i);
    return any_of(any);
}

/// Inputs from which the coefficients of the links (viscous couplings) from a place of each line to the next
/// place are computed.
struct LinksToNext {
    const float *own, *next;  ///< viscous coefficients of the place and of the next place
    /// Coefficients of the six places around the link; used if a border of two fluids may be there.
    LinkRows around;
    const float* nearer;  ///< factors of the links, 1 where no wall cuts one; null: all are 1
    bool holds;           ///< true: a closed place (in a solid) brakes its open neighbour
    float most;           ///< largest coefficient of a link that no wall cuts
};

LinksToNext links_from(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r, bool layered) {
    const bool holds = lines.no_slip_at_solids || (lines.through && lines.edge != Edge::periodic);
    return {.own = coefficients_at(lines, buffers, r),
            .next = lines.coefficient + (r + 1) * lines.row,
            .around = layered ? rows_around(lines, buffers, r) : LinkRows{},
            .nearer = holds && lines.nearer != nullptr ? lines.nearer + r * lines.nearer_row : nullptr,
            .holds = holds,
            .most = lines.max_link};
}

/// Coefficients of eight links (viscous couplings), each from a place to the next one on its line.
template <bool layered>
[[gnu::always_inline]] inline Floats8 link_at(const LinksToNext& links, std::ptrdiff_t i) {
    const Floats8 most = zero8 + links.most;
    Floats8 result = smaller(link(links.holds, load(links.own + i), load(links.next + i)), most);
    if constexpr (layered) result = smaller(layered_link(result, links.around, i), most);
    return links.nearer != nullptr ? result * load(links.nearer + i) : result;
}

/// Begins the elimination of the tridiagonal systems: computes the explicit and implicit parts of the links
/// (viscous couplings) to the walls at the low end, and of the link between the ends of periodic lines.
template <bool ring>
void begin(const Lines& lines, const RowBuffers& buffers, const EliminationFactors& left) {
    const auto last = (lines.count - 1) * lines.row;
    const float multiple = links_to_walls(lines)[0];
    const float* own = coefficients_at(lines, buffers, 0);
    for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8) {
        const Floats8 whole = multiple * smaller(larger(load(own + i), zero8), zero8 + lines.max_link);
        const Floats8 part = explicit_part(whole, zero8 + max_explicit_wall_link);
        const Floats8 value = load(lines.value + i);
        store(buffers.below + i, zero8);
        store(buffers.flux + i, -part * value);
        store(buffers.to_wall + i, whole - part);
        if constexpr (ring) {
            const Floats8 mean =
                link(lines.no_slip_at_solids, load(lines.coefficient + last + i), load(own + i));
            const Floats8 ends = smaller(
                lines.varies ? layered_link(mean, rows_around(lines, buffers, lines.count - 1), i) : mean,
                zero8 + lines.max_link);
            const Floats8 half = explicit_part(ends, zero8 + max_explicit_link);
            store(buffers.ring + i, half * (value - load(lines.value + last + i)));
            // The matrix of a periodic line is that of an open line plus (ends - half) (e0 - en)(e0 - en)^T,
            // where e0 and en are the unit vectors of its first and its last place.
            for (std::ptrdiff_t r = 1; r + 1 < lines.count; ++r)
                store(left.corner + r * lines.pitch + i, zero8);
            store(left.corner + i, ends - half);
            store(left.corner + (lines.count - 1) * lines.pitch + i, half - ends);
        }
    }
}

/// Velocities and viscous coefficients of one place on each of the parallel lines.
struct PlaceRows {
    std::ptrdiff_t index;
    float* value;
    const float* coefficient;
    const float* next_coefficient;  ///< coefficients of the next place; null at the last one
    /// Factor from this place's coefficient to that of its link to the wall at the high end of the line; 0
    /// before the last place.
    float wall_multiple;
};

template <bool last>
PlaceRows place_at(const Lines& lines, const RowBuffers& buffers, std::ptrdiff_t r) {
    return {.index = r,
            .value = lines.value + r * lines.row,
            .coefficient = coefficients_at(lines, buffers, r),
            .next_coefficient = last ? nullptr : lines.coefficient + (r + 1) * lines.row,
            .wall_multiple = last ? links_to_walls(lines)[1] : 0};
}

/// Velocities at one place of eight lines after the explicit half of the step, and their links (viscous
/// couplings) to the next place.
struct ExplicitHalf {
    Floats8 value;
    Floats8 to_next;  ///< flux of momentum to the next place or to the wall, by the velocity before the step
    /// Part, for the implicit half of the step, of the viscous coupling coefficient between each velocity and
    /// the next one on its line or the wall.
    Floats8 implicit_link;
};

template <bool ring, bool last>
[[gnu::always_inline]] inline ExplicitHalf explicit_half(const Lines& lines, const RowBuffers& buffers,
                                                         const PlaceRows& place, const Floats8& link,
                                                         std::ptrdiff_t i) {
    const Floats8 here = load(place.value + i), coefficient = load(place.coefficient + i);
    Floats8 whole, part, to_next;
    if constexpr (last) {
        whole = place.wall_multiple * smaller(larger(coefficient, zero8), zero8 + lines.max_link);
        part = explicit_part(whole, zero8 + max_explicit_wall_link);
        to_next = part * here;
    } else {
        whole = link;
        part = explicit_part(whole, coefficient, load(place.next_coefficient + i));
        to_next = part * (here - load(place.value + lines.row + i));
    }
    Floats8 given = here + (load(buffers.flux + i) - to_next);
    if constexpr (last)
        if (lines.lid != 0) given += lines.lid * whole;
    if constexpr (ring) {
        if (place.index == 0) given -= load(buffers.ring + i);
        if constexpr (last) given += load(buffers.ring + i);
    }
    return {given, to_next, whole - part};
}

/// Does the explicit half of the step at one place of each line, and eliminates this place from the system of
/// the implicit half. `layered`: whether this place or the next one may hold an interface (border of two
/// fluids) on some line.
template <bool ring, bool last, bool layered>
void eliminate_place(const Lines& lines, const RowBuffers& buffers, const EliminationFactors& left,
                     std::ptrdiff_t r) {
    const auto w = lines.pitch;
    const PlaceRows place = place_at<last>(lines, buffers, r);
    const LinksToNext links = last ? LinksToNext{} : links_from(lines, buffers, r, layered);
    // No place precedes the first one, so zeros stand for it.
    const float* before = r == 0 ? buffers.zeros : place.value - lines.row;
    const float* low_end = r == 0 ? buffers.to_wall : buffers.zeros;
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        Floats8 to_next = zero8;
        if constexpr (!last) to_next = link_at<layered>(links, i);
        const ExplicitHalf half = explicit_half<ring, last>(lines, buffers, place, to_next, i);
        const Floats8 coefficient = load(place.coefficient + i);
        const Floats8 above = last ? zero8 : half.implicit_link;
        Floats8 to_walls = load(low_end + i);
        if constexpr (last) to_walls = to_walls + half.implicit_link;
        const Floats8 below = load(buffers.below + i);
        const Floats8 kept = 1.0F - load(left.upper + (r - 1) * w + i);
        const Floats8 per = 1.0F / (1.0F + below * kept + above + to_walls);
        const Floats8 open = coefficient < zero8 ? zero8 : per;
        const Floats8 found = (half.value + below * load(before + i)) * open;
        store(place.value + i, coefficient < zero8 ? zero8 : found);
        store(left.upper + r * w + i, above * open);
        store(buffers.flux + i, half.to_next);
        store(buffers.below + i, above);
        if constexpr (ring) {
            float* corner = left.corner + r * w + i;
            const Floats8 second = (load(corner) + below * load(corner - w)) * open;
            store(corner, coefficient < zero8 ? zero8 : second);
        }
    }
}

/// Whether no wall drags on these lines. A velocity that all places share then stays unchanged.
bool is_loose(const Lines& lines, bool solids) {
    return !solids && (lines.edge == Edge::periodic || (lines.edge == Edge::free_slip && !lines.through));
}

/// Sets `first` to the velocity at the first place of each line, and subtracts it from all places of that
/// line.
void subtract_first(const Lines& lines, float* first) {
    std::copy_n(lines.value, lines.pitch, first);
    for (std::ptrdiff_t r = 0; r < lines.count; ++r) {
        float* value = lines.value + r * lines.row;
        for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8)
            store(value + i, load(value + i) - load(first + i));
    }
}

void add_first(const Lines& lines, const float* first) {
    for (std::ptrdiff_t r = 0; r < lines.count; ++r) {
        float* value = lines.value + r * lines.row;
        for (std::ptrdiff_t i = 0; i < lines.pitch; i += 8)
            store(value + i, load(value + i) + load(first + i));
    }
}

/// Transposes a slab (layer of parallel lines) so that its lines, which are `line` apart in memory, become
/// adjacent. `width` is their number; lines that fill it up to a multiple of eight are marked as closed.
void turn_slab(const float* values, const float* coefficients, std::ptrdiff_t line, std::ptrdiff_t width,
               const Lines& lines, float* turned_values, float* turned_coefficients) {
    transpose({values, line}, {turned_values, lines.row}, width, lines.count);
    transpose({coefficients, line}, {turned_coefficients, lines.row}, width, lines.count);
    for (std::ptrdiff_t r = 0; r < lines.count && width < lines.pitch; ++r)
        std::fill_n(turned_coefficients + r * lines.row + width, lines.pitch - width, -1.0F);
}

/// Does the explicit and the implicit half of the step for all lines at once. The tridiagonal systems are
/// solved by elimination from the low end to the high one, then substitution back.
template <bool ring>
void solve(const Lines& lines, const RowBuffers& buffers, const EliminationFactors& left) {
    const auto n = lines.count;
    const auto w = lines.pitch;
    begin<ring>(lines, buffers, left);
    bool layered = may_hold_interface(lines, buffers, 0);
    for (std::ptrdiff_t r = 0; r + 1 < n; ++r) {
        const bool next_layered = may_hold_interface(lines, buffers, r + 1);
        if (layered || next_layered)
            eliminate_place<ring, false, true>(lines, buffers, left, r);
        else
            eliminate_place<ring, false, false>(lines, buffers, left, r);
        layered = next_layered;
    }
    eliminate_place<ring, true, false>(lines, buffers, left, n - 1);
    for (std::ptrdiff_t r = n - 2; r >= 0; --r) {
        float* value = lines.value + r * lines.row;
        float* corner = left.corner + r * w;
        for (std::ptrdiff_t i = 0; i < w; i += 8) {
            const Floats8 upper = load(left.upper + r * w + i);
            store(value + i, load(value + i) + upper * load(value + lines.row + i));
            if constexpr (ring) store(corner + i, load(corner + i) + upper * load(corner + w + i));
        }
    }
    if constexpr (!ring) return;
    // Formula of Sherman and Morrison: subtracts the multiple of the second solution (`corner`)
    // that makes the last place of each line couple to its first one (periodic).
    const auto end = (n - 1) * w;
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Floats8 by = (load(lines.value + i) - load(lines.value + (n - 1) * lines.row + i)) /
                           (1.0F + load(left.corner + i) - load(left.corner + end + i));
        for (std::ptrdiff_t r = 0; r < n; ++r) {
            float* value = lines.value + r * lines.row + i;
            store(value, load(value) - by * load(left.corner + r * w + i));
        }
    }
}

/// The faces of a list that lie in some layers. The list is sorted by index.
template <class Face>
std::span<const Face> faces_in(const std::vector<Face>& faces, const Lattice& lattice, Layers layers) {
    const auto from = [&](int layer) {
        const auto first = static_cast<std::size_t>(lattice.at(0, 0, layer));
        return std::ranges::lower_bound(faces, first, {}, &Face::at);
    };
    return {from(layers.first), from(layers.end)};
}

}  // namespace

Viscosity::Viscosity(const Lattice& lattice, const Solids* solids, const SolidShare& solid)
    : lattice_(lattice), solids_(solids), rows_(solids != nullptr ? solids->rows() : whole_rows(lattice)) {
    face_coefficients_.fill(Samples(lattice.size, -1.0F));
    const auto [nx, ny, nz] = lattice.cells;
    const auto width = static_cast<std::size_t>(round_up_to_8(std::max(nx, ny)));
    const auto most = width * static_cast<std::size_t>(1 + std::max({nx, ny, nz}));
    for (LineScratch& scratch : scratch_) {
        for (auto* slab : {&scratch.value, &scratch.coefficient, &scratch.upper, &scratch.corner})
            slab->assign(most, 0.0F);
        for (auto& row : scratch.rows) row.assign(width, 0.0F);
    }
    closed_.assign(width, -1.0F);
    if (solids_ == nullptr) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        find_faces(solid, axis);
        for (std::size_t across = 0; across < 3; ++across) {
            find_cuts(solid, axis, across);
            find_open_ranges(axis, across);
        }
    }
}

// The components do not depend on each other. Lines along x and y lie within a layer across z, and lines
// along z within a level across y, so all layers of all components are solved at once, then all levels.
void Viscosity::diffuse(const ViscousStep& step, std::array<Samples, 3>& velocity, Team& team) {
    const auto each = [&](int number, auto&& solve) {
        const Split split(team, number, 8);
        team.each(3 * split.slices, [&](int slice, unsigned seat) {
            const auto axis = static_cast<std::size_t>(slice % 3);
            solve(axis, split[slice / 3], velocity[axis], scratch_[seat]);
        });
    };
    const int layers = lattice_.cells[2], levels = lattice_.cells[1];
    each(layers, [&](std::size_t axis, Layers slice, Samples& u, LineScratch& scratch) {
        begin_component(step, axis, slice, u);
        along(step, axis, 0, slice, u, scratch);
        along(step, axis, 1, slice, u, scratch);
    });
    // The second pass takes the axes in the opposite order.
    each(levels, [&](std::size_t axis, Layers slice, Samples& u, LineScratch& scratch) {
        for (int pass = 0; pass < step.passes; ++pass) along(step, axis, 2, slice, u, scratch);
    });
    if (step.passes == 2)
        each(layers, [&](std::size_t axis, Layers slice, Samples& u, LineScratch& scratch) {
            along(step, axis, 1, slice, u, scratch);
            along(step, axis, 0, slice, u, scratch);
        });
    if (solids_ != nullptr && step.no_slip_at_solids)
        team.each(3, [&](int component, unsigned) {
            const auto axis = static_cast<std::size_t>(component);
            scale_to_faces(step, axis, velocity[axis]);
        });
    if (step.force != nullptr)
        each(layers, [&](std::size_t axis, Layers slice, Samples& u, LineScratch&) {
            end_component(step, axis, slice, u);
        });
}

/// Sets the coefficients of the faces of a component in some layers, takes the force out, and converts the
/// velocities of cut faces.
void Viscosity::begin_component(const ViscousStep& step, std::size_t axis, Layers layers, Samples& u) {
    const auto s = lattice_.stride[axis];
    const auto half = static_cast<float>(0.5 * step.dt / (step.passes * lattice_.h * lattice_.h));
    const Floats8 most = zero8 + max_coefficient(lattice_, step);
    const float* nu = step.viscosity->data();
    const bool holds = solids_ != nullptr && step.no_slip_at_solids;
    const float* open = holds                ? on_lines_[axis].data()
                        : solids_ != nullptr ? solids_->open()[axis].data()
                                             : nullptr;
    each_row(rows_, layers, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8) {
            const Floats8 both = half * (load(nu + i - s) + load(nu + i));
            const Floats8 closed = zero8 - 1.0F;
            const Floats8 share = open == nullptr ? closed + 2.0F : load(open + i);
            const Floats8 coefficients = share > zero8 ? both : closed;
            store(face_coefficients_[axis].data() + i, coefficients);
            if (step.force != nullptr) add_force(step, axis, -1, smaller(coefficients, most), i, u);
        }
    });
    if (holds) scale_to_lines(axis, layers, u);
}

/// Puts the force back that begin_component has taken out.
void Viscosity::end_component(const ViscousStep& step, std::size_t axis, Layers layers, Samples& u) const {
    const Floats8 most = zero8 + max_coefficient(lattice_, step);
    each_row(rows_, layers, [&](Row row) {
        for (std::ptrdiff_t i = row.at; i < row.at + row.count; i += 8)
            add_force(step, axis, 1, smaller(load(face_coefficients_[axis].data() + i), most), i, u);
    });
}

/// Adds to eight places, times `sign`, the part of a constant force on which the explicit half of the step
/// would act. This part is taken out before the step and put back after it, so that viscosity does not damp
/// it.
void Viscosity::add_force(const ViscousStep& step, std::size_t axis, float sign, const Floats8& coefficients,
                          std::ptrdiff_t at, Samples& u) {
    const auto half = 0.5F * sign * static_cast<float>(step.dt);
    const Floats8 share =
        2 * max_explicit_link < coefficients ? 2 * max_explicit_link / coefficients : zero8 + 1.0F;
    const Floats8 more = half * share * load((*step.force)[axis].data() + at);
    store(u.data() + at, load(u.data() + at) + (coefficients < zero8 ? zero8 : more));
}

/// Before a solve, converts the velocities of cut faces from the centre of the open part to the centre of the
/// face. Saves those of dragged faces (whose centre lies in the solid or close to it) and sets them to 0.
void Viscosity::scale_to_lines(std::size_t axis, Layers layers, Samples& u) {
    const auto dragged = faces_in(dragged_[axis], lattice_, layers);
    float* speed = dragged_speeds_[axis].data() + (dragged.data() - dragged_[axis].data());
    for (const DraggedFace& face : dragged) {
        *speed++ = u[face.at];
        u[face.at] = 0;
    }
    for (const ScaledFace& face : faces_in(scaled_[axis], lattice_, layers)) u[face.at] *= face.factor;
}

/// After a solve, converts the velocities of cut faces back. Pulls those of dragged faces (whose centre lies
/// in the solid or close to it) towards a profile that fits their neighbours.
void Viscosity::scale_to_faces(const ViscousStep& step, std::size_t axis, Samples& u) {
    const auto& dragged = dragged_[axis];
    auto& speeds = dragged_speeds_[axis];
    const auto across = static_cast<std::size_t>(lattice_.stride[axis]);
    const Samples& nu = *step.viscosity;
    const auto factor = static_cast<float>(0.5 * step.dt / (lattice_.h * lattice_.h)) * drag_factor;
    const auto thickest = static_cast<float>(step.thickest);
    for (std::size_t i = 0; i < dragged.size(); ++i) {
        const DraggedFace& face = dragged[i];
        float drawn = 0;
        for (std::size_t side = 0; side < 6; ++side) drawn += face.share[side] * u[face.from[side]];
        const float both = std::min(nu[face.at - across], thickest) + std::min(nu[face.at], thickest);
        const float drag = factor * both * face.nearer;
        speeds[i] = (speeds[i] + drag * drawn) / (1 + drag);
    }
    for (std::size_t i = 0; i < dragged.size(); ++i) u[dragged[i].at] = speeds[i];
    for (const ScaledFace& face : scaled_[axis]) u[face.at] /= face.factor;
}

/// The range of places, and of lines, in a slab (layer of parallel lines) outside of which all places are in
/// solids.
Viscosity::OpenRange Viscosity::open_range(std::size_t axis, std::size_t across, int slab) const {
    if (solids_ != nullptr) return open_ranges_[axis][across][static_cast<std::size_t>(slab)];
    return {{0, lattice_.cells[across]}, {0, lattice_.cells[slabs_along(lattice_, across).beside]}};
}

/// Solves the lines of a component along one axis, in some slabs (layers of parallel lines).
void Viscosity::along(const ViscousStep& step, std::size_t axis, std::size_t across, Layers slabs, Samples& u,
                      LineScratch& scratch) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    const auto place = lattice_.stride[across], line = lattice_.stride[beside];
    Lines lines = lines_along(lattice_, step, axis, across);
    const bool ring = lines.edge == Edge::periodic;
    if (ring && lines.count == 1) return;
    auto& [zeros, below, flux, to_wall, ends, firsts] = scratch.rows;
    const RowBuffers buffers{closed_.data(), zeros.data(),   below.data(),
                             flux.data(),    to_wall.data(), ends.data()};
    const auto longest = static_cast<std::ptrdiff_t>(zeros.size());
    const EliminationFactors left{scratch.upper.data() + longest, scratch.corner.data() + longest};
    for (int o = slabs.first; o < slabs.end; ++o) {
        const OpenRange open = open_range(axis, across, o);
        if (open.places.count == 0) continue;
        const auto first =
            lattice_.first + o * lattice_.stride[outer] + open.places.first * place + open.lines.first * line;
        float* values = u.data() + first;
        const float* coefficients = face_coefficients_[axis].data() + first;
        const std::ptrdiff_t width = open.lines.count;
        lines.count = open.places.count;
        lines.pitch = round_up_to_8(width);
        if (solids_ != nullptr)
            lines.nearer = nearer_[axis][across].data() + open.lines.first +
                           (o * lattice_.cells[across] + open.places.first) * pitch;
        lines.value = line == 1 ? values : scratch.value.data();
        lines.coefficient = line == 1 ? coefficients : scratch.coefficient.data();
        if (line != 1) {
            lines.row = lines.pitch;
            turn_slab(values, coefficients, line, width, lines, scratch.value.data(),
                      scratch.coefficient.data());
        }
        // If no wall drags on the lines (`loose`), a uniform velocity must stay exactly uniform. Rounding
        // errors would mix layers of fluid, and a little very viscous fluid thickens all that it enters.
        const bool loose = is_loose(lines, solids_ != nullptr);
        if (loose) subtract_first(lines, firsts.data());
        ring ? solve<true>(lines, buffers, left) : solve<false>(lines, buffers, left);
        if (loose) add_first(lines, firsts.data());
        if (line != 1) transpose({scratch.value.data(), lines.row}, {values, line}, lines.count, width);
    }
}

}  // namespace thaum::fluid
