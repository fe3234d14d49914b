// Benchmarks the tactile mixer: time of a frame with the largest number of effects, and of a silent frame;
// time and error of rendering places between actuators; a long run with hostile input.
#include <array>
#include <cmath>
#include <memory>

#include "core/hash.h"
#include "core/random.h"
#include "core/text.h"
#include "game/data/match_data.h"
#include "tactile/mixer.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using tactile::Effect;
using tactile::EffectBank;
using tactile::Layout;
using tactile::Pattern;
using tactile::Region;
using tactile::TactileMixer;
using tactile::Where;

constexpr std::size_t frames_in_a_call = 16;
constexpr std::size_t phantoms_in_a_call = 16;

Expected<Layout> layout_of(const std::string& name) {
    return tactile::load_layout(game::find_assets() / "tactile/layouts" / (name + ".toml"));
}

// ---- time of a frame -------------------------------------------------------------------------------------

/// An effect of each pattern that lasts longer than the benchmark, except a clip, which ends after a minute.
EffectBank lasting_effects() {
    EffectBank bank;
    constexpr double lasting_ms = 1e12;
    for (const auto pattern : {Pattern::single, Pattern::spread, Pattern::sweep, Pattern::heartbeat}) {
        Effect effect;
        effect.strongest = 0.2e-3;
        effect.wavelength = 12e-3;
        effect.stiffness = 5000;
        effect.envelope = {.attack = 10, .hold = lasting_ms, .decay = 10, .smooth = true};
        effect.pattern = pattern;
        effect.speed = 0.6;
        effect.reach = 1;
        effect.slowest_hz = effect.fastest_hz = 2;
        effect.length_ms = lasting_ms;
        effect.to = tactile::BodyPoint{tactile::Part::front, {0.1, 1, 0.09}};
        if (pattern == Pattern::heartbeat) effect.envelope.hold = 1e3;
        // The sweep is so long that it still moves over the body when the benchmark ends.
        if (pattern == Pattern::sweep) effect.length_ms = 6e5;
        bank.effects.push_back(std::move(effect));
    }
    return bank;
}

/// A mixer that plays as many effects as it can at a time, all of one pattern, or of all patterns in turn.
struct MixRun {
    std::string pattern;
    std::unique_ptr<TactileMixer> mixer;
    Tick tick{};
    std::uint64_t hash{};
    std::uint64_t allocations{};

    void run() {
        const auto before = allocation_count();
        for (std::size_t f = 0; f < frames_in_a_call; ++f, tick += tactile::frame_ticks) {
            const auto& frame = mixer->mix(tick);
            do_not_optimise(frame);
        }
        allocations += allocation_count() - before;
    }
};

MixRun mix_run(const Layout& layout, const EffectBank& bank, std::string name, std::uint32_t first,
               std::uint32_t kinds) {
    MixRun run{std::move(name),
               std::make_unique<TactileMixer>(layout, bank, tactile::MixerSettings{.gap = 0})};
    for (std::size_t i = 0; i < tactile::max_playing && kinds > 0; ++i) {
        const double angle = 2 * pi * static_cast<double>(i) / tactile::max_playing;
        const auto effect = first + static_cast<std::uint32_t>(i) % kinds;
        run.mixer->start(effect, Where::from({det::sin(angle), 0, det::cos(angle)}), 1, 0);
    }
    for (; run.tick < 800; run.tick += tactile::frame_ticks)
        run.hash = hash_combine(run.hash, hash_value(run.mixer->mix(run.tick)));
    return run;
}

Row row_of(const MixRun& run, std::vector<double> us, std::size_t playing, std::size_t actuators) {
    for (double& one : us) one /= frames_in_a_call;
    Row row{.area = "tactile", .name = playing > 0 ? "mix" : "silent"};
    row.setting = {{"pattern", run.pattern}, {"actuators", static_cast<std::int64_t>(actuators)}};
    row.time_us = times(us);
    row.is_default = run.pattern == "all";
    row.metrics = {{"playing", static_cast<double>(playing)},
                   {"allocations", static_cast<double>(run.allocations)}};
    row.hash = hex(run.hash);
    return row;
}

void mixing(const Options& options, const Layout& layout, Report& report) {
    const auto bank = lasting_effects();
    std::vector<MixRun> runs;
    constexpr std::array names{"single", "spread", "sweep", "heartbeat"};
    runs.push_back(mix_run(layout, bank, "all", 0, 4));
    for (std::uint32_t i = 0; i < names.size(); ++i) runs.push_back(mix_run(layout, bank, names[i], i, 1));
    runs.push_back(mix_run(layout, bank, "none", 0, 0));
    std::vector<Contestant> contestants;
    for (auto& run : runs) contestants.push_back({{}, [&run] { run.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 4.0, .least = 21});
    for (std::size_t i = 0; i < runs.size(); ++i)
        report.rows.push_back(row_of(runs[i], samples[i], runs[i].mixer->playing(), layout.actuators.size()));
}

// ---- places between actuators ----------------------------------------------------------------------------

/// Places on the chart (the flattened map) of the torso, on a grid within the rectangle of the front
/// actuators.
std::vector<vec2> wanted_places(const Layout& layout) {
    vec2 low(1e9), high(-1e9);
    for (std::size_t i = 0; i < layout.actuators.size(); ++i) {
        if (layout.actuators[i].place.part != tactile::Part::front) continue;
        low = glm::min(low, layout.chart_of(Region::torso, i));
        high = glm::max(high, layout.chart_of(Region::torso, i));
    }
    std::vector<vec2> places;
    for (int i = 0; i < 64; ++i) {
        for (int k = 0; k < 64; ++k) places.push_back(low + (high - low) * (vec2(i, k) + 0.5) / 64.0);
    }
    return places;
}

using Amplitudes = std::array<double, tactile::max_actuators>;

/// Baseline: only the nearest actuator, as the firmware of jackets does.
Amplitudes nearest_actuator(const Layout& layout, vec2 place) {
    Amplitudes result{};
    std::size_t best = 0;
    double shortest = 1e9;
    for (const auto i : layout.group(Region::torso)) {
        const double way =
            glm::length(layout.between(Region::torso, place, layout.chart_of(Region::torso, i)));
        if (way < shortest) best = i;
        shortest = std::min(shortest, way);
    }
    result[best] = 1;
    return result;
}

/// Baseline: amplitudes of a Gaussian about the place, not corrected so that their centroid is the place.
Amplitudes gaussian(const Layout& layout, vec2 place) {
    Amplitudes result{};
    const double sigma = 0.7 * layout.pitch(Region::torso);
    for (const auto i : layout.group(Region::torso)) {
        const vec2 way = layout.between(Region::torso, place, layout.chart_of(Region::torso, i)) / sigma;
        result[i] = det::exp(-0.25 * glm::dot(way, way));
    }
    return result;
}

Amplitudes phantom(const Layout& layout, vec2 place) {
    Amplitudes result{};
    const auto found = tactile::phantom(layout, {Region::torso, place}, vec2(0.7));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::sqrt(static_cast<double>(found.shares[i]));
    return result;
}

struct Renderer {
    std::string solver;
    std::string layout_name;
    const Layout* layout;
    Amplitudes (*render)(const Layout& layout, vec2 place);
    std::vector<vec2> places;
    std::size_t next{};

    void run() {
        for (std::size_t i = 0; i < phantoms_in_a_call; ++i)
            do_not_optimise(render(*layout, places[next + i]));
        next = (next + phantoms_in_a_call) % places.size();
    }
};

Row row_of(const Renderer& renderer, std::vector<double> us) {
    for (double& one : us) one /= phantoms_in_a_call;
    const Layout& layout = *renderer.layout;
    double worst = 0, sum = 0, worst_3d = 0;
    std::uint64_t hash = 0;
    for (const vec2 place : renderer.places) {
        const auto amplitudes = renderer.render(layout, place);
        const double error = glm::length(tactile::felt_offset(layout, Region::torso, place, amplitudes));
        vec3 felt(0);
        double energy = 0;
        for (std::size_t i = 0; i < layout.actuators.size(); ++i) {
            felt += amplitudes[i] * amplitudes[i] * layout.actuators[i].place.at;
            energy += amplitudes[i] * amplitudes[i];
        }
        worst_3d = std::max(worst_3d, glm::length(felt / energy - layout.torso.point(place)));
        worst = std::max(worst, error);
        sum += error;
        hash = hash_combine(hash, hash_value(amplitudes));
    }
    return {.area = "tactile",
            .name = "place",
            .setting = {{"layout", renderer.layout_name}, {"solver", renderer.solver}},
            .time_us = times(us),
            .error = ErrorMeasure{"worst_mm", 1e3 * worst},
            .is_default = renderer.solver == "thaum" && renderer.layout_name == "abstract_4x5",
            .metrics = {{"mean_mm", 1e3 * sum / static_cast<double>(renderer.places.size())},
                        {"worst_3d_mm", 1e3 * worst_3d},
                        {"pitch_mm", 1e3 * layout.pitch(Region::torso)}},
            .hash = hex(hash)};
}

void placing(const Options& options, const std::string& name, const Layout& layout, Report& report) {
    const auto places = wanted_places(layout);
    std::array renderers{Renderer{"thaum", name, &layout, phantom, places},
                         Renderer{"gaussian", name, &layout, gaussian, places},
                         Renderer{"nearest", name, &layout, nearest_actuator, places}};
    std::vector<Contestant> contestants;
    for (auto& renderer : renderers) contestants.push_back({{}, [&renderer] { renderer.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.3 : 1.5, .least = 21});
    for (std::size_t i = 0; i < renderers.size(); ++i)
        report.rows.push_back(row_of(renderers[i], samples[i]));
}

// ---- hostile input ---------------------------------------------------------------------------------------

/// Fifty random hits in each frame, for one minute or ten. Counts frames that exceed a limit, and events that
/// are lost.
Row hostile(const Options& options, const Layout& layout, const EffectBank& bank) {
    const auto mixer = std::make_unique<TactileMixer>(layout, bank);
    Random random = random_stream(11, 1);
    std::uint64_t violations = 0, hash = 0;
    std::vector<double> us;
    const Tick end = options.quick ? 60'000 : 600'000;
    for (Tick tick = 0; tick < end; tick += tactile::frame_ticks) {
        const double begin = now_us();
        for (int i = 0; i < 50; ++i) {
            const vec3 from(random.uniform(-1, 1), 0, random.uniform(-1, 1));
            const auto effect = static_cast<std::uint32_t>(random.below(bank.effects.size()));
            mixer->start(effect, Where::from(from, random.uniform(0.8, 1.5)), random.uniform(-0.1, 1.1),
                         tick);
        }
        us.push_back((now_us() - begin) / 50);
        const auto& frame = mixer->mix(tick);
        double sum = 0;
        for (std::size_t i = 0; i < frame.count; ++i) {
            sum += static_cast<double>(frame.amplitude[i]) * frame.amplitude[i];
            violations += !(frame.amplitude[i] >= 0 && frame.amplitude[i] <= 1);
        }
        violations += !(sum <= 1.5);
        hash = hash_combine(hash, hash_value(frame));
    }
    const auto& counts = mixer->counts();
    return {.area = "tactile",
            .name = "hostile",
            .setting = {{"hits_per_frame", std::int64_t{50}}},
            .time_us = times(us),
            .metrics = {{"violations", static_cast<double>(violations)},
                        {"lost", static_cast<double>(counts.offered - counts.started - counts.merged)},
                        {"merged", static_cast<double>(counts.merged)},
                        {"replaced", static_cast<double>(counts.replaced)}},
            .hash = hex(hash)};
}

}  // namespace

void tactile_mixer(const Options& options, Report& report) {
    const auto bank = tactile::load_effects(game::find_assets() / "tactile/effects");
    if (!bank) return report.faults.push_back(bank.error().message);
    for (const std::string name : {"abstract_4x5", "x40", "x16"}) {
        const auto layout = layout_of(name);
        if (!layout) return report.faults.push_back(layout.error().message);
        if (name == "x40") {
            mixing(options, *layout, report);
            report.rows.push_back(hostile(options, *layout, *bank));
        }
        placing(options, name, *layout, report);
    }
}

}  // namespace thaum::bench
