// Work half: one of the two halves of the Great Work, which win a round if held together. The wizard holds it
// until death. The other half is the lens.
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class HalfOfWork final : public Effect {
public:
    explicit HalfOfWork(const ConfigTable&) {}

    void begin(const EffectUse& use) const override {
        auto* half = use.context.world.find<WorkHalf>(use.wizard);
        if (half == nullptr) return;
        half->held = 1;
        const auto player = std::as_const(use.context.world).get<Wizard>(use.wizard).player;
        record(use.context, {.tick = use.tick,
                             .kind = EventKind::work_half,
                             .subject = player,
                             .by = player,
                             .place = use.place});
    }
    void lost(const EffectUse& use) const override {
        const auto& world = std::as_const(use.context.world);
        const auto* half = world.find<WorkHalf>(use.wizard);
        if (half == nullptr || half->held == 0) return;
        use.context.world.get<WorkHalf>(use.wizard).held = 0;
        record(use.context, {.tick = use.tick,
                             .kind = EventKind::work_lost,
                             .subject = world.get<Wizard>(use.wizard).player,
                             .place = use.place});
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<WorkHalf>(); }
};

const EffectRegistration registration({.name = "work_half",
                                       .worth_taking = true,
                                       .read = read_effect<HalfOfWork>});

}  // namespace
}  // namespace thaum::game::inline effects
