// game/senses/sound/scene_parts.h: the parts of a SoundScene. Each adds its voices to a frame.
#pragma once
#include "game/senses/sound/sound_scene.h"

namespace thaum::game {

/// Keys of lasting voices. A wizard's voices have the player's number added.
namespace lasting {
inline constexpr std::uint32_t ready = 10, hold = 20, stir = 30, boil = 40, score = 50, orb = 60, carve = 64;
}

/// A frame that is being written.
struct SoundWriting {
    const Simulation& match;
    const MatchSounds& sounds;
    SoundMemory& memory;
    std::span<const std::uint32_t> listening;
    audio::AudioFrame& out;

    Tick played() const { return match.match().played; }
    /// Bits of the listeners who are this player; 0 if the player does not listen.
    std::uint32_t ears_of(std::uint32_t player) const;
};

/// How strongly and where a sound is heard.
struct Heard {
    vec3 place{};  ///< (m, world)
    double gain{1}, pitch{1};
    std::uint32_t heard_by{3};  ///< bits of the listeners
    bool at_ear{};              ///< without place
    bool sided{};               ///< at the ear, but the words tell the side of `place`
};

/// Begins a voice, muffled by walls. Its pitch differs a little from that of the voice before.
void begin(SoundWriting& writing, SoundNumber sound, const Heard& heard);
void begin(SoundWriting& writing, Cue cue, const Heard& heard);
/// Adds a lasting voice. The key is the same in each frame while the voice lasts.
void last(SoundWriting& writing, SoundNumber sound, std::uint32_t key, const Heard& heard);

void add_event_sounds(SoundWriting& writing);
void add_wizard_sounds(SoundWriting& writing);
void add_thing_sounds(SoundWriting& writing);
void add_brew_sounds(SoundWriting& writing);
/// The hum of an orb that somebody scries. It rises towards the core.
void add_orb_sounds(SoundWriting& writing);
void add_clock_sounds(SoundWriting& writing);
void add_score(SoundWriting& writing);
/// Muffles lasting voices behind walls. Looks at one voice in each frame, since each look costs a ray.
void muffle_by_walls(SoundWriting& writing);

}  // namespace thaum::game
