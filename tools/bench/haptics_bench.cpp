// Benchmark of the simulated device: the stiffest stable wall (Z-width) compared with theory, and the time of
// a tick. Also the safety stage, which limits all forces, under hostile input, and the time of a servo step.

#include "core/hash.h"
#include "core/text.h"
#include "haptics/audit/safety_audit.h"
#include "haptics/servo.h"
#include "tests/scenes/safety_attack.h"
#include "tests/scenes/z_width.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

void z_width(Report& report) {
    for (const double damping : {0.2, 0.5, 1.0}) {
        for (const int latency : {0, 1, 2}) {
            const auto spec = reference_device(damping, latency);
            const double simulated = simulated_limit(spec), exact = exact_limit(spec);
            report.rows.push_back(
                {.area = "haptics",
                 .name = "z_width",
                 .setting = {{"model", std::string("reference")},
                             {"damping_n_s_per_m", damping},
                             {"delay_ticks", std::int64_t{latency}}},
                 .error = ErrorMeasure{"relative_to_exact_limit", std::abs(simulated / exact - 1)},
                 .is_default = damping == 0.5 && latency == 0,
                 .metrics = {{"stiffness_n_per_m", simulated},
                             {"exact_limit_n_per_m", exact},
                             {"passive_bound_n_per_m", passive_stiffness(damping, latency)}}});
        }
    }
}

/// Effective stiffness of a wall at 2 N, with the wall's own damping and with the passivity controller. Also
/// the side effects of these two: the difference between the felt force and the wall's force while it
/// settles, and the time until it settles.
void controlled_walls(Report& report) {
    constexpr double newtons = 2;
    for (const int latency : {0, 1, 2}) {
        for (const auto& [damping, controller] :
             {std::pair{0.0, 0.0}, {2.0, 0.0}, {0.0, 5.0}, {2.0, 2.0}, {2.0, 5.0}, {2.0, 50.0}}) {
            const auto spec = reference_device(0.5, latency);
            Wall wall{.damping = damping, .controller = controller};
            const double limit = delivered_limit(spec, wall, newtons);
            wall.stiffness = 1000;
            const Pressed at = pressed(spec, wall, newtons);
            report.rows.push_back(
                {.area = "haptics",
                 .name = "z_width_controlled",
                 .setting = {{"wall_damping", damping},
                             {"controller", controller},
                             {"delay_ticks", std::int64_t{latency}}},
                 .is_default = damping == 2 && controller == 5 && latency == 1,
                 .metrics = {{"stiffness_n_per_m", limit},
                             {"penetration_at_1000", (at.depth + at.shake) * wall.stiffness / newtons},
                             {"settled_s", at.settled},
                             {"added_n", at.added},
                             {"added_later_n", at.added_later},
                             {"created_j", at.created}}});
        }
    }
}

/// Motion of a device during the benchmark. Rest, sliding and reversal are computed by different branches of
/// a tick.
struct Motion {
    const char* name;
    double friction;  // dry friction of the device (N)
    double swing;     // amplitude of the target to which the hand moves (m)
    int period;       // period of the target's motion (ticks)
};
constexpr std::array motions{Motion{"frictionless", 0, 0.03, 400}, Motion{"sliding", 0.26, 0.03, 400},
                             Motion{"held", 0.26, 0, 400}, Motion{"stop_and_go_every_tick", 0.26, 0.005, 2}};
constexpr int motion_ticks = 4000;

haptics::SimulatedState play(const Motion& motion) {
    auto spec = reference_device(0.5, 1);
    spec.coulomb_friction = motion.friction;
    const auto device = haptics::simulated_device(spec, {});
    auto state = haptics::resting_at({});
    for (int tick = 0; tick < motion_ticks; ++tick) {
        const int phase = tick % motion.period;
        const double triangle = std::abs(2.0 * phase / motion.period - 1);
        state = haptics::step(device, state, motion.swing * vec3(triangle, -triangle, 0.5 * triangle),
                              vec3(0, 0.05, 0));
    }
    return state;
}

void simulated_ticks(const Options& options, Report& report) {
    std::array<haptics::SimulatedState, motions.size()> ends;
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < motions.size(); ++i)
        contestants.push_back({{}, [&end = ends[i], &motion = motions[i]] { end = play(motion); }});
    auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 3.0, .least = 11});
    for (std::size_t i = 0; i < motions.size(); ++i) {
        for (double& us : samples[i]) us /= motion_ticks;
        report.rows.push_back({.area = "haptics",
                               .name = "simulated",
                               .setting = {{"motion", std::string(motions[i].name)}},
                               .time_us = times(samples[i]),
                               .hash = hex(hash_value(ends[i]))});
    }
}

// ---- safety stage and servo -------------------------------------------------------------------------------

/// Values of a device file (assets/devices) that the safety stage reads.
struct DeviceLimits {
    const char* name;
    double peak, continuous;  // peak force and continuous force (N)
};
constexpr std::array device_limits{DeviceLimits{"touch", 3.3, 0.88}, DeviceLimits{"omni", 3.3, 0.88},
                                   DeviceLimits{"premium", 8.5, 1.4}, DeviceLimits{"falcon", 8, 3},
                                   DeviceLimits{"omega3", 12, 12}};

haptics::DeviceSpec spec_of(const DeviceLimits& device) {
    haptics::DeviceSpec spec;
    spec.name = device.name;
    spec.peak_force = device.peak;
    spec.continuous_force = device.continuous;
    return spec;
}

/// Number of ticks in a block. Ticks run in blocks so that the clock measures the safety stage alone, and
/// neither the making of hostile input nor the check of the results.
constexpr std::size_t block_ticks = 1000;

struct AttackBlock {
    std::array<haptics::SafetyLimits, block_ticks> limits{};
    std::array<haptics::SafetyInput, block_ticks> inputs{};
    std::array<vec3, block_ticks> outputs{};
};

/// Runs a block of ticks. Returns the mean time of a tick (us).
double run_block(AttackBlock& block, haptics::SafetyState& state) {
    return us_of([&] {
               for (std::size_t i = 0; i < block_ticks; ++i)
                   block.outputs[i] = haptics::make_safe(block.limits[i], state, block.inputs[i]);
           }) /
           block_ticks;
}

void safety_hostile(const Options& options, Report& report) {
    const int blocks = options.quick ? 100 : 1000;
    for (const auto& device : device_limits) {
        SafetyAttack attack(spec_of(device), 1);
        haptics::SafetyState state;
        haptics::SafetyAudit audit;
        AttackBlock block;
        std::vector<double> samples;
        double felt = 0;
        for (int b = 0; b < blocks; ++b) {
            for (std::size_t i = 0; i < block_ticks; ++i) {
                block.inputs[i] = attack.next();
                block.limits[i] = attack.limits();
            }
            samples.push_back(run_block(block, state));
            for (std::size_t i = 0; i < block_ticks; ++i) {
                audit.record(block.limits[i], block.inputs[i], block.outputs[i]);
                felt += block.outputs[i] != vec3(0) ? 1 : 0;
            }
        }
        const auto ticks = static_cast<double>(audit.ticks());
        report.rows.push_back({.area = "haptics",
                               .name = "safety_hostile",
                               .setting = {{"model", std::string(device.name)}},
                               .time_us = times(samples),
                               .metrics = {{"ticks", ticks},
                                           {"violations", static_cast<double>(audit.violations())},
                                           {"felt_share", felt / ticks}},
                               .hash = hex(hash_value(state))});
    }
}

struct ServoLoad {
    const char* name;
    std::uint32_t every, length;  // time from one pulse to the next, and duration of a pulse (ticks); 0: no
                                  // pulses
    bool primitives = false;
    bool patch = false;
};
constexpr std::array servo_loads{ServoLoad{"quiet", 0, 0}, ServoLoad{"bolts", 125, 15},
                                 ServoLoad{"four_pulses", 25, 100}, ServoLoad{"four_primitives", 0, 0, true},
                                 ServoLoad{"full_patch", 0, 0, false, true}};

/// One haptic primitive (simple source of force) of each kind: a floor, a point to snap to, a groove that
/// leads to it, and a wind.
haptics::PrimitiveSet four_primitives() {
    using enum haptics::PrimitiveKind;
    haptics::PrimitiveSet set;
    set.add({plane, {0, -0.0002, 0}, {0, 1, 0}, 2});
    set.add({point, {0.0005, 0, 0}, {}, 0.1});
    set.add({line, {}, {1, 0, 0}, 0.1});
    set.add({directed, {}, {0, -1, 0}, 0.1});
    return set;
}
/// A patch (the surfaces near a hand) that is full: a rough, moving floor of 32 triangles of eight bodies.
haptics::SurfacePatch full_patch() {
    haptics::SurfacePatch patch;
    patch.body_count = haptics::surface_body_capacity;
    for (std::uint32_t i = 0; i < patch.body_count; ++i) {
        patch.bodies[i].key = i;
        patch.bodies[i].velocity = {0.01, 0, 0};
        patch.bodies[i].material = {.stiffness = 300, .static_friction = 0.5, .dynamic_friction = 0.3};
    }
    constexpr double cell = 4e-4;  // edge of a square of two triangles (m)
    for (std::uint32_t i = 0; i < haptics::surface_capacity; ++i) {
        const std::uint32_t row = i / 8, column = i / 2 % 4;
        const vec3 corner = cell * vec3(column, -0.5, -1.0 - row);
        const vec3 x(cell, 0, 0), z(0, 0, cell);
        patch.surfaces[i] = {.kind = haptics::SurfaceKind::triangle,
                             .body = i % patch.body_count,
                             .part = i,
                             .a = i % 2 == 0 ? corner : corner + x + z,
                             .b = i % 2 == 0 ? corner + z : corner + x,
                             .c = i % 2 == 0 ? corner + x : corner + z};
    }
    patch.count = haptics::surface_capacity;
    return patch;
}
constexpr std::uint32_t servo_ticks = 20'000;

haptics::ServoState play(const ServoLoad& load) {
    const haptics::Servo servo{haptics::safety_limits(spec_of(device_limits[0]), 1)};
    haptics::ServoState state;
    haptics::HapticModel model;
    if (load.primitives) {
        model.primitives = four_primitives();
        model.coupling = {.stiffness = 300, .damping = 1};
    }
    if (load.patch) model.patch = full_patch();
    for (std::uint32_t tick = 0; tick < servo_ticks; ++tick) {
        if (load.every != 0 && tick % load.every == 0)
            model.pulse = {{0, 0.1, 0.2}, load.length, model.pulse.number + 1};
        const double x = 1e-5 * (tick % 100);
        do_not_optimise(haptics::servo_step(servo, state, model, {{x, load.patch ? -x : 0, -x}, 0}));
    }
    return state;
}

void servo_steps(const Options& options, Report& report) {
    std::array<haptics::ServoState, servo_loads.size()> ends;
    std::vector<Contestant> contestants;
    for (std::size_t i = 0; i < servo_loads.size(); ++i)
        contestants.push_back({{}, [&end = ends[i], &load = servo_loads[i]] { end = play(load); }});
    auto samples = measure(contestants, {.seconds = options.quick ? 0.3 : 2.0, .least = 11});
    for (std::size_t i = 0; i < servo_loads.size(); ++i) {
        for (double& us : samples[i]) us /= servo_ticks;
        report.rows.push_back({.area = "haptics",
                               .name = "servo",
                               .setting = {{"motion", std::string(servo_loads[i].name)}},
                               .time_us = times(samples[i]),
                               .hash = hex(hash_value(ends[i]))});
    }
}

}  // namespace

void haptics(const Options& options, Report& report) {
    z_width(report);
    controlled_walls(report);
    simulated_ticks(options, report);
    safety_hostile(options, report);
    servo_steps(options, report);
    surfaces(options, report);
    round_bodies(options, report);
    modes(options, report);
    modes_hostile(options, report);
    servo_rates(options, report);
    passivity(report);
    switches(options, report);
    stirring_passivity(options, report);
    arms(options, report);
}

}  // namespace thaum::bench
