// game/data/casting_rules.h: rules for strokes and for the focus that spells cost (assets/casting.toml).
#pragma once
#include "core/config.h"
#include "core/units.h"

namespace thaum::game {

struct CastingRules {
    double focus_cap{};     ///< focus of a new wizard, and its largest value
    double focus_regain{};  ///< focus per second
    /// Viscosity of the space round a hand that draws a stroke. The force of a stroke is this times the hand's speed
    /// (N s/m).
    double viscosity{};
    double stick_reach{};     ///< way of the hand from the middle to a fully pushed stick (m)
    double gentle_below{};    ///< mean force below which a stroke is gentle (N)
    double harsh_from{};      ///< mean force from which on a stroke is harsh (N)
    double harsh_strength{};  ///< strength of a harsh spell, relative to a gentle one
    double harsh_cost{};      ///< focus that a harsh spell costs, relative to a gentle one
    Tick shortest{};          ///< shortest stroke that is read (ticks)
    double smallest{};        ///< least arc length of a stroke that is read (m)
    // Casting without a button.
    double free_least_probability{};  ///< least probability of a gesture that casts
    double free_most_score{};         ///< score of the worst gesture that casts (gesture::Candidate::score)
    Tick free_rest{};                 ///< time for which the hand rests after the gesture (ticks)
    double free_rest_way{};           ///< longest way of a hand that rests (m)
    Tick free_longest{};              ///< longest stroke (ticks)
    Tick free_apart{};                ///< least time between two spells (ticks)
};

CastingRules read_casting_rules(const Config& file);

}  // namespace thaum::game
