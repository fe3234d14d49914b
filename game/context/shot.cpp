#include "game/context/shot.h"

#include <algorithm>
#include <optional>

#include "core/text.h"
#include "game/components/hand_state.h"
#include "game/context/aim_assist.h"
#include "game/context/hand_forces.h"
#include "game/context/shove.h"
#include "game/context/strikes.h"

namespace thaum::game::inline context {
namespace {

/// Distance of the point aimed at if nothing nearer is under the crosshair (m)
constexpr double aim_reach = 60;
/// Minimum distance of the point aimed at (m). A shot from the wand's tip to a nearer point would fly
/// sideways.
constexpr double nearest_aim = 1.0;

bool blocked(const physics::Physics& physics, vec3 from, vec3 to, double radius, physics::Key ignored) {
    return radius > 0 ? physics.sweep_sphere(from, to, radius, physics::all_layers, ignored).has_value()
                      : physics.ray(from, to, physics::all_layers, ignored).has_value();
}

/// Point of a body at which a burst (a missile's explosion) acts: the body's middle, or for an upright body
/// the nearest point of its axis.
vec3 middle_towards(const Body& body, vec3 centre, vec3 from) {
    if (body.upright == 0) return centre;
    return centre + vec3(0, std::clamp(from.y - centre.y, -body.size.y, body.size.y), 0);
}

/// Effect of a burst (a missile's explosion) on one body.
struct Reached {
    double share{};  ///< fraction of the full effect of the burst (explosion) on the body, > 0
    vec3 away{};     ///< direction of the impulse on the body (unit)
    vec3 point{};    ///< point on the body's surface (m, world)
};

/// Effect of a burst (a missile's explosion) on one body; std::nullopt if the body is too far away or behind
/// another body.
std::optional<Reached> reach(const physics::Physics& physics, const Burst& burst, physics::Key key,
                             vec3 middle) {
    constexpr double touching = 1e-6;
    const vec3 to = middle - burst.place;
    const double whole = glm::length(to);
    if (whole < touching) return Reached{1, vec3(0, 1, 0), middle};
    const vec3 away = to / whole;
    const double seen = std::min(whole, burst.radius + burst.size);
    const auto ignored = key == burst.shooter ? physics::no_key : burst.shooter;
    const auto hit = physics.ray(burst.place, burst.place + away * seen, physics::all_layers, ignored);
    if (!hit || hit->key != key) return {};
    const double distance = std::max(0.0, hit->fraction * seen - burst.size);
    if (distance >= burst.radius) return {};
    return Reached{1 - distance / burst.radius, away, hit->point};
}

void push(MatchContext& context, const Burst& burst, ecs::Entity e, double mass, const Reached& reached,
          Tick tick) {
    const double impulse = std::min(burst.impulse * reached.share, burst.fastest * mass);
    shove(context, e, reached.away * impulse, reached.point, burst.player, tick);
}

void hurt_by_burst(MatchContext& context, const Burst& burst, ecs::Entity e, double points, Tick tick) {
    if (!context.world.has<Wizard>(e)) return;
    if (burst.venom > 0 && points > 0 && !context.world.has<Dead>(e)) {
        auto& health = context.world.get<Health>(e);
        if (tick >= health.shielded_until) {
            health.poison = burst.venom;
            health.poisoned_until = tick + burst.venom_lasts;
            health.poisoned_by = burst.player;
        }
    }
    hurt(context, e, tick,
         {.points = points,
          .by = burst.player,
          .how = burst.how,
          .place = burst.place,
          .pierces = burst.pierces});
}

}  // namespace

GrowingValue read_growing(const ConfigTable& table, std::string_view name, std::string_view full,
                          Range range) {
    const GrowingValue read{table.number(name, range), table.number(full, range)};
    if (read.most < read.least) table.report(full, text("'", full, "' must not be less than ", name));
    return read;
}

bool holds_fire(const Controls& controls) {
    return ((controls.held | controls.pressed) & input::bit(input::Button::fire)) != 0;
}

Sight sight_of(const MatchContext& context, ecs::Entity wizard) {
    const auto& gaze = std::as_const(context.world).get<Gaze>(wizard);
    return {eye_of(context.data.wizard, context.physics.read().state(wizard.index).position),
            look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1)};
}

Muzzle muzzle_of(const WandUse& use, double radius) {
    const auto& world = std::as_const(use.context.world);
    const auto& physics = use.context.physics.read();
    const auto& gaze = world.get<Gaze>(use.wizard);
    const auto key = use.wizard.index;
    const quat looking = look_rotation(gaze.yaw, gaze.pitch);
    const vec3 eye = eye_of(use.context.data.wizard, world.get<Motion>(use.wizard).position);
    const vec3 ahead = looking * vec3(0, 0, -1);
    const auto seen = physics.ray(eye, eye + ahead * aim_reach, physics::all_layers, key);
    const double depth = std::max(nearest_aim, seen ? seen->fraction * aim_reach : aim_reach);
    const double wand_per_hand =
        use.context.input.haptic_setup.wand_per_hand[world.get<Wizard>(use.wizard).player];
    vec3 tip = eye + looking * wand_tip_of(wand_per_hand, world.get<HandState>(use.wizard));
    if (blocked(physics, eye, tip, radius, key)) tip = eye;
    return {.tip = tip, .ahead = ahead, .aim = glm::normalize(eye + ahead * depth - tip)};
}

void help_aim(const WandUse& use, double speed, Muzzle& muzzle) {
    muzzle.aim = helped_aim(use.context, use.wizard, muzzle.tip, muzzle.aim, speed);
}

void note_dry(const WandUse& use) {
    const auto player = std::as_const(use.context.world).get<Wizard>(use.wizard).player;
    record(use.context, {.tick = use.tick, .kind = EventKind::dry, .subject = player, .by = player});
}

void note_shot(const WandUse& use, EventKind hit, vec3 tip) {
    auto& world = use.context.world;
    ++world.get<WandBelt>(use.wizard).fired;
    world.get<Health>(use.wizard).shielded_until = use.tick;
    const auto player = std::as_const(world).get<Wizard>(use.wizard).player;
    record(use.context, {.tick = use.tick,
                         .kind = EventKind::shot,
                         .subject = player,
                         .by = player,
                         .detail = static_cast<std::uint32_t>(hit),
                         .place = tip});
}

void burst(MatchContext& context, const Burst& burst, Tick tick) {
    record(context, {.tick = tick,
                     .kind = EventKind::burst,
                     .subject = burst.player,
                     .by = burst.player,
                     .detail = static_cast<std::uint32_t>(burst.how),
                     .amount = burst.radius,
                     .place = burst.place});
    strike_by_burst(context, burst.place, burst.size, burst.player);
    const auto& physics = context.physics.read();
    context.world.view<const Body, const Motion>().each(
        [&](ecs::Entity e, const Body& body, const Motion& motion) {
            if (body.mass <= 0) return;
            const auto middle = middle_towards(body, motion.position, burst.place);
            const auto reached = reach(physics, burst, e.index, middle);
            if (reached) push(context, burst, e, body.mass, *reached, tick);
            if (e.index == burst.struck)
                hurt_by_burst(context, burst, e, burst.struck_damage, tick);
            else if (reached)
                hurt_by_burst(context, burst, e, burst.damage * reached->share, tick);
        });
}

}  // namespace thaum::game::inline context
