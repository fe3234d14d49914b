#include "game/bots/senses.h"

#include <algorithm>
#include <cmath>

#include "game/context/fog.h"
#include "game/context/hand_forces.h"
#include "game/data/wand_slots.h"

namespace thaum::game::inline bots {
namespace {

/// Number of gameplay ticks between the two observations from which the foe's velocity is taken.
constexpr std::uint64_t stride = 12;
constexpr double noticed_within = 2.0;  ///< distance within which a thing is noticed without being seen (m)
constexpr vec3 head{0, 0.5, 0};         ///< position of the head relative to the chest (m)
constexpr double bolt_reach = 0.9;      ///< distance from the bot beyond which a passing bolt is ignored (m)
/// Distance within which a passing shot counts as aimed at the bot (m).
constexpr double shot_near = 2.0;
constexpr double bolt_soon = 0.7;  ///< time until the impact beyond which a bolt is still ignored (s)

/// Whether the place is in the bot's field of view, and no fog hides it.
bool in_view(const Simulation& match, const Self& self, const Seat& seat, vec3 place) {
    const vec3 to = place - self.eye;
    const double distance = glm::length(to);
    return distance > 1e-6 && glm::dot(to / distance, self.ahead) >= seat.skill.view_cos &&
           !hidden_by_fog(match.world(), self.eye, place);
}

Glimpse look(const Simulation& match, const Self& self, const Seat& seat) {
    const auto& world = match.world();
    const auto foe = wizard_of(world, 1 - seat.player);
    if (world.has<Dead>(foe)) return {};
    const vec3 chest = world.get<Motion>(foe).position + vec3(0, 0.2, 0);
    if (!in_view(match, self, seat, chest)) return {};
    const auto hidden = [&](vec3 place) {
        const auto hit = match.physics().ray(self.eye, place, physics::all_layers, self.key);
        return hit && hit->key != foe.index ? match.physics().desc(hit->key).layer : 0;
    };
    // A loose thing that one of the wizards holds may hide the foe's chest. Then it is enough for the bot to
    // see the head.
    const auto by = hidden(chest);
    if (by != 0 && ((by & layer::prop) == 0 || hidden(chest + head) != 0)) return {};
    return {chest, 1};
}

/// Search for the bolt that arrives first, and for the step that avoids it.
struct Threat {
    const Simulation& match;
    const Self& self;
    const Seat& seat;
    const Mind& mind;
    double soonest = bolt_soon;
    std::int32_t step = 0;
};

void judge(const Missile& missile, Threat& threat) {
    const double speed = glm::length(missile.velocity);
    if (missile.player == threat.seat.player || speed < 1) return;
    // A bot reacts only to a missile that has been in the air for its reaction time.
    const double flown = glm::distance(missile.position, threat.mind.foe) / speed;
    if (flown < seconds(threat.seat.skill.reaction)) return;
    const vec3 way = missile.velocity / speed;
    const vec3 to_self = threat.self.centre - missile.position;
    const double ahead = glm::dot(to_self, way);
    const double when = ahead / speed;
    if (when <= 0 || when >= threat.soonest) return;
    const vec3 off = to_self - way * ahead;
    if (glm::length(off) > bolt_reach) return;
    // Few missiles come so near, so the costliest test is the last one.
    if (!in_view(threat.match, threat.self, threat.seat, missile.position)) return;
    const vec3 right = look_rotation(threat.self.yaw, 0) * vec3(1, 0, 0);
    threat.soonest = when;
    threat.step = glm::dot(off, right) >= 0 ? 1 : -1;
}

}  // namespace

Self self_of(const Simulation& match, std::uint32_t player, double readiness) {
    const auto& world = match.world();
    const auto wizard = wizard_of(world, player);
    const auto& motion = world.get<Motion>(wizard);
    const auto& gaze = world.get<Gaze>(wizard);
    const auto& belt = world.get<WandBelt>(wizard);
    Self self{.centre = motion.position,
              .eye = eye_of(match.data().wizard, motion.position),
              .velocity = motion.velocity,
              .yaw = gaze.yaw,
              .pitch = gaze.pitch,
              .health = world.get<Health>(wizard).points,
              .hit_at = world.get<Health>(wizard).foe_did_at,
              .key = wizard.index,
              .alive = !world.has<Dead>(wizard)};
    const vec3 tip = wand_tip_of(match.haptic_setup().wand_per_hand[player], world.get<HandState>(wizard));
    const quat look = look_rotation(gaze.yaw, gaze.pitch);
    self.tip = self.eye + look * tip;
    self.ahead = look * vec3(0, 0, -1);
    if (const auto* wand = wand_in_hand(match.data(), belt)) {
        const auto& stats = wand->stats;
        self.wand = stats.slot;
        self.readiness = wand->rules->readiness(world, wizard).value_or(self.readiness);
        const auto shot = wand->rules->shot(std::max(readiness, self.readiness), match.data().wizard.gravity);
        self.shot = shot.value_or(self.shot);
        const double energy = energy_in_hand(match.data(), belt);
        self.can_shoot = shot && energy >= std::max(stats.energy_cost, self.shot.energy);
        self.energy_share = stats.energy_cap > 0 ? energy / stats.energy_cap : 1;
        self.held = wand->rules->held_at(world, wizard);
    }
    return self;
}

void see_foe(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes, Mind& mind, Tick tick) {
    eyes.glimpses[eyes.looks % bot_memory] = look(match, self, seat);
    const auto delay =
        std::min<std::uint64_t>(seat.skill.reaction / gameplay_period, bot_memory - 1 - stride);
    if (eyes.looks >= delay + stride) {
        const auto& then = eyes.glimpses[(eyes.looks - delay) % bot_memory];
        const auto& before = eyes.glimpses[(eyes.looks - delay - stride) % bot_memory];
        if (then.seen != 0) {
            mind.foe = then.chest;
            mind.foe_seen_at = tick;
            const vec3 moved = then.chest - before.chest;
            mind.foe_velocity = before.seen != 0 ? moved / (stride * gameplay_dt) : vec3(0);
        }
    }
    ++eyes.looks;
}

void see_power_ups(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes) {
    const auto count = std::min(match.data().arena.power_ups.size(), max_power_ups);
    if (count == 0) return;
    const auto number = static_cast<std::uint32_t>(eyes.looks % count);
    const vec3 place = match.data().arena.power_ups[number].position + vec3(0, 0.5, 0);
    const bool near = glm::distance(place, self.centre) < noticed_within;
    if (!near && (!in_view(match, self, seat, place) || match.physics().ray(self.eye, place, layer::ground)))
        return;
    match.world().view<const PowerUp>().each([&](const PowerUp& p) {
        if (p.number == number) eyes.back_at[number] = p.back_at;
    });
}

void see_things(const Simulation& match, const Self& self, const Seat& seat, Eyes& eyes) {
    const auto count = std::min<std::uint64_t>(match.world().count<Prop>(), max_things);
    if (count == 0) return;
    const auto number = eyes.looks % count;
    std::uint64_t i = 0;
    match.world().view<const Prop, const Motion>().each(
        [&](ecs::Entity e, const Prop&, const Motion& motion) {
            if (i++ != number) return;
            const vec3 place = motion.position;
            const bool near = glm::distance(place, self.centre) < noticed_within;
            if (!near && !in_view(match, self, seat, place)) return;
            const auto hit = match.physics().ray(self.eye, place, physics::all_layers, self.key);
            if (hit && hit->key == e.index) eyes.things[number] = {e, place};
        });
}

bool crosshair_on(const Simulation& match, const Self& self, ecs::Entity thing, double reach) {
    const vec3 end = self.eye + self.ahead * reach;
    const auto hit = match.physics().ray(self.eye, end, physics::all_layers, self.key);
    return hit && hit->key == thing.index;
}

bool sees_a_shot_come(const Simulation& match, const Self& self, const Seat& seat) {
    bool comes = false;
    const auto note = [&](const Missile& missile) {
        const vec3 to = self.centre - missile.position;
        const double ahead = glm::dot(to, missile.velocity);
        if (comes || missile.player == seat.player || ahead <= 0) return;
        const double speed = glm::length(missile.velocity);
        const double off = glm::length(to - missile.velocity * (ahead / (speed * speed)));
        comes = off < shot_near && in_view(match, self, seat, missile.position);
    };
    for (const auto& wand : match.data().wands) {
        // A lambda with one reference fits into std::function without an allocation.
        wand.rules->show(match.world(), [&note](const Missile& missile) { note(missile); });
    }
    return comes;
}

std::int32_t step_aside(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind) {
    Threat threat{.match = match, .self = self, .seat = seat, .mind = mind};
    for (const auto& wand : match.data().wands) {
        wand.rules->show(match.world(), [&threat](const Missile& missile) { judge(missile, threat); });
    }
    return threat.step;
}

}  // namespace thaum::game::inline bots
