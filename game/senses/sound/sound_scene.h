// game/senses/sound/sound_scene.h: what players hear of a match. It reads a Simulation every eighth tick and
// writes an audio frame. The match is never changed, and equal matches give equal frames.
//
// Three things are heard: events (their rows in assets/events.toml name the sounds), wands (the table `sound`
// of their data files), and the state of the match (game/senses/sound/cues.h): steps, blows between things,
// the brew, the heart, the clock, the score.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "audio/frame.h"
#include "game/match/follower.h"
#include "game/senses/sound/sound_names.h"

namespace thaum::game::inline senses {

/// State of one wizard's steps, wand and heart at the last audio frame (8 ms).
struct WizardSoundMemory {
    Stride stride{};
    double falling{};  ///< downward speed of the wizard (m/s)
    bool grounded{true}, holds{}, ladle_inside{};
    std::uint32_t selected{}, fired{};
    Tick heart_at{};               ///< when the wizard's heart beats next (ticks of play)
    std::optional<vec3> chisel{};  ///< position of the tool in a crystal (m, world)
};

/// Motion of a loose thing at the last audio frame (8 ms).
struct ThingSoundMemory {
    vec3 velocity{};
    Tick quiet_until{};  ///< tick before which the thing makes no further sound
    bool known{};
};

/// Muffling of a lasting voice (a playing sound) by walls, smoothed.
struct WallSoundMemory {
    std::uint32_t key{};
    std::array<double, audio::max_listeners> muffled{};
};

/// Number of layers of the music.
inline constexpr std::size_t score_layers = 4;

struct SoundMemory {
    MatchFollower follower{};
    std::array<WizardSoundMemory, players> wizards{};
    std::vector<ThingSoundMemory> things;  ///< memory about loose things, indexed by their entity index
    std::array<WallSoundMemory, 16> walls{};
    /// Counter of checks of walls. Modulo the number of lasting voices (playing sounds), it is the voice to
    /// be checked next.
    std::uint32_t wall_turn{};
    std::uint32_t voices_begun{};  ///< number of voices (playing sounds) so far, which varies their pitch
                                   ///< slightly
    Tick fought_at{};              ///< when a wizard last was hurt or fired a shot (ticks of play)
    int second{-1};                ///< last announced second of the countdown or of the last ten seconds
    std::array<double, score_layers> score{};
};

class SoundScene {
public:
    explicit SoundScene(MatchSounds sounds);

    /// Writes what the listening players (0, 1 or both) hear in the eight ticks that have passed. After a
    /// jump of the clock, or a change of the match, no sounds are started for the skipped time.
    void take(const Simulation& match, std::span<const std::uint32_t> listening, audio::AudioFrame& out);

private:
    MatchSounds sounds_;
    SoundMemory memory_;
};

}  // namespace thaum::game::inline senses
