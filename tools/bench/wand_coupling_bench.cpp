// Benchmark of the coupling with Bullet: an object held by a moving hand, as felt with haptic models of
// several ages, and a wizard on a rope. Each is run with several time steps and compared with steps of a
// sixteenth of a millisecond or less.
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"
#include "game/wands/wand_coupling.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using game::apply_coupling;
using game::coupled_velocity;
using game::WandCoupling;

constexpr physics::Key body = 1;
constexpr std::array<std::int64_t, 4> tug_steps_ms{1, 2, 4, 8};

physics::Physics world_with(double mass, vec3 place) {
    physics::Physics physics;
    physics.add(body, {.shape = physics::Shape::sphere, .size = {0.2, 0, 0}, .mass = mass},
                {.position = place});
    return physics;
}

// ---- an object held by the hand ---------------------------------------------------------------------------

constexpr double held_mass = 20;         // mass of the object (kg)
constexpr double held_stiffness = 4000;  // stiffness of the coupling (N/m)
constexpr double held_damping = 25;      // damping of the coupling (N s/m)
constexpr double held_seconds = 2;
constexpr double hand_swing = 0.2;  // amplitude of the hand in the world (m): 10 mm at the device
constexpr double hand_rate = 2;     // frequency of the hand (Hz)

double hand_at(double t) { return hand_swing * std::sin(2 * pi * hand_rate * t); }

/// Position and velocity of the object that the hand holds, at each step.
struct Held {
    std::vector<double> place, speed;
};

Held hold(double dt) {
    auto physics = world_with(held_mass, {});
    const double drag = 0.7 * 2 * std::sqrt(held_stiffness * held_mass);
    const auto step = haptics::coupling_step({held_stiffness, held_damping, drag}, 1 / held_mass, 0, dt);
    WandCoupling coupling;
    Held held;
    const auto steps = static_cast<int>(std::lround(held_seconds / dt));
    for (int i = 0; i < steps; ++i) {
        const double from = hand_at(i * dt), to = hand_at((i + 1) * dt);
        const vec3 velocity = coupled_velocity(physics, body, coupling);
        held.place.push_back(physics.state(body).position.x);
        held.speed.push_back(velocity.x);
        const auto result = haptics::couple(step, {.hand = {from, 0, 0},
                                                   .hand_velocity = {(to - from) / dt, 0, 0},
                                                   .object = physics.state(body).position,
                                                   .object_velocity = velocity,
                                                   .drag_velocity = {},
                                                   .object_acceleration = {}});
        apply_coupling(physics, body, result, dt, coupling);
        physics.step(dt);
    }
    return held;
}

double spring_force(double t, double place) { return held_stiffness * (hand_at(t) - place); }

/// Largest error of the spring's force over all milliseconds (N, world), if the servo's data about the object
/// are `age` ticks old. The servo assumes that the object moves on at its velocity, or that it stands still.
double worst_force(const Held& held, std::int64_t step_ms, int age, bool moves_on, const Held& reference) {
    constexpr std::size_t per_ms = 16;
    double worst = 0;
    for (int ms = 100; ms < static_cast<int>(held_seconds * 1000); ++ms) {
        // Number of the step at whose start the servo's data about the object were made.
        const auto made = (ms - age) / step_ms;
        const double late = (ms - static_cast<double>(made * step_ms)) * 1e-3;
        const auto at = static_cast<std::size_t>(made);
        const double place = held.place[at] + (moves_on ? late * held.speed[at] : 0);
        const double exact = spring_force(ms * 1e-3, reference.place[static_cast<std::size_t>(ms) * per_ms]);
        worst = std::max(worst, std::abs(spring_force(ms * 1e-3, place) - exact));
    }
    return worst;
}

void in_bullet(const Options& options, Report& report) {
    const auto reference = hold(1e-3 / 16);
    std::array<Held, tug_steps_ms.size()> runs;
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < tug_steps_ms.size(); ++i)
        contestants.push_back(
            {{}, [&run = runs[i], i] { run = hold(static_cast<double>(tug_steps_ms[i]) * 1e-3); }});
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = options.quick ? 3U : 11U});
    for (std::size_t i = 0; i < tug_steps_ms.size(); ++i) {
        auto us = samples[i];
        for (double& sample : us) sample /= held_seconds;
        for (const int age : {0, 1, 2}) {
            const double error = worst_force(runs[i], tug_steps_ms[i], age, true, reference);
            const double still = worst_force(runs[i], tug_steps_ms[i], age, false, reference);
            report.rows.push_back(
                {.area = "coupling",
                 .name = "in_bullet",
                 .setting = {{"dt_ms", tug_steps_ms[i]}, {"model_age_ticks", std::int64_t{age}}},
                 .time_us = times(us),
                 .error = ErrorMeasure{"force_n_in_the_world", error},
                 .is_default = tug_steps_ms[i] == 1 && age == 0,
                 .metrics = {{"error_n_if_the_thing_stood_still", still}},
                 .hash = hex(hash_bytes(std::as_bytes(std::span(runs[i].place))))});
        }
    }
}

// ---- a wizard on a rope -----------------------------------------------------------------------------------

constexpr double wizard_mass = 75;       // mass of the wizard (kg)
constexpr double rope_stiffness = 4000;  // stiffness of the rope (N/m)
constexpr double rope_length = 7;        // length of the rope (m): 0.7 times the distance of 10 m at which it
                                         // was attached
constexpr double rope_seconds = 60;
// Position at which the wizard lets go, relative to the point at which the rope is fixed (m).
const vec3 let_go_at{6, -4.2, 0};

struct Swung {
    double energy_drift{};  ///< drift of the wizard's energy during the swing, as a share of the swing's
                            ///< energy
    double period{};        ///< mean period of the swing over the run (s)
    std::uint64_t hash{};
};

double energy_of(vec3 place, vec3 velocity) {
    const double stretch = std::max(0.0, glm::length(place) - rope_length);
    return wizard_mass * (glm::dot(velocity, velocity) / 2 + 9.81 * place.y) +
           rope_stiffness * stretch * stretch / 2;
}

Swung swing_for(double dt, double seconds) {
    auto physics = world_with(wizard_mass, let_go_at);
    const game::Rope rope{.anchor = {}, .length = rope_length, .stiffness = rope_stiffness};
    const vec3 gravity = physics.settings().gravity;
    WandCoupling coupling;
    const double before = energy_of(let_go_at, {});
    const double swing = before - energy_of({0, -rope_length, 0}, {});
    double first = 0, last = 0;
    int crossings = 0;
    vec3 place = let_go_at;
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (int i = 0; i < steps; ++i) {
        const auto result =
            game::hang(rope, wizard_mass, place, coupled_velocity(physics, body, coupling), gravity, dt);
        result ? apply_coupling(physics, body, *result, dt, coupling) : end_coupling(physics, body, coupling);
        physics.step(dt);
        const vec3 next = physics.state(body).position;
        if (place.x < 0 && next.x >= 0) {
            last = (i - place.x / (next.x - place.x)) * dt;
            if (crossings++ == 0) first = last;
        }
        place = next;
    }
    const double after = energy_of(place, coupled_velocity(physics, body, coupling));
    return {.energy_drift = (after - before) / swing,
            .period = crossings > 1 ? (last - first) / (crossings - 1) : 0,
            .hash = hash_bytes(std::as_bytes(std::span(&place, 1)))};
}

void pendulum(const Options& options, Report& report) {
    const auto reference = swing_for(1e-3 / 32, rope_seconds);
    std::array<Swung, tug_steps_ms.size()> runs;
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < tug_steps_ms.size(); ++i)
        contestants.push_back({{}, [&run = runs[i], i] {
                                   run = swing_for(static_cast<double>(tug_steps_ms[i]) * 1e-3, rope_seconds);
                               }});
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = options.quick ? 3U : 11U});
    for (std::size_t i = 0; i < tug_steps_ms.size(); ++i) {
        auto us = samples[i];
        for (double& sample : us) sample /= rope_seconds;
        report.rows.push_back(
            {.area = "coupling",
             .name = "pendulum",
             .setting = {{"dt_ms", tug_steps_ms[i]}},
             .time_us = times(us),
             .error = ErrorMeasure{"energy_drift_in_a_minute", std::abs(runs[i].energy_drift)},
             .is_default = tug_steps_ms[i] == 1,
             .metrics = {{"period_error", std::abs(runs[i].period / reference.period - 1)},
                         {"energy_change", runs[i].energy_drift}},
             .hash = hex(runs[i].hash)});
    }
}

}  // namespace

void wand_coupling(const Options& options, Report& report) {
    in_bullet(options, report);
    pendulum(options, report);
}

}  // namespace thaum::bench
