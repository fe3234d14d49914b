// Benchmark of the brew's surface (engine/fluid/spring_surface.h): run time for a simulated second against
// the error of a wave's frequency, compared with an ideal membrane. Also the roundness of ripples, the loss
// of energy, the cost of a push, and that a sleeping surface costs nothing.
#include <array>
#include <cmath>

#include "core/hash.h"
#include "core/text.h"
#include "core/units.h"
#include "fluid/spring_surface.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using fluid::SpringSurface;
using fluid::SpringSurfaceScratch;
using fluid::SpringSurfaceSettings;
using fluid::SurfaceProbe;

constexpr std::array<std::uint32_t, 3> surface_sizes{fluid::classic_nodes, 33, 65};

struct Wave {
    std::uint32_t p, q;
};

/// One wave along the sides and one along the diagonals, with almost the same wavelength. Ripples are round
/// if the speeds of both are equal.
constexpr std::array round_waves{Wave{7, 0}, Wave{5, 5}};
constexpr std::array one_wave{Wave{3, 2}};

/// Height of a standing wave at a node of the grid, at most 1. `wave` holds the numbers of half waves along x
/// and z.
double wave_shape(const SpringSurfaceSettings& s, Wave wave, std::size_t x, std::size_t z) {
    const auto X = static_cast<double>(x), Z = static_cast<double>(z);
    if (s.rim == fluid::Rim::pinned)
        return det::sin(wave.p * pi * X / (s.nodes - 1)) * det::sin(wave.q * pi * Z / (s.nodes - 1));
    return det::cos(wave.p * pi * (X + 0.5) / s.nodes) * det::cos(wave.q * pi * (Z + 0.5) / s.nodes);
}

template <class Visit>
void each_node(const SpringSurfaceSettings& s, Wave wave, Visit visit) {
    for (std::size_t z = 0; z < s.nodes; ++z) {
        for (std::size_t x = 0; x < s.nodes; ++x)
            visit(surface_node_index(s, x, z), wave_shape(s, wave, x, z));
    }
}

SpringSurface surface_with_waves(const SpringSurfaceSettings& s, std::span<const Wave> waves) {
    SpringSurface surface = make_spring_surface(s);
    for (const Wave wave : waves)
        each_node(s, wave, [&](std::size_t i, double shape) { surface.height[i] += 0.01 * shape; });
    refresh_after_edit(surface);
    return surface;
}

/// Frequency of a wave on the ideal membrane (rad/s).
double membrane_frequency(const SpringSurfaceSettings& s, Wave wave) {
    const double side = s.rim == fluid::Rim::pinned ? s.side : s.nodes * surface_node_spacing(s);
    return pi / side * std::sqrt(s.tension / s.areal_mass * (wave.p * wave.p + wave.q * wave.q));
}

/// Result of simulating waves on the surface for a second.
struct WaveRun {
    SpringSurfaceSettings settings{};
    double dt{};  ///< time by which one call advances the surface (s)
    std::span<const Wave> waves{};
    double error{}, energy_lost{}, steps{};
    std::uint64_t hash{};
};

/// Measured frequency of a wave, divided by that on the membrane. Valid if the phase error is below half a
/// turn.
double relative_frequency(const SpringSurface& surface, Wave wave, double seconds) {
    double height = 0, velocity = 0;
    each_node(surface.settings, wave, [&](std::size_t i, double shape) {
        height += shape * surface.height[i];
        velocity += shape * surface.velocity[i];
    });
    const double frequency = membrane_frequency(surface.settings, wave), turned = frequency * seconds;
    const double off = det::atan2(-velocity / frequency, height) - turned;
    return 1 + (off - 2 * pi * std::round(off / (2 * pi))) / turned;
}

void run_waves(WaveRun& run) {
    SpringSurface surface = surface_with_waves(run.settings, run.waves);
    SpringSurfaceScratch scratch;
    const double before = energy(surface);
    double seconds = 0;
    run.steps = 0;
    while (seconds < 1) {
        const auto step = advance(surface, scratch, {}, run.dt);
        seconds += step.seconds;
        run.steps += step.steps;
    }
    const double first = relative_frequency(surface, run.waves[0], seconds);
    run.error =
        std::abs(first / (run.waves.size() > 1 ? relative_frequency(surface, run.waves[1], seconds) : 1) - 1);
    run.energy_lost = 1 - energy(surface) / before;
    run.hash = hash_bytes(std::as_bytes(std::span(surface.height)));
}

std::vector<WaveRun> wave_runs() {
    std::vector<WaveRun> runs;
    for (const double shear : {0.0, 1.0 / 3}) {
        for (const std::uint32_t nodes : surface_sizes) {
            for (const double dt : {0.001, 0.004, 0.016}) {
                SpringSurfaceSettings s{.nodes = nodes, .shear = shear, .damping = 0, .still = 0};
                runs.push_back({s, dt, one_wave});
                s.rim = fluid::Rim::free;
                runs.push_back({s, dt, round_waves});
            }
        }
    }
    return runs;
}

/// Whether these are the settings that the game uses for touch and picture.
bool is_shipped(const WaveRun& run) {
    const SpringSurfaceSettings shipped;
    return run.settings.nodes == shipped.nodes && run.settings.shear == shipped.shear && run.dt == 0.004;
}

void waves(const Options& options, Report& report) {
    std::vector<WaveRun> runs = wave_runs();
    std::vector<Contestant> contestants;
    for (WaveRun& run : runs) contestants.push_back({{}, [&run] { run_waves(run); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 2.0 : 8.0, .least = 5});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const WaveRun& run = runs[i];
        const Times second = times(samples[i]);
        const bool round = run.waves.size() > 1;
        report.rows.push_back(
            {.area = "surface",
             .name = round ? "round_ripple" : "wave",
             .setting = {{"nodes", std::int64_t{run.settings.nodes}},
                         {"shear", run.settings.shear},
                         {"dt_ms", 1e3 * run.dt}},
             .time_us = second,
             .error = ErrorMeasure{round ? "speed_across_to_along" : "relative_frequency", run.error},
             .is_default = is_shipped(run),
             .metrics = {{"us_per_step", second.median / run.steps},
                         {"energy_lost", run.energy_lost},
                         {"steps", run.steps}},
             .hash = hex(run.hash)});
    }
}

// ---- cost of one call ------------------------------------------------------------------------------------

struct CallRun {
    std::string name;
    std::uint32_t nodes{};
    SpringSurface surface{};
    SpringSurfaceScratch scratch{};
    std::vector<SurfaceProbe> probes{};
    double stiffness{1};
    double dt{0.004};
    fluid::SpringSurfaceStep last{};
};

std::vector<CallRun> call_runs() {
    std::vector<CallRun> runs;
    const SurfaceProbe press{.place = {0.2, -0.1}, .height = -0.02, .radius = 0.15};
    for (const std::uint32_t nodes : surface_sizes) {
        runs.push_back({.name = "ripples", .nodes = nodes});
        runs.push_back({.name = "push", .nodes = nodes, .probes = {press}});
        runs.push_back({.name = "asleep", .nodes = nodes});
        runs.push_back({.name = "million_times_as_stiff", .nodes = nodes, .stiffness = 1e6});
    }
    for (CallRun& run : runs) {
        SpringSurfaceSettings s{.nodes = run.nodes, .still = 0};
        s.tension *= run.stiffness;
        run.surface = run.name == "asleep" ? make_spring_surface(s) : surface_with_waves(s, one_wave);
    }
    return runs;
}

void calls(const Options& options, Report& report) {
    constexpr std::size_t in_a_sample = 32;
    std::vector<CallRun> runs = call_runs();
    std::vector<Contestant> contestants;
    for (CallRun& run : runs)
        contestants.push_back(
            {{}, [&run] { run.last = advance(run.surface, run.scratch, run.probes, run.dt); }});
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 1.0 : 4.0, .least = 11, .calls = in_a_sample});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const CallRun& run = runs[i];
        const auto& last = run.last;
        report.rows.push_back({.area = "surface",
                               .name = run.name,
                               .setting = {{"nodes", std::int64_t{run.nodes}}, {"dt_ms", 1e3 * run.dt}},
                               .time_us = times(samples[i]),
                               .metrics = {{"steps", static_cast<double>(last.steps)},
                                           {"visited_nodes", static_cast<double>(last.visited)},
                                           {"advanced_s", last.seconds},
                                           {"force_n", last.probes[0].force}}});
    }
}

}  // namespace

void surface(const Options& options, Report& report) {
    waves(options, report);
    calls(options, report);
}

}  // namespace thaum::bench
