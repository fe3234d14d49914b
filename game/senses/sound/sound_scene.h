// game/senses/sound/sound_scene.h: what players hear of a match. It reads a Simulation every eighth tick and writes an
// audio frame. It never changes the match, and equal matches give equal frames.
//
// Three things are heard: events (their rows in assets/events.toml name the sounds), wands (the table `sound` of
// their data files), and what the state shows (game/senses/sound/cues.h): steps, blows between things, the brew, the
// heart, the clock, the score.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "audio/frame.h"
#include "game/match/follower.h"
#include "game/senses/sound/sound_names.h"

namespace thaum::game {

/// Steps, wand and heart of one wizard at the last frame.
struct WizardSoundMemory {
    Stride stride{};
    double falling{};  ///< speed downwards (m/s)
    bool grounded{true}, holds{}, ladle_inside{};
    std::uint32_t selected{}, fired{};
    Tick heart_at{};               ///< when the heart beats next (ticks of play)
    std::optional<vec3> chisel{};  ///< place of the tool in a crystal (m, world)
};

/// Motion of a loose thing at the last frame.
struct ThingSoundMemory {
    vec3 velocity{};
    Tick quiet_until{};  ///< tick before which the thing makes no sound again
    bool known{};
};

/// Loudness of a lasting voice behind walls, smoothed.
struct WallSoundMemory {
    std::uint32_t key{};
    std::array<double, audio::most_listeners> muffled{};
};

/// Layers of the score.
inline constexpr std::size_t score_layers = 4;

struct SoundMemory {
    MatchFollower follower{};
    std::array<WizardSoundMemory, players> wizards{};
    std::vector<ThingSoundMemory> things;  ///< by entity index
    std::array<WallSoundMemory, 16> walls{};
    std::uint32_t wall_turn{};     ///< lasting voice whose walls are looked at next
    std::uint32_t voices_begun{};  ///< number of voices so far, for small differences of their pitch
    Tick fought_at{};              ///< when a wizard was last hurt or shot (ticks of play)
    int second{-1};                ///< second of the countdown or of the last ten seconds that was told last
    std::array<double, score_layers> score{};
};

class SoundScene {
public:
    explicit SoundScene(MatchSounds sounds);

    /// Writes what the listening players (0, 1 or both) hear in the eight ticks that have passed. A frame after a
    /// jump of the clock, or of a match that was changed, begins no voices for what lies between.
    void take(const Simulation& match, std::span<const std::uint32_t> listening, audio::AudioFrame& out);

private:
    MatchSounds sounds_;
    SoundMemory memory_;
};

}  // namespace thaum::game
