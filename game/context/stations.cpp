#include "game/context/stations.h"

#include <cmath>
#include <type_traits>
#include <utility>

#include "game/components/cauldron.h"
#include "game/components/crystal.h"
#include "game/components/orb.h"
#include "game/components/wizard.h"

namespace thaum::game::inline context {
namespace {

/// Time constant of the turn of the view to the cauldron, orb or crystal at which a wizard begins to work
/// (s). After this time, 1/e of the angle is left.
constexpr double turning_time = 0.15;

void turn_eyes(const WizardRules& rules, vec3 body, const AtStation& station, Gaze& gaze) {
    const vec3 way = station.middle - eye_of(rules, body);
    const double share = tick_seconds / turning_time;
    const double left = std::remainder(station.yaw - gaze.yaw, 2 * pi);
    gaze.yaw = std::remainder(gaze.yaw + share * left, 2 * pi);
    gaze.pitch += share * (det::atan2(way.y, off_axis(way)) - gaze.pitch);
}

}  // namespace

bool at_station(const ecs::World& world, ecs::Entity wizard) { return world.has<AtStation>(wizard); }

bool is_near_station(const WizardRules& rules, vec3 body, vec3 middle, double reach) {
    return off_axis(body - middle) < reach && std::abs(body.y - middle.y) < rules.height;
}

AtStation station_at(vec3 body, vec3 middle, StationKind kind, std::uint32_t number) {
    const vec3 in = middle - body;
    return {.middle = middle, .yaw = det::atan2(-in.x, -in.z), .kind = kind, .number = number};
}

void leave_station(ecs::World& world, ecs::Entity wizard) {
    const auto drop = [&]<class Part>(std::type_identity<Part>) {
        if (std::as_const(world).has<Part>(wizard)) world.remove<Part>(wizard);
    };
    drop(std::type_identity<AtStation>{});
    drop(std::type_identity<Ladle>{});
    drop(std::type_identity<Scrying>{});
    drop(std::type_identity<Chisel>{});
}

void add_station_gaze_system(MatchContext& context, ecs::Schedule& schedule) {
    auto& world = context.world;
    schedule.add({.name = "eyes at stations",
                  .reads = world.mask<Motion, AtStation>(),
                  .writes = world.mask<Gaze>(),
                  .needs = world.mask<AtStation>(),
                  .run = [&context](ecs::World& w, Tick) {
                      w.view<const Motion, const AtStation, Gaze>().each(
                          [&](ecs::Entity, const Motion& motion, const AtStation& station, Gaze& gaze) {
                              turn_eyes(context.data.wizard, motion.position, station, gaze);
                          });
                  }});
}

}  // namespace thaum::game::inline context
