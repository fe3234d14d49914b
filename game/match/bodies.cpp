#include "game/match/bodies.h"

#include "game/components/crystal.h"
#include "game/context/strikes.h"

namespace thaum::game::inline match {
namespace {

/// Ticks over which the impulses of one blow are summed. Bullet spreads a blow over a few steps.
constexpr Tick blow_length = 24;
/// Minimum speed of a thing towards the wizard at which its contact is a blow (m/s). A slower thing is merely
/// pushed, stood on or walked into.
constexpr double hitting_speed = 0.5;

/// Returns the blow that this thing is giving to the wizard, or a free slot for a new blow.
Blow& blow_of(Blows& blows, ecs::Entity by) {
    Blow* oldest = blows.recent.data();
    for (auto& blow : blows.recent) {
        if (blow.by == by) return blow;
        if (blow.counts_again < oldest->counts_again) oldest = &blow;
    }
    return *oldest;
}

void collect(ecs::World& world, ecs::Entity wizard, ecs::Entity thing, const physics::Contact& contact,
             vec3 towards, Tick tick, Tick again) {
    auto& blow = blow_of(world.get<Blows>(wizard), thing);
    const bool running = blow.by == thing && tick < blow.began + blow_length;
    if (running) {
        if (blow.impulse >= 0) blow.impulse += contact.impulse;
        return;
    }
    const bool ready = blow.by != thing || tick >= blow.counts_again;
    // Velocity before this physics step, and so before the blow.
    const vec3 velocity = std::as_const(world).get<Motion>(thing).velocity;
    if (!ready || glm::dot(velocity, towards) < hitting_speed) return;
    blow = {.by = thing, .began = tick, .counts_again = tick + again, .impulse = contact.impulse};
}

/// Player who is credited with a blow by a thing. `began`: tick at which the blow began. no_player if no
/// player moved the thing in the `blame` ticks before.
std::uint32_t mover_of(const ecs::World& world, ecs::Entity thing, Tick began, Tick blame) {
    const auto* prop = world.find<Prop>(thing);
    return prop != nullptr && began <= prop->moved_at + blame ? prop->moved_by : no_player;
}

void blow_on_crystal(MatchContext& context, ecs::Entity crystal, ecs::Entity thing,
                     const physics::Contact& contact, Tick tick) {
    strike_by_thing(context, crystal, contact,
                    mover_of(context.world, thing, tick, context.data.wizard.blame), tick);
}

/// Sums up the impulses of things that hit wizards, one sum for each blow, and records blows on crystals.
void collect_blows(MatchContext& context, Tick tick) {
    auto& world = context.world;
    for (const auto& contact : context.physics.read().contacts()) {
        const auto a = world.entity(contact.a);
        const auto b = world.entity(contact.b);
        if (!a || !b) continue;
        const auto again = context.data.wizard.object_again;
        if (world.has<Wizard>(a) && world.has<Prop>(b))
            collect(world, a, b, contact, contact.normal, tick, again);
        if (world.has<Wizard>(b) && world.has<Prop>(a))
            collect(world, b, a, contact, -contact.normal, tick, again);
        if (world.has<Crystal>(a) && world.has<Prop>(b)) blow_on_crystal(context, a, b, contact, tick);
        if (world.has<Crystal>(b) && world.has<Prop>(a)) blow_on_crystal(context, b, a, contact, tick);
    }
}

/// Number of a thing's Surface, which is its kind, such as crate. For a thing that no longer exists, the
/// number of the first kind.
std::uint32_t surface_of(const ecs::World& world, ecs::Entity thing) {
    const auto* look = world.find<Look>(thing);
    return static_cast<std::uint32_t>(look != nullptr ? look->surface : Surface{});
}

/// Turns blows that have ended into harm.
void count_blows(MatchContext& context, Tick tick) {
    const auto& rules = context.data.wizard;
    context.world.view<Blows, const Motion>().each(
        [&](ecs::Entity wizard, Blows& blows, const Motion& motion) {
            for (auto& blow : blows.recent) {
                if (!blow.by || blow.impulse < 0 || tick < blow.began + blow_length) continue;
                const double points = harm_of_blow(rules, blow.impulse);
                blow.impulse = -1;
                hurt(context, wizard, tick,
                     {.points = points,
                      .by = mover_of(context.world, blow.by, blow.began, rules.blame),
                      .how = EventKind::object_hit,
                      .place = motion.position,
                      .detail = surface_of(context.world, blow.by)});
            }
        });
}

}  // namespace

void add_body_hooks(MatchContext& context) {
    context.world.on_add<Body>({[](void* data, ecs::Entity e, const void* body) {
                                    auto& s = *static_cast<MatchContext*>(data);
                                    s.physics.write().add(e.index, *static_cast<const Body*>(body),
                                                          std::as_const(s.world).get<Motion>(e));
                                },
                                &context});
    context.world.on_remove<Body>({[](void* data, ecs::Entity e, const void*) {
                                       static_cast<MatchContext*>(data)->physics.write().remove(e.index);
                                   },
                                   &context});
}

void copy_places(MatchContext& context) {
    const auto& physics = context.physics.read();
    context.world.view<const Body, Motion>().each([&](ecs::Entity e, const Body& body, Motion& motion) {
        if (body.mass > 0) static_cast<physics::BodyState&>(motion) = physics.state(e.index);
    });
}

double harm_of_blow(const WizardRules& rules, double impulse) {
    return std::clamp(rules.object_damage * (impulse - rules.object_safe), 0.0, rules.max_object_damage);
}

void rebuild_physics(MatchContext& context) {
    auto& physics = context.physics.write();
    physics = physics::Physics(physics.settings(), context.data.arena.meshes);
    context.world.view<const Body, const Motion>().each(
        [&](ecs::Entity e, const Body& body, const Motion& motion) { physics.add(e.index, body, motion); });
    physics.rebuild();
}

void add_body_systems(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "physics",
                  .period = physics_period,
                  .writes = world.mask<resource::Physics>(),
                  .needs = world.mask<Body>(),
                  .run = [&context](ecs::World&, Tick) { context.physics.write().step(physics_dt); }});
    schedule.add(
        {.name = "blows",
         .period = physics_period,
         .reads = world.mask<Wizard, Effects, Prop, Motion, Look, Dead, Crystal, resource::Physics>(),
         .writes = world.mask<Blows, Health, EventLog, resource::Journal>(),
         .needs = world.mask<Blows, Prop>(),
         .run = [&context](ecs::World&, Tick tick) {
             collect_blows(context, tick);
             if (tick % gameplay_period == 0) count_blows(context, tick);
         }});
    schedule.add({.name = "places",
                  .period = physics_period,
                  .reads = world.mask<Body, resource::Physics>(),
                  .writes = world.mask<Motion>(),
                  .needs = world.mask<Body>(),
                  .run = [&context](ecs::World&, Tick) {
                      if (!context.physics.read().skipped_last_step()) copy_places(context);
                  }});
}

}  // namespace thaum::game::inline match
