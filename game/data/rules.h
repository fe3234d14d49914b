// game/data/rules.h: rules of rounds, wizards and hands, read from data files (assets/rules, assets/wizards,
// assets/haptics.toml).
#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "game/components/match.h"
#include "game/components/power_up.h"
#include "game/components/wizard.h"
#include "game/data/effect.h"
#include "physics/mover.h"

namespace thaum::game::inline data {

/// A part of a round in which the players' blows do more harm, the mana surge.
struct Surge {
    Tick after{};      ///< ticks from the beginning of the round to that of the surge
    double factor{1};  ///< factor on the harm that players do to each other
};

/// Time that a round is prolonged by if its kills are equal at the end. The next death decides it.
struct BoilOverRules {
    Tick length{};  ///< longest time (ticks); 0: such a round is a draw at once
    /// Health of both wizards at the beginning, and their largest health meanwhile (HP); at most that of a
    /// new wizard
    double health{};
};

/// Kinds of event that are recorded for both players: a mana surge begins or ends (amount: its factor), and
/// the Boil-over begins (amount: its longest time in s). They are registered beside the rules, so that every
/// program that reads the rules can read how the events are shown.
EventKind surge_event();
EventKind tied_event();

/// Rules of rounds, which give a match its length: from assets/rules/quick.toml, standard.toml or another
/// file there.
struct RoundRules {
    std::int32_t kills{};         ///< number of kills that win the round
    Tick length{};                ///< length of a round (ticks)
    std::uint32_t rounds{};       ///< largest number of rounds; more than half of them win the match
    Tick interval{};              ///< ticks from the end of a round until the next one begins by itself
    Tick respawn{};               ///< ticks from death until the wizard returns to life
    Tick spawn_shield{};          ///< ticks without harm after returning to life
    std::vector<Surge> surges{};  ///< sorted by time; each lasts until the next one, or the end of the round
    BoilOverRules boil_over{};
};

/// Factor on the harm that players do to each other, `age` ticks after the beginning of a round.
double surge_at(const RoundRules& rules, Tick age);
/// Tick of play at which the present round ends at the latest.
Tick round_ends_at(const RoundRules& rules, const Match& match);

struct PowerUpRules {
    EffectList effects{};  ///< what the power-up does to the wizard who picks it up
    Tick again{};          ///< ticks after it was picked up until the power-up is available again
    double radius{};       ///< radius within which the power-up is picked up (m, on the ground)
};

/// Parts of the game that a rule set switches on or off, from assets/rules/thaum.toml or classic.toml.
struct RuleSet {
    bool energy_regain = true;  ///< true: wands regain energy by themselves, at the rates in their files
    bool spawn_shield = true;
    bool aim_assist = true;  ///< true: players may have aim assist (game/context/aim_assist.h)
    bool cauldron = true;    ///< true: a bowl in the arena holds a brew
    bool spells = true;      ///< true: strokes cast spells
    bool surges = true;      ///< true: rounds have mana surges and a Boil-over
    std::array<PowerUpRules, power_up_names.size()> power_ups{};
};

struct WizardRules {
    /// Downward acceleration of wizards, things and missiles in flight (m/s^2).
    double gravity{};
    /// Mass (kg); radius, height, and height of the eye above the feet (m)
    double mass{}, radius{}, height{}, eye{};
    physics::MoverSettings walk{};
    /// `loose`: ticks for which the feet slip after a push. `loose_grip`: share of ground friction that is
    /// left meanwhile.
    Tick loose{};
    double loose_grip{};
    /// Initial health (HP), largest health (HP), and loss rate of health above the initial value (HP/s).
    double health{}, health_cap{}, excess_loss{};
    /// Largest landing speed without harm (m/s), and harm per speed above it (HP per m/s).
    double fall_safe{}, fall_damage{};
    /// Largest impulse without harm (N s), harm per impulse above it (HP per N s), largest harm (HP).
    double object_safe{}, object_damage{}, max_object_damage{};
    /// Ticks after the beginning of a blow in which the same thing cannot hurt again.
    Tick object_again{};
    /// Ticks for which a player is credited with harm to the other wizard: with a fall after that player has
    /// hurt or pushed the wizard, and with a blow by a thing after that player has moved the thing.
    Tick blame{};
    double pitch_limit{};  ///< largest angle of view above or below the horizon (rad)
};

/// Health of a wizard who is well, above which health falls back, and largest health (HP).
inline double full_health(const WizardRules& rules, const Health& health) {
    return std::min(rules.health, health.limit);
}
inline double largest_health(const WizardRules& rules, const Health& health) {
    return std::min(rules.health_cap, health.limit);
}

/// Contact of the wand's tip with surfaces, as felt at the device.
struct ProbeRules {
    /// Stiffness at the device (N/m), limited to what the device can render; 0: contacts are not felt.
    double stiffness{};
    double damping{};           ///< damping at the device (N s/m), limited to what the device can render
    double static_friction{};   ///< static friction as a multiple of the body's own friction
    double dynamic_friction{};  ///< dynamic friction as a multiple of the body's own friction
    /// Force felt by the hand per force with which the wand's tip pushes a thing (N/N); 0: things are not
    /// pushed.
    double newtons_per_newton{};
};

/// Haptic rules of hands, from assets/haptics.toml.
struct HapticRules {
    std::string device;  ///< name of a device file in assets/devices
    double share{};      ///< largest force as a share of the device's peak force
    /// Displacement of the wand's tip per displacement of the hand, for a device whose workspace is 0.16 m
    /// wide; more for a narrower one (m/m).
    double wand_per_hand{};
    /// displacement of the hand per mouse count while the clutch, the key for moving the hand instead of the
    /// view, is held (um)
    std::int32_t clutch_per_count{};
    /// displacement of the hand per tick with a stick fully deflected while the clutch is held, which makes
    /// the stick move the hand (um)
    std::int32_t clutch_per_tick{};
    ProbeRules probe{};
};

RoundRules read_round_rules(const Config& file);
RuleSet read_rule_set(const Config& file);
WizardRules read_wizard_rules(const Config& file);
HapticRules read_haptic_rules(const Config& file);

}  // namespace thaum::game::inline data
