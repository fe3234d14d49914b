#include "game/wands/shot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/text.h"
#include "game/components/grip.h"
#include "game/match/touch.h"

namespace thaum::game {
namespace {

constexpr double aim_reach = 60;     ///< m; the crosshair's depth where it meets nothing nearer
constexpr double nearest_aim = 1.0;  ///< m; nearer things would make a shot leave sideways

bool blocked(const physics::Physics& physics, vec3 from, vec3 to, double radius, physics::Key ignored) {
    return radius > 0 ? physics.sweep_sphere(from, to, radius, physics::all_layers, ignored).has_value()
                      : physics.ray(from, to, physics::all_layers, ignored).has_value();
}

/// The point of a body that a burst sees: its middle; of what stands upright the nearest of its axis.
vec3 middle_towards(const Body& body, vec3 centre, vec3 from) {
    if (body.upright == 0) return centre;
    return centre + vec3(0, std::clamp(from.y - centre.y, -body.size.y, body.size.y), 0);
}

/// What a burst does to one body.
struct Reached {
    double share{};  ///< of all that it does, > 0
    vec3 away{};     ///< unit
    vec3 point{};    ///< m, on the body's surface
};

/// Nothing where the body is too far off or behind another.
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

void push(Stage& stage, const Burst& burst, ecs::Entity e, double mass, const Reached& reached, Tick tick) {
    const double impulse = std::min(burst.impulse * reached.share, burst.fastest * mass);
    stage.physics.apply_impulse(e.index, reached.away * impulse, reached.point);
    if (stage.world.has<Prop>(e)) stage.world.get<Prop>(e) = {.moved_at = tick, .moved_by = burst.player};
}

void hurt_by_burst(Stage& stage, const Burst& burst, ecs::Entity e, double points, Tick tick) {
    if (!stage.world.has<Wizard>(e)) return;
    hurt(stage.world, e, tick,
         {.points = points, .by = burst.player, .how = burst.how, .place = burst.place});
}

}  // namespace

Growing read_growing(const ConfigTable& table, std::string_view name, std::string_view full, Range range) {
    const Growing read{table.number(name, range), table.number(full, range)};
    if (read.most < read.least) table.report(full, text("'", full, "' must not be less than ", name));
    return read;
}

bool holds_fire(const Controls& controls) {
    return ((controls.held | controls.pressed) & input::bit(input::Button::fire)) != 0;
}

Sight sight_of(const Stage& stage, ecs::Entity wizard) {
    const auto& gaze = std::as_const(stage.world).get<Gaze>(wizard);
    return {eye_of(stage.data.wizard, stage.physics.state(wizard.index).position),
            look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1)};
}

Muzzle muzzle_of(const WandUse& use, double radius) {
    const auto& world = std::as_const(use.stage.world);
    const auto& physics = use.stage.physics;
    const auto& gaze = world.get<Gaze>(use.wizard);
    const auto key = use.wizard.index;
    const quat looking = look_rotation(gaze.yaw, gaze.pitch);
    const vec3 eye = eye_of(use.stage.data.wizard, world.get<Motion>(use.wizard).position);
    const vec3 ahead = looking * vec3(0, 0, -1);
    const auto seen = physics.ray(eye, eye + ahead * aim_reach, physics::all_layers, key);
    const double depth = std::max(nearest_aim, seen ? seen->fraction * aim_reach : aim_reach);
    const double wand_per_hand = use.stage.touch.wand_per_hand[world.get<Wizard>(use.wizard).player];
    vec3 tip = eye + looking * wand_tip_of(wand_per_hand, world.get<Grip>(use.wizard));
    if (blocked(physics, eye, tip, radius, key)) tip = eye;
    return {.tip = tip, .ahead = ahead, .aim = glm::normalize(eye + ahead * depth - tip)};
}

void note_dry(const WandUse& use) {
    const auto player = std::as_const(use.stage.world).get<Wizard>(use.wizard).player;
    record(use.stage.world, {.tick = use.tick, .kind = EventKind::dry, .subject = player, .by = player});
}

void note_shot(const WandUse& use, EventKind hit, vec3 tip) {
    auto& world = use.stage.world;
    ++world.get<WandBelt>(use.wizard).fired;
    world.get<Health>(use.wizard).shielded_until = use.tick;
    const auto player = std::as_const(world).get<Wizard>(use.wizard).player;
    record(world, {.tick = use.tick,
                   .kind = EventKind::shot,
                   .subject = player,
                   .by = player,
                   .detail = static_cast<std::uint32_t>(hit),
                   .place = tip});
}

void burst(Stage& stage, const Burst& burst, Tick tick) {
    record(stage.world, {.tick = tick,
                         .kind = EventKind::burst,
                         .subject = burst.player,
                         .by = burst.player,
                         .detail = static_cast<std::uint32_t>(burst.how),
                         .amount = burst.radius,
                         .place = burst.place});
    stage.world.view<const Body, const Motion>().each(
        [&](ecs::Entity e, const Body& body, const Motion& motion) {
            if (body.mass <= 0) return;
            const auto middle = middle_towards(body, motion.position, burst.place);
            const auto reached = reach(stage.physics, burst, e.index, middle);
            if (reached) push(stage, burst, e, body.mass, *reached, tick);
            if (e.index == burst.struck)
                hurt_by_burst(stage, burst, e, burst.struck_damage, tick);
            else if (reached)
                hurt_by_burst(stage, burst, e, burst.damage * reached->share, tick);
        });
}

}  // namespace thaum::game
