// haptics/balance.h: where a proxy comes to rest between a spring and the forces of haptic primitives.
//
// Every force is minus the gradient of a convex function with a kink at its point, line or plane, and the spring's energy
// is strictly convex. So the place where all forces cancel (eq. 8) is the one minimum of
//
//     f(x) = k/2 |x - c|^2 + sum s |x - p| + sum s dist(x, line) + sum s max(0, -(x - p).q) - sum s q.x
//
// and the proxy is a proximal map of the spring's centre: of two centres the proxies are never further apart than these.
// Nothing is kept from one call to the next, so a proxy depends on its arguments alone.
#pragma once
#include <array>

#include "haptics/primitives.h"

namespace thaum::haptics {

/// A linear spring between the proxy and a fixed centre.
struct Spring {
    vec3 centre{};       ///< c, m
    double stiffness{};  ///< k, N/m, 1e-6 to 1e9
};

/// Spring and damper between probe and proxy (eq. 3), within the ranges of Spring.
struct ProxyCoupling {
    double stiffness{};  ///< k, N/m, > 0
    double damping{};    ///< D, N s/m, >= 0
};

/// The coupling's force k (probe - x) + D (probe_velocity - v) with the backward difference v = (x - proxy_before) / period
/// is that of one spring: the damper only stiffens and moves it. Metres, m/s, s.
Spring effective_spring(const ProxyCoupling& coupling, vec3 probe, vec3 probe_velocity, vec3 proxy_before,
                        double period) noexcept;

/// Where the proxy is, and how well that is known.
struct Balance {
    vec3 proxy{};  ///< x, m
    vec3 force{};  ///< of the primitives on the proxy, so of the spring on the hand; N
    std::array<vec3, primitive_capacity> primitive{};  ///< what each of them adds to it, N
    /// N: bounds the error of force and of stiffness * proxy, whatever the set. Infinite where the spring is out of range.
    ///
    /// Solved where it is <= 1e-9: then it is what is left of the sum of all forces, each being one that its primitive can
    /// exert at x. Of random sets at the scale of a hand (0.01 m, 3 N, 300 N/m), half of them degenerate, all of 8 million are.
    /// Where strength / stiffness is 1e12 times the set's size, one in a thousand is left, and by any amount. Of lines that are parallel
    /// but for 1e-8 to 1e-14, up to one in ten is left, by 0.3 mN at most of 280,000 sets.
    double residual{};
    int steps{};  ///< Newton steps and what costs as much
};

/// Of steps in one call: a servo's tick must end, 0.2 ms at 16 primitives. Then the best place so far is returned with its
/// residual. Random sets take at most 40; what is not solved at 128 was mostly not at 500 either.
inline constexpr int balance_step_budget = 128;

/// Balances spring and primitives (eq. 8). What lies closer to x than positions are rounded to (4e-15 of the
/// coordinates of its position or of x, 2e-16 of those of the farthest position) counts as touched.
Balance balance(const PrimitiveSet& set, const Spring& spring) noexcept;

}  // namespace thaum::haptics
