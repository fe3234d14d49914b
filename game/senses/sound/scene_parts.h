// game/senses/sound/scene_parts.h: the functions that make up a SoundScene. Each adds its voices (playing
// sounds) to an audio frame.
#pragma once
#include "game/senses/sound/sound_scene.h"

namespace thaum::game::inline senses {

/// Keys by which lasting voices (playing sounds) are known from frame to frame. For a wizard's voices, the
/// player's number is added.
namespace lasting {
inline constexpr std::uint32_t ready = 10, hold = 20, stir = 30, boil = 40, score = 50, orb = 60, carve = 64;
}

/// An audio frame that is being filled in.
struct SoundWriting {
    const Simulation& match;
    const MatchSounds& sounds;
    SoundMemory& memory;
    std::span<const std::uint32_t> listening;
    audio::AudioFrame& out;

    Tick played() const { return match.match().played; }
    /// Bits of those listeners who are this player (bit i for listener i); 0 if the player does not listen.
    std::uint32_t ears_of(std::uint32_t player) const;
};

/// How strongly and where a sound is heard.
struct Heard {
    vec3 place{};  ///< position of the sound (m, world)
    double gain{1}, pitch{1};
    std::uint32_t heard_by{3};  ///< listeners who hear the sound: bit 0 for the first, bit 1 for the second
    bool at_ear{};              ///< true: played at the listener's ear, without a position
    bool sided{};               ///< true: played at the ear, but the caption names the side of `place`
};

/// Starts a voice, which plays a sound once. A voice with a position is muffled by walls, and its pitch
/// differs slightly from that of the previous voice.
void begin(SoundWriting& writing, SoundNumber sound, const Heard& heard);
void begin(SoundWriting& writing, Cue cue, const Heard& heard);
/// Adds a voice (a playing sound) that lasts until it is missing in a frame. While it lasts, its key is the
/// same in each frame.
void last(SoundWriting& writing, SoundNumber sound, std::uint32_t key, const Heard& heard);

void add_event_sounds(SoundWriting& writing);
void add_wizard_sounds(SoundWriting& writing);
void add_thing_sounds(SoundWriting& writing);
void add_brew_sounds(SoundWriting& writing);
/// Adds the hum of an orb while a wizard scries (searches it). Its pitch rises towards the orb's hidden core
/// (the axis of a vortex).
void add_orb_sounds(SoundWriting& writing);
void add_clock_sounds(SoundWriting& writing);
void add_score(SoundWriting& writing);
/// Muffles lasting voices (playing sounds) behind walls. Checks one voice in each frame, since each check
/// costs a ray cast.
void muffle_by_walls(SoundWriting& writing);

}  // namespace thaum::game::inline senses
