#include "game/match/spawn.h"

namespace thaum::game::inline match {
namespace {

constexpr double anchor_radius = 0.2;

}  // namespace

ecs::Entity spawn_thing(ecs::World& world, const Thing& thing) {
    Motion motion;
    motion.position = thing.position;
    const Look look{thing.surface};
    // Body must be added last: adding it calls a hook that reads Motion.
    const auto e = thing.prop ? world.create(motion, look, Prop{}) : world.create(motion, look);
    world.add(e, thing.body);
    return e;
}

void spawn_arena(ecs::World& world, const Arena& arena) {
    for (const auto& thing : arena.things) spawn_thing(world, thing);
    for (const auto& position : arena.anchors) {
        Thing thing;
        thing.body.shape = physics::Shape::sphere;
        thing.body.size = {anchor_radius, 0, 0};
        thing.body.layer = layer::ground;
        thing.surface = Surface::anchor;
        thing.position = position;
        world.add<Anchor>(spawn_thing(world, thing));
    }
    for (const auto& pad : arena.pads) {
        Motion motion;
        motion.position = pad.feet;
        world.create(motion, Look{Surface::pad}, pad);
    }
    for (std::uint32_t i = 0; i < arena.power_ups.size(); ++i) {
        Motion motion;
        motion.position = arena.power_ups[i].position;
        world.create(motion, PowerUp{.kind = arena.power_ups[i].kind, .number = i});
    }
}

}  // namespace thaum::game::inline match
