// Focus: the wizard gains focus (what spells cost) at once, up to the cap. Does nothing in a match without
// spells.
#include <algorithm>

#include "game/components/casting.h"
#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class GivenFocus final : public Effect {
public:
    explicit GivenFocus(const ConfigTable& entry) : points_(entry.number("points", {0, 1e6})) {}

    void begin(const EffectUse& use) const override {
        const double gained = gain(use);
        if (auto* focus = use.context.world.find<Focus>(use.wizard)) focus->points += gained;
    }
    double gain(const EffectUse& use) const override {
        const auto* focus = std::as_const(use.context.world).find<Focus>(use.wizard);
        if (focus == nullptr || !use.context.data.casting) return 0;
        return std::max(
            0.0, std::min(points_ * use.strength, use.context.data.casting->focus_cap - focus->points));
    }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Focus>(); }

private:
    double points_;  ///< focus that the wizard gains
};

const EffectRegistration registration({.name = "focus", .read = read_effect<GivenFocus>});

}  // namespace
}  // namespace thaum::game::inline effects
