// Benchmarks what the sound of a match and a jacket cost while they are absent, while nothing is heard or
// felt, and during a duel. Costs are given relative to a tick of the duel.
#include <algorithm>
#include <numeric>

#include "audio/mixer.h"
#include "core/text.h"
#include "game/senses/senses.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr std::array<std::uint32_t, game::players> both{0, 1};
constexpr double max_share = 0.01;  ///< largest cost while nothing is heard or felt, as a share of a tick

/// Mean (us) without the longest hundredth of the samples, during which other programs ran.
double usual_mean(std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    const auto count = samples.size() - samples.size() / 100;
    return std::accumulate(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
           static_cast<double>(count);
}

/// Sound scene and mixer of a match. Without a scene, nothing is computed.
struct SkippedSound {
    std::optional<game::SoundScene> scene{};
    std::optional<audio::Mixer> mixer{};
    audio::AudioFrame frame{};
    std::array<float, audio::block_values> block{};

    /// The work for sound that is done on the match's thread.
    void follow(const game::Simulation& match) {
        if (scene) scene->take(match, both, frame);
    }
    /// The work for sound that is done on the loudspeakers' thread.
    void mix() {
        if (mixer) mixer->play(frame, block);
    }
};

/// Tactile scene with a jacket for both players, and another with only the figure on the screen. The
/// difference is the cost of the jacket.
struct SkippedJacket {
    std::array<std::unique_ptr<game::TactileScene>, game::players> without{}, with{};
    std::size_t layout = 0;

    SkippedJacket(const game::SenseData& data, const game::MatchEffects& effects,
                  const tactile::Layout& jacket) {
        for (std::uint32_t p = 0; p < game::players; ++p) {
            without.at(p) = std::make_unique<game::TactileScene>(effects, data.effects, p);
            with.at(p) = std::make_unique<game::TactileScene>(effects, data.effects, p);
            without.at(p)->add(data.figure);
            with.at(p)->add(data.figure);
            layout = with.at(p)->add(jacket);
        }
    }
    void set_used(bool used) {
        for (auto& scene : with) scene->set_used(layout, used);
    }
    static double us_of_take(std::array<std::unique_ptr<game::TactileScene>, game::players>& scenes,
                             const game::Simulation& match) {
        const double start = now_us();
        for (auto& scene : scenes) scene->take(match);
        return now_us() - start;
    }
    /// Time that the jacket adds to a frame of eight ticks (us).
    double follow(const game::Simulation& match) {
        const double plain = us_of_take(without, match);
        return us_of_take(with, match) - plain;
    }
};

struct SenseTimes {
    double tick_us{};
    /// One time for each frame of eight ticks (us).
    std::vector<double> sound_us{}, mixing_us{}, jacket_us{};
};

/// Measures the senses in `frames` frames of eight ticks; `run` plays those ticks.
SenseTimes measure_senses(const game::Simulation& match, std::size_t frames, SkippedSound& hearing,
                          SkippedJacket& jacket, const std::function<void()>& run) {
    std::vector<double> ticks_us;
    SenseTimes out;
    for (std::size_t i = 0; i < frames; ++i) {
        ticks_us.push_back(us_of(run) / static_cast<double>(audio::frame_ticks));
        out.sound_us.push_back(us_of([&] { hearing.follow(match); }));
        out.mixing_us.push_back(us_of([&] { hearing.mix(); }));
        out.jacket_us.push_back(jacket.follow(match));
    }
    out.tick_us = usual_mean(ticks_us);
    return out;
}

/// Time that a measurement gives for no work at all (us), to be subtracted from the times of work.
double us_of_nothing() {
    std::vector<double> samples(2000);
    for (auto& sample : samples) sample = us_of([] {});
    return median(samples);
}

void add_row(const char* name, const char* state, double us_per_frame, double tick_us, Report& report) {
    const double ns = std::max(0.0, us_per_frame) * 1000 / static_cast<double>(audio::frame_ticks);
    report.rows.push_back({.area = "skip",
                           .name = name,
                           .setting = {{"state", std::string(state)}},
                           .metrics = {{"ns_per_tick", ns}, {"share_of_tick", ns / (1000 * tick_us)}}});
    const double share = ns / (1000 * tick_us);
    if (std::string_view(state) != "active" && share > max_share)
        report.faults.push_back(
            text("skip ", name, ": ", state, ", it takes ", fixed(100 * share, 2), " % of a tick"));
}

struct LoadedSenses {
    std::shared_ptr<const game::SenseData> data;
    tactile::Layout jacket;
};

std::optional<LoadedSenses> load_skipped_senses() {
    const auto assets = game::find_assets();
    auto data = game::SenseData::load(assets, audio::WithSamples::yes);
    auto jacket = tactile::load_layout(assets / "tactile" / "layouts" / "x40.toml");
    if (!there(data, "skip/sound") || !there(jacket, "skip/jacket")) return std::nullopt;
    return LoadedSenses{*data, std::move(*jacket)};
}

/// One state of sound and jacket, such as absent or silent, and the match that brings it about.
struct SenseCase {
    const char* state;
    bool present{};
    const game::Simulation& match;
    std::function<void()> run;
};

}  // namespace

void skip_senses(const Options& options, Report& report) {
    const auto loaded = load_skipped_senses();
    auto duel = heaviest_duel();
    auto still = idle_match();
    if (!loaded || !still || !there(duel, "skip")) return;
    const std::size_t frames = options.quick ? 1500 : 8000;
    const double empty = us_of_nothing();
    double tick_us = 0;
    const auto run_duel = [&] { duel->run(audio::frame_ticks); };
    const auto run_still = [&] { still->run(audio::frame_ticks); };
    for (const auto& c : {SenseCase{"active", true, *duel->match, run_duel},
                          SenseCase{"silent", true, *still->match, run_still},
                          SenseCase{"absent", false, *duel->match, run_duel}}) {
        const auto& shown = *c.match.data().presentation;
        const auto effects = game::match_effects(loaded->data->effects, shown);
        // The music is off, because it is never silent.
        auto mixer = audio::Mixer::create(loaded->data->bank, {.music = 0});
        if (!there(mixer, "skip/sound")) return;
        SkippedSound hearing;
        if (c.present) {
            hearing.scene.emplace(game::match_sounds(loaded->data->bank, shown));
            hearing.mixer.emplace(std::move(*mixer));
        }
        SkippedJacket jacket(*loaded->data, effects, loaded->jacket);
        jacket.set_used(c.present);
        measure_senses(c.match, 200, hearing, jacket, c.run);  // warm-up, which allocates memory
        const auto measured = measure_senses(c.match, frames, hearing, jacket, c.run);
        if (tick_us == 0) tick_us = measured.tick_us;
        add_row("sound", c.state, usual_mean(measured.sound_us) - empty, tick_us, report);
        constexpr double frame_us = 1e6 * seconds(audio::frame_ticks);
        report.rows.back().metrics.push_back(
            {"mixing_share_of_core", std::max(0.0, usual_mean(measured.mixing_us) - empty) / frame_us});
        add_row("jacket", c.state, usual_mean(measured.jacket_us), tick_us, report);
    }
}

}  // namespace thaum::bench
