// Energy: the wizard's emptiest wand is refilled by a share of its cap, at once.
#include <algorithm>
#include <limits>

#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

/// The wand whose energy is the smallest share of its cap; null if no wand has a cap.
const LoadedWand* emptiest_wand(const MatchData& data, const WandBelt& belt) {
    const LoadedWand* found = nullptr;
    double least = std::numeric_limits<double>::max();
    for (const auto& wand : data.wands) {
        if (wand.stats.energy_cap <= 0) continue;
        const double share = belt.energy[wand.stats.energy_slot] / wand.stats.energy_cap;
        if (share < least) found = &wand, least = share;
    }
    return found;
}

class GivenEnergy final : public Effect {
public:
    explicit GivenEnergy(const ConfigTable& entry) : share_(entry.number("share", {0, 1})) {}

    void begin(const EffectUse& use) const override {
        auto& belt = use.context.world.get<WandBelt>(use.wizard);
        if (const auto* wand = emptiest_wand(use.context.data, belt))
            belt.energy[wand->stats.energy_slot] += gain_for(*wand, belt, use.strength);
    }
    double gain(const EffectUse& use) const override {
        const auto& belt = std::as_const(use.context.world).get<WandBelt>(use.wizard);
        const auto* wand = emptiest_wand(use.context.data, belt);
        return wand == nullptr ? 0 : gain_for(*wand, belt, use.strength);
    }
    double worth(const BotNeeds& needs) const override { return needs.energy * share_ * 2; }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<WandBelt>(); }

private:
    double gain_for(const LoadedWand& wand, const WandBelt& belt, double strength) const {
        const auto& stats = wand.stats;
        return std::max(0.0, std::min(share_ * strength * stats.energy_cap,
                                      stats.energy_cap - belt.energy[stats.energy_slot]));
    }

    double share_;  ///< energy that the wand gains, as a share of its cap
};

const EffectRegistration registration({.name = "energy", .read = read_effect<GivenEnergy>});

}  // namespace
}  // namespace thaum::game::inline effects
