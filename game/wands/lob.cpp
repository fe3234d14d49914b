// The lob wand: a slingshot. Holding fire draws the hand back along a line, against a spring with detents.
// Releasing fire throws a stone. Its speed follows from the draw that the device measured.
//
// The hand moves to the position given by the trigger; a key counts as a full trigger. The speed of the hand
// is limited, so the player feels the spring being drawn. After the release the hand glides back, and the
// next draw begins only when it has arrived. A player with a real arm pulls the arm back while holding fire.
// If the draw is too short, no stone is thrown and no energy is lost.
//
// A stone in flight is a sphere, whose parabola is computed exactly in each physics step. After the bodies
// have moved, the sphere is swept along the chord of the step. So a stone cannot pass through anything, and
// its landing point has a closed form. It bursts on the foe, passes through the shooter, bounces off
// everything else, and bursts at the end of its fuse. The stone's weight does not act on other bodies.
#include <algorithm>
#include <optional>
#include <utility>

#include "game/components/crystal.h"
#include "game/components/hand_state.h"
#include "game/context/arms.h"
#include "game/context/hand_forces.h"
#include "game/context/shot.h"

namespace thaum::game::inline wands {
namespace {

constexpr double clear_of = 1e-5;  ///< distance at which the stone is put from the surface after a bounce (m)
constexpr double min_bounce = 0.3;  ///< speed of impact below which the stone does not bounce (m/s)

struct LobData {
    vec3 axis{};  ///< direction in which the hand draws the sling (unit, device frame)
    /// Displacements of the hand (m): at full draw, smallest that throws a stone, and farthest of the
    /// simulated hand.
    double full{}, least{}, travel{};
    /// Displacement of the hand per tick while drawing and while returning (m).
    double step{}, return_step{};
    /// spring of the sling; its anchor, the place to which it pulls, is set at each draw
    haptics::Tether spring{};
    GrowingValue speed;
    double energy{};
    double radius{};  ///< radius of the stone (m)
    Tick fuse{};
    double bounce{}, drag{};
    double damage{}, reach{}, impulse{}, fastest{};
    EventKind hit{};  ///< kind of event as which the wand's hits are recorded
};

/// A stone in flight, or at rest until the end of its fuse.
struct Lob {
    vec3 position{};  ///< position of the stone (m, world)
    vec3 velocity{};  ///< velocity of the stone (m/s, world)
    Tick bursts_at{};
    std::uint32_t player{};
    std::uint32_t shooter{};  ///< number of the shooter's body in the physics
    double venom{};           ///< harm rate that a potion adds for those whom the stone hits (HP/s)
    Tick venom_lasts{};       ///< duration of the harm that the potion adds (ticks)
    std::uint32_t slot{};     ///< slot of the wand that threw it
    std::uint32_t spare{};
    THAUM_COMPONENT(Lob, position, velocity, bursts_at, player, shooter, venom, venom_lasts, slot, spare);
};

/// State of the lob wand in a wizard's hand.
struct LobHand {
    vec3 anchor{};            ///< hand position at which the draw began (m, device frame)
    double target{};          ///< displacement to which the simulated hand moves along the sling's axis (m)
    double drawn{};           ///< draw that the device measured, as a share of a full draw
    std::uint32_t drawing{};  ///< 1 while fire is held and the sling is drawn
    std::uint32_t slot{};     ///< slot of the wand that is drawn, or was drawn last
    THAUM_COMPONENT(LobHand, anchor, target, drawn, drawing, slot);
};

vec3 read_axis(const ConfigTable& draw) {
    const vec3 axis = draw.vector("axis", {-1, 1});
    const double length = glm::length(axis);
    if (length > 0.1) return axis / length;
    draw.report("axis", "'axis' must be a direction");
    return {0, 0, 1};
}

haptics::Tether read_spring(const ConfigTable& spring, vec3 axis, double full) {
    haptics::Tether tether{.stiffness = spring.number("stiffness_n_per_m", {0.1, 1000}),
                           .damping = spring.number("damping_n_s_per_m", {0, 10})};
    tether.detents = {.axis = axis,
                      .places = {0.25 * full, 0.5 * full, 0.75 * full},
                      .depth = spring.number("detent_n", {0, 10}),
                      .width = spring.number("detent_width_m", {0.0005, 0.1})};
    if (tether.detents.width > 0.25 * full)
        spring.report("detent_width_m", "'detent_width_m' must not be more than a quarter of full_m");
    return tether;
}

LobData read(const ConfigTable& root) {
    LobData data;
    data.hit = hit_kind("lob_hit");
    data.energy = root.table("energy").number("cost", {0, 1e6});
    const auto draw = root.table("draw");
    data.axis = read_axis(draw);
    data.full = draw.number("full_m", {0.001, 1});
    data.least = draw.number("least_m", {0, 1});
    data.travel = draw.number("travel_m", {0.001, 1});
    data.step = draw.number("speed_m_s", {0.001, 10}) * tick_seconds;
    data.return_step = draw.number("return_m_s", {0.001, 10}) * tick_seconds;
    data.spring = read_spring(root.table("spring"), data.axis, data.full);
    const auto shot = root.table("shot");
    data.speed = read_growing(shot, "speed_m_s", "speed_full_m_s", {0.1, 1000});
    data.radius = shot.number("radius_m", {0.01, 1});
    data.fuse = ticks(shot.number("fuse_s", {0.001, 60}));
    data.bounce = shot.number("bounce", {0, 1});
    data.drag = shot.number("drag", {0, 1});
    const auto burst = root.table("burst");
    data.damage = burst.number("damage", {0, 1e6});
    data.reach = burst.number("radius_m", {0.01, 100});
    data.impulse = burst.number("impulse_n_s", {0, 1e4});
    data.fastest = burst.number("fastest_m_s", {0, 100});
    return data;
}

void begin(const WandUse& use, const LobData& data, LobHand& hand) {
    const auto& hand_state = std::as_const(use.context.world).get<HandState>(use.wizard);
    hand.anchor = haptics::measured_position(use.context.input.haptic_setup.device, hand_state.device);
    hand.drawing = 1;
    hand.slot = use.stats.slot;
    auto spring = data.spring;
    spring.anchor = hand.anchor;
    tether(use.context, use.wizard, spring);
}

void shoot(const WandUse& use, const LobData& data, double share) {
    auto& world = use.context.world;
    const auto muzzle = muzzle_of(use, data.radius);
    auto& belt = world.get<WandBelt>(use.wizard);
    const double venom = use.tick < belt.venom_until ? std::exchange(belt.venom, 0) : 0;
    world.commands().create(Lob{.position = muzzle.tip,
                                .velocity = muzzle.ahead * data.speed.at(share),
                                .bursts_at = use.tick + data.fuse,
                                .player = std::as_const(world).get<Wizard>(use.wizard).player,
                                .shooter = use.wizard.index,
                                .venom = venom,
                                .venom_lasts = venom > 0 ? belt.venom_lasts : 0,
                                .slot = use.stats.slot});
    note_shot(use, data.hit, muzzle.tip);
}

void stop_drawing(const WandUse& use) {
    use.context.world.get<LobHand>(use.wizard) = {};
    let_go(use.context, use.wizard);
}

void fire(const WandUse& use, const LobData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<LobHand>(use.wizard);
    auto& belt = world.get<WandBelt>(use.wizard);
    if (hand.drawing == 0) {
        if (!holds_fire(controls) || hand.target > 0) return;
        if (belt.energy[use.stats.energy_slot] >= data.energy) return begin(use, data, hand);
        if ((controls.pressed & input::bit(input::Button::fire)) != 0) note_dry(use);
        return;
    }
    if (holds_fire(controls)) return;
    const double drawn = std::exchange(hand.drawn, 0);
    hand.drawing = 0;
    tether(use.context, use.wizard, {});
    if (drawn * data.full >= data.least && spend(belt, use.stats, data.energy)) shoot(use, data, drawn);
}

/// Displacement (m) to which the hand should move: given by the trigger while fire is held, zero after the
/// draw. Between the release and the next gameplay tick it does not change.
double wanted_target(const LobData& data, const Controls& controls, const LobHand& hand) {
    if (hand.drawing == 0) return 0;
    const bool held = (controls.held & input::bit(input::Button::fire)) != 0;
    return held ? data.travel * (controls.trigger / 255.0) : hand.target;
}

/// Moves the simulated hand and measures the draw. This runs every tick, so that the hand moves evenly. A
/// real arm is not moved by the trigger.
void draw(MatchContext& context, const LobData& data, std::uint32_t slot) {
    context.world.view<const Wizard, const Controls, LobHand, HandState>().each(
        [&](const Wizard& wizard, const Controls& controls, LobHand& hand, HandState& hand_state) {
            if (hand.slot != slot || (hand.drawing == 0 && hand.target == 0)) return;
            const bool by_arm = plays_by_arm(context.world, wizard.player);
            const double most = hand.drawing != 0 ? data.step : data.return_step;
            const double wanted = by_arm ? 0 : wanted_target(data, controls, hand);
            hand.target += std::clamp(wanted - hand.target, -most, most);
            hand_state.pull = hand.target * data.axis;
            if (hand.drawing == 0) return;
            const vec3 moved =
                haptics::measured_position(context.input.haptic_setup.device, hand_state.device) -
                hand.anchor;
            hand.drawn = std::clamp(glm::dot(moved, data.axis) / data.full, 0.0, 1.0);
        });
}

void add_force_systems(const WandSystems& to, const LobData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add(
        {.name = "lob draws",
         .reads = world.mask<Wizard, Controls, Arm>(),
         .writes = world.mask<LobHand, HandState>(),
         .needs = world.mask<LobHand>(),
         .run = [&context = to.context, &data, slot](ecs::World&, Tick) { draw(context, data, slot); }});
}

void go_off(MatchContext& context, const Lob& lob, const LobData& data, vec3 place, Tick tick) {
    burst(context,
          {.place = place,
           .size = data.radius,
           .radius = data.reach,
           .damage = data.damage,
           .impulse = data.impulse,
           .fastest = data.fastest,
           .player = lob.player,
           .shooter = lob.shooter,
           .how = data.hit,
           .venom = lob.venom,
           .venom_lasts = lob.venom_lasts},
          tick);
}

/// Velocity after a bounce off a surface with this normal.
vec3 bounced(const LobData& data, vec3 velocity, vec3 normal) {
    const double into = glm::dot(velocity, normal);
    if (into >= 0) return velocity;
    const double back = -into > min_bounce ? -into * data.bounce : 0;
    return (velocity - into * normal) * (1 - data.drag) + back * normal;
}

/// Moves the stone by one physics step. Returns true if the stone has burst. After a bounce the remaining
/// time of the step, at most one tick, is skipped.
bool fly(MatchContext& context, const LobData& data, Lob& lob, Tick tick) {
    const vec3 gravity = context.physics.read().settings().gravity;
    const vec3 way = (lob.velocity + 0.5 * physics_dt * gravity) * physics_dt;
    const auto at = context.physics.read().sweep_sphere(lob.position, lob.position + way, data.radius,
                                                        physics::all_layers, lob.shooter);
    const double part = at ? at->fraction : 1;
    lob.position += part * way;
    lob.velocity += part * physics_dt * gravity;
    const bool on_wizard = at && context.world.has<Wizard>(context.world.entity(at->key));
    if (on_wizard || tick >= lob.bursts_at) {
        go_off(context, lob, data, lob.position, tick);
        return true;
    }
    if (at) {
        lob.velocity = bounced(data, lob.velocity, at->normal);
        lob.position += clear_of * at->normal;
    }
    return false;
}

void add_missile_systems(const WandSystems& to, const LobData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add(
        {.name = "lobs",
         .period = physics_period,
         .reads = world.mask<Body, Motion, Wizard, Effects, Dead, Crystal>(),
         .writes = world.mask<Lob, Health, Stance, EventLog, Prop, resource::Journal, resource::Physics>(),
         .needs = world.mask<Lob>(),
         .run = [&context = to.context, &data, slot](ecs::World& w, Tick tick) {
             w.view<Lob>().each([&](ecs::Entity e, Lob& lob) {
                 if (lob.slot == slot && fly(context, data, lob, tick)) w.commands().destroy(e);
             });
         }});
}

class LobWand final : public WandRules {
public:
    LobWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, LobHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    void put_away(const WandUse& use) const override { stop_drawing(use); }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<LobHand, EventLog, Health, HandState, resource::Journal>();
    }
    void add_forces(const WandSystems& to) const override { add_force_systems(to, data_, slot_); }
    void add_missiles(const WandSystems& to) const override { add_missile_systems(to, data_, slot_); }
    void show(const ecs::World& world, const std::function<void(const Missile&)>& show) const override {
        world.view<const Lob>().each([&](ecs::Entity e, const Lob& b) {
            if (b.slot != slot_) return;
            show({.entity = e,
                  .position = b.position,
                  .velocity = b.velocity,
                  .player = b.player,
                  .size = 0.1});
        });
    }
    std::optional<ShotKind> shot(double readiness, double gravity) const override {
        return ShotKind{.speed = data_.speed.at(readiness),
                        .fall = gravity,
                        .radius = data_.reach,
                        .energy = data_.energy,
                        .held = true};
    }
    std::optional<double> readiness(const ecs::World& world, ecs::Entity wizard) const override {
        const auto& hand = world.get<LobHand>(wizard);
        return hand.slot == slot_ ? hand.drawn : 0;
    }

private:
    LobData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "lob",
    .hits = {{.name = "lob_hit", .cause = "lob", .fixed = FixedNumbers{12, 2}}},
    .declare = declare_all<Lob, LobHand>,
    .read = read_rules<WandRules, LobWand>,
});

}  // namespace
}  // namespace thaum::game::inline wands
