// Benchmark of the servo's rate: the stiffest coupling that stays stable on a wall, for steps of 0.2 to 1 ms.
//
// A step computes the haptic modes at the tip, the balance of the proxy and the force. The safety stage and
// the passivity controller are left out, because their limits are counted in ticks of 1 ms. The device is the
// reference device without a hand, pressed on the wall with 1 N. Theory allows a stiffness of b / (T / 2) for
// the damping b and the step T (passivity bound), so a rate five times as high should allow a stiffness five
// times as large.
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"
#include "haptics/modes.h"
#include "haptics/simulated.h"
#include "haptics/volume/implicit.h"
#include "tests/scenes/scanned_volumes.h"
#include "tests/scenes/z_width.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr double wall_damping = 0.5;  // damping of the device (N s/m)
constexpr std::array rates_ms{0.2, 0.5, 1.0};

/// A device that rests on a wall at the origin, which the haptic mode `isosurface` renders.
struct WallRun {
    double dt{};         ///< time step (s)
    double stiffness{};  ///< stiffness between tip and proxy, the point held on the surface (N/m)
    haptics::HalfSpace ground{.place = {}, .normal = {0, 1, 0}};

    /// Largest speed in the second and in the last quarter of the simulated time (m/s).
    struct Motions {
        double earlier{}, later{};
    };

    Motions play(double seconds_long, haptics::SimulatedState& state) const {
        const auto device =
            haptics::simulated_device(reference_device(wall_damping, 0), haptics::no_hand, dt);
        const haptics::ModeUse wall{
            haptics::find_mode("isosurface"), haptics::any_field(field::field_of<field::Scalar>(ground)), {}};
        TouchedModes hand{{wall}, stiffness};
        hand.uses[0].settings.strength = field::constant(1e5);
        hand.uses[0].settings.solid_below = true;
        state = haptics::resting_at({0, 1e-4, 0});
        hand.start(state.position);
        Motions motions;
        const int steps = static_cast<int>(seconds_long / dt);
        for (int i = 0; i < steps; ++i) {
            const vec3 force = hand.move(state.position) + vec3(0, -1, 0);
            state = haptics::step(device, state, vec3(0), force);
            const double speed = glm::length(state.velocity);
            if (4 * i >= steps && 2 * i < steps) motions.earlier = std::max(motions.earlier, speed);
            if (4 * i >= 3 * steps) motions.later = std::max(motions.later, speed);
        }
        return motions;
    }
};

/// Largest stiffness with which the device comes to rest (N/m), to within 1 %.
double stiffest(double dt) {
    double stable = 50, unstable = 50'000;
    while (unstable > 1.01 * stable) {
        const double middle = std::sqrt(stable * unstable);
        haptics::SimulatedState state;
        const auto motions = WallRun{dt, middle}.play(4, state);
        (motions.later < 0.99 * motions.earlier ? stable : unstable) = middle;
    }
    return stable;
}

}  // namespace

void servo_rates(const Options& options, Report& report) {
    for (const double ms : rates_ms) {
        const double dt = ms / 1000, limit = stiffest(dt);
        haptics::SimulatedState end;
        const WallRun run{dt, 300};
        const Contestant contestant{{}, [&] { run.play(1, end); }};
        auto samples = measure(std::span(&contestant, 1), {.seconds = options.quick ? 0.2 : 1.0});
        // Converts the time of a run to that of a step: the run simulates a second, which has 1 / dt steps.
        for (double& us : samples[0]) us *= dt;
        report.rows.push_back(
            {.area = "haptics",
             .name = "servo_rate",
             .setting = {{"step_ms", ms}},
             .time_us = times(samples[0]),
             .is_default = ms == 1,
             .metrics = {{"stiffness_n_per_m", limit}, {"passive_bound_n_per_m", 2 * wall_damping / dt}},
             .hash = hex(hash_value(end))});
    }
}

}  // namespace thaum::bench
