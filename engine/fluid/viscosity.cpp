#include "fluid/viscosity.h"

#include <algorithm>

#include "fluid/eight.h"
#include "fluid/transpose.h"

namespace thaum::fluid {
namespace {

/// Of h, to a wall. A place that is cut off along three axes loses its speed by the product of all three; were that thousands, the pressure
/// there would take minutes to settle.
constexpr double least_way = 0.1;

/// Slabs of lines side by side along x; lines along x stand side by side along y.
struct Slabs {
    std::size_t beside, outer;  ///< axes
    std::ptrdiff_t pitch;       ///< lines of one, in whole eights
};

Slabs slabs_along(const Lattice& lattice, std::size_t across) {
    const std::size_t beside = across == 0 ? 1 : 0;
    return {beside, 3 - across - beside, whole_eights(lattice.cells[beside])};
}

/// The part of the way after which solid begins; 1 where none does.
double open_way(const std::function<double(vec3)>& solid, vec3 from, vec3 to) {
    double open = 0, end = 1;
    for (int halvings = 0; halvings < 12; ++halvings) {
        const double middle = 0.5 * (open + end);
        (solid(from + middle * (to - from)) < 0.5 ? open : end) = middle;
    }
    return end;
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
};

void find_links(const Lines& lines, const Slab& slab) {
    const auto last = (lines.count - 1) * lines.pitch;
    for (std::ptrdiff_t i = 0; i < last; i += 8)
        store(slab.link + i, link(lines, slab.coefficient + i, slab.coefficient + i + lines.pitch));
    std::fill_n(slab.link + last, lines.pitch, 0.0F);
    if (lines.solid_holds)
        for (const CutLink& cut : lines.cuts) slab.link[cut.at] *= cut.nearer;
}

/// Forward elimination and back substitution of every line at once. `ends`: multiples of the first and last place's own
/// coefficient that its diagonal has besides.
void eliminate(const Lines& lines, const Slab& slab, float* value, const std::array<float, 2>& ends) {
    const auto n = lines.count;
    const auto w = lines.pitch;
    for (std::ptrdiff_t r = 0; r < n; ++r) {
        const float more = (r == 0 ? ends[0] : 0.0F) + (r == n - 1 ? ends[1] : 0.0F);
        for (std::ptrdiff_t i = r * w; i < (r + 1) * w; i += 8) {
            const Eight own = load(slab.coefficient + i);
            const Eight above = load(slab.link + i);
            const Eight below = load(slab.link + i - w);
            const Eight kept = 1.0F - load(slab.upper + i - w);
            const Eight per = 1.0F / (1.0F + below * kept + above + more * larger(own, none));
            const Eight open = own < none ? none : per;
            store(slab.upper + i, above * open);
            const Eight found = (load(value + i) + below * load(value + i - w)) * open;
            store(value + i, own < none ? none : found);
        }
    }
    for (std::ptrdiff_t i = (n - 1) * w - 8; i >= 0; i -= 8)
        store(value + i, load(value + i) + load(slab.upper + i) * load(value + i + w));
}

/// The ends of periodic lines are linked: Sherman and Morrison's correction by a second solution.
void solve_ring(const Lines& lines, const Slab& slab) {
    const auto w = lines.pitch;
    const auto last = (lines.count - 1) * w;
    // The matrix is that of open ends plus ends * (e0 - en)(e0 - en)^T.
    std::fill_n(slab.corner, last + w, 0.0F);
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight ends = link(lines, slab.coefficient + last + i, slab.coefficient + i);
        store(slab.corner + i, load(slab.corner + i) + ends);
        store(slab.corner + last + i, load(slab.corner + last + i) - ends);
    }
    eliminate(lines, slab, slab.value, {});
    eliminate(lines, slab, slab.corner, {});
    for (std::ptrdiff_t i = 0; i < w; i += 8) {
        const Eight by = (load(slab.value + i) - load(slab.value + last + i)) /
                         (1.0F + load(slab.corner + i) - load(slab.corner + last + i));
        for (std::ptrdiff_t at = i; at <= last + i; at += w)
            store(slab.value + at, load(slab.value + at) - by * load(slab.corner + at));
    }
}

void solve(const Lines& lines, const Slab& slab) {
    if (lines.edge == Edge::periodic) {
        find_links(lines, slab);
        if (lines.count > 1) solve_ring(lines, slab);
        return;
    }
    const auto last = (lines.count - 1) * lines.pitch;
    if (lines.through) {
        // The first place is the wall.
        std::fill_n(slab.coefficient, lines.pitch, -1.0F);
        Lines to_wall = lines;
        to_wall.solid_holds = true;
        find_links(to_wall, slab);
        eliminate(to_wall, slab, slab.value, {0, 1});
        return;
    }
    const float wall = lines.edge == Edge::no_slip ? 2.0F : 0.0F;
    if (wall > 0 && lines.lid != 0)
        for (std::ptrdiff_t i = last; i < last + lines.width; ++i)
            slab.value[i] += wall * lines.lid * std::max(slab.coefficient[i], 0.0F);
    find_links(lines, slab);
    eliminate(lines, slab, slab.value, {wall, wall});
}

}  // namespace

Viscosity::Viscosity(const Lattice& lattice, const Walls& walls)
    : lattice_(lattice), open_(walls.open), nodal_(make_samples(lattice)) {
    const auto [nx, ny, nz] = lattice.cells;
    const auto width = whole_eights(std::max(nx, ny));
    const auto most = static_cast<std::size_t>(width * (1 + std::max({nx, ny, nz})));
    for (auto* slab : {&value_, &coefficient_, &link_, &upper_, &corner_}) slab->assign(most, 0.0F);
    if (open_ == nullptr) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t across = 0; across < 3; ++across) find_cuts(walls.solid, axis, across);
}

void Viscosity::find_cuts(const std::function<double(vec3)>& solid, std::size_t axis, std::size_t across) {
    const auto [beside, outer, pitch] = slabs_along(lattice_, across);
    const auto is_open = [&](const Cells& c) {
        return (*open_)[axis][static_cast<std::size_t>(lattice_.at(c[0], c[1], c[2]))] > 0;
    };
    const auto place_of = [&](const Cells& c) {
        vec3 place = vec3(c[0], c[1], c[2]) + 0.5;
        place[static_cast<int>(axis)] -= 0.5;
        return lattice_.h * place;
    };
    Cells low{};
    for (low[outer] = 0; low[outer] < lattice_.cells[outer]; ++low[outer]) {
        for (low[across] = 0; low[across] + 1 < lattice_.cells[across]; ++low[across]) {
            for (low[beside] = 0; low[beside] < lattice_.cells[beside]; ++low[beside]) {
                Cells high = low;
                ++high[across];
                if (is_open(low) == is_open(high)) continue;
                const vec3 first = place_of(low), second = place_of(high);
                const double way =
                    is_open(low) ? open_way(solid, first, second) : open_way(solid, second, first);
                cuts_[axis][across].push_back({low[outer], low[across] * pitch + low[beside],
                                               static_cast<float>(1 / std::max(way, least_way))});
            }
        }
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
    const auto half = static_cast<float>(0.5 * spread.dt / (lattice_.h * lattice_.h));
    const float* nu = spread.viscosity->data();
    const float* open = open_ != nullptr ? (*open_)[axis].data() : nullptr;
    each_row(lattice_, [&](std::ptrdiff_t at) {
        for (std::ptrdiff_t i = at; i < at + lattice_.cells[0]; i += 8) {
            const Eight both = half * (load(nu + i - s) + load(nu + i));
            const Eight closed = none - 1.0F;
            const Eight share = open == nullptr ? closed + 2.0F : load(open + i);
            store(nodal_.data() + i, share > none ? both : closed);
        }
    });
    for (std::size_t across = 0; across < 3; ++across) along(spread, axis, across, u);
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
                .cuts = {}};
    const Slab slab{value_.data() + w, coefficient_.data() + w, link_.data() + w, upper_.data() + w,
                    corner_.data() + w};
    for (auto* rows : {&value_, &link_, &upper_, &corner_}) std::fill_n(rows->data(), w, 0.0F);
    for (int o = 0; o < lattice_.cells[outer]; ++o) {
        const auto first = lattice_.first + o * lattice_.stride[outer];
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
