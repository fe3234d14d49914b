// Venom: the wizard's next lob (a thrown stone that explodes) poisons those whom it hits. It must be thrown
// while the effect acts.
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Venom final : public Effect {
public:
    explicit Venom(const ConfigTable& entry)
        : harm_(entry.number("harm_per_s", {0, 1e3})),
          poisons_(ticks(entry.number("poisons_s", {0.01, 3600}))) {}

    void begin(const EffectUse& use) const override {
        auto& belt = use.context.world.get<WandBelt>(use.wizard);
        belt.venom = harm_ * use.strength;
        belt.venom_until = use.tick + use.lasts;
        belt.venom_lasts = poisons_;
    }
    void lost(const EffectUse& use) const override { use.context.world.get<WandBelt>(use.wizard).venom = 0; }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<WandBelt>(); }

private:
    double harm_;   ///< harm by poison to those whom the lob hits (HP/s)
    Tick poisons_;  ///< duration of the poison (ticks)
};

const EffectRegistration registration({.name = "venom", .lasts = true, .read = read_effect<Venom>});

}  // namespace
}  // namespace thaum::game::inline effects
