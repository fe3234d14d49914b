#include "game/context/strikes.h"

#include "game/components/crystal.h"

namespace thaum::game::inline context {
namespace {

/// Distance of a position from the surface of a crystal's box (m); 0 inside.
double distance_from(const Crystal& crystal, vec3 place) {
    const vec3 at = rotation({0, 1, 0}, -crystal.yaw) * (place - crystal.middle);
    return glm::length(glm::max(glm::abs(at) - crystal.size / 2, vec3(0)));
}

}  // namespace

void strike(MatchContext& context, physics::Key struck, vec3 place, vec3 way, std::uint32_t player) {
    auto& world = context.world;
    const auto body = world.entity(struck);
    if (!body || !world.has<Crystal>(body)) return;
    world.commands().create(CrystalStrike{.crystal = body, .place = place, .way = way, .player = player});
}

void strike_by_burst(MatchContext& context, vec3 place, double size, std::uint32_t player) {
    if (!context.data.crystal) return;
    auto& world = context.world;
    const double reach = size + context.data.crystal->chip_burst_reach;
    std::as_const(world).view<const Crystal>().each([&](ecs::Entity e, const Crystal& crystal) {
        if (distance_from(crystal, place) > reach) return;
        world.commands().create(CrystalStrike{.crystal = e, .place = place, .way = {}, .player = player});
    });
}

void strike_by_thing(MatchContext& context, ecs::Entity crystal, const physics::Contact& contact,
                     std::uint32_t player, Tick tick) {
    auto& world = context.world;
    const auto& rules = *context.data.crystal;
    const auto chipped = std::as_const(world).get<Crystal>(crystal).chipped;
    const bool again = chipped != 0 && tick < chipped + rules.chip_again;
    if (again || contact.impulse < rules.chip_least_impulse) return;
    world.commands().create(
        CrystalStrike{.crystal = crystal, .place = contact.point, .way = {}, .player = player});
}

}  // namespace thaum::game::inline context
