#include "game/stations/crystal/chips.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline stations {
namespace {

/// Middle of the solid voxel nearest to a position (crystal frame); std::nullopt for an empty crystal.
std::optional<vec3> nearest_solid(const field::VoxelView& body, vec3 place) {
    std::optional<vec3> nearest;
    double least = HUGE_VAL;
    const vec3 first = body.first_place();
    for (int k = 0; k < body.count[2]; ++k) {
        for (int j = 0; j < body.count[1]; ++j) {
            for (int i = 0; i < body.count[0]; ++i) {
                if (!(body.density[body.at(i, j, k)] >= crystal_surface)) continue;
                const vec3 middle = first + body.spacing * vec3(i, j, k), off = middle - place;
                const double square = glm::dot(off, off);
                if (square < least) least = square, nearest = middle;
            }
        }
    }
    return nearest;
}

void chip(MatchContext& context, CrystalBodies& bodies, const CrystalStrike& strike, Tick tick) {
    auto& world = context.world;
    auto& crystal = world.get<Crystal>(strike.crystal);
    touch_crystal(context, bodies, crystal);
    const auto placement = placement_of(crystal);
    const vec3 from = field::to_own(placement, strike.place);
    const auto at = strike.way == vec3(0) ? nearest_solid(voxels_of(world, bodies, crystal), from)
                                          : surface_along(world, crystal, from, strike.way * placement.turn);
    if (!at) return;
    const auto edit = cut_crystal(context, bodies, crystal, context.data.crystal->chip, {.place = *at});
    if (edit.voxels == 0) return;
    crystal.chipped = std::max<Tick>(tick, 1);
    const double spacing = spacing_of(crystal);
    record(context, {.tick = tick,
                     .kind = EventKind::chipped,
                     .subject = crystal.carver,
                     .by = strike.player,
                     .amount = edit.removed / (spacing * spacing * spacing),
                     .place = field::to_parent(placement, *at)});
}

}  // namespace

void add_chip_system(MatchContext& context, CrystalResource& crystals, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "chips",
                  .writes = world.mask<CrystalStrike, Crystal, CrystalDensity, CrystalColour, EventLog,
                                       resource::Crystals, resource::Journal>(),
                  .needs = world.mask<CrystalStrike>(),
                  .run = [&context, &crystals](ecs::World& w, Tick tick) {
                      w.view<const CrystalStrike>().each([&](ecs::Entity e, const CrystalStrike& strike) {
                          chip(context, crystals.write(), strike, tick);
                          w.commands().destroy(e);
                      });
                  }});
}

}  // namespace thaum::game::inline stations
