// Regen: the wizard gains health for a while, up to that of a new wizard.
#include <algorithm>

#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class Regen final : public Effect {
public:
    explicit Regen(const ConfigTable& entry) : rate_(entry.number("points_per_s", {0, 1e4})) {}

    void step(const EffectUse& use) const override {
        auto& health = use.context.world.get<Health>(use.wizard);
        auto& points = health.points;
        if (points <= 0) return;  // the wizard is about to die in this tick
        const double more = points + rate_ * use.strength * gameplay_dt;
        points = std::max(points, std::min(more, full_health(use.context.data.wizard, health)));
    }
    double worth(const BotNeeds& needs) const override { return needs.health; }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    double rate_;  ///< health that the wizard gains (HP/s)
};

const EffectRegistration registration({.name = "regen", .lasts = true, .read = read_effect<Regen>});

}  // namespace
}  // namespace thaum::game::inline effects
