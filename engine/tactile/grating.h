// tactile/grating.h: the sinusoidal grating from which effects are built (paper 004, "Virtual Reality Game
// Modeling for a Haptic Jacket", section 3.2).
//
// The paper models an effect as a one-dimensional sinusoidal grating of amplitude A and wavelength L, over
// which the collision state p(t) = (p_x, p_y, p_z) moves. z points out of the wall. Two methods make a force
// from it:
//
//     h(x)     = A sin(2 pi x / L) + A                       height of the grating
//     impact   p_1(t) = 0                    where p_z > 0   F_mag: collision with the flat wall beneath,
//                       h(p_x) - p_z         where p_z <= 0         force along the wall's normal n_w
//     vibration p_2(t) = 0                   where p_z > h   F_vec: collision with the grating itself,
//                       h(p_x) - p_z         where p_z <= h         force along the grating's normal n_r(p)
//     F_r      = k dx + B x'                 while moving in, k dx otherwise
//
// Here k is the stiffness, B the damping, dx the depth p_1 or p_2, and x' the speed at which it changes.
// Corrections to the text of the paper: the bracket of the sine is not closed there; the second case of the
// second method tests p_z <= h(p_x), written h(p_x(x)); the two cases of F_r are both printed for x' below
// zero, so the second is read as x' >= 0. The damping resists deepening, so x' counts here as the speed of
// deepening.
#pragma once
#include "core/maths.h"

namespace thaum::tactile {

/// A sinusoidal grating over which the skin moves (see the top of this file).
struct Grating {
    double amplitude{};   ///< amplitude A, >= 0 (m)
    double wavelength{};  ///< wavelength L, > 0 (m)
};

/// Height of the grating over the wall, from 0 to 2 A (m).
double height(const Grating& grating, double x);
/// Slope of the height.
double slope(const Grating& grating, double x);
/// Unit normal of the grating in the plane of x and z.
vec2 normal(const Grating& grating, double x);

/// Depth of the skin at p = (p_x, p_z) inside the grating once it touches the flat wall beneath, 0 before
/// that (m): p_1 of the impact-based method.
double impact_depth(const Grating& grating, vec2 p);
/// Depth of the skin at p = (p_x, p_z) inside the grating (m): p_2 of the vibration-based method.
double vibration_depth(const Grating& grating, vec2 p);

/// Force F_r of the spring and damper, >= 0 (N). `deepening` is the speed at which the depth grows (m/s).
double reaction(double stiffness, double damping, double depth, double deepening);

}  // namespace thaum::tactile
