#include "game/data/potion_effect.h"

#include <algorithm>

namespace thaum::game::inline data {
namespace {

std::vector<PotionEffectKind>& registered_effects() {
    static std::vector<PotionEffectKind>
        all;  // made at the first use, because registrations run in any order
    return all;
}

}  // namespace

PotionEffectRegistration::PotionEffectRegistration(const PotionEffectKind& kind) {
    auto& all = registered_effects();
    // The linker chooses the order of registrations, so the list is sorted to be independent of it.
    all.insert(std::ranges::upper_bound(all, kind.name, {}, &PotionEffectKind::name), kind);
}

const std::vector<PotionEffectKind>& potion_effect_kinds() { return registered_effects(); }

std::vector<std::shared_ptr<const PotionEffect>> read_potion_effects(const ConfigTable& wizard) {
    std::vector<std::shared_ptr<const PotionEffect>> effects;
    for (const auto& kind : potion_effect_kinds())
        if (auto effect = kind.read(wizard)) effects.push_back(std::move(effect));
    return effects;
}

}  // namespace thaum::game::inline data
