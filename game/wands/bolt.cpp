// The bolt wand: while fire is held, it shoots needles of light at a fixed rate, each in a slightly random
// direction.
//
// A bolt in flight is a point on a straight line. In each physics step, after the bodies have moved, a ray is
// cast along its path. So a bolt cannot pass through anything, however thin, and points of impact are exact.
#include <algorithm>
#include <array>
#include <cmath>

#include "game/components/crystal.h"
#include "game/context/hand_forces.h"
#include "game/context/match_context.h"
#include "game/context/shot.h"
#include "game/context/strikes.h"

namespace thaum::game::inline wands {
namespace {

struct BoltData {
    Tick interval{};  ///< ticks between shots
    double damage{};  ///< harm of a hit (HP)
    double speed{};   ///< speed of a bolt (m/s)
    double spread{};  ///< half the opening angle of the random spread (rad)
    Tick life{};
    double impulse{};  ///< impulse that a hit gives to a body (N s)
    double recoil{};   ///< peak force of the recoil (N)
    Tick recoil_length{};
    EventKind hit{};  ///< kind of event as which the wand's hits are recorded
};

/// A bolt in flight.
struct Bolt {
    vec3 position{};  ///< position of the bolt (m, world)
    vec3 velocity{};  ///< velocity of the bolt (m/s, world)
    Tick dies_at{};
    std::uint32_t player{};
    /// number of the shooter's body in the physics, which the bolt passes through
    std::uint32_t ignores{};
    std::uint32_t slot{};  ///< slot of the wand that shot it
    std::uint32_t spare{};
    THAUM_COMPONENT(Bolt, position, velocity, dies_at, player, ignores, slot, spare);
};

/// State of the bolt wand in a wizard's hand.
struct BoltHand {
    std::array<Tick, wand_slots> next_shot{};  ///< by the slot of the wand
    THAUM_COMPONENT(BoltHand, next_shot);
};

BoltData read(const ConfigTable& root) {
    const auto shot = root.table("shot");
    BoltData data;
    data.hit = hit_kind("bolt_hit");
    data.interval = std::max<Tick>(1, ticks(1 / shot.number("per_s", {0.01, 1000})));
    data.damage = shot.number("damage", {0, 1e6});
    data.speed = shot.number("speed_m_s", {0.1, 1000});
    data.spread = shot.number("spread_deg", {0, 45}) * radians_per_degree;
    data.life = ticks(shot.number("life_s", {0.001, 60}));
    data.impulse = shot.number("impulse_n_s", {0, 1e4});
    const auto recoil = root.table("recoil");
    data.recoil = recoil.number("force_n", {0, 100});
    data.recoil_length = std::max<Tick>(1, ticks(recoil.number("length_s", {0.001, 10})));
    return data;
}

/// Random direction, uniform over a spherical cap with the half angle `spread` around `direction`.
vec3 scattered(vec3 direction, double spread, Random& random) {
    const double radius = det::tan(spread) * std::sqrt(random.uniform());
    const double angle = random.uniform(0, 2 * pi);
    const vec3 side = perpendicular_to(direction);
    const vec3 up = glm::cross(side, direction);
    return glm::normalize(direction + radius * (det::cos(angle) * side + det::sin(angle) * up));
}

void shoot(const WandUse& use, const BoltData& data) {
    auto& world = use.context.world;
    auto muzzle = muzzle_of(use, 0);
    help_aim(use, data.speed, muzzle);
    auto& dice = world.single<Dice>();
    world.commands().create(Bolt{.position = muzzle.tip,
                                 .velocity = scattered(muzzle.aim, data.spread, dice.spread) * data.speed,
                                 .dies_at = use.tick + data.life,
                                 .player = std::as_const(world).get<Wizard>(use.wizard).player,
                                 .ignores = use.wizard.index,
                                 .slot = use.stats.slot});
    note_shot(use, data.hit, muzzle.tip);
    recoil(use.context, use.wizard, data.recoil, data.recoil_length);
}

void fire(const WandUse& use, const BoltData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& next_shot = world.get<BoltHand>(use.wizard).next_shot.at(use.stats.slot);
    if (!holds_fire(controls) || use.tick < next_shot) return;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats, use.stats.energy_cost)) {
        if ((controls.pressed & input::bit(input::Button::fire)) != 0) note_dry(use);
        return;
    }
    // Shots are possible only in gameplay ticks (every eighth). The time of the next shot follows from the
    // time at which the last one was due, not from when it was made, so the rate is exact on average.
    next_shot = std::max(next_shot + data.interval, use.tick + data.interval - gameplay_period + 1);
    shoot(use, data);
}

void hit(MatchContext& context, const Bolt& bolt, const BoltData& data, const physics::RayHit& at,
         Tick tick) {
    const auto victim = context.world.entity(at.key);
    strike(context, at.key, at.point, bolt.velocity, bolt.player);
    context.physics.write().apply_impulse(at.key, glm::normalize(bolt.velocity) * data.impulse, at.point);
    if (victim && context.world.has<Wizard>(victim)) {
        hurt(context, victim, tick,
             {.points = data.damage, .by = bolt.player, .how = data.hit, .place = at.point});
    } else if (victim && context.world.has<Prop>(victim)) {
        context.world.get<Prop>(victim) = {.moved_at = tick, .moved_by = bolt.player};
    }
}

void fly(MatchContext& context, const BoltData& data, std::uint32_t slot, Tick tick) {
    auto& world = context.world;
    world.view<Bolt>().each([&](ecs::Entity e, Bolt& bolt) {
        if (bolt.slot != slot) return;
        const vec3 to = bolt.position + bolt.velocity * physics_dt;
        const auto at = context.physics.read().ray(bolt.position, to, physics::all_layers, bolt.ignores);
        if (at) hit(context, bolt, data, *at, tick);
        if (at || tick >= bolt.dies_at) world.commands().destroy(e);
        bolt.position = to;
    });
}

void add_missile_systems(const WandSystems& to, const BoltData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add(
        {.name = "bolts",
         .period = physics_period,
         .reads = world.mask<Wizard, Effects, Dead, Crystal>(),
         .writes = world.mask<Bolt, Health, EventLog, Prop, resource::Journal, resource::Physics>(),
         .needs = world.mask<Bolt>(),
         .run = [&context = to.context, &data, slot](ecs::World&, Tick tick) {
             fly(context, data, slot, tick);
         }});
}

class BoltWand final : public WandRules {
public:
    BoltWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, BoltHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<BoltHand, Dice, EventLog, Health, HandState, resource::Journal>();
    }
    void add_missiles(const WandSystems& to) const override { add_missile_systems(to, data_, slot_); }
    void show(const ecs::World& world, const std::function<void(const Missile&)>& show) const override {
        world.view<const Bolt>().each([&](ecs::Entity e, const Bolt& b) {
            if (b.slot != slot_) return;
            show({.entity = e, .position = b.position, .velocity = b.velocity, .player = b.player});
        });
    }
    std::optional<ShotKind> shot(double, double) const override { return ShotKind{.speed = data_.speed}; }

private:
    BoltData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "bolt",
    .hits = {{.name = "bolt_hit", .cause = "bolt", .fixed = FixedNumbers{2, 0}}},
    .declare = declare_all<Bolt, BoltHand>,
    .read = read_rules<WandRules, BoltWand>,
});

}  // namespace
}  // namespace thaum::game::inline wands
