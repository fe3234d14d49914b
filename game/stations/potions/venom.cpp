// Venom: a potion that lets the wizard's next lob (a thrown stone that explodes) poison those whom it hits.
#include "game/context/match_context.h"
#include "game/data/potion_effect.h"

namespace thaum::game::inline stations {
namespace {

class VenomEffect final : public PotionEffect {
public:
    VenomEffect(double strength, Tick poisons) : strength_(strength), poisons_(poisons) {}

    void drunk(const PotionUse& use) const override {
        auto& belt = use.context.world.get<WandBelt>(use.wizard);
        belt.venom = strength_;
        belt.venom_until = use.tick + use.lasts;
        belt.venom_lasts = poisons_;
    }
    void lost(const PotionUse& use) const override { use.context.world.get<WandBelt>(use.wizard).venom = 0; }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<WandBelt>(); }

private:
    double strength_;  ///< harm by poison to those whom the lob hits (HP/s)
    Tick poisons_;     ///< duration of the poison (ticks)
};

const PotionEffectRegistration registration({
    .name = "venom",
    .read = [](const ConfigTable& wizard) -> std::shared_ptr<const PotionEffect> {
        const double strength = wizard.number("venom_per_s", {0, 1e3}, 0);
        const Tick poisons = ticks(wizard.number("venom_s", {0, 3600}, 0));
        return strength > 0 ? std::make_shared<VenomEffect>(strength, poisons) : nullptr;
    },
});

}  // namespace
}  // namespace thaum::game::inline stations
