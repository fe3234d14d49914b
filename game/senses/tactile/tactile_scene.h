// game/senses/tactile/tactile_scene.h: what one player feels on the body during a match. It reads a
// Simulation every eighth tick and starts effects on every layout that the player has: the picture of a
// jacket, a pad, a recorder. The match is never changed, and equal matches give equal frames. Actuators on
// the right arm move with the wand.
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

namespace thaum::game::inline senses {

/// An effect that starts, or that lasts while its key is repeated.
struct BodyCue {
    std::uint32_t effect{};
    tactile::Where where{};
    double strength{1};
    std::uint32_t key{};  ///< key of a lasting effect; 0: the effect starts and plays to its end
    /// Event that caused the effect; EventKind::none: it comes from the state of the match.
    EventKind event{};
};

/// Strengths of effects for the body's figure in the view. It leaves out the recoil of the player's own
/// shots, since that would cover the other effects.
tactile::Faders figure_faders();

/// Time since any cell of the body's figure in a view was last active, which was at tick `felt_at` (s). Very
/// long if `felt_at` is 0 (never).
double since_felt_s(Tick now, Tick felt_at);

class TactileScene {
public:
    /// Keeps references to `effects` and `bank`, which must outlive the scene.
    TactileScene(const MatchEffects& effects, const tactile::EffectBank& bank, std::uint32_t player);

    /// Adds a layout (the places of an output's motors) and returns its index, for frame() and the setters.
    /// Keeps a reference to the layout.
    std::size_t add(const tactile::Layout& layout);
    /// Switches a layout (the motors of one output) on or off. While it is off, it costs nothing and its
    /// frames are silent. New layouts are on.
    void set_used(std::size_t layout, bool used);
    void set_faders(std::size_t layout, const tactile::Faders& faders);

    /// Sets whether a layout (the motors of one output) also plays sounds. New layouts do not.
    void set_hears(std::size_t layout, bool hears) { outputs_[layout].hears = hears; }
    /// Sets how strongly sounds are felt in the next frame, for each frequency band, 0 to 1; all 0: not at
    /// all.
    void set_sound(const BandStrengths& strengths) { sound_ = strengths; }

    /// Makes the frames (strengths of all motors) of the last eight ticks. In a pause and after a jump of the
    /// clock they are silent.
    void take(const Simulation& match);
    const tactile::TactileFrame& frame(std::size_t layout) const { return outputs_[layout].frame; }
    /// Effects that started or lasted in the last frame, for captions.
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
    /// One layout (the motors of one output) with its mixer.
    struct Output {
        std::unique_ptr<tactile::TactileMixer> mixer;
        tactile::TactileFrame frame{};
        bool used = true;
        bool hears{};
        bool has_arms{};  ///< true: some actuators are on an arm or a shoulder
    };
    std::vector<Output> outputs_;
    std::vector<BodyCue> cues_{};  ///< effects that started or lasted in the last frame; the memory is
                                   ///< allocated once
    BandStrengths sound_{};
    std::array<bool, felt_bands> sounding_{};  ///< frequency bands of sound that are being felt
    Tick quiet_until_{};  ///< value of Simulation::now from which on sounds are felt again
    bool any_arms_{};
    /// Angle of the arm that holds the wand, as last passed to the mixers, counted forwards from hanging down
    /// (rad)
    double raised_{};

    // State of the match at the last frame, by which jumps of its clock are noticed.
    MatchFollower follower_{};
    std::uint32_t fired_{};
    Stride stride_{};
    bool left_foot_{};
};

}  // namespace thaum::game::inline senses
