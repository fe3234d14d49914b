// game/senses/tactile/match_effects.h: the effects on the body named in the rows of events, and those that
// the state of a match causes, looked up once in the bank of effects.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "game/data/presentation.h"
#include "game/senses/tactile/felt_sound.h"
#include "tactile/effect.h"

namespace thaum::game::inline senses {

/// Number of an effect in the bank of all loaded effects; std::nullopt: nothing is felt.
using EffectNumber = std::optional<std::uint32_t>;

struct MatchEffects {
    std::vector<EffectNumber> events;  ///< effects of events, indexed by EventKind; not those of spells
    std::vector<EffectNumber> spells;  ///< effects of spells, indexed by the spell's number
    EffectNumber recoil, stir, heartbeat, great_work, walk_left, walk_right;
    std::array<EffectNumber, felt_bands> sounds{};  ///< effects by which sounds are felt: one for each
                                                    ///< frequency band, the lowest first
    /// Effects that are missing among the loaded ones (the bank). Effects with a fault are not listed: the
    /// bank reports those.
    std::vector<MissingName> missing{};
};

/// Looks up all effects. A missing or faulty effect is not felt, and does not affect the others.
MatchEffects match_effects(const tactile::EffectBank& bank, const Presentation& shown);

}  // namespace thaum::game::inline senses
