#include "game/data/potion_effect.h"

namespace thaum::game::inline data {

std::vector<std::shared_ptr<const PotionEffect>> read_potion_effects(const ConfigTable& wizard) {
    std::vector<std::shared_ptr<const PotionEffect>> effects;
    for (const auto& kind : potion_effect_kinds())
        if (auto effect = kind.read(wizard)) effects.push_back(std::move(effect));
    return effects;
}

}  // namespace thaum::game::inline data
