// game/match/rules.h: the numbers of a match, each from a data file (assets/rules, assets/wizards).
#pragma once
#include <array>
#include <string>

#include "core/config.h"
#include "core/units.h"
#include "game/components/power_up.h"
#include "physics/mover.h"

namespace thaum::game {

/// How long a match is: assets/rules/quick.toml, standard.toml.
struct RoundRules {
    std::int32_t kills{};    ///< to win the round
    Tick length{};           ///< ticks of a round
    std::uint32_t rounds{};  ///< at most; the match is won by more than half of them
    Tick interval{};         ///< ticks until the next round begins by itself
    Tick respawn{};          ///< ticks from death to resurrection
    Tick spawn_shield{};     ///< ticks
};

struct PowerUpRules {
    double health{};        ///< HP it gives
    double energy_share{};  ///< of the emptiest wand's cap
    Tick again{};           ///< ticks until it is back
    double radius{};        ///< m, on the ground
};

/// What is fought by: assets/rules/thaum.toml, classic.toml.
struct RuleSet {
    bool energy_regain = true;  ///< wands regain energy by themselves, as their files say
    bool spawn_shield = true;
    bool cauldron = true;  ///< the arena's bowl holds a brew
    std::array<PowerUpRules, power_up_names.size()> power_ups{};
};

struct WizardRules {
    double mass{}, radius{}, height{}, eye{};  ///< kg, m
    physics::MoverSettings walk{};
    double health{}, health_cap{}, excess_loss{};                ///< HP, HP, HP/s
    double fall_safe{}, fall_damage{};                           ///< m/s, HP per m/s
    double object_safe{}, object_damage{}, object_damage_max{};  ///< N s, HP per N s, HP
    Tick object_again{};
    Tick blame{};          ///< ticks for which a fall, or a thing set going, is still the foe's deed
    double pitch_limit{};  ///< rad
};

/// How the wand's tip feels what it touches, for a device that can do it.
struct ProbeRules {
    double stiffness{};           ///< N/m at the device, at most what it can; 0: nothing is felt
    double damping{};             ///< N s/m, likewise
    double static_friction{};     ///< per unit of the thing's own
    double dynamic_friction{};    ///< likewise
    double newtons_per_newton{};  ///< of the hand, for one on the thing; 0: things are not pushed
};

/// What hands hold and feel: assets/haptics.toml.
struct TouchRules {
    std::string device;               ///< a model in assets/devices
    double share{};                   ///< of its peak force, at most
    double wand_per_hand{};           ///< m of the wand's tip for a metre of the hand, in a usual workspace
    std::int32_t clutch_per_count{};  ///< um of the hand for a count of the mouse
    std::int32_t clutch_per_tick{};   ///< um of the hand in a tick, with a stick fully pushed
    ProbeRules probe{};
};

RoundRules read_round_rules(const Config& file);
RuleSet read_rule_set(const Config& file);
WizardRules read_wizard_rules(const Config& file);
TouchRules read_touch_rules(const Config& file);

}  // namespace thaum::game
