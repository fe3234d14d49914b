// game/data/casting_rules.h: rules for strokes and for the focus that spells cost (assets/casting.toml).
#pragma once
#include "core/config.h"
#include "core/units.h"

namespace thaum::game {

struct CastingRules {
    double focus_cap{};     ///< focus of a new wizard, and its largest value
    double focus_regain{};  ///< focus per second
    /// Viscosity of the space round a hand that draws a stroke (N s/m). The force of a stroke is this times the hand's
    /// speed.
    double viscosity{};
    double stick_reach{};     ///< way of the hand from the middle to a fully pushed stick (m)
    double gentle_below{};    ///< mean force below which a stroke is gentle (N)
    double harsh_from{};      ///< mean force from which on a stroke is harsh (N)
    double harsh_strength{};  ///< strength of a harsh spell, relative to a gentle one
    double harsh_cost{};      ///< focus that a harsh spell costs, relative to a gentle one
    Tick shortest{};          ///< shortest stroke that is read (ticks)
    double smallest{};        ///< least arc length of a stroke that is read (m)
    // Casting without a button.
    Tick free_rest{};                 ///< time for which the hand rests after the gesture (ticks)
    double free_rest_way{};           ///< way from a place within which a hand rests (m)
    Tick free_pause{};                ///< rest that no gesture has (ticks)
    double free_least_probability{};  ///< least probability of a gesture that casts
    double free_quiet_probability{};  ///< the same where the hand was slow before
    /// Pace before a gesture, as a share of its own, below which the hand was slow.
    double free_quiet_pace{};
    double free_most_pace{};   ///< the same from which on it was no beginning
    double free_loop{};        ///< way of a closed gesture below which a quiet start does not suffice (m)
    double free_stop{};        ///< stop within a gesture from which on it may be two movements (s)
    double free_stop_share{};  ///< the same, as a share of the gesture's duration; both must hold
    double free_near_probability{};  ///< least probability of a near miss
    double free_smallest{};          ///< least width or height of a gesture (m)
    double free_shortest{};          ///< shortest gesture (s)
    Tick free_apart{};               ///< least time between two spells (ticks)
};

CastingRules read_casting_rules(const Config& file);

}  // namespace thaum::game
