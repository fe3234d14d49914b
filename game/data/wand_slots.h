// game/data/wand_slots.h: the wands of a match by their slots, and the wand that a wizard has in hand.
#pragma once
#include "game/components/wizard.h"
#include "game/data/match_data.h"

namespace thaum::game::inline data {

/// The wand in a slot; null if the slot is empty.
const LoadedWand* wand_in_slot(const MatchData& data, std::uint32_t slot);

/// Whether no wand before this one in `data.wands` has its kind. The states of a kind in a wizard's hand are
/// shared by all wands of the kind.
bool is_first_of_kind(const MatchData& data, const LoadedWand& wand);

/// The next slot that holds a wand. A `step` of 1 searches forwards, wand_slots - 1 backwards.
std::uint32_t next_slot(const MatchData& data, std::uint32_t from, std::uint32_t step);

/// The wand in hand; null if the selected slot is empty.
const LoadedWand* wand_in_hand(const MatchData& data, const WandBelt& belt);

/// Energy of the wand in hand; 0 if the selected slot is empty.
double energy_in_hand(const MatchData& data, const WandBelt& belt);

/// A new wizard's wands: all have full energy, and the first one is selected.
WandBelt full_belt(const MatchData& data);

}  // namespace thaum::game::inline data
