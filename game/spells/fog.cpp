// Fog: a cloud around a point ahead of its wizard, through which no one can see. game/context/fog.h computes
// what a cloud hides from bots and aim assist.
#include <algorithm>
#include <cmath>

#include "game/components/fog.h"
#include "game/context/match_context.h"
#include "game/data/spell.h"

namespace thaum::game::inline spells {
namespace {

constexpr double badly_hurt = 0.35;  ///< share of health below which a bot hides in fog

class FogSpell final : public SpellRules {
public:
    explicit FogSpell(const ConfigTable& root)
        : radius_(root.number("radius_m", {0.1, 100})),
          ahead_(root.number("ahead_m", {0, 100})),
          sight_(root.number("sight_m", {0.1, 100})),
          lasts_(root.number("lasts_s", {0, 3600})) {}

    /// The ground that the cloud covers and its duration are proportional to the strength of the spell (1 for
    /// a gentle stroke), so the radius is proportional to the square root.
    void cast(const SpellCast& cast) const override {
        auto& world = cast.context.world;
        const auto& const_world = std::as_const(world);
        Motion motion;
        motion.position = const_world.get<Motion>(cast.wizard).position +
                          rotation({0, 1, 0}, const_world.get<Gaze>(cast.wizard).yaw) * vec3(0, 0, -ahead_);
        world.commands().create(Fog{.radius = radius_ * std::sqrt(cast.strength),
                                    .sight = sight_,
                                    .began = cast.tick,
                                    .until = cast.tick + std::max<Tick>(1, ticks(lasts_ * cast.strength)),
                                    .player = const_world.get<Wizard>(cast.wizard).player},
                                motion);
    }
    double worth(const SpellOccasion& occasion) const override {
        const bool wanted = occasion.sees_foe && occasion.under_fire && occasion.health < badly_hurt &&
                            occasion.foe_distance > radius_ + ahead_;
        return wanted ? 0.6 : 0;
    }
    ecs::Mask reads(const ecs::World& world) const override { return world.mask<Wizard, Motion, Gaze>(); }
    ecs::Mask writes(const ecs::World&) const override { return {}; }
    void add_systems(const SpellSystems& to) const override {
        auto& world = to.context.world;
        to.schedule.add({.name = "fog",
                         .period = gameplay_period,
                         .reads = world.mask<Fog>(),
                         .needs = world.mask<Fog>(),
                         .run = [](ecs::World& w, Tick tick) {
                             w.view<const Fog>().each([&](ecs::Entity e, const Fog& fog) {
                                 if (tick >= fog.until) w.commands().destroy(e);
                             });
                         }});
    }

private:
    double radius_{};  ///< radius of the cloud of a gentle stroke (m)
    double ahead_{};   ///< distance of the cloud's middle from the wizard (m)
    double sight_{};   ///< length of a line of sight through the cloud beyond which nothing is seen (m)
    double lasts_{};   ///< duration of the cloud of a gentle stroke (s)
};

const SpellRegistration registration({
    .name = "fog",
    .declare = declare_all<>,
    .read = read_rules<SpellRules, FogSpell>,
});

}  // namespace
}  // namespace thaum::game::inline spells
