// Benchmark of rigid bodies: run time against error, by time step and by treatment of Bullet's
// first-order step.
//
// Scheme "bullet" is semi-implicit Euler as in Bullet. "half_start" is the same, but the caller gives every
// body the velocity of half a step earlier; free fall is then exact, and this is possible from outside.
// "exact_flight" is the shipped scheme. The reference solutions are closed forms, and for the pendulum a
// converged Runge-Kutta integration.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "physics/physics.h"
#include "tests/scenes/worse.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using physics::BodyDesc;
using physics::BodyState;
using physics::Key;
using physics::Physics;
using physics::Shape;

constexpr double g = 9.81;  // gravity of Physics (m/s^2)
constexpr std::array schemes{"bullet", "half_start", "exact_flight"};
constexpr std::array<std::int64_t, 4> steps_ms{1, 2, 4, 8};
constexpr std::int64_t shipped_step_ms = 1;
constexpr int shipped_iterations = physics::Settings{}.solver_iterations;

/// A simulated world, its treatment of steps (scheme), and its time step.
struct Run {
    std::string scheme;
    double dt;  ///< time step (s)
    Physics physics;

    Run(const std::string& name, std::int64_t step_ms, int iterations = shipped_iterations)
        : scheme(name),
          dt(static_cast<double>(step_ms) * 1e-3),
          physics({.solver_iterations = iterations, .exact_flight = name == "exact_flight"}) {}

    /// Velocity that must be given to a body so that it starts with `velocity` under gravity.
    vec3 starting(vec3 velocity) const {
        return scheme == "half_start" ? velocity + vec3(0, g * dt / 2, 0) : velocity;
    }
    int steps_in(double seconds) const { return static_cast<int>(std::lround(seconds / dt)); }
};

struct Outcome {
    double error{};  ///< error (m)
    std::vector<std::pair<std::string, double>> metrics{};
    std::uint64_t hash{};
};

BodyDesc ball() { return {.shape = Shape::sphere, .size = {0.1, 0, 0}, .mass = 1}; }

// ---- free flight -----------------------------------------------------------------------------------------

/// Distance from the closed form of the free flight after 2 s.
Outcome flight(Run& run, vec3 velocity) {
    constexpr double seconds = 2;
    const vec3 from{0, 100, 0};
    run.physics.add(1, ball(), {.position = from, .velocity = run.starting(velocity)});
    for (int i = run.steps_in(seconds); i > 0; --i) run.physics.step(run.dt);
    const vec3 exact = from + velocity * seconds - vec3(0, g * seconds * seconds / 2, 0);
    const BodyState& state = run.physics.state(1);
    return {.error = glm::length(state.position - exact), .hash = hash_value(state)};
}

// ---- pendulum --------------------------------------------------------------------------------------------

constexpr double swing_seconds = 10;
constexpr double rod = 1;  // length of the rod (m)

/// Angle of the pendulum from its lowest position, and its angular speed, after swing_seconds. It is released
/// at rest at 90 degrees and obeys theta'' = -(g / rod) sin theta.
std::array<double, 2> exact_swing() {
    constexpr int steps = 100'000;  // number of steps; twice as many change the angle by less than 1e-12 rad
    constexpr double h = swing_seconds / steps;
    double angle = pi / 2, speed = 0;
    const auto pull = [](double a) { return -g / rod * std::sin(a); };
    for (int i = 0; i < steps; ++i) {
        const double k1 = speed, l1 = pull(angle);
        const double k2 = speed + h / 2 * l1, l2 = pull(angle + h / 2 * k1);
        const double k3 = speed + h / 2 * l2, l3 = pull(angle + h / 2 * k2);
        const double k4 = speed + h * l3, l4 = pull(angle + h * k3);
        angle += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        speed += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return {angle, speed};
}

/// Position of the bob at the end of a step if there were no rod, by the scheme of the run (m).
vec3 free_end(const Run& run, const BodyState& s) {
    const double gravity_path = run.scheme == "exact_flight" ? g * run.dt * run.dt / 2 : g * run.dt * run.dt;
    return s.position + s.velocity * run.dt - vec3(0, gravity_path, 0);
}

/// Applies one impulse per step along the rod, like a game's coupling, so that the bob ends the step at
/// the length of the rod (SHAKE). The pivot is the origin.
void hold_by_rod(Run& run) {
    const BodyState& s = run.physics.state(1);
    const vec3 along = s.position / rod;
    const vec3 end = free_end(run, s);
    // Solves |end + push along|^2 = rod^2 for `push`, the root near zero.
    const double half = glm::dot(end, along);
    const double push = -half + std::sqrt(half * half - glm::dot(end, end) + rod * rod);
    run.physics.set_velocity(1, s.velocity + along * (push / run.dt));
}

/// Energy of the bob of 1 kg (J), ignoring the velocity that the rod removes at once.
double energy(const Run& run) {
    const BodyState& s = run.physics.state(1);
    // Without exact flight, the stored velocity is that of half a step earlier.
    const vec3 velocity = run.scheme == "exact_flight" ? s.velocity : s.velocity - vec3(0, g * run.dt / 2, 0);
    const vec3 along = glm::normalize(s.position);
    const vec3 across = velocity - along * glm::dot(velocity, along);
    return glm::dot(across, across) / 2 + g * s.position.y;
}

Outcome pendulum(Run& run) {
    static const auto exact = exact_swing();
    run.physics.add(1, ball(), {.position = {rod, 0, 0}, .velocity = run.starting({})});
    for (int i = run.steps_in(swing_seconds); i > 0; --i) {
        hold_by_rod(run);
        run.physics.step(run.dt);
    }
    const BodyState& state = run.physics.state(1);
    const vec3 there = rod * vec3(std::sin(exact[0]), -std::cos(exact[0]), 0);
    return {.error = glm::length(state.position - there),
            // The energy was 0 at the start, so the energy at the end is the drift.
            .metrics = {{"energy_drift_j", energy(run)},
                        {"rod_error_m", std::abs(glm::length(state.position) - rod)}},
            .hash = hash_value(state)};
}

// ---- stacks ----------------------------------------------------------------------------------------------

constexpr std::size_t stack_count = 32;

/// Median and its 98 % confidence interval. The interval is from the 10th to the 23rd of 32 values, by the
/// binomial distribution. Source: Conover, Practical Nonparametric Statistics, 3.2.
struct MedianOf {
    double value{}, low{}, high{};
};

MedianOf median_of(std::array<double, stack_count> values) {
    std::sort(values.begin(), values.end());
    return {(values[15] + values[16]) / 2, values[9], values[22]};
}

constexpr Key stack_boxes = 8;    // number of boxes in a stack
constexpr double half_box = 0.2;  // half the edge of a box (m)

Key box_key(Key stack, Key level) { return 1 + stack * stack_boxes + level; }

/// Adds the ground and the stacks. Returns the position of the lowest box of each stack (m).
std::array<vec3, stack_count> add_stacks(Physics& physics) {
    physics.add(0, {.size = {20, 1, 20}}, {.position = {0, -1, 0}});
    Random random{1};
    std::array<vec3, stack_count> feet{};
    for (Key s = 0; s < stack_count; ++s) {
        const double x = random.uniform(-1, 1), z = random.uniform(-1, 1), turn = random.uniform(0, pi / 2);
        const Key column = s % 8, row = s / 8;
        feet[s] = {3.0 * column - 10.5 + x, half_box, 3.0 * row - 4.5 + z};
        for (Key i = 0; i < stack_boxes; ++i) {
            physics.add(box_key(s, i), {.size = vec3(half_box), .mass = 5},
                        {.position = feet[s] + vec3(0, 2 * half_box * i, 0),
                         .orientation = rotation({0, 1, 0}, turn)});
        }
    }
    return feet;
}

/// Distances of the boxes in the stacks from the places where perfectly rigid boxes would be.
struct StackDrift {
    std::array<double, stack_count> of_top{};  ///< distance of each stack's top box from its place on rigid
                                               ///< boxes (m)
    double sunk{};                             ///< largest distance by which any box has sunk (m)
    std::uint64_t hash{};                      ///< hash of the states of all boxes
};

StackDrift drift_of(const Physics& physics, const std::array<vec3, stack_count>& feet) {
    StackDrift drift;
    for (Key s = 0; s < stack_count; ++s) {
        for (Key i = 0; i < stack_boxes; ++i) {
            const BodyState& state = physics.state(box_key(s, i));
            const vec3 way = state.position - feet[s] - vec3(0, 2 * half_box * i, 0);
            drift.hash = hash_combine(drift.hash, hash_value(state));
            drift.sunk = std::max(drift.sunk, -way.y);
            drift.of_top[s] = glm::length(way);
        }
    }
    return drift;
}

/// Stacks of eight boxes of 0.4 m, turned and placed at random. The error is how far the top has
/// drifted after 5 s from its place on rigid boxes. One stack's drift may be five times another's by
/// chance. The result is therefore the median of many, and values within its interval do not differ.
Outcome stacks(Run& run) {
    const auto feet = add_stacks(run.physics);
    int awake_steps = 0;
    for (int i = run.steps_in(5); i > 0; --i) {
        run.physics.step(run.dt);
        if (run.physics.counters().awake > 0) ++awake_steps;
    }
    const StackDrift drift = drift_of(run.physics, feet);
    const MedianOf median = median_of(drift.of_top);
    return {.error = median.value,
            .metrics = {{"error_low_m", median.low},
                        {"error_high_m", median.high},
                        {"sunk_m", drift.sunk},
                        {"settled_s", awake_steps * run.dt}},
            .hash = drift.hash};
}

// ---- rows of the report ----------------------------------------------------------------------------------

struct Case {
    std::string name;
    std::string error_name;
    double seconds;  ///< simulated time (s)
    std::function<Outcome(Run&)> play;
    bool has_iterations = false;
};

struct Setting {
    std::string scheme;
    std::int64_t step_ms;
    int iterations;
    bool shipped() const {
        return scheme == "exact_flight" && step_ms == shipped_step_ms && iterations == shipped_iterations;
    }
};

/// Numbers of solver iterations to compare. A quick run leaves out the most expensive one.
std::vector<int> iterations_of(const Case& one, bool quick) {
    if (!one.has_iterations) return {shipped_iterations};
    if (quick) return {4, shipped_iterations};
    return {4, shipped_iterations, 40};
}

std::vector<Setting> settings_of(const Case& one, bool quick) {
    std::vector<Setting> result;
    const std::vector<int> iterations = iterations_of(one, quick);
    for (const auto* scheme : schemes) {
        if (one.has_iterations && scheme == std::string_view("half_start"))
            // The scene starts at rest and not in flight, so the scheme with velocities of half a step
            // earlier does not apply.
            continue;
        for (const auto step : steps_ms) {
            for (const int count : iterations) result.push_back({scheme, step, count});
        }
    }
    return result;
}

Row row_of(const Case& one, const Setting& setting, const Outcome& outcome, std::vector<double> samples_us) {
    for (double& us : samples_us) us /= one.seconds;
    Row row{.area = "physics",
            .name = one.name,
            .setting = {{"scheme", setting.scheme}, {"dt_ms", setting.step_ms}},
            .time_us = times(samples_us),
            .error = ErrorMeasure{one.error_name, outcome.error},
            .is_default = setting.shipped(),
            .metrics = outcome.metrics,
            .hash = hex(outcome.hash)};
    if (one.has_iterations) row.setting.emplace_back("iterations", std::int64_t{setting.iterations});
    row.metrics.emplace_back("real_time_factor", 1e6 / row.time_us->median);
    return row;
}

void measure_case(const Case& one, const Options& options, Report& report) {
    const auto settings = settings_of(one, options.quick);
    std::vector<Outcome> outcomes(settings.size());
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        contestants.push_back({{}, [&one, &outcome = outcomes[i], &setting = settings[i]] {
                                   Run run(setting.scheme, setting.step_ms, setting.iterations);
                                   outcome = one.play(run);
                               }});
    }
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 2.0 : 15.0, .least = options.quick ? 1U : 11U});
    for (std::size_t i = 0; i < settings.size(); ++i)
        report.rows.push_back(row_of(one, settings[i], outcomes[i], samples[i]));
}

// ---- contacts --------------------------------------------------------------------------------------------

/// One row with the shipped settings of the physics, whose error must stay below a bound.
struct Stress {
    std::string name;
    std::string shape;
    std::string error_name;
    double bound;
    std::function<double()> worst;
};

constexpr std::array shape_names{"box", "sphere", "capsule", "cylinder"};

/// Largest deviation of the ratio of rebound to approach speed from 1, for restitution 1, in drops of
/// 0.1 to 4 m onto a static box.
double worst_rebound(Shape shape) {
    double worst = 0;
    for (double height = 0.1; height < 4; height *= 1.17) {
        Physics world;
        world.add(1, {.shape = Shape::box, .size = {50, 1, 50}, .restitution = 1}, {.position = {0, -1, 0}});
        const BodyDesc body{.shape = shape, .size = vec3(0.1), .mass = 1, .friction = 0, .restitution = 1};
        const double half = shape == Shape::capsule ? 0.2 : 0.1;
        world.add(2, body, {.position = {0, half + height, 0}});
        double approach = 0, rebound = 0;
        for (int i = 0; i < 2000 && rebound <= 0.01 - approach; ++i) {
            approach = -world.velocity(2).y;
            world.step(1e-3);
            rebound = world.velocity(2).y;
        }
        for (int i = 0; i < 3; ++i) {  // three more steps, because another point of the rim may touch later
            world.step(1e-3);
            rebound = std::max(rebound, world.velocity(2).y);
        }
        worst = worse(worst, std::abs(rebound / approach - 1));
    }
    return worst;
}

/// Share of 300 slender bodies that pass through a wall of 2 cm at 50 to 200 m/s.
double share_through(Shape shape) {
    int through = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random{i};
        Physics world({.gravity = {}});
        world.add(1, {.shape = Shape::box, .size = {0.01, 3, 3}}, {});
        const vec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        world.add(2, {.shape = shape, .size = {0.03, 0.2, 0.03}, .mass = 0.5, .friction = 0.3, .swept = 1},
                  {.position = {-random.uniform(0.5, 0.8), 0, 0},
                   .orientation = rotation(glm::normalize(axis), random.uniform(0, 2 * pi)),
                   .velocity = {random.uniform(50, 200), random.uniform(-30, 30), random.uniform(-30, 30)},
                   .spin = {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)}});
        bool behind = false;
        for (int tick = 0; tick < 50 && !behind; ++tick) {
            world.step(1e-3);
            const vec3 p = world.state(2).position;
            behind = p.x > 0 && std::abs(p.y) < 2.5 && std::abs(p.z) < 2.5;
        }
        through += behind ? 1 : 0;
    }
    return through / 300.0;
}

/// Depth by which a load on four boxes of 2 kg sinks within 10 s (m).
double sunk_under(double load) {
    Physics world;
    world.add(1, {.size = {50, 1, 50}}, {.position = {0, -1, 0}});
    for (Key i = 0; i < 5; ++i) {
        world.add(10 + i, {.size = vec3(0.1), .mass = i == 4 ? load : 2.0},
                  {.position = {0.003 * i, 0.1 + 0.2 * i, 0.002 * (i % 2)}});
    }
    for (int i = 0; i < 10'000; ++i) world.step(1e-3);
    return 0.9 - world.state(14).position.y;
}

std::vector<Stress> contact_stresses() {
    std::vector<Stress> all;
    for (std::uint32_t i = 0; i < shape_names.size(); ++i) {
        const auto shape = static_cast<Shape>(i);
        all.push_back({.name = "restitution",
                       .shape = shape_names[i],
                       .error_name = "rebound_speed_off_its_share",
                       .bound = 0.05,
                       .worst = [shape] { return worst_rebound(shape); }});
    }
    for (std::uint32_t i = 0; i < shape_names.size(); ++i) {
        const auto shape = static_cast<Shape>(i);
        all.push_back({.name = "swept",
                       .shape = shape_names[i],
                       .error_name = "share_through_2_cm",
                       .bound = 0,
                       .worst = [shape] { return share_through(shape); }});
    }
    all.push_back({.name = "loaded_stack",
                   .shape = "200_kg_on_2_kg",
                   .error_name = "sunk_m_after_10_s",
                   .bound = 0.001,
                   .worst = [] { return sunk_under(200); }});
    return all;
}

void measure_contacts(Report& report) {
    for (const auto& stress : contact_stresses()) {
        const double start = now_us();
        const double worst = stress.worst();
        Row row{.area = "physics", .name = stress.name};
        row.setting = {{"shape", stress.shape}, {"dt_ms", shipped_step_ms}};
        row.time_us = times({now_us() - start});
        row.error = ErrorMeasure{stress.error_name, worst};
        report.rows.push_back(row);
        if (worst <= stress.bound) continue;
        report.faults.push_back(text("physics / ", stress.name, " (", stress.shape, "): ", stress.error_name,
                                     " is ", worst, ", at most ", stress.bound));
    }
}

}  // namespace

void physics(const Options& options, Report& report) {
    const std::vector<Case> cases{
        {"free_fall", "position_m_after_2_s", 2, [](Run& run) { return flight(run, {}); }},
        {"projectile", "position_m_after_2_s", 2,
         [](Run& run) {
             return flight(run, {12, 9, -5});
         }},
        {"pendulum", "position_m_after_10_s", swing_seconds, pendulum},
        {"stack", "median_top_off_its_place_m_after_5_s", 5, stacks, true},
    };
    for (const auto& one : cases) measure_case(one, options, report);
    measure_contacts(report);
}

}  // namespace thaum::bench
