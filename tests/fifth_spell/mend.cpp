// Mend: a spell of the tests. It gives its wizard health over a while, never beyond that of a new wizard.
#include <algorithm>

#include "game/context/match_context.h"
#include "game/data/spell.h"

namespace thaum::game {
namespace {

/// Health that a wizard is still to get.
struct Mending {
    double left{};  ///< health still to be given (HP)
    double rate{};  ///< health given in a gameplay tick (HP)
    THAUM_COMPONENT(Mending, left, rate);
};

class MendSpell final : public SpellRules {
public:
    explicit MendSpell(const ConfigTable& root)
        : gives_(root.number("gives_hp", {0, 1000})), lasts_(root.number("lasts_s", {0.01, 60})) {}

    std::string_view refusal(const MatchContext& context, ecs::Entity wizard) const override {
        const bool whole = context.world.get<Health>(wizard).points >= context.data.wizard.health;
        return whole ? "nothing to mend" : "";
    }
    void cast(const SpellCast& cast) const override {
        const double gives = gives_ * cast.strength;
        const Mending mending{gives, gives / lasts_ * gameplay_dt};
        auto& world = cast.context.world;
        if (auto* before = world.find<Mending>(cast.wizard))
            *before = mending;
        else
            world.commands().add(cast.wizard, mending);
    }
    ecs::Mask reads(const ecs::World& world) const override { return world.mask<Health>(); }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Mending>(); }
    double worth(const SpellOccasion& occasion) const override { return occasion.health < 0.7 ? 1 : 0; }
    void add_systems(const SpellSystems& to) const override {
        auto& world = to.context.world;
        to.schedule.add(
            {.name = "mending",
             .period = gameplay_period,
             .reads = world.mask<Dead>(),
             .writes = world.mask<Mending, Health>(),
             .needs = world.mask<Mending>(),
             .run = [most = to.context.data.wizard.health](ecs::World& w, Tick) {
                 w.view<Mending, Health>().each([&](ecs::Entity e, Mending& mending, Health& health) {
                     const double step = std::min(mending.left, mending.rate);
                     mending.left -= step;
                     if (!w.has<Dead>(e))
                         health.points = std::max(health.points, std::min(most, health.points + step));
                     if (mending.left <= 0 || w.has<Dead>(e)) w.commands().remove<Mending>(e);
                 });
             }});
    }

private:
    double gives_{};  ///< health that a gentle stroke gives (HP)
    double lasts_{};  ///< time over which a stroke gives its health (s)
};

const SpellRegistration registration({
    .name = "mend",
    .declare = declare_all<Mending>,
    .read = read_rules<SpellRules, MendSpell>,
});

}  // namespace
}  // namespace thaum::game
