#include "game/match/bodies.h"

namespace thaum::game {
namespace {

/// A blow is over after this; Bullet spreads it over a few steps.
constexpr Tick blow_length = 24;
/// m/s towards the wizard, below which a thing does not hit but is pushed, stood on or walked into.
constexpr double hitting_speed = 0.5;

/// The blow of this thing, or the slot that a new one may take.
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
    const vec3 velocity = std::as_const(world).get<Motion>(thing).velocity;  // from before the step
    if (!ready || glm::dot(velocity, towards) < hitting_speed) return;
    blow = {.by = thing, .began = tick, .counts_again = tick + again, .impulse = contact.impulse};
}

/// Sums what hits wizards while the blow lasts.
void collect_blows(Stage& stage, Tick tick) {
    auto& world = stage.world;
    for (const auto& contact : stage.physics.contacts()) {
        const auto a = world.entity(contact.a);
        const auto b = world.entity(contact.b);
        if (!a || !b) continue;
        const auto again = stage.data.wizard.object_again;
        if (world.has<Wizard>(a) && world.has<Prop>(b))
            collect(world, a, b, contact, contact.normal, tick, again);
        if (world.has<Wizard>(b) && world.has<Prop>(a))
            collect(world, b, a, contact, -contact.normal, tick, again);
    }
}

/// Whose deed a thing's blow is.
std::uint32_t mover_of(const ecs::World& world, ecs::Entity thing, Tick began, Tick blame) {
    const auto* prop = world.find<Prop>(thing);
    return prop != nullptr && began <= prop->moved_at + blame ? prop->moved_by : no_player;
}

/// Counts the blows that are over.
void count_blows(Stage& stage, Tick tick) {
    const auto& rules = stage.data.wizard;
    stage.world.view<Blows, const Motion>().each([&](ecs::Entity wizard, Blows& blows, const Motion& motion) {
        for (auto& blow : blows.recent) {
            if (!blow.by || blow.impulse < 0 || tick < blow.began + blow_length) continue;
            const double points = harm_of_blow(rules, blow.impulse);
            blow.impulse = -1;
            hurt(stage.world, wizard, tick,
                 {.points = points,
                  .by = mover_of(stage.world, blow.by, blow.began, rules.blame),
                  .how = EventKind::object_hit,
                  .place = motion.position});
        }
    });
}

}  // namespace

void add_body_hooks(Stage& stage) {
    stage.world.on_add<Body>({[](void* context, ecs::Entity e, const void* body) {
                                  auto& s = *static_cast<Stage*>(context);
                                  s.physics.add(e.index, *static_cast<const Body*>(body),
                                                std::as_const(s.world).get<Motion>(e));
                              },
                              &stage});
    stage.world.on_remove<Body>({[](void* context, ecs::Entity e, const void*) {
                                     static_cast<Stage*>(context)->physics.remove(e.index);
                                 },
                                 &stage});
}

void copy_places(Stage& stage) {
    stage.world.view<const Body, Motion>().each([&](ecs::Entity e, const Body& body, Motion& motion) {
        if (body.mass > 0) static_cast<physics::BodyState&>(motion) = stage.physics.state(e.index);
    });
}

double harm_of_blow(const WizardRules& rules, double impulse) {
    return std::clamp(rules.object_damage * (impulse - rules.object_safe), 0.0, rules.object_damage_max);
}

void rebuild_physics(Stage& stage) {
    stage.physics = physics::Physics(stage.physics.settings(), stage.data.arena.meshes);
    stage.world.view<const Body, const Motion>().each(
        [&](ecs::Entity e, const Body& body, const Motion& motion) {
            stage.physics.add(e.index, body, motion);
        });
    stage.physics.rebuild();
}

void add_body_systems(Stage& stage, ecs::Schedule& schedule) {
    auto& world = stage.world;
    schedule.add({.name = "physics",
                  .period = physics_period,
                  .needs = world.mask<Body>(),
                  .run = [&stage](ecs::World&, Tick) {
                      const auto skipped = stage.physics.counters().skipped;
                      stage.physics.step(physics_dt);
                      stage.moved = stage.physics.counters().skipped == skipped;
                  }});
    schedule.add({.name = "blows",
                  .period = physics_period,
                  .reads = world.mask<Wizard, Prop, Motion, Dead>(),
                  .writes = world.mask<Blows, Health, Chronicle>(),
                  .needs = world.mask<Blows, Prop>(),
                  .run = [&stage](ecs::World&, Tick tick) {
                      collect_blows(stage, tick);
                      if (tick % gameplay_period == 0) count_blows(stage, tick);
                  }});
    schedule.add({.name = "places",
                  .period = physics_period,
                  .reads = world.mask<Body>(),
                  .writes = world.mask<Motion>(),
                  .needs = world.mask<Body>(),
                  .run = [&stage](ecs::World&, Tick) {
                      if (stage.moved) copy_places(stage);
                  }});
}

}  // namespace thaum::game
