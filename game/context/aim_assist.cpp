#include "game/context/aim_assist.h"

#include <algorithm>
#include <cmath>

#include "game/context/aim.h"
#include "game/context/arms.h"
#include "game/context/fog.h"
#include "game/data/wand_slots.h"

namespace thaum::game::inline context {
namespace {

/// Angle between crosshair and foe within which the view turns more slowly (rad)
constexpr double slow_zone = 4 * radians_per_degree;
/// Largest share of the player's turning speed that aim assist takes away: at full strength, with the
/// crosshair on the foe.
constexpr double max_slowed = 0.7;
constexpr double draw_rate = 40;  ///< speed at which aim assist turns the view towards the foe, per angle
                                  ///< that is left (rad/s per rad)
/// Largest speed at which the view is turned towards the foe (rad/s)
constexpr double fastest_draw = 120 * radians_per_degree;
constexpr double help_ends = 40;  ///< distance of the foe beyond which there is no aim assist (m)

/// How much the game helps a player to aim (aim assist), 0 (not at all) to 1 (fully).
double strength_for(const MatchContext& context, std::uint32_t player) {
    if (!context.data.rules.aim_assist) return 0;
    double strength = 0;
    for (const auto& device : context.input.devices) {
        if (device.player == player) strength = std::max(strength, device.aim_assist / 100.0);
    }
    return strength > 0 && plays_by_arm(context.world, player) ? 0 : strength;
}

/// Position of the foe's body relative to the line along which the player aims.
struct FoeBeside {
    vec3 point{};         ///< point of the axis of the foe's body that is nearest to the aim (m, world)
    double off{};         ///< angle from the aim to the nearest point of the foe's body (rad)
    double half_width{};  ///< half of the angle that the body's width subtends (rad)
};

double angle_off(vec3 a, vec3 b) { return det::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// The foe's body with its centre at `centre`, as seen from `from` along `aim`.
FoeBeside foe_beside(const WizardRules& rules, vec3 centre, vec3 from, vec3 aim) {
    const vec3 to = centre - from;
    const double flat_way = std::sqrt(to.x * to.x + to.z * to.z);
    const double flat_aim = std::max(1e-6, std::sqrt(aim.x * aim.x + aim.z * aim.z));
    const double half_axis = rules.height / 2 - rules.radius;
    const double height = std::clamp(aim.y / flat_aim * flat_way, to.y - half_axis, to.y + half_axis);
    const vec3 way(to.x, height, to.z);
    return {from + way, angle_off(aim, way), det::atan2(rules.radius, glm::length(way))};
}

/// The living foe of `player` within reach of aim assist; an invalid Entity if there is none.
ecs::Entity foe_in_reach(const MatchContext& context, std::uint32_t player, vec3 from) {
    const auto foe = wizard_of(context.world, 1 - player);
    if (!foe || context.world.has<Dead>(foe)) return {};
    const vec3 centre = context.physics.read().state(foe.index).position;
    return glm::distance(centre, from) <= help_ends ? foe : ecs::Entity{};
}

/// Point at which a straight shot from `from` meets the middle of the walking foe (m, world). If the wand in
/// hand has no straight shot (`speed` 0), the present middle of the foe.
vec3 meeting_point(const MatchContext& context, ecs::Entity foe, vec3 from, double speed) {
    const auto& body = context.physics.read().state(foe.index);
    if (!(speed > 0)) return body.position;
    const double flight = glm::distance(from, body.position) / speed;
    return body.position + flight * vec3(body.velocity.x, 0, body.velocity.z);
}

/// Speed of straight shots of the wand in hand (m/s); 0: the wand has none.
double speed_in_hand(const MatchContext& context, ecs::Entity wizard) {
    const auto* wand = wand_in_slot(context.data, context.world.get<WandBelt>(wizard).selected);
    const auto shot = wand != nullptr ? wand->rules->shot(1, context.data.wizard.gravity) : std::nullopt;
    return shot && shot->fall == 0 ? shot->speed : 0;
}

/// Adds to `help` the angles by which aim assist turns the view towards a point in this tick.
void draw_to(vec3 eye, vec3 point, const Gaze& gaze, double strength, ViewHelp& help) {
    const auto aim = aim_at(eye, point);
    const double left = angle_between(gaze.yaw, aim.yaw), up = aim.pitch - gaze.pitch;
    const double off = std::sqrt(left * left + up * up);
    if (off < 1e-9) return;
    const double step = std::min(off, strength * std::min(fastest_draw, draw_rate * off) * tick_seconds);
    help.left = left * step / off;
    help.up = up * step / off;
}

/// Whether nothing, not even fog, stands between the shooter and the foe.
bool sees(const MatchContext& context, ecs::Entity wizard, vec3 from, ecs::Entity foe) {
    const auto& physics = context.physics.read();
    const vec3 place = physics.state(foe.index).position;
    const auto hit = physics.ray(from, place, physics::all_layers, wizard.index);
    return hit && hit->key == foe.index && !hidden_by_fog(context.world, from, place);
}

vec3 turned_towards(vec3 from, vec3 to, double angle) {
    const vec3 across = to - from * glm::dot(from, to);
    const double length = glm::length(across);
    if (length < 1e-9) return from;
    return glm::normalize(from * det::cos(angle) + across / length * det::sin(angle));
}

}  // namespace

ViewHelp view_help(const MatchContext& context, ecs::Entity wizard) {
    const auto player = context.world.get<Wizard>(wizard).player;
    const double strength = strength_for(context, player);
    if (strength == 0 || context.world.has<Dead>(wizard)) return {};
    const auto& gaze = context.world.get<Gaze>(wizard);
    const auto& physics = context.physics.read();
    const vec3 eye = eye_of(context.data.wizard, physics.state(wizard.index).position);
    const auto foe = foe_in_reach(context, player, eye);
    if (!foe) return {};
    const auto& rules = context.data.wizard;
    const vec3 ahead = look_rotation(gaze.yaw, gaze.pitch) * vec3(0, 0, -1);
    const auto seen = foe_beside(rules, physics.state(foe.index).position, eye, ahead);
    const auto met =
        foe_beside(rules, meeting_point(context, foe, eye, speed_in_hand(context, wizard)), eye, ahead);
    const double beside = std::max(0.0, std::min(seen.off - seen.half_width, met.off - met.half_width));
    if (beside >= slow_zone || !sees(context, wizard, eye, foe)) return {};
    ViewHelp help{.turn_share = 1 - max_slowed * strength * (1 - beside / slow_zone)};
    if (beside < max_pull) draw_to(eye, met.point, gaze, strength, help);
    return help;
}

vec3 helped_aim(const MatchContext& context, ecs::Entity wizard, vec3 from, vec3 aim, double speed) {
    const auto player = context.world.get<Wizard>(wizard).player;
    const double strength = strength_for(context, player);
    if (strength == 0) return aim;
    const auto foe = foe_in_reach(context, player, from);
    if (!foe) return aim;
    const auto target = foe_beside(context.data.wizard, meeting_point(context, foe, from, speed), from, aim);
    const double pull = strength * max_pull;
    if (target.off > target.half_width + pull || !sees(context, wizard, from, foe)) return aim;
    return turned_towards(aim, glm::normalize(target.point - from), std::min(pull, target.off));
}

}  // namespace thaum::game::inline context
