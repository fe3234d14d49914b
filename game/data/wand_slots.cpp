#include "game/data/wand_slots.h"

#include <algorithm>

namespace thaum::game::inline data {

const LoadedWand* wand_in_slot(const MatchData& data, std::uint32_t slot) {
    const auto found = std::find_if(data.wands.begin(), data.wands.end(),
                                    [&](const auto& w) { return w.stats.slot == slot; });
    return found == data.wands.end() ? nullptr : &*found;
}

bool is_first_of_kind(const MatchData& data, const LoadedWand& wand) {
    return &*std::ranges::find(data.wands, wand.kind, &LoadedWand::kind) == &wand;
}

std::uint32_t next_slot(const MatchData& data, std::uint32_t from, std::uint32_t step) {
    auto slot = from;
    for (std::size_t i = 0; i < wand_slots; ++i) {
        slot = static_cast<std::uint32_t>((slot + step) % wand_slots);
        if (wand_in_slot(data, slot) != nullptr) return slot;
    }
    return from;
}

const LoadedWand* wand_in_hand(const MatchData& data, const WandBelt& belt) {
    return wand_in_slot(data, belt.selected);
}

double energy_in_hand(const MatchData& data, const WandBelt& belt) {
    const auto* wand = wand_in_hand(data, belt);
    return wand == nullptr ? 0 : belt.energy[wand->stats.energy_slot];
}

WandBelt full_belt(const MatchData& data) {
    WandBelt belt;
    for (const auto& wand : data.wands) belt.energy[wand.stats.energy_slot] = wand.stats.energy_cap;
    belt.selected = next_slot(data, wand_slots - 1, 1);
    return belt;
}

}  // namespace thaum::game::inline data
