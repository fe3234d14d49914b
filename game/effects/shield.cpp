// Shield: harm to the wizard is absorbed for a while, up to an amount. hurt() in game/context/match_context.h
// subtracts that harm.
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Shield final : public Effect {
public:
    explicit Shield(const ConfigTable& entry)
        : absorbs_(entry.number("absorbs_hp", {0, 1e6})), lasts_(ticks(entry.number("lasts_s", {0, 3600}))) {}

    void begin(const EffectUse& use) const override {
        auto& health = use.context.world.get<Health>(use.wizard);
        health.ward = absorbs_ * use.strength;
        health.ward_until = use.tick + lasts_;
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    double absorbs_;  ///< harm that the shield absorbs (HP)
    Tick lasts_;      ///< time after which it is gone (ticks)
};

const EffectRegistration registration({.name = "shield", .worth_taking = true, .read = read_effect<Shield>});

}  // namespace
}  // namespace thaum::game::inline effects
