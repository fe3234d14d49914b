// The simulated device: how stiff a wall it can touch (Z-width) beside what theory says, and what a tick costs.
#include "core/hash.h"
#include "core/text.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"
#include "tools/bench/z_width.h"

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

/// What a device is put through, and so which way through a tick is taken.
struct Motion {
    const char* name;
    double friction;  // N
    double swing;     // m, of the target
    int period;       // ticks
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

}  // namespace

void haptics(const Options& options, Report& report) {
    z_width(report);
    simulated_ticks(options, report);
}

}  // namespace thaum::bench
