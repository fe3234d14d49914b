// haptics/primitives/balance.h: the balance of a spring and the forces of haptic primitives on a proxy.
//
// The force of each primitive is minus the gradient of a convex function that has a kink at the primitive's
// point, line or plane. The spring's energy is strictly convex. So the place x of the proxy at which all
// forces cancel (Lundin and others 2007, eq. 8) is the only minimum of the energy
//
//     f(x) = k/2 |x - c|^2 + sum s |x - p| + sum s dist(x, line) + sum s max(0, -(x - p).q) - sum s q.x
//
// with stiffness k and centre c of the spring; strength s, position p and direction q of each primitive. The
// terms are spring, points, lines, planes and directed forces. The proxy is a proximal map of the spring's
// centre: the proxies of two centres are never farther apart than the centres. A call keeps no state, so a
// proxy depends on the arguments alone.
#pragma once
#include <array>

#include "haptics/primitives/primitives.h"

namespace thaum::haptics {

/// A linear spring between the proxy and a fixed centre.
struct Spring {
    vec3 centre{};       ///< place c to which the spring pulls (m)
    double stiffness{};  ///< stiffness k, 1e-6 to 1e9 (N/m)
};

/// Spring and damper between probe and proxy (Lundin and others 2007, eq. 3), within the ranges of Spring.
struct ProxyCoupling {
    double stiffness{};  ///< stiffness k, > 0 (N/m)
    double damping{};    ///< damping D, >= 0 (N s/m)
};

/// Returns the one spring that acts like the coupling. The coupling's force is k (probe - x) + D
/// (probe_velocity - v), with the backward difference v = (x - proxy_before) / period. The damper only
/// stiffens and moves the spring. Units: m, m/s, s.
Spring effective_spring(const ProxyCoupling& coupling, vec3 probe, vec3 probe_velocity, vec3 proxy_before,
                        double period) noexcept;

/// Position of the proxy, forces on it, and accuracy.
struct Balance {
    vec3 proxy{};  ///< position x of the proxy (m)
    /// Force of the primitives on the proxy, equal to the spring's force on the hand (N).
    vec3 force{};
    std::array<vec3, primitive_capacity> primitive{};  ///< share of each primitive in `force` (N)
    /// Bound of the error of force and of stiffness * proxy, for every set of primitives (N). Infinite if the
    /// spring is out of range.
    ///
    /// A residual <= 1e-9 counts as solved. It is then the length of the sum of all forces, each of which is
    /// one that its primitive can exert at x. All of 8 million random sets at the scale of a hand (0.01 m, 3
    /// N, 300 N/m) are solved; half of them were degenerate (kinks parallel, coincident or meeting in a
    /// point). If strength / stiffness is 1e12 times the set's size, one in a thousand is unsolved, by any
    /// amount. Of sets with lines that differ from parallel by 1e-8 to 1e-14, up to one in ten is unsolved.
    /// In 280,000 such sets the error is at most 0.3 mN.
    double residual{};
    int steps{};  ///< number of Newton steps; other work counts as steps of the same cost
};

/// Largest number of steps in one call, because a servo's tick must end: 0.2 ms at 16 primitives. Beyond it,
/// the best place so far is returned with its residual. Random sets take at most 40. Most sets unsolved at
/// 128 steps were unsolved at 500 too.
inline constexpr int balance_step_budget = 128;

/// Balances spring and primitives (Lundin and others 2007, eq. 8). The place x of the proxy counts as on a
/// kink if it is closer to the kink than the rounding of positions: 4e-15 of the coordinates of x or of the
/// primitive's position, or 2e-16 of those of the farthest position.
Balance balance(const PrimitiveSet& set, const Spring& spring) noexcept;

}  // namespace thaum::haptics
