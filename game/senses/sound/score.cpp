#include <algorithm>
#include <cmath>

#include "game/senses/sound/scene_parts.h"

namespace thaum::game::inline senses {
namespace {

constexpr Tick told_seconds = 10, counted_seconds = 3;
constexpr double fight_fades_s = 8, final_s = 30, weak_health = 0.4;
/// Loudness of each layer of music, and the time in which layers fade in and out (s).
constexpr double calm = 0.5, pulse = 0.5, tension = 0.5, last_layer = 0.6, change_s = 1.5;
/// Loudness below which a layer of the music is left out. The mixer keeps all layers in step.
constexpr double unheard = 1e-3;
constexpr std::array<Cue, score_layers> layers{Cue::music_calm, Cue::music_pulse, Cue::music_tension,
                                               Cue::music_final};

double left_s(const SoundWriting& writing) {
    const auto end = round_ends_at(writing.match.data().round, writing.match.match());
    return end > writing.played() ? seconds(end - writing.played()) : 0;
}

double weakest(const SoundWriting& writing) {
    double share = 1;
    writing.match.world().view<const Wizard, const Health, ecs::Without<Dead>>().each(
        [&](const Wizard&, const Health& health) {
            share = std::min(share, health.points / writing.match.data().wizard.health);
        });
    return share;
}

/// Loudness that each layer of the music should fade to.
std::array<double, score_layers> wanted(const SoundWriting& writing) {
    const auto& match = writing.match.match();
    if (match.phase != Phase::playing || match.paused != 0) return {calm, 0, 0, 0};
    const auto& memory = writing.memory;
    const double since = memory.fought_at != 0
                             ? seconds(writing.played() - std::min(writing.played(), memory.fought_at))
                             : fight_fades_s;
    const double fight = std::clamp(1 - since / fight_fades_s, 0.0, 1.0);
    const bool last_seconds = left_s(writing) < final_s;
    return {calm, pulse * fight, weakest(writing) < weak_health ? tension : 0, last_seconds ? last_layer : 0};
}

}  // namespace

void add_clock_sounds(SoundWriting& writing) {
    const auto& match = writing.match.match();
    const auto& rules = writing.match.data().round;
    auto& told = writing.memory.second;
    Tick left = 0;
    Cue cue = Cue::last_seconds;
    if (match.phase == Phase::between) {
        left = rules.interval > match.waited ? rules.interval - match.waited : 0;
        if (left > counted_seconds * ticks_per_second) left = 0;
        cue = Cue::count_tick;
    } else if (match.phase == Phase::playing) {
        left = ticks(left_s(writing));
        if (left > told_seconds * ticks_per_second) left = 0;
    }
    const int second = static_cast<int>((left + ticks_per_second - 1) / ticks_per_second);
    if (second > 0 && second != told) begin(writing, cue, {.at_ear = true});
    told = second;
}

void add_score(SoundWriting& writing) {
    const auto goal = wanted(writing);
    const double share = seconds(audio::frame_ticks) / change_s;
    for (std::uint32_t i = 0; i < score_layers; ++i) {
        auto& current = writing.memory.score.at(i);
        current += share * (goal.at(i) - current);
        if (current < unheard) continue;
        last(writing, writing.sounds.cues.at(static_cast<std::size_t>(layers.at(i))), lasting::score + i,
             {.gain = current, .at_ear = true});
    }
}

}  // namespace thaum::game::inline senses
