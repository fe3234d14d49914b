// The blast wand: holding fire charges the wand, and a growing force presses the hand. Releasing fire shoots
// a ball of fire and kicks the hand.
//
// If fire is released before the charge begins, nothing is shot and no energy is lost. The charge grows
// evenly and stops when the energy is used up, so neither charge nor force jumps. At the shot, the steady
// force fades while the recoil rises. Otherwise the slew limit would have to reduce the steady force later,
// at the cost of the recoil. The sum never exceeds the greater of the two. The ball flies straight, as a bolt
// does. In each physics step, after the bodies have moved, a sphere is swept along its path. The ball bursts
// at the first contact.
#include <algorithm>
#include <optional>

#include "game/components/crystal.h"
#include "game/context/hand_forces.h"
#include "game/context/shot.h"

namespace thaum::game::inline wands {
namespace {

struct BlastData {
    Tick from{};            ///< number of ticks for which fire must be held before charging begins
    double charge_step{};   ///< growth of the charge per tick
    double steady_force{};  ///< steady force on the hand at full charge (N)
    GrowingValue energy, damage, speed;
    double radius{};  ///< radius of the ball (m)
    Tick life{};
    double splash{};       ///< share of the damage that the explosion does to bodies not struck directly
    GrowingValue reach;    ///< radius of the explosion (m), as a function of the charge
    GrowingValue impulse;  ///< impulse of the explosion at distance zero (N s), as a function of the charge
    double fastest{};
    double recoil{};  ///< peak force of the recoil at full charge (N)
    Tick recoil_length{};
    EventKind hit{};  ///< kind of event as which the wand's hits are recorded
};

/// A ball of fire in flight.
struct Blast {
    vec3 position{};  ///< position of the ball (m, world)
    vec3 velocity{};  ///< velocity of the ball (m/s, world)
    double charge{};
    Tick dies_at{};
    std::uint32_t player{};
    std::uint32_t shooter{};  ///< number of the shooter's body in the physics
    /// 1: the shooter held the Lens (reward for carving) at the shot, so shields absorb none of the ball's
    /// harm
    std::uint32_t lens{};
    std::uint32_t slot{};  ///< slot of the wand that shot it
    THAUM_COMPONENT(Blast, position, velocity, charge, dies_at, player, shooter, lens, slot);
};

/// State of the blast wand in a wizard's hand.
struct BlastHand {
    double charge{};      ///< charge of the wand, 0 to 1
    double affordable{};  ///< largest charge that the remaining energy can pay for
    double leaning{};     ///< charge before the shot, whose steady force on the hand still fades; 0: none
    Tick began{};
    Tick went_off{};           ///< tick of the last shot, at which the recoil began
    std::uint32_t charging{};  ///< 1 while fire is held
    std::uint32_t slot{};      ///< slot of the wand that charges, or has been shot last
    THAUM_COMPONENT(BlastHand, charge, affordable, leaning, began, went_off, charging, slot);
};

BlastData read(const ConfigTable& root) {
    BlastData data;
    data.hit = hit_kind("blast_hit");
    data.energy = read_growing(root.table("energy"), "cost", "cost_full", {0, 1e6});
    const auto charge = root.table("charge");
    const double from = charge.number("from_s", {0, 60}), full = charge.number("full_s", {0.001, 60});
    if (full <= from) charge.report("full_s", "'full_s' must be more than from_s");
    data.from = ticks(from);
    data.charge_step = tick_seconds / std::max(full - from, tick_seconds);
    data.steady_force = charge.number("force_n", {0, 100});
    const auto shot = root.table("shot");
    data.damage = read_growing(shot, "damage", "damage_full", {0, 1e6});
    data.speed = read_growing(shot, "speed_m_s", "speed_full_m_s", {0.1, 1000});
    data.radius = shot.number("radius_m", {0.01, 1});
    data.life = ticks(shot.number("life_s", {0.001, 60}));
    const auto splash = root.table("splash");
    data.splash = splash.number("share", {0, 1});
    data.reach = read_growing(splash, "radius_m", "radius_full_m", {0.01, 100});
    data.impulse = read_growing(splash, "impulse_n_s", "impulse_full_n_s", {0, 1e4});
    data.fastest = splash.number("fastest_m_s", {0, 100});
    const auto recoil = root.table("recoil");
    data.recoil = recoil.number("force_n", {0, 100});
    data.recoil_length = std::max<Tick>(1, ticks(recoil.number("length_s", {0.001, 10})));
    return data;
}

/// The charge that an amount of energy can pay for; negative if the energy is too low for any shot.
double affordable(const GrowingValue& energy, double left) {
    if (left < energy.least) return -1;
    const double more = energy.most - energy.least;
    return more > 0 ? std::min(1.0, (left - energy.least) / more) : 1;
}

/// Peak of the recoil (N), proportional to the energy and the speed of the shot (paper 002, section 3.1.2).
double recoil_of(const BlastData& data, double charge) {
    const double energy = data.energy.most > 0 ? data.energy.at(charge) / data.energy.most : 1;
    return data.recoil * energy * data.speed.at(charge) / data.speed.most;
}

bool holds_lens(const ecs::World& world, ecs::Entity wizard) {
    const auto* lens = world.find<Lens>(wizard);
    return lens != nullptr && lens->held != 0;
}

void shoot(const WandUse& use, const BlastData& data, double charge) {
    auto& world = use.context.world;
    auto muzzle = muzzle_of(use, data.radius);
    help_aim(use, data.speed.at(charge), muzzle);
    world.commands().create(Blast{.position = muzzle.tip,
                                  .velocity = muzzle.aim * data.speed.at(charge),
                                  .charge = charge,
                                  .dies_at = use.tick + data.life,
                                  .player = std::as_const(world).get<Wizard>(use.wizard).player,
                                  .shooter = use.wizard.index,
                                  .lens = holds_lens(world, use.wizard) ? 1U : 0U,
                                  .slot = use.stats.slot});
    note_shot(use, data.hit, muzzle.tip);
    recoil(use.context, use.wizard, recoil_of(data, charge), data.recoil_length);
}

void stop_charging(const WandUse& use) {
    use.context.world.get<BlastHand>(use.wizard) = {};
    let_go(use.context, use.wizard);
}

/// After the shot, reduces the steady force in proportion to how far the recoil has risen, until the recoil's
/// peak. So the sum of the two forces never exceeds the greater of them.
void give_way(MatchContext& context, const BlastData& data, ecs::Entity wizard, Tick tick, BlastHand& hand) {
    if (hand.leaning == 0) return;
    const auto at = static_cast<std::uint32_t>(tick - hand.went_off);
    const auto length = static_cast<std::uint32_t>(data.recoil_length);
    const double left = 2 * at < length ? 1 - haptics::half_sine(at, length) : 0;
    set_steady_force(context, wizard, {0, 0, data.steady_force * hand.leaning * left});
    if (left == 0) hand.leaning = 0;
}

void fire(const WandUse& use, const BlastData& data) {
    auto& world = use.context.world;
    const auto& controls = std::as_const(world).get<Controls>(use.wizard);
    auto& hand = world.get<BlastHand>(use.wizard);
    auto& belt = world.get<WandBelt>(use.wizard);
    const double most = affordable(data.energy, belt.energy[use.stats.energy_slot]);
    if (hand.charging == 0) {
        const bool pressed = (controls.pressed & input::bit(input::Button::fire)) != 0;
        if (!holds_fire(controls)) return;
        if (most < 0) return pressed ? note_dry(use) : void();
        hand.affordable = most;
        hand.began = use.tick;
        hand.charging = 1;
        hand.slot = use.stats.slot;
        return;
    }
    hand.affordable = most;
    if (holds_fire(controls)) return;
    const bool goes_off = use.tick >= hand.began + data.from;
    const double charge = std::min(hand.charge, most);
    if (!goes_off || most < 0 || !spend(belt, use.stats, data.energy.at(charge))) return stop_charging(use);
    hand = {.leaning = hand.charge, .went_off = use.tick, .slot = use.stats.slot};
    shoot(use, data, charge);
    give_way(use.context, data, use.wizard, use.tick, hand);
}

/// Increases charge and steady force. This runs every tick, so that the force grows without steps.
void charge(MatchContext& context, const BlastData& data, ecs::Entity wizard, Tick tick, BlastHand& hand) {
    if (hand.charging == 0 || tick <= hand.began + data.from) return;
    hand.charge = std::max(hand.charge, std::min(hand.charge + data.charge_step, hand.affordable));
    set_steady_force(context, wizard, {0, 0, data.steady_force * hand.charge});
}

void add_force_systems(const WandSystems& to, const BlastData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add({.name = "blast charges",
                     .reads = world.mask<Wizard>(),
                     .writes = world.mask<BlastHand, HandState>(),
                     .needs = world.mask<BlastHand>(),
                     .run = [&context = to.context, &data, slot](ecs::World& w, Tick tick) {
                         w.view<BlastHand>().each([&](ecs::Entity e, BlastHand& hand) {
                             if (hand.slot != slot) return;
                             charge(context, data, e, tick, hand);
                             give_way(context, data, e, tick, hand);
                         });
                     }});
}

void hit(MatchContext& context, const Blast& blast, const BlastData& data, vec3 place, physics::Key struck,
         Tick tick) {
    const bool lens = blast.lens != 0 && context.data.crystal;
    const double damage = data.damage.at(blast.charge) * (lens ? context.data.crystal->lens_share : 1);
    burst(context,
          {.place = place,
           .size = data.radius,
           .radius = data.reach.at(blast.charge),
           .damage = data.splash * damage,
           .impulse = data.impulse.at(blast.charge),
           .fastest = data.fastest,
           .player = blast.player,
           .shooter = blast.shooter,
           .how = data.hit,
           .struck = struck,
           .struck_damage = damage,
           .pierces = lens},
          tick);
}

void fly(MatchContext& context, const BlastData& data, std::uint32_t slot, Tick tick) {
    auto& world = context.world;
    world.view<Blast>().each([&](ecs::Entity e, Blast& blast) {
        if (blast.slot != slot) return;
        const vec3 way = blast.velocity * physics_dt;
        const auto at = context.physics.read().sweep_sphere(blast.position, blast.position + way, data.radius,
                                                            physics::all_layers, blast.shooter);
        if (at) hit(context, blast, data, blast.position + at->fraction * way, at->key, tick);
        if (at || tick >= blast.dies_at) world.commands().destroy(e);
        blast.position += way;
    });
}

void add_missile_systems(const WandSystems& to, const BlastData& data, std::uint32_t slot) {
    auto& world = to.context.world;
    to.schedule.add(
        {.name = "blasts",
         .period = physics_period,
         .reads = world.mask<Body, Motion, Wizard, Effects, Dead, Crystal>(),
         .writes = world.mask<Blast, Health, Stance, EventLog, Prop, resource::Journal, resource::Physics>(),
         .needs = world.mask<Blast>(),
         .run = [&context = to.context, &data, slot](ecs::World&, Tick tick) {
             fly(context, data, slot, tick);
         }});
}

class BlastWand final : public WandRules {
public:
    BlastWand(const ConfigTable& root, std::uint32_t slot) : data_(read(root)), slot_(slot) {}

    void outfit(ecs::World& world, ecs::Entity wizard) const override { world.add(wizard, BlastHand{}); }
    void use(const WandUse& use) const override { fire(use, data_); }
    void put_away(const WandUse& use) const override { stop_charging(use); }
    ecs::Mask writes(const ecs::World& world) const override {
        return world.mask<BlastHand, EventLog, Health, HandState, resource::Journal>();
    }
    void add_forces(const WandSystems& to) const override { add_force_systems(to, data_, slot_); }
    void add_missiles(const WandSystems& to) const override { add_missile_systems(to, data_, slot_); }
    void show(const ecs::World& world, const std::function<void(const Missile&)>& show) const override {
        world.view<const Blast>().each([&](ecs::Entity e, const Blast& b) {
            if (b.slot != slot_) return;
            show({.entity = e,
                  .position = b.position,
                  .velocity = b.velocity,
                  .player = b.player,
                  .size = 0.12 + 0.1 * b.charge});
        });
    }
    std::optional<ShotKind> shot(double readiness, double) const override {
        return ShotKind{.speed = data_.speed.at(readiness),
                        .radius = data_.reach.at(readiness),
                        .energy = data_.energy.at(readiness),
                        .held = true};
    }
    std::optional<double> readiness(const ecs::World& world, ecs::Entity wizard) const override {
        const auto& hand = world.get<BlastHand>(wizard);
        return hand.slot == slot_ ? hand.charge : 0;
    }

private:
    BlastData data_;
    std::uint32_t slot_;
};

const WandRegistration registration({
    .name = "blast",
    .hits = {{.name = "blast_hit", .cause = "blast", .fixed = FixedNumbers{11, 1}}},
    .declare = declare_all<Blast, BlastHand>,
    .read = read_rules<WandRules, BlastWand>,
});

}  // namespace
}  // namespace thaum::game::inline wands
