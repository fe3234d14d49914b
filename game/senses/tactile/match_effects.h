// game/senses/tactile/match_effects.h: the effects on the body that events name in their rows, and those that the state of a
// match causes, found in the bank of effects once.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "game/data/presentation.h"
#include "game/senses/tactile/felt_sound.h"
#include "tactile/effect.h"

namespace thaum::game {

/// Number of an effect in the bank; std::nullopt: nothing is felt.
using EffectNumber = std::optional<std::uint32_t>;

struct MatchEffects {
    std::vector<EffectNumber> events;  ///< by EventKind; without those of spells
    std::vector<EffectNumber> spells;  ///< by number of the spell
    EffectNumber recoil, stir, heartbeat, great_work, walk_left, walk_right;
    std::array<EffectNumber, felt_bands> sounds{};  ///< by band, the lowest first
    /// Effects that the bank lacks. Faulty effects are not among them: the bank says why.
    std::vector<MissingName> missing{};
};

/// A missing or faulty effect is not felt, and costs no other one.
MatchEffects match_effects(const tactile::EffectBank& bank, const Presentation& shown);

}  // namespace thaum::game
