#include "game/bots/lifting.h"

#include <algorithm>
#include <cmath>

#include "game/bots/armoury.h"
#include "game/bots/senses.h"
#include "game/match/bodies.h"

// What a thing is worth is the harm that it would do over the time that it takes to throw it.
namespace thaum::game {
namespace {

using input::bit;
using input::Button;

constexpr double handy = 0.8;        ///< of the wand's reach: from there it takes a thing up
constexpr double too_near = 1.8;     ///< m along the ground; it would touch who holds it
constexpr double near_foe = 3;       ///< m; one does not turn away from a foe who is nearer
constexpr double far_foe = 15;       ///< m; too far for a throw
constexpr double least_harm = 8;     ///< HP
constexpr double carrying_cost = 8;  ///< of energy, about, until it is thrown
constexpr double cost_per_kg = 0.3;  ///< likewise
constexpr double walk_pace = 4;      ///< m/s
constexpr double turn_pace = 1.5;    ///< rad/s, with a thing in hand
constexpr double time_to_take = 1;   ///< s
constexpr Tick come_time = ticks(3.0), take_time = ticks(1.4), press_time = ticks(0.03);
constexpr Tick last_chance = ticks(1.0);
constexpr Tick lull = ticks(0.3);
constexpr double shield_height = 0.2;  ///< m above the body's middle

struct Lifter {
    const LoadedWand& wand;
    GraspKind grasp;
    double energy;
};

std::optional<Lifter> lifter_of(const Simulation& match, const Seat& seat) {
    const auto& belt = match.world().get<WandBelt>(wizard_of(match.world(), seat.player));
    for (const auto& wand : match.data().wands) {
        if (wand.kind->grasp == nullptr) continue;
        return Lifter{wand, wand.kind->grasp(wand.data.get()), belt.energy[wand.stats.energy_slot]};
    }
    return {};
}

/// HP, of one who is struck squarely.
double harm_of(const WizardRules& rules, double mass, double speed) {
    const double impulse = mass * rules.mass / (mass + rules.mass) * speed;
    return harm_of_blow(rules, impulse);
}

/// m, from the middle to the farthest point.
double size_of(const physics::BodyDesc& body) {
    switch (body.shape) {
        case physics::Shape::box: return glm::length(body.size);
        case physics::Shape::sphere: return body.size.x;
        default: return body.size.x + body.size.y;
    }
}

double along_ground(vec3 from, vec3 to) { return glm::length(vec2(to.x - from.x, to.z - from.z)); }

/// HP a second; 0 where it is of no use.
double worth_of(const Simulation& match, const Self& self, const Seat& seat, const WalkGrid& grid,
                const Mind& mind, const Lifter& lifter, const Sighting& seen) {
    const auto key = seen.thing.index;
    if (!match.world().alive(seen.thing) || !match.physics().has(key)) return 0;
    const auto& body = match.physics().desc(key);
    const vec3 to = seen.place - self.eye;
    const double distance = glm::length(to);
    const double walk = std::max(0.0, distance - handy * lifter.grasp.reach);
    const bool fits = body.mass <= lifter.grasp.mass_max && size_of(body) <= seat.skill.lift.largest;
    if (!fits || walk > seat.skill.lift.seek || along_ground(self.eye, seen.place) < too_near) return 0;
    const double speed =
        throw_speed(lifter.grasp, body.mass, lifter.energy - carrying_cost - cost_per_kg * body.mass);
    const double harm = harm_of(match.data().wizard, body.mass, speed);
    if (harm < least_harm || (walk > 0 && !grid.straight(self.centre, seen.place))) return 0;
    const vec3 to_foe = mind.foe - self.eye;
    const double turn = det::acos(
        std::clamp(glm::dot(to, to_foe) / std::max(1e-9, distance * glm::length(to_foe)), -1.0, 1.0));
    return harm / (time_to_take + walk / walk_pace + turn / turn_pace);
}

const Sighting* best_thing(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
                           const WalkGrid& grid, const Mind& mind, const Lifter& lifter) {
    const Sighting* best = nullptr;
    double most = 0;
    for (const auto& seen : eyes.things) {
        if (!seen.thing) continue;
        const double worth = worth_of(match, self, seat, grid, mind, lifter, seen);
        if (worth > most) most = worth, best = &seen;
    }
    return best;
}

void end(const Seat& seat, Mind& mind, Porter& porter, Tick tick) {
    if (hands_full(porter)) {
        mind.buttons &= ~(bit(Button::fire) | bit(Button::throw_));
        mind.wand_until = tick;  // another wand
    }
    porter.what = Porting::none;
    porter.not_before = tick + ticks(seconds(seat.skill.lift.rest) * mind.random.uniform(0.6, 1.4));
    if (mind.errand == Errand::lift) mind.errand = Errand::none;
}

void consider(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
              const WalkGrid& grid, Mind& mind, Porter& porter, Tick tick) {
    const double distance = glm::distance(self.eye, mind.foe);
    const bool knows = mind.foe_seen_at != 0 && tick <= mind.foe_seen_at + ticks(2.0);
    if (!knows || distance < near_foe || distance > far_foe || mind.errand != Errand::none) return;
    if (tick < porter.not_before) return;
    porter.not_before = tick + ticks(0.5);
    const bool readying = self.shot.held && (mind.buttons & bit(Button::fire)) != 0;
    if (readying || mind.random.uniform() >= seat.skill.lift.share) return;
    const auto lifter = lifter_of(match, seat);
    if (!lifter) return;
    const auto* found = best_thing(match, self, seat, eyes, grid, mind, *lifter);
    if (found == nullptr) return;
    porter.thing = found->thing;
    porter.place = found->place;
    porter.what = Porting::approach;
    porter.until = tick + come_time;
}

void come_nearer(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes, Mind& mind,
                 Porter& porter, Tick tick) {
    for (const auto& seen : eyes.things) {
        if (seen.thing == porter.thing) porter.place = seen.place;
    }
    const auto lifter = lifter_of(match, seat);
    const bool wanted = mind.errand == Errand::none || mind.errand == Errand::lift;
    if (!wanted || !lifter || tick >= porter.until || along_ground(self.eye, porter.place) < too_near)
        return end(seat, mind, porter, tick);
    mind.errand = Errand::lift;
    mind.goal = porter.place;
    if (glm::distance(self.eye, porter.place) > handy * lifter->grasp.reach) return;
    const auto hit = match.physics().ray(self.eye, porter.place, physics::all_layers, self.key);
    if (!hit || hit->key != porter.thing.index) return;
    mind.errand = Errand::none;
    mind.buttons &= ~bit(Button::fire);
    mind.wand = lifter->wand.stats.slot;
    porter.what = Porting::take;
    porter.until = tick + take_time;
}

/// Presses fire when the crosshair is on it; where that took nothing, lets go and tries again.
Aim take_up(const Simulation& match, const Self& self, const Seat& seat, const Lifter& lifter, Mind& mind,
            Porter& porter, Tick tick) {
    const auto fire = bit(Button::fire);
    const vec3 place = match.world().get<Motion>(porter.thing).position;
    const Aim aim = aim_at(self.eye, place);
    if (in_hand(self, mind) && self.held) {
        porter.what = Porting::hold;
        porter.until = tick + seat.skill.lift.hold;
        mind.buttons |= fire;
    } else if (tick >= porter.until) {
        end(seat, mind, porter, tick);
    } else if (mind.wand == self.wand && (mind.buttons & fire) == 0) {
        if (!crosshair_on(match, self, porter.thing, lifter.grasp.reach)) return aim;
        porter.off_left = angle_between(self.yaw, aim.yaw);
        porter.off_up = aim.pitch - self.pitch;
        mind.buttons |= fire;
        mind.fire_from = tick;
    } else if (tick >= mind.fire_from + press_time) {
        mind.buttons &= ~fire;
    }
    return aim;
}

void note_shots(const Simulation& match, const Self& self, const Seat& seat, Porter& porter, Tick tick) {
    if (!sees_a_shot_come(match, self, seat)) return;
    if (tick >= porter.shot_at + 2 * lull) porter.shots_from = tick;
    porter.shot_at = tick;
}

/// It knows a reaction time later, and believes it for a moment after the last one.
bool under_fire(const Seat& seat, const Porter& porter, Tick tick) {
    const Tick later = seat.skill.reaction;
    return porter.shot_at != 0 && tick >= porter.shots_from + later && tick < porter.shot_at + later + lull;
}

/// So that the thing, as far away as it is, stands in the way of what comes from the foe.
Aim aim_to_guard(const Self& self, const Mind& mind, const Porter& porter) {
    const vec3 chest = self.centre + vec3(0, shield_height, 0);
    const vec3 way = mind.foe - chest;
    const double share = glm::distance(self.eye, *self.held) / std::max(1e-6, glm::length(way));
    Aim aim = aim_at(self.eye, chest + way * std::min(1.0, share));
    aim.yaw -= porter.off_left;
    aim.pitch -= porter.off_up;
    return aim;
}

/// What a throw from where the thing is would have to be, and what it would be now.
struct Throw {
    vec3 target{};  ///< m
    vec3 wanted{};  ///< unit
    vec3 now{};     ///< unit
    double harm{};  ///< HP
};

vec3 along(Aim aim) { return look_rotation(aim.yaw, aim.pitch) * vec3(0, 0, -1); }

Throw plan_throw(const Simulation& match, const Self& self, const Seat& seat, const Mind& mind,
                 const Lifter& lifter, const Porter& porter) {
    const double mass = match.physics().desc(porter.thing.index).mass;
    const vec3 thing = *self.held;
    Self from_there = self;
    from_there.eye = from_there.tip = thing;
    from_there.shot = {.speed = throw_speed(lifter.grasp, mass, lifter.energy),
                       .fall = -match.physics().settings().gravity.y};
    Throw t{.target = aim_point(from_there, seat, mind, seat.skill.lift.lead),
            .harm = harm_of(match.data().wizard, mass, from_there.shot.speed)};
    t.wanted = along(aim_of_shot(from_there, t.target));
    const vec3 crossing = self.eye + along({self.yaw, self.pitch}) * lifter.grasp.crossing - thing;
    t.now = crossing / std::max(1e-9, glm::length(crossing));
    return t;
}

/// Holds it up until the throw is right, or before itself while shots come.
Aim hold_and_throw(const Simulation& match, const Self& self, const Seat& seat, const Lifter& lifter,
                   Mind& mind, Porter& porter, Tick tick) {
    const Aim as_it_is{self.yaw, self.pitch};
    if (!in_hand(self, mind) || !self.held || tick >= porter.until + last_chance) {
        end(seat, mind, porter, tick);
        return as_it_is;
    }
    const bool waits = tick < porter.until;
    const bool guards = seat.skill.lift.guards != 0 && under_fire(seat, porter, tick);
    if (guards && waits) return aim_to_guard(self, mind, porter);
    const vec3 thing = *self.held;
    const auto t = plan_throw(match, self, seat, mind, lifter, porter);
    if (t.harm < least_harm) {  // it has cost too much so far
        end(seat, mind, porter, tick);
        return as_it_is;
    }
    const bool sees = mind.foe_seen_at != 0 && tick <= mind.foe_seen_at + ticks(0.4);
    const double off = det::acos(std::clamp(glm::dot(t.wanted, t.now), -1.0, 1.0));
    if (sees && off < seat.skill.lift.within * (waits ? 1 : 2) &&
        !match.physics().ray(thing, t.target, layer::ground))
        mind.buttons |= bit(Button::throw_);
    const double rest = lifter.grasp.crossing - glm::distance(thing, self.eye);
    return aim_at(self.eye, thing + t.wanted * std::max(1.0, rest));
}

}  // namespace

void plan_to_lift(const Simulation& match, const Self& self, const Seat& seat, const Eyes& eyes,
                  const WalkGrid& grid, Mind& mind, Porter& porter, Tick tick) {
    if (seat.skill.lift.share <= 0) return;
    if (seat.skill.lift.guards != 0) note_shots(match, self, seat, porter, tick);
    if (porter.what == Porting::none) consider(match, self, seat, eyes, grid, mind, porter, tick);
    if (porter.what == Porting::approach) come_nearer(match, self, seat, eyes, mind, porter, tick);
}

Aim handle_thing(const Simulation& match, const Self& self, const Seat& seat, Mind& mind, Porter& porter,
                 Tick tick) {
    const auto lifter = lifter_of(match, seat);
    if (!lifter || !match.world().alive(porter.thing)) {
        end(seat, mind, porter, tick);
        return {self.yaw, self.pitch};
    }
    return porter.what == Porting::take ? take_up(match, self, seat, *lifter, mind, porter, tick)
                                        : hold_and_throw(match, self, seat, *lifter, mind, porter, tick);
}

}  // namespace thaum::game
