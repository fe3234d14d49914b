// game/components/effects.h: effects that act on a wizard for a time, whoever gave them: potions, spells,
// power-ups, the orb or a crystal.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

/// Most effects that the data files of a match may list, all lists together.
inline constexpr std::size_t max_effects = 64;

/// Effects that act on a wizard, by their numbers (ListedEffect::number). Some effects keep more of their
/// state elsewhere, such as Health::ward.
struct Effects {
    /// Time at which each effect stops acting (ticks of play); 0: it does not act
    std::array<Tick, max_effects> until{};
    /// How strongly each effect acts (EffectUse::strength); 0: it does not act
    std::array<double, max_effects> strength{};
    THAUM_COMPONENT(Effects, until, strength);
    bool operator==(const Effects&) const = default;
};

}  // namespace thaum::game::inline components
