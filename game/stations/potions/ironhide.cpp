// Ironhide: a potion after which the wizard takes only a share of every harm.
#include "game/context/match_context.h"
#include "game/data/potion_effect.h"

namespace thaum::game::inline stations {
namespace {

class HardenedEffect final : public PotionEffect {
public:
    explicit HardenedEffect(double share) : share_(share) {}

    void drunk(const PotionUse& use) const override {
        auto& health = use.context.world.get<Health>(use.wizard);
        health.harm_share = share_;
        health.hardened_until = use.tick + use.lasts;
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    double share_;  ///< share of every harm that the wizard still takes
};

const PotionEffectRegistration registration({
    .name = "ironhide",
    .read = [](const ConfigTable& wizard) -> std::shared_ptr<const PotionEffect> {
        const double share = wizard.number("harm", {0, 10}, 1);
        return share != 1 ? std::make_shared<HardenedEffect>(share) : nullptr;
    },
});

}  // namespace
}  // namespace thaum::game::inline stations
