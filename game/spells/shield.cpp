// The shield absorbs harm to its wizard for a while, up to an amount. hurt() in game/context/match_context.h
// subtracts that harm.
#include "game/context/match_context.h"
#include "game/data/spell.h"

namespace thaum::game::inline spells {
namespace {

/// Share of health below which a bot that is being shot at casts a shield.
constexpr double hurt_below = 0.6;

class ShieldSpell final : public SpellRules {
public:
    explicit ShieldSpell(const ConfigTable& root)
        : absorbs_(root.number("absorbs_hp", {0, 1e6})), lasts_(ticks(root.number("lasts_s", {0, 3600}))) {}

    void cast(const SpellCast& cast) const override {
        auto& health = cast.context.world.get<Health>(cast.wizard);
        health.ward = absorbs_ * cast.strength;
        health.ward_until = cast.tick + lasts_;
    }
    double worth(const SpellOccasion& occasion) const override {
        const bool wanted = occasion.under_fire && !occasion.warded && occasion.health < hurt_below;
        return wanted ? 1 - 0.5 * occasion.health : 0;
    }
    ecs::Mask reads(const ecs::World&) const override { return {}; }
    ecs::Mask writes(const ecs::World& world) const override { return world.mask<Health>(); }

private:
    double absorbs_{};  ///< harm that the shield of a gentle stroke absorbs (HP)
    Tick lasts_{};
};

const SpellRegistration registration({
    .name = "shield",
    .declare = declare_all<>,
    .read = read_rules<SpellRules, ShieldSpell>,
});

}  // namespace
}  // namespace thaum::game::inline spells
