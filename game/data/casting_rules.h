// game/data/casting_rules.h: rules for strokes and for the focus that spells cost (assets/casting.toml).
#pragma once
#include <string_view>

#include "core/config.h"
#include "core/units.h"

namespace thaum::game::inline data {

struct CastingRules {
    double focus_cap{};     ///< largest amount of focus, which spells cost; a new wizard has it
    double focus_regain{};  ///< focus (what spells cost) that a wizard regains (1/s)
    /// Viscosity of the field in which a hand draws a stroke (N s/m). The force of a stroke is this viscosity
    /// times the hand's speed.
    double viscosity{};
    /// distance of the simulated hand from its rest position with the stick fully pushed (m)
    double stick_reach{};
    double gentle_below{};    ///< mean force below which a stroke is gentle (N)
    double harsh_from{};      ///< mean force at or above which a stroke is harsh (N)
    double harsh_strength{};  ///< strength of a harsh (forcefully drawn) spell, relative to a gentle one
    double harsh_cost{};      ///< focus that a harsh (forcefully drawn) spell costs, relative to a gentle one
    Tick shortest{};          ///< duration below which a stroke is not read (ticks)
    double smallest{};        ///< arc length below which a stroke is not read (m)
    // Rules of casting without a button, in which a gesture ends where the hand comes to rest.
    Tick free_rest{};        ///< time for which the hand must rest after the gesture (ticks)
    double free_rest_way{};  ///< radius within which a hand counts as resting (m)
    Tick free_pause{};       ///< duration from which on a rest is too long to be part of a gesture (ticks)
    /// probability with which a gesture must be recognised in order to cast its spell, 0 to 1
    double free_least_probability{};
    double free_quiet_probability{};  ///< probability that suffices instead if the hand was slow before the
                                      ///< gesture, 0 to 1
    /// Speed of the hand before a gesture, as a multiple of the speed in the gesture, below which the hand
    /// was slow.
    double free_quiet_pace{};
    /// Limit of the speed of the hand just before a part of its motion (a window) that is tried as a gesture,
    /// as a multiple of the speed in the window. Above this limit no gesture begins there, because the hand
    /// was already moving.
    double free_most_pace{};
    /// Arc length below which a closed gesture, such as a circle, must reach free_least_probability even if
    /// the hand was slow before it (m). Small loops are often drawn by accident.
    double free_loop{};
    double free_stop{};  ///< duration of a pause within a gesture from which on the gesture may be two
                         ///< movements (s)
    /// Share of a gesture's duration that a pause in it must also reach, besides the time free_stop, to make
    /// the gesture two movements.
    double free_stop_share{};
    /// Probability from which on the player is told of a gesture that almost cast a spell, 0 to 1.
    double free_near_probability{};
    double free_smallest{};  ///< minimum width or height of a gesture, whichever is larger (m)
    double free_shortest{};  ///< minimum duration of a gesture (s)
    Tick free_apart{};       ///< minimum time between two spells (ticks)
};

CastingRules read_casting_rules(const Config& file);

/// Word for the force of a stroke: "gentle", "normal" or "harsh".
std::string_view force_word(const CastingRules& rules, double force);

}  // namespace thaum::game::inline data
