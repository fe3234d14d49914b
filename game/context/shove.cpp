#include "game/context/shove.h"

namespace thaum::game::inline context {

void shove(MatchContext& context, ecs::Entity body, vec3 impulse, vec3 point, std::uint32_t player,
           Tick tick) {
    auto& world = context.world;
    context.physics.write().apply_impulse(body.index, impulse, point);
    if (world.has<Prop>(body)) world.get<Prop>(body) = {.moved_at = tick, .moved_by = player};
    if (world.has<Wizard>(body)) world.get<Stance>(body).loose_until = tick + context.data.wizard.loose;
}

}  // namespace thaum::game::inline context
