// tests/scenes/z_width.h: the stiffest virtual wall that a simulated device can touch without shaking (the
// Z-width of Colgate and Brown): by simulation, by the eigenvalues of the sampled loop, and by the
// passivity bound. Used by benchmark and tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/servo.h"
#include "haptics/simulated.h"

namespace thaum::bench {

/// The reference device of the Z-width: 0.1 kg, 0.5 N s/m, 1 ms, without friction and quantisation, and with
/// limits that are never reached.
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

/// Passivity bound b > K T (1/2 + delay) of Colgate and Schenkel, solved for the stiffness K (N/m). A tick
/// is 1 ms.
inline double passive_stiffness(double damping, int latency) {
    return damping / (tick_seconds * (0.5 + latency));
}

/// Schur-Cohn test: true if all roots lie inside the unit circle. Coefficients start at the lowest power.
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

/// Characteristic polynomial of a bare device (mass m and damping b > 0) at a wall of the given stiffness,
/// with the force held constant between samples (zero-order hold): z^latency (z - 1)(z - e) + stiffness (b1
/// (z - e) + a b2) = 0, where e = exp(-b T / m), a = (1 - e) m / b, b1 = (T - a) / b, b2 = (1 - e) / b and T
/// is the tick.
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

/// Largest stiffness for which `stable` is true (N/m), by bisection. It must be true below that value and
/// false above.
template <class Stable>
double max_stable(Stable stable) {
    double low = 1, high = 1e6;
    for (int i = 0; i < 50; ++i) {
        const double middle = std::sqrt(low * high);
        (stable(middle) ? low : high) = middle;
    }
    return low;
}

/// Exact stability limit of a wall's stiffness in the linear sampled loop (N/m).
inline double exact_limit(const haptics::DeviceSpec& spec) {
    return max_stable([&spec](double k) { return is_stable(wall_polynomial(spec, k)); });
}

/// Presses a device into a wall with 0.5 N and kicks it. Returns whether the oscillation dies away. The
/// wall's force uses the measured position.
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

/// Stability limit of a wall's stiffness at the simulated device (N/m).
inline double simulated_limit(const haptics::DeviceSpec& spec, double kick = 1e-4) {
    return max_stable([&spec, kick](double k) { return wall_calms_down(spec, k, kick); });
}

// ---- a wall with damping and the passivity controller -----------------------------------------------------

struct Wall {
    double stiffness{};  ///< stiffness of the wall (N/m)
    double damping{};    ///< damping of the wall while the device moves inwards (N s/m)
    /// Largest damping that the passivity controller may add (N s/m); 0: controller off.
    double controller{};
};

/// Results of a simulated device that lands on a wall and is then pressed into it.
struct Pressed {
    double depth{};    ///< mean depth in the last second (m)
    double shake{};    ///< largest deviation from the mean depth in the last second (m)
    double settled{};  ///< time after which the depth stays within a tenth of force / stiffness (s)
    /// Largest force beyond stiffness * depth before the last second (N): from
    /// damping, controller and shaking.
    double added{};
    double added_later{};  ///< largest force beyond stiffness * depth in the last second (N)
    double created{};      ///< largest energy that the wall gave beyond what the wall received (J)
};

/// Simulates a device that lands on the wall at 0.1 m/s and is pressed with `newtons` (N) for ten seconds.
/// Runs the whole servo step, safety stage included.
inline Pressed pressed(const haptics::DeviceSpec& spec, const Wall& wall, double newtons) {
    constexpr int ticks = 10'000, last_second = 9'000;
    const auto device = haptics::simulated_device(spec, haptics::no_hand);
    auto servo = haptics::servo_of(spec, 1);
    servo.max_damping = wall.controller;
    haptics::ServoState state;
    haptics::HapticModel model;
    model.patch.surfaces[0] = {.kind = haptics::SurfaceKind::plane, .b = {1, 0, 0}};
    model.patch.bodies[0].material = {.stiffness = wall.stiffness, .damping = wall.damping};
    model.patch.count = model.patch.body_count = 1;
    auto at = haptics::resting_at({0.005, 0, 0});
    at.velocity.x = -0.1;
    std::vector<double> depths;
    Pressed result;
    for (int tick = 0; tick < ticks; ++tick) {
        const vec3 measured = haptics::measured_position(device, at);
        const double force = haptics::servo_step(servo, state, model, {measured, 0}).x;
        const double wrong = std::abs(force - wall.stiffness * std::max(0.0, -measured.x));
        if (tick < last_second && tick > 100) result.added = std::max(result.added, wrong);
        if (tick >= last_second) result.added_later = std::max(result.added_later, wrong);
        at = haptics::step(device, at, {}, {force - newtons, 0, 0});
        depths.push_back(-at.position.x);
        const double off = depths.back() - newtons / wall.stiffness;
        if (std::abs(off) > 0.1 * newtons / wall.stiffness) result.settled = tick * tick_seconds;
    }
    for (int tick = last_second; tick < ticks; ++tick)
        result.depth += depths[static_cast<std::size_t>(tick)] / (ticks - last_second);
    for (int tick = last_second; tick < ticks; ++tick)
        result.shake =
            std::max(result.shake, std::abs(depths[static_cast<std::size_t>(tick)] - result.depth));
    result.created = state.energy.most_created;
    return result;
}

/// Largest of the stiffnesses 50, 51.5, ... N/m, in steps of 3 %, that the wall really renders. The search
/// stops at the first failure: the loop is not linear, and a stiffer wall may oscillate less.
inline double delivered_limit(const haptics::DeviceSpec& spec, Wall wall, double newtons) {
    double best = 0;
    for (wall.stiffness = 50; wall.stiffness < 1e4; wall.stiffness *= 1.03) {
        const Pressed current = pressed(spec, wall, newtons);
        if (!(current.depth + current.shake <= 1.1 * newtons / wall.stiffness)) break;
        best = wall.stiffness;
    }
    return best;
}

}  // namespace thaum::bench
