// tools/bench/z_width.h: the stiffest virtual wall that a simulated device can touch without shaking (Colgate and Brown's
// Z-width), by simulation, by the eigenvalues of the sampled loop and by the passivity bound. Used by benchmark and tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/simulated.h"

namespace thaum::bench {

/// haptics.md: 0.1 kg, 0.5 N s/m, 1 ms; no friction, no quantum, and no limits that a wall would meet.
inline haptics::DeviceSpec reference_device(double damping, int latency) {
    return {.name = "reference",
            .sensed = 3,
            .actuated = 3,
            .peak_force = 1e6,
            .continuous_force = 1e6,
            .max_stiffness = 1e6,
            .max_damping = 1e3,
            .workspace = vec3(100),
            .position_quantum = 0,
            .mass = 0.1,
            .damping = damping,
            .coulomb_friction = 0,
            .update_rate = 1000,
            .latency = latency};
}

/// The passivity bound b > K T (1/2 + delay) of Colgate and Schenkel, as a stiffness; ticks of 1 ms.
inline double passive_stiffness(double damping, int latency) {
    return damping / (tick_seconds * (0.5 + latency));
}

/// Schur and Cohn's test: are all roots inside the unit circle? Coefficients from the lowest power up.
inline bool is_stable(std::vector<double> p) {
    while (p.size() > 1) {
        const double low = p.front(), high = p.back();
        if (std::abs(low) >= std::abs(high)) return false;
        std::vector<double> reduced(p.size() - 1);
        for (std::size_t i = 0; i < reduced.size(); ++i)
            reduced[i] = (high * p[i + 1] - low * p[p.size() - 2 - i]) / high;
        p = std::move(reduced);
    }
    return true;
}

/// Characteristic polynomial of a bare device (mass, damping > 0) against a wall of `stiffness`: the mechanism by
/// zero-order hold, z^latency (z - 1)(z - e) + stiffness (b1 (z - e) + a b2) = 0.
inline std::vector<double> wall_polynomial(const haptics::DeviceSpec& spec, double stiffness) {
    const double b = spec.damping, t = tick_seconds;
    const double lost = -std::expm1(-b * t / spec.mass), e = 1 - lost;
    const double a = lost * spec.mass / b, b1 = (t - a) / b, b2 = lost / b;
    std::vector<double> p(static_cast<std::size_t>(spec.latency) + 3);
    p[0] = stiffness * (a * b2 - b1 * e);
    p[1] = stiffness * b1;
    const auto shift = static_cast<std::size_t>(spec.latency);
    p[shift] += e;
    p[shift + 1] -= 1 + e;
    p[shift + 2] += 1;
    return p;
}

/// The largest stiffness for which `stable` holds, by halving; it must hold below and fail above.
template <class Stable>
double largest_stable(Stable stable) {
    double low = 1, high = 1e6;
    for (int i = 0; i < 50; ++i) {
        const double middle = std::sqrt(low * high);
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

/// N/m, the exact limit of the linear sampled loop.
inline double exact_limit(const haptics::DeviceSpec& spec) {
    return largest_stable([&spec](double k) { return is_stable(wall_polynomial(spec, k)); });
}

/// Does a small shake of a device pressed into a wall (0.5 N) die away? The wall's spring is computed from what is measured.
inline bool wall_calms_down(const haptics::DeviceSpec& spec, double stiffness, double kick = 1e-4) {
    constexpr double preload = 0.5;
    constexpr int ticks = 10'000, window = 1'000;
    const auto device = haptics::simulated_device(spec, haptics::no_hand);
    const double middle = -preload / stiffness;
    auto state = haptics::resting_at({middle, 0, 0});
    state.velocity.x = kick;
    double first = 0, last = 0;
    for (int i = 0; i < ticks; ++i) {
        const double depth = -haptics::measured_position(device, state).x;
        const double push = depth > 0 ? stiffness * depth : 0;
        state = haptics::step(device, state, {}, {push - preload, 0, 0});
        const double shake = std::abs(state.position.x - middle);
        if (i < window) first = std::max(first, shake);
        if (i >= ticks - window) last = std::max(last, shake);
    }
    return last <= first;
}

/// N/m, of the simulated device.
inline double simulated_limit(const haptics::DeviceSpec& spec, double kick = 1e-4) {
    return largest_stable([&spec, kick](double k) { return wall_calms_down(spec, k, kick); });
}

}  // namespace thaum::bench
