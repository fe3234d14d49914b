// The hail wand, a sixth wand that only the tests have. This file and the wand's data file are all that a new
// wand needs: the game's files stay unchanged.
#include <algorithm>

#include "game/components/hand_state.h"
#include "game/context/match_context.h"
#include "game/context/shot.h"

namespace thaum::game {
namespace {

struct HailData {
    Tick interval{};       ///< ticks between shots
    std::int64_t lumps{};  ///< lumps of ice per shot
    double damage{};       ///< harm to a wizard who is struck (HP)
    double speed{};        ///< speed at the muzzle (m/s)
    double fall{};         ///< downward acceleration (m/s^2)
    Tick life{};
    double frost_damage{};  ///< harm to a wizard near whom a lump lands (HP)
    double frost_radius{};  ///< distance from the lump up to which wizards are harmed by its frost (m)
    EventKind hit{}, frost{};
};

/// A lump of ice in flight.
struct Hail {
    vec3 position{};  ///< position (m, world)
    vec3 velocity{};  ///< velocity (m/s, world)
    Tick dies_at{};
    std::uint32_t player{};
    std::uint32_t ignores{};  ///< key of the shooter's body, which the lump does not strike
    std::uint32_t slot{};     ///< slot of the wand that shot it
    std::uint32_t spare{};
    THAUM_COMPONENT(Hail, position, velocity, dies_at, player, ignores, slot, spare);
};

/// State of the hail wand in a wizard's hand.
struct HailHand {
    Tick next_shot{};
    THAUM_COMPONENT(HailHand, next_shot);
};

HailData read(const ConfigTable& root) {
    HailData data;
    const auto shot = root.table("shot"), frost = root.table("frost");
    data.interval = std::max<Tick>(1, ticks(1 / shot.number("per_s", {0.01, 1000})));
    data.lumps = shot.integer("lumps", {1, 10'000});
    data.damage = shot.number("damage", {0, 1e6});
    data.speed = shot.number("speed_m_s", {0.1, 1000});
    data.fall = shot.number("fall_m_s2", {0, 100});
    data.life = ticks(shot.number("life_s", {0.001, 60}));
    data.frost_damage = frost.number("damage", {0, 1e6});
    data.frost_radius = frost.number("radius_m", {0, 100});
    data.hit = hit_kind("hail_hit");
    data.frost = hit_kind("hail_frost");
    return data;
}

void fire(const WandUse& use, const HailData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<HailHand>(use.wizard);
    if (!holds_fire(controls) || use.tick < hand.next_shot) return;
    if (!spend(world.get<WandBelt>(use.wizard), use.stats)) {
        if ((controls.pressed & input::bit(input::Button::fire)) != 0) note_dry(use);
        return;
    }
    hand.next_shot = use.tick + data.interval;
    const auto muzzle = muzzle_of(use, 0);
    const Hail lump{.position = muzzle.tip,
                    .velocity = muzzle.ahead * data.speed,
                    .dies_at = use.tick + data.life,
                    .player = std::as_const(world).get<Wizard>(use.wizard).player,
                    .ignores = use.wizard.index,
                    .slot = use.stats.slot};
    for (std::int64_t i = 0; i < data.lumps; ++i) world.commands().create(lump);
    note_shot(use, data.hit, muzzle.tip);
}

void chill(MatchContext& context, const HailData& data, const Hail& hail, vec3 place, Tick tick) {
    context.world.view<const Wizard, const Motion>().each(
        [&](ecs::Entity e, const Wizard&, const Motion& motion) {
            if (e.index == hail.ignores || glm::distance(motion.position, place) > data.frost_radius) return;
            hurt(context, e, tick,
                 {.points = data.frost_damage, .by = hail.player, .how = data.frost, .place = place});
        });
}

void land(MatchContext& context, const HailData& data, const Hail& hail, const physics::RayHit& at,
          Tick tick) {
    const auto struck = context.world.entity(at.key);
    if (struck && context.world.has<Wizard>(struck))
        hurt(context, struck, tick,
             {.points = data.damage, .by = hail.player, .how = data.hit, .place = at.point});
    else
        chill(context, data, hail, at.point, tick);
}

void fly(MatchContext& context, const HailData& data, std::uint32_t slot, Tick tick) {
    auto& world = context.world;
    world.view<Hail>().each([&](ecs::Entity e, Hail& hail) {
        if (hail.slot != slot) return;
        const vec3 to = hail.position + hail.velocity * physics_dt;
        const auto at = context.physics.read().ray(hail.position, to, physics::all_layers, hail.ignores);
        if (at) land(context, data, hail, *at, tick);
        if (at || tick >= hail.dies_at) world.commands().destroy(e);
        hail.position = to;
        hail.velocity.y -= data.fall * physics_dt;
    });
}

class HailWand final : public WandRules {
public:
    HailWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, HailHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<HailHand, EventLog, Health, HandState, resource::Journal>();
    }
    void add_missiles(const WandSystems& to) const override {
        const auto& world = to.context.world;
        to.schedule.add({.name = "hail",
                         .period = physics_period,
                         .reads = world.mask<Wizard, Effects, Motion, Dead, resource::Physics>(),
                         .writes = world.mask<Hail, Health, EventLog, resource::Journal>(),
                         .needs = world.mask<Hail>(),
                         .run = [&context = to.context, this](ecs::World&, Tick tick) {
                             fly(context, data_, slot_, tick);
                         }});
    }
    void show(const ecs::World& world, const std::function<void(const Missile&)>& show) const override {
        world.view<const Hail>().each([&](ecs::Entity e, const Hail& h) {
            if (h.slot != slot_) return;
            show({.entity = e, .position = h.position, .velocity = h.velocity, .player = h.player});
        });
    }
    std::optional<ShotKind> shot(double, double) const override {
        return ShotKind{.speed = data_.speed, .fall = data_.fall, .energy = 0, .liking = 2};
    }

private:
    HailData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "hail",
    .hits = {{.name = "hail_hit", .cause = "hail"}, {.name = "hail_frost", .cause = "frost"}},
    .declare = declare_all<Hail, HailHand>,
    .read = read_rules<WandRules, HailWand>,
});

}  // namespace
}  // namespace thaum::game
