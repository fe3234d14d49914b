// game/senses/tactile/tactile_scene.h: what one player feels on the body during a match. It reads a Simulation every eighth
// tick and starts effects on every layout that the player has: the picture of a jacket, a pad, a recorder. It never
// changes the match, and equal matches give equal frames. Actuators on the right arm move with the wand.
//
//     match -> events and state -> TactileScene -> TactileMixer of each layout -> TactileFrame every 8 ms
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "game/match/follower.h"
#include "game/senses/tactile/match_effects.h"
#include "tactile/layout.h"
#include "tactile/mixer.h"

namespace thaum::game {

/// One effect that starts, or that lasts under a key.
struct BodyCue {
    std::uint32_t effect{};
    tactile::Where where{};
    double strength{1};
    std::uint32_t key{};  ///< 0: starts and plays to its end
    EventKind event{};    ///< event that caused it; EventKind::none: the state of the match did
};

/// Faders of the figure in the view: it shows what comes from outside, and the own shots would hide that.
tactile::Faders figure_faders();

/// Time since a cell of a figure was last on, at the tick `felt_at` (s); very long for 0: never.
double since_felt_s(Tick now, Tick felt_at);

class TactileScene {
public:
    /// Keeps the references.
    TactileScene(const MatchEffects& effects, const tactile::EffectBank& bank, std::uint32_t player);

    /// Adds a layout, whose frames have the returned number. Keeps the reference.
    std::size_t add(const tactile::Layout& layout);
    /// A layout that is not used costs nothing, and its frames are silent. New ones are used.
    void set_used(std::size_t layout, bool used);
    void set_faders(std::size_t layout, const tactile::Faders& faders);

    /// Whether a layout feels sounds, too. New ones do not.
    void set_hears(std::size_t layout, bool hears) { outputs_[layout].hears = hears; }
    /// Strengths of the sounds in the next frame, 0 to 1; all 0 for none.
    void set_sound(const BandStrengths& strengths) { sound_ = strengths; }

    /// Makes the frames of the eight ticks that have passed. In a pause, and after a jump of the clock, all is still.
    void take(const Simulation& match);
    const tactile::TactileFrame& frame(std::size_t layout) const { return outputs_[layout].frame; }
    /// What was felt anew or lasted in the last frame, for words on it.
    std::span<const BodyCue> cues() const { return cues_; }
    const tactile::MixerCounts& counts(std::size_t layout) const { return outputs_[layout].mixer->counts(); }

private:
    void feel(const BodyCue& cue, Tick now);
    void feel(const EffectNumber& effect, BodyCue cue, Tick now);
    void feel_events(const Simulation& match);
    void feel_event(const Simulation& match, const Event& event);
    void feel_sound(Tick now);
    void feel_own(const Simulation& match);
    void feel_foes_work(const Simulation& match);
    void follow_arm(const Simulation& match, bool anew);
    void feel_steps(const Simulation& match, ecs::Entity wizard);

    const MatchEffects& effects_;
    const tactile::EffectBank& bank_;
    std::uint32_t player_;
    /// One layout with its mixer.
    struct Output {
        std::unique_ptr<tactile::TactileMixer> mixer;
        tactile::TactileFrame frame{};
        bool used = true;
        bool hears{};
        bool has_arms{};  ///< some actuator sits on an arm or a shoulder
    };
    std::vector<Output> outputs_;
    std::vector<BodyCue> cues_{};  ///< of the last frame; never grows
    BandStrengths sound_{};
    std::array<bool, felt_bands> sounding_{};  ///< bands that play
    Tick quiet_until_{};                       ///< Simulation::now from which sounds are felt again
    bool any_arms_{};
    double raised_{};  ///< angle of the wand's arm in the mixers, from hanging down forwards (rad)

    // The match at the last frame.
    MatchFollower follower_{};
    std::uint32_t fired_{};
    Stride stride_{};
    bool left_foot_{};
};

}  // namespace thaum::game
