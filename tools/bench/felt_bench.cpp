// Benchmarks what sound and tactile output add to the ticks of a match.
#include <algorithm>

#include "audio/synth.h"
#include "game/data/match_data.h"
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/tactile_scene.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using game::players;

/// Two listeners, and for each player a body figure on the screen and a pad.
struct Senses {
    audio::SoundBank bank;
    tactile::EffectBank effects;
    tactile::Layout figure, pad;
};

Expected<Senses> load_senses() {
    const auto assets = game::find_assets();
    auto bank = audio::load_sounds(assets / "sounds");
    if (!bank) return bank.error();
    auto effects = tactile::load_effects(assets / "tactile" / "effects");
    if (!effects) return effects.error();
    auto figure = tactile::load_layout(assets / "tactile" / "layouts" / "abstract_4x5.toml");
    if (!figure) return figure.error();
    auto pad = tactile::load_layout(assets / "tactile" / "layouts" / "pad.toml");
    if (!pad) return pad.error();
    return Senses{std::move(*bank), std::move(*effects), std::move(*figure), std::move(*pad)};
}

/// Computes the sound and the tactile output of one match.
class Sensed {
public:
    Sensed(const Senses& senses, game::MatchSounds sounds, game::MatchEffects effects)
        : effects_(std::move(effects)), sound_(std::move(sounds)) {
        for (std::uint32_t p = 0; p < players; ++p) {
            scenes_.push_back(std::make_unique<game::TactileScene>(effects_, senses.effects, p));
            scenes_.back()->add(senses.figure);
            scenes_.back()->add(senses.pad);
        }
    }

    void follow(const game::Simulation& match) {
        constexpr std::array<std::uint32_t, players> both{0, 1};
        sound_.take(match, both, frame_);
        begun += frame_.begins.count;
        for (auto& scene : scenes_) {
            scene->take(match);
            felt += scene->frame(0).is_silent() ? 0 : 1;
        }
    }

    std::uint64_t begun = 0;  ///< number of voices (playing sounds) that began
    std::uint64_t felt = 0;   ///< frames of the body figure in which a player feels something

private:
    game::MatchEffects effects_;
    game::SoundScene sound_;
    std::vector<std::unique_ptr<game::TactileScene>> scenes_;
    audio::AudioFrame frame_{};
};

struct Measured {
    double plain_us{}, sensed_us{};
    std::vector<double> frames;  ///< time to compute the sound and the tactile output of eight ticks (us)
    std::uint64_t allocations{};
};

/// Plays two equal duels alternately, eight ticks each, one of them with sound and tactile output.
Measured measure(game::BotDuel& plain, game::BotDuel& other, Sensed& sensed, std::size_t frames) {
    Measured out;
    for (std::size_t i = 0; i < frames; ++i) {
        const double start = now_us();
        plain.run(audio::frame_ticks);
        const double between = now_us();
        other.run(audio::frame_ticks);
        const double played = now_us();
        const auto before = allocation_count();
        sensed.follow(*other.match);
        const double end = now_us();
        out.allocations += allocation_count() - before;
        out.plain_us += between - start;
        out.sensed_us += end - between;
        out.frames.push_back(end - played);
    }
    return out;
}

}  // namespace

void tick_duel_felt(const Options& options, Report& report) {
    auto plain = heaviest_duel(), other = heaviest_duel();
    const auto senses = load_senses();
    if (!there(plain, "tick") || !there(other, "tick") || !there(senses, "tick/duel_felt")) return;
    const auto& shown = *other->match->data().presentation;
    auto sounds = game::match_sounds(senses->bank, shown);
    auto effects = game::match_effects(senses->effects, shown);
    Sensed sensed(*senses, std::move(sounds), std::move(effects));
    measure(*plain, *other, sensed, 1000);  // not counted: runs until all memory is allocated
    const auto measured = measure(*plain, *other, sensed, options.quick ? 2'500 : 15'000);
    report.rows.push_back(
        {.area = "tick",
         .name = "duel_felt",
         .setting = {{"listeners", std::int64_t{players}}, {"layouts", std::int64_t{2 * players}}},
         .time_us = times(measured.frames),
         .metrics = {{"ratio_to_plain", measured.sensed_us / measured.plain_us},
                     {"mean_us", mean(measured.frames)},
                     {"allocations", static_cast<double>(measured.allocations)},
                     {"voices", static_cast<double>(sensed.begun)},
                     {"felt_frames", static_cast<double>(sensed.felt)},
                     {"same_state", plain->match->state_hash() == other->match->state_hash() ? 1.0 : 0.0}},
         .hash = hex(other->match->state_hash())});
}

}  // namespace thaum::bench
