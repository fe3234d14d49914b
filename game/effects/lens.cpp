// Lens: the wizard's blasts are stronger and pierce shields (game/wands/blast.cpp), and the wizard holds one
// of the two halves of the Great Work, until death. The other one is the work half.
#include "game/components/crystal.h"
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class GivenLens final : public Effect {
public:
    explicit GivenLens(const ConfigTable&) {}

    void begin(const EffectUse& use) const override {
        auto* lens = use.context.world.find<Lens>(use.wizard);
        if (lens == nullptr) return;
        lens->held = 1;
        const auto player = std::as_const(use.context.world).get<Wizard>(use.wizard).player;
        record(
            use.context,
            {.tick = use.tick, .kind = EventKind::lens, .subject = player, .by = player, .place = use.place});
    }
    void lost(const EffectUse& use) const override {
        const auto& world = std::as_const(use.context.world);
        const auto* lens = world.find<Lens>(use.wizard);
        if (lens == nullptr || lens->held == 0) return;
        use.context.world.get<Lens>(use.wizard).held = 0;
        record(use.context, {.tick = use.tick,
                             .kind = EventKind::lens_lost,
                             .subject = world.get<Wizard>(use.wizard).player,
                             .place = use.place});
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Lens>(); }
};

const EffectRegistration registration({.name = "lens", .worth_taking = true, .read = read_effect<GivenLens>});

}  // namespace
}  // namespace thaum::game::inline effects
