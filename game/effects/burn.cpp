// Burn: the wizard loses health once a second, as by the poison of a lob. It is the price of something good.
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Burn final : public Effect {
public:
    explicit Burn(const ConfigTable& entry)
        : harm_(entry.number("harm_per_s", {0, 1e3})), lasts_(ticks(entry.number("lasts_s", {0.01, 3600}))) {}

    void begin(const EffectUse& use) const override {
        auto& health = use.context.world.get<Health>(use.wizard);
        health.poison = harm_ * use.strength;
        health.poisoned_until = use.tick + lasts_;
        health.poisoned_by = std::as_const(use.context.world).get<Wizard>(use.wizard).player;
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    double harm_;  ///< harm to the wizard (HP/s)
    Tick lasts_;   ///< time for which it hurts (ticks)
};

const EffectRegistration registration({.name = "burn", .read = read_effect<Burn>});

}  // namespace
}  // namespace thaum::game::inline effects
