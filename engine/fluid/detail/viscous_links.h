// fluid/detail/viscous_links.h: coefficients of the links between places in a flow whose viscosity varies
// (viscosity.h).
#pragma once
#include <array>

#include "fluid/floats8.h"

namespace thaum::fluid {

/// Coefficient of the viscous link between two places (samples of the velocity), of which a and b are the
/// coefficients: their harmonic mean, because the layers between the places resist one after the other. It is
/// exact where the viscosity jumps halfway. With the arithmetic mean, a thin layer beside a thick one is half
/// a cell too thin. A negative coefficient marks a closed place (in a solid). If `holds`, such a place brakes
/// the other one; if not, it has no link.
inline Floats8 link(bool holds, const Floats8& a, const Floats8& b) {
    const Floats8 low = smaller(a, b), high = larger(a, b);
    // This order of operations leaves equal coefficients unchanged, to the bit.
    const Floats8 both = low * ((high + high) / (low + high + 1e-30F));
    const Floats8 one = holds ? larger(high, zero8) : zero8;
    return low < zero8 ? one : both;
}

/// Ratio of the viscous coefficients of two places from which on their link is corrected for an interface
/// (border of two fluids). Below this ratio, the harmonic mean alone puts the interface at most a twentieth
/// of a cell off.
inline constexpr float layers_from = 1.1F;

/// Rows of viscous coefficients of six consecutive places. The link between the third and the fourth is
/// wanted.
using LinkRows = std::array<const float*, 6>;

/// Viscous coefficients of five consecutive places, seen from the middle one (`own`): two places behind it,
/// itself, the neighbour at the other end of the link, and the place beyond that neighbour.
struct HalfPlaces {
    Floats8 far_behind, behind, own, faced, far_faced;
};

/// Absolute difference between the viscous coefficient of a place and that of the place beyond it; 0 if the
/// latter is closed (in a solid).
inline Floats8 step_beyond(const Floats8& place, const Floats8& beyond) {
    const Floats8 step = beyond < zero8 ? zero8 : beyond - place;
    return larger(step, -step);
}

/// Confidence that a place between two others holds an interface (border of two fluids), 0 to 1. `jump` is
/// the difference of its neighbours' coefficients. The confidence is high only if the place beyond each
/// neighbour equals that neighbour to within a hundredth of the jump. In a gradual mixture, and in an edge
/// that is smeared over more than one place, the confidence is low.
inline Floats8 sureness(const HalfPlaces& at, const Floats8& jump) {
    const Floats8 uneven = step_beyond(at.behind, at.far_behind) + step_beyond(at.faced, at.far_faced);
    const Floats8 sure = 2.0F - 200.0F * uneven / (jump + 1e-30F);
    return smaller(larger(sure, zero8), zero8 + 1.0F);
}

/// Rows of viscous coefficients of the two places before a place and of the two after it.
using PlacesAround = std::array<const float*, 4>;

/// Which of eight places may hold an interface (border of two fluids): those whose two neighbours differ from
/// each other, while the place beyond each neighbour equals that neighbour.
inline Magnitudes8 interface_between(const PlacesAround& rows, std::ptrdiff_t i) {
    const Floats8 before = load(rows[1] + i), after = load(rows[2] + i);
    const Floats8 uneven = step_beyond(before, load(rows[0] + i)) + step_beyond(after, load(rows[3] + i));
    const Floats8 low = smaller(before, after), high = larger(before, after);
    return (low >= zero8) & (high > layers_from * low) & (100.0F * uneven < high - low);
}

/// Viscous resistance of that half of a place which faces a neighbour. If the place holds an interface
/// (border of two fluids), its coefficient tells how far the fluid of each neighbour reaches into it. A place
/// beside a closed one (in a solid) is treated as uniform.
inline Floats8 half_resistance(const HalfPlaces& at) {
    const Floats8 one = zero8 + 1.0F, whole = one / (at.own + 1e-30F);
    const Floats8 sign = at.behind > at.faced ? one : -one;
    const Floats8 jump = sign * (at.behind - at.faced);
    const Floats8 share = sign * (at.own - at.faced) / (jump + 1e-30F);
    const Floats8 in_half = larger(share + share - one, zero8);
    const Floats8 layers = in_half / (at.behind + 1e-30F) + (one - in_half) / (at.faced + 1e-30F);
    const auto between = (share > zero8) & (share < one) & (at.behind >= zero8) & (at.faced >= zero8);
    return between ? whole + sureness(at, jump) * (layers - whole) : whole;
}

/// The coefficients `simple` of links between two places, corrected where an interface (border of two fluids)
/// lies within one of the places.
inline Floats8 layered_link(const Floats8& simple, const LinkRows& rows, std::ptrdiff_t i) {
    const Floats8 before = load(rows[1] + i), a = load(rows[2] + i), b = load(rows[3] + i);
    const Floats8 after = load(rows[4] + i), low = smaller(a, b);
    const Floats8 resistance = half_resistance({load(rows[0] + i), before, a, b, after}) +
                               half_resistance({load(rows[5] + i), after, b, a, before});
    const auto uneven = (low >= zero8) & (larger(a, b) > layers_from * low);
    return uneven ? 2.0F / resistance : simple;
}

}  // namespace thaum::fluid
