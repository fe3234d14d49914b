#include "game/senses/sound/sound_scene.h"

#include <algorithm>

#include "game/senses/sound/scene_parts.h"

namespace thaum::game::inline senses {
namespace {

/// Muffling by a wall between ear and source (0: none, 1: full). Share of the remaining change that is made
/// at each check, so that the muffling does not jump.
constexpr double wall_muffles = 0.75, wall_share = 0.5;
/// A wall no farther than this from the source belongs to the source and does not muffle it (m).
constexpr double own_wall = 0.4;

void take_listeners(SoundWriting& writing) {
    auto& out = writing.out;
    const auto& world = writing.match.world();
    out.listener_count = static_cast<std::uint32_t>(writing.listening.size());
    for (std::size_t i = 0; i < writing.listening.size(); ++i) {
        const auto wizard = wizard_of(world, writing.listening[i]);
        const auto& gaze = world.get<Gaze>(wizard);
        const quat looking = look_rotation(gaze.yaw, gaze.pitch);
        out.listeners.at(i) = {
            .position = eye_of(writing.match.data().wizard, world.get<Motion>(wizard).position),
            .forward = looking * vec3(0, 0, -1),
            .up = looking * vec3(0, 1, 0)};
    }
}

double wall_between(const SoundWriting& writing, std::size_t listener, vec3 place) {
    const vec3 ear = writing.out.listeners.at(listener).position;
    const auto hit = writing.match.physics().ray(ear, place, layer::ground);
    return hit && glm::distance(hit->point, place) > own_wall ? wall_muffles : 0;
}

/// A number from -1 to 1 that differs from voice to voice (playing sound), by which their pitch is varied.
double differing(std::uint32_t voice) {
    Random random = random_stream(voice, 0x736f756e64);
    return random.uniform(-1, 1);
}

/// Starts the memory of what was heard anew, so that what happened before makes no sounds.
void begin_anew(SoundWriting& writing) {
    auto& memory = writing.memory;
    const auto score = memory.score;
    memory = {};
    memory.things.reserve(1024);
    memory.score = score;
    memory.follower.skip_events(writing.match);
}

}  // namespace

std::uint32_t SoundWriting::ears_of(std::uint32_t player) const {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < listening.size(); ++i)
        if (listening[i] == player) bits |= 1U << i;
    return bits;
}

void begin(SoundWriting& writing, SoundNumber sound, const Heard& heard) {
    constexpr double pitch_spread = 0.04;
    if (!sound || heard.heard_by == 0) return;
    const double spread = heard.at_ear ? 0 : pitch_spread * differing(writing.memory.voices_begun++);
    audio::Voice voice{.sound = *sound,
                       .heard_by = heard.heard_by,
                       .at_ear = heard.at_ear,
                       .sided = heard.sided,
                       .position = heard.place,
                       .gain = heard.gain,
                       .pitch = heard.pitch * (1 + spread)};
    for (std::size_t i = 0; !heard.at_ear && i < writing.listening.size(); ++i)
        voice.muffled.at(i) = wall_between(writing, i, heard.place);
    writing.out.begins.add(voice);
}

void begin(SoundWriting& writing, Cue cue, const Heard& heard) {
    begin(writing, writing.sounds.cues.at(static_cast<std::size_t>(cue)), heard);
}

void last(SoundWriting& writing, SoundNumber sound, std::uint32_t key, const Heard& heard) {
    if (!sound || heard.heard_by == 0) return;
    writing.out.lasts.add({.sound = *sound,
                           .key = key,
                           .heard_by = heard.heard_by,
                           .at_ear = heard.at_ear,
                           .position = heard.place,
                           .gain = heard.gain,
                           .pitch = heard.pitch});
}

void muffle_by_walls(SoundWriting& writing) {
    auto& voices = writing.out.lasts;
    auto& walls = writing.memory.walls;
    if (voices.count == 0) return;
    const auto looked = writing.memory.wall_turn++ % voices.count;
    for (std::uint32_t i = 0; i < voices.count; ++i) {
        auto& voice = voices.voices.at(i);
        if (voice.at_ear) continue;
        auto& wall = walls.at(voice.key % walls.size());
        if (wall.key != voice.key) wall = {.key = voice.key};
        for (std::size_t ear = 0; i == looked && ear < writing.listening.size(); ++ear) {
            auto& muffled = wall.muffled.at(ear);
            muffled += wall_share * (wall_between(writing, ear, voice.position) - muffled);
        }
        voice.muffled = wall.muffled;
    }
}

SoundScene::SoundScene(MatchSounds sounds) : sounds_(std::move(sounds)) { memory_.things.reserve(1024); }

void SoundScene::take(const Simulation& match, std::span<const std::uint32_t> listening,
                      audio::AudioFrame& out) {
    out.begins.count = out.begins.left_out = out.lasts.count = out.lasts.left_out = 0;
    SoundWriting writing{match, sounds_, memory_, listening, out};
    const bool followed = memory_.follower.goes_on(match);
    if (!followed) begin_anew(writing);
    take_listeners(writing);
    if (match.match().paused == 0) {
        add_event_sounds(writing);
        // Between rounds everything stands still, but keeps its speed and charge, which must make no sound.
        if (match.match().phase == Phase::playing) {
            add_wizard_sounds(writing);
            add_thing_sounds(writing);
            add_brew_sounds(writing);
            add_orb_sounds(writing);
        }
        add_clock_sounds(writing);
    }
    if (!followed) out.begins.count = 0;
    // At the first frame of a match, its first round has already begun, so the sound of that start is added
    // here.
    if (!memory_.follower.has_begun() && match.match().played <= audio::frame_ticks)
        begin(writing, Cue::count_go, {.at_ear = true});
    add_score(writing);
    muffle_by_walls(writing);
    memory_.follower.look(match);
}

}  // namespace thaum::game::inline senses
