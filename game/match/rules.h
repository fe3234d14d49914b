// game/match/rules.h: the numbers of a match, each from a data file (assets/rules, assets/wizards).
#pragma once
#include "core/config.h"
#include "core/units.h"
#include "physics/mover.h"

namespace thaum::game {

struct RoundRules {
    std::int32_t kills{};  ///< to win the round
    Tick length{};         ///< ticks
    Tick respawn{};        ///< ticks from death to resurrection
    Tick spawn_shield{};   ///< ticks
};

struct WizardRules {
    double mass{}, radius{}, height{}, eye{};  ///< kg, m
    physics::MoverSettings walk{};
    double health{}, health_cap{}, excess_loss{};                ///< HP, HP, HP/s
    double fall_safe{}, fall_damage{};                           ///< m/s, HP per m/s
    double object_safe{}, object_damage{}, object_damage_max{};  ///< N s, HP per N s, HP
    Tick object_again{};
    double pitch_limit{};  ///< rad
};

RoundRules read_round_rules(const Config& file);
WizardRules read_wizard_rules(const Config& file);

}  // namespace thaum::game
