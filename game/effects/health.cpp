// Health: the wizard gains health at once, up to the cap. Above the health of a new wizard it falls again.
#include <algorithm>
#include <cmath>

#include "game/context/match_context.h"
#include "game/data/effect.h"

namespace thaum::game::inline effects {
namespace {

class GivenHealth final : public Effect {
public:
    explicit GivenHealth(const ConfigTable& entry) : points_(entry.number("points", {0, 1e6})) {}

    void begin(const EffectUse& use) const override {
        const double gained = gain(use);
        use.context.world.get<Health>(use.wizard).points += gained;
    }
    double gain(const EffectUse& use) const override {
        const auto& health = std::as_const(use.context.world).get<Health>(use.wizard);
        if (health.points <= 0) return 0;  // the wizard is about to die in this tick
        const double room = largest_health(use.context.data.wizard, health) - health.points;
        return std::max(0.0, std::min(points_ * use.strength, room));
    }
    double worth(const BotNeeds& needs) const override { return needs.health * std::sqrt(points_ / usual); }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    static constexpr double usual = 25;  ///< points that are worth 1 to a bot without health

    double points_;  ///< health that the wizard gains (HP)
};

const EffectRegistration registration({.name = "health", .read = read_effect<GivenHealth>});

}  // namespace
}  // namespace thaum::game::inline effects
