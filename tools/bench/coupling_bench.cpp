// Benchmark of the virtual coupling: run time and error over stiffness, mass ratio and step. The baseline is
// semi-implicit Euler, the usual way to step such springs.
#include <cmath>
#include <limits>

#include "core/hash.h"
#include "core/text.h"
#include "haptics/coupling.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using haptics::coupling_step;
using haptics::CouplingState;

constexpr double pair_seconds = 1;
constexpr double pair_damping_ratio = 0.1;
constexpr double pair_stretch = 0.2;  // stretch of the spring at the start (m)
constexpr double hand_mass = 1;       // mass of a free hand (kg)

struct PairSetting {
    bool exact;
    double stiffness;   // stiffness of the coupling (N/m)
    double mass_ratio;  // mass of the object divided by that of the hand
    std::int64_t step_ms;
    bool free_hand = false;

    double dt() const { return static_cast<double>(step_ms) * 1e-3; }
    int steps() const { return static_cast<int>(std::lround(pair_seconds / dt())); }
    double inverse_mass() const { return 1 / (mass_ratio * hand_mass) + (free_hand ? 1 / hand_mass : 0); }
    double damping() const { return 2 * pair_damping_ratio * std::sqrt(stiffness / inverse_mass()); }
};

/// Velocity of a hand whose motion is given, at each step (m/s). It reverses every 16 ms, whatever the step
/// length.
double hand_velocity(const PairSetting& s, int i) {
    if (s.free_hand) return 0;
    return (i * s.step_ms / 16) % 2 == 0 ? 0.5 : -0.5;
}

/// Stretch of the spring after each step (m), by the closed form of the underdamped oscillator, in long
/// double.
std::vector<double> exact_stretches(const PairSetting& s) {
    using Real = long double;
    const Real rate2 = Real(s.stiffness) * Real(s.inverse_mass());
    const Real decay = Real(s.damping()) * Real(s.inverse_mass()) / 2, t = Real(s.step_ms) / 1000;
    const Real w = std::sqrt(rate2 - decay * decay);
    const Real c = std::cos(w * t), sine = std::sin(w * t), fade = std::exp(-decay * t);
    std::vector<double> result;
    Real e = pair_stretch, e_rate = hand_velocity(s, 0);
    for (int i = 0; i < s.steps(); ++i) {
        if (i > 0) e_rate += Real(hand_velocity(s, i)) - Real(hand_velocity(s, i - 1));
        const Real b = e_rate + decay * e;
        const Real next = fade * (e * c + b / w * sine);
        e_rate = fade * (e_rate * c - (decay * b / w + w * e) * sine);
        e = next;
        result.push_back(static_cast<double>(e));
    }
    return result;
}

void step_exactly(const PairSetting& s, std::vector<double>& stretches) {
    const auto step = coupling_step({s.stiffness, s.damping(), 0}, 1 / (s.mass_ratio * hand_mass),
                                    s.free_hand ? 1 / hand_mass : 0, s.dt());
    CouplingState state{.hand = {pair_stretch, 0, 0}};
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        if (!s.free_hand) state.hand_velocity.x = hand_velocity(s, static_cast<int>(i));
        const auto r = couple(step, state);
        // The centre of mass of a free pair stays at rest, so a free hand moves against the object,
        // `mass_ratio` times as far. Otherwise the hand's motion is given.
        state.hand += s.free_hand ? -s.mass_ratio * r.displacement : state.hand_velocity * s.dt();
        if (s.free_hand) state.hand_velocity -= r.impulse / hand_mass;
        state.object += r.displacement;
        state.object_velocity += r.velocity_change;
        stretches[i] = state.hand.x - state.object.x;
    }
}

void step_by_euler(const PairSetting& s, std::vector<double>& stretches) {
    CouplingState state{.hand = {pair_stretch, 0, 0}};
    const double k = s.stiffness, b = s.damping(), dt = s.dt();
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        if (!s.free_hand) state.hand_velocity.x = hand_velocity(s, static_cast<int>(i));
        const vec3 impulse =
            (k * (state.hand - state.object) + b * (state.hand_velocity - state.object_velocity)) * dt;
        if (s.free_hand) state.hand_velocity -= impulse / hand_mass;
        state.object_velocity += impulse / (s.mass_ratio * hand_mass);
        state.hand += state.hand_velocity * dt;
        state.object += state.object_velocity * dt;
        stretches[i] = state.hand.x - state.object.x;
    }
}

/// Largest error over the run, relative to the stretch at the start.
double relative_error(const std::vector<double>& found, const std::vector<double>& exact) {
    double worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double off = std::abs(found[i] - exact[i]) / pair_stretch;
        if (!std::isfinite(off)) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, off);
    }
    return worst;
}

/// Stretches of the spring after each step (m): with a hand whose motion is given, and with a free hand.
struct PairRun {
    std::vector<double> moved, free;
};

PairSetting with_free_hand(PairSetting s) {
    s.free_hand = true;
    return s;
}

void run_pair(const PairSetting& s, PairRun& out) {
    const auto stepped = s.exact ? step_exactly : step_by_euler;
    stepped(s, out.moved);
    stepped(with_free_hand(s), out.free);
}

std::vector<PairSetting> pair_settings() {
    std::vector<PairSetting> result;
    for (const double stiffness : {10.0, 4000.0, 1e6}) {
        for (const double ratio : {1e-3, 1.0, 1e3}) {
            for (const std::int64_t ms : {1, 2, 4, 8}) {
                for (const bool exact : {true, false}) result.push_back({exact, stiffness, ratio, ms});
            }
        }
    }
    return result;
}

Row pair_row(const PairSetting& s, const PairRun& run, std::vector<double> samples_us) {
    for (double& us : samples_us) us /= 2 * s.steps();
    const double error = std::max(relative_error(run.moved, exact_stretches(s)),
                                  relative_error(run.free, exact_stretches(with_free_hand(s))));
    return {.area = "coupling",
            .name = "oscillator",
            .setting = {{"scheme", std::string(s.exact ? "exact" : "semi_implicit_euler")},
                        {"stiffness_n_per_m", s.stiffness},
                        {"mass_ratio", s.mass_ratio},
                        {"dt_ms", s.step_ms}},
            .time_us = times(samples_us),
            .error = ErrorMeasure{"relative_stretch_within_1_s", error, !s.exact},
            .is_default = s.exact && s.step_ms == 1,
            .hash = hex(hash_bytes(std::as_bytes(std::span(run.free))))};
}

}  // namespace

void coupling(const Options& options, Report& report) {
    const auto settings = pair_settings();
    std::vector<PairRun> runs;
    std::vector<Contestant> contestants;
    for (const auto& s : settings) {
        const std::vector<double> empty(static_cast<std::size_t>(s.steps()));
        runs.push_back({empty, empty});
    }
    for (std::size_t i = 0; i < settings.size(); ++i)
        contestants.push_back({{}, [&s = settings[i], &run = runs[i]] { run_pair(s, run); }});
    const auto samples =
        measure(contestants, {.seconds = options.quick ? 1.0 : 5.0, .least = options.quick ? 3U : 11U});
    for (std::size_t i = 0; i < settings.size(); ++i)
        report.rows.push_back(pair_row(settings[i], runs[i], samples[i]));
    wand_coupling(options, report);
}

}  // namespace thaum::bench
