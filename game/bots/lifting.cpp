#include "game/bots/lifting.h"

#include <algorithm>
#include <cmath>

#include "game/bots/armoury.h"
#include "game/bots/senses.h"
#include "game/match/bodies.h"

// The worth of a thing is the harm that a throw of it would do to the foe, divided by the time to fetch and
// throw it.
namespace thaum::game::inline bots {
namespace {

using input::bit;
using input::Button;

constexpr double handy = 0.8;  ///< share of the wand's reach within which the bot takes a thing up
/// Distance along the ground below which a held thing would hit its holder (m).
constexpr double too_near = 1.8;
constexpr double near_foe = 3;       ///< distance of the foe below which the bot does not turn away (m)
constexpr double far_foe = 15;       ///< distance of the foe beyond which no throw arrives (m)
constexpr double min_harm = 8;       ///< least harm for which the bot throws a thing (HP)
constexpr double carrying_cost = 8;  ///< estimated energy of the wand for carrying a thing
constexpr double cost_per_kg = 0.3;  ///< further energy for each kilogram of the carried thing
constexpr double walk_pace = 4;      ///< walking speed (m/s)
constexpr double turn_pace = 1.5;    ///< turning speed of the view while the bot holds a thing (rad/s)
constexpr double time_to_take = 1;   ///< time to take a thing up (s)
constexpr Tick come_time = ticks(3.0), take_time = ticks(1.4), press_time = ticks(0.03);
constexpr Tick last_chance = ticks(1.0);
constexpr Tick lull = ticks(0.3);
constexpr double shield_height = 0.2;  ///< height of the point that a shield guards, from mid-body (m)

struct Lifter {
    const LoadedWand& wand;
    GraspKind grasp;
    double energy;
};

std::optional<Lifter> lifter_of(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& belt = match.world().get<WandBelt>(wizard_of(match.world(), turn.seat.player));
    for (const auto& wand : match.data().wands) {
        const auto grasp = wand.rules->grasp();
        if (!grasp) continue;
        return Lifter{wand, *grasp, belt.energy[wand.stats.energy_slot]};
    }
    return {};
}

/// Harm of a thing that hits a wizard squarely (HP).
double harm_of(const WizardRules& rules, double mass, double speed) {
    const double impulse = mass * rules.mass / (mass + rules.mass) * speed;
    return harm_of_blow(rules, impulse);
}

/// Distance from a body's middle to the farthest point of the body (m).
double size_of(const physics::BodyDesc& body) {
    switch (body.shape) {
        case physics::Shape::box: return glm::length(body.size);
        case physics::Shape::sphere: return body.size.x;
        default: return body.size.x + body.size.y;
    }
}

double along_ground(vec3 from, vec3 to) { return glm::length(vec2(to.x - from.x, to.z - from.z)); }

/// Worth of taking up a thing: harm of a throw per time for it (HP/s); 0 if the thing is of no use.
double worth_of(const BotTurn& turn, const Lifter& lifter, const Sighting& seen) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill.lift;
    const auto key = seen.thing.index;
    if (!match.world().alive(seen.thing) || !match.physics().has(key)) return 0;
    const auto& body = match.physics().desc(key);
    const vec3 to = seen.place - self.eye;
    const double distance = glm::length(to);
    const double walk = std::max(0.0, distance - handy * lifter.grasp.reach);
    const bool fits = body.mass <= lifter.grasp.max_mass && size_of(body) <= skill.largest;
    if (!fits || walk > skill.seek || along_ground(self.eye, seen.place) < too_near) return 0;
    const double speed =
        throw_speed(lifter.grasp, body.mass, lifter.energy - carrying_cost - cost_per_kg * body.mass);
    const double harm = harm_of(match.data().wizard, body.mass, speed);
    if (harm < min_harm || (walk > 0 && !turn.grid.straight(self.centre, seen.place))) return 0;
    const vec3 to_foe = turn.mind.foe - self.eye;
    const double angle = det::acos(
        std::clamp(glm::dot(to, to_foe) / std::max(1e-9, distance * glm::length(to_foe)), -1.0, 1.0));
    return harm / (time_to_take + walk / walk_pace + angle / turn_pace);
}

const Sighting* best_thing(const BotTurn& turn, const Lifter& lifter) {
    const Sighting* best = nullptr;
    double most = 0;
    for (const auto& seen : turn.eyes.things) {
        if (!seen.thing) continue;
        const double worth = worth_of(turn, lifter, seen);
        if (worth > most) most = worth, best = &seen;
    }
    return best;
}

void end_lifting(const BotTurn& turn) {
    auto& mind = turn.mind;
    auto& lift_plan = turn.lift_plan;
    const Tick tick = turn.tick;
    if (hands_full(lift_plan)) {
        mind.buttons &= ~(bit(Button::fire) | bit(Button::throw_));
        mind.wand_until = tick;  // from now on another wand may be chosen
    }
    lift_plan.stage = LiftStage::none;
    lift_plan.not_before = tick + ticks(seconds(turn.seat.skill.lift.rest) * mind.random.uniform(0.6, 1.4));
    if (mind.errand == Errand::lift) mind.errand = Errand::none;
}

void consider_lifting(const BotTurn& turn) {
    const auto& self = turn.self;
    auto& mind = turn.mind;
    auto& lift_plan = turn.lift_plan;
    const Tick tick = turn.tick;
    const double distance = glm::distance(self.eye, mind.foe);
    const bool knows = mind.foe_seen_at != 0 && tick <= mind.foe_seen_at + ticks(2.0);
    if (!knows || distance < near_foe || distance > far_foe || mind.errand != Errand::none) return;
    if (tick < lift_plan.not_before) return;
    lift_plan.not_before = tick + ticks(0.5);
    const bool readying = self.shot.held && (mind.buttons & bit(Button::fire)) != 0;
    if (readying || mind.random.uniform() >= turn.seat.skill.lift.share) return;
    const auto lifter = lifter_of(turn);
    if (!lifter) return;
    const auto* found = best_thing(turn, *lifter);
    if (found == nullptr) return;
    lift_plan.thing = found->thing;
    lift_plan.place = found->place;
    lift_plan.stage = LiftStage::approach;
    lift_plan.until = tick + come_time;
}

void come_nearer(const BotTurn& turn) {
    const auto& self = turn.self;
    auto& mind = turn.mind;
    auto& lift_plan = turn.lift_plan;
    for (const auto& seen : turn.eyes.things) {
        if (seen.thing == lift_plan.thing) lift_plan.place = seen.place;
    }
    const auto lifter = lifter_of(turn);
    const bool wanted = mind.errand == Errand::none || mind.errand == Errand::lift;
    if (!wanted || !lifter || turn.tick >= lift_plan.until ||
        along_ground(self.eye, lift_plan.place) < too_near)
        return end_lifting(turn);
    mind.errand = Errand::lift;
    mind.goal = lift_plan.place;
    if (glm::distance(self.eye, lift_plan.place) > handy * lifter->grasp.reach) return;
    const auto hit = turn.match.physics().ray(self.eye, lift_plan.place, physics::all_layers, self.key);
    if (!hit || hit->key != lift_plan.thing.index) return;
    mind.errand = Errand::none;
    mind.buttons &= ~bit(Button::fire);
    mind.wand = lifter->wand.stats.slot;
    lift_plan.stage = LiftStage::take;
    lift_plan.until = turn.tick + take_time;
}

/// Presses fire when the crosshair is on the thing to lift. If the wand took nothing, releases fire and tries
/// again.
Aim take_up(const BotTurn& turn, const Lifter& lifter) {
    const auto& self = turn.self;
    auto& mind = turn.mind;
    auto& lift_plan = turn.lift_plan;
    const Tick tick = turn.tick;
    const auto fire = bit(Button::fire);
    const vec3 place = turn.match.world().get<Motion>(lift_plan.thing).position;
    const Aim aim = aim_at(self.eye, place);
    if (in_hand(self, mind) && self.held) {
        lift_plan.stage = LiftStage::hold;
        lift_plan.until = tick + turn.seat.skill.lift.hold;
        mind.buttons |= fire;
    } else if (tick >= lift_plan.until) {
        end_lifting(turn);
    } else if (mind.wand == self.wand && (mind.buttons & fire) == 0) {
        if (!crosshair_on(turn.match, self, lift_plan.thing, lifter.grasp.reach)) return aim;
        lift_plan.off_left = angle_between(self.yaw, aim.yaw);
        lift_plan.off_up = aim.pitch - self.pitch;
        mind.buttons |= fire;
        mind.fire_from = tick;
    } else if (tick >= mind.fire_from + press_time) {
        mind.buttons &= ~fire;
    }
    return aim;
}

void note_shots(const BotTurn& turn) {
    auto& lift_plan = turn.lift_plan;
    const Tick tick = turn.tick;
    if (!sees_a_shot_come(turn.match, turn.self, turn.seat)) return;
    if (tick >= lift_plan.shot_at + 2 * lull) lift_plan.shots_from = tick;
    lift_plan.shot_at = tick;
}

/// Whether the bot knows that it is under fire. It knows one reaction time after the first shot that it saw
/// coming, and until a moment after the last one.
bool under_fire(const BotTurn& turn) {
    const auto& lift_plan = turn.lift_plan;
    const Tick later = turn.seat.skill.reaction, tick = turn.tick;
    return lift_plan.shot_at != 0 && tick >= lift_plan.shots_from + later &&
           tick < lift_plan.shot_at + later + lull;
}

/// Direction of view at which the held thing, at its present distance, is between the foe and the bot.
Aim aim_to_guard(const BotTurn& turn) {
    const auto& self = turn.self;
    const vec3 chest = self.centre + vec3(0, shield_height, 0);
    const vec3 way = turn.mind.foe - chest;
    const double share = glm::distance(self.eye, *self.held) / std::max(1e-6, glm::length(way));
    Aim aim = aim_at(self.eye, chest + way * std::min(1.0, share));
    aim.yaw -= turn.lift_plan.off_left;
    aim.pitch -= turn.lift_plan.off_up;
    return aim;
}

/// A throw of the held thing from its present position: the wanted direction and the present one.
struct Throw {
    vec3 target{};  ///< point that the throw is to hit (m, world)
    vec3 wanted{};  ///< direction of a throw that would hit the target (unit, world)
    vec3 actual{};  ///< direction of a throw at this moment (unit, world)
    double harm{};  ///< harm if the thrown thing hits the foe (HP)
};

vec3 along(Aim aim) { return look_rotation(aim.yaw, aim.pitch) * vec3(0, 0, -1); }

Throw plan_throw(const BotTurn& turn, const Lifter& lifter) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    const double mass = match.physics().desc(turn.lift_plan.thing.index).mass;
    const vec3 thing = *self.held;
    Self from_there = self;
    from_there.eye = from_there.tip = thing;
    from_there.shot = {.speed = throw_speed(lifter.grasp, mass, lifter.energy),
                       .fall = -match.physics().settings().gravity.y};
    Throw t{.target = aim_point(from_there, seat, turn.mind, seat.skill.lift.lead),
            .harm = harm_of(match.data().wizard, mass, from_there.shot.speed)};
    t.wanted = along(aim_of_shot(from_there, t.target));
    const vec3 crossing = self.eye + along({self.yaw, self.pitch}) * lifter.grasp.crossing - thing;
    t.actual = crossing / std::max(1e-9, glm::length(crossing));
    return t;
}

/// Holds the lifted thing until a throw would hit, or as a shield while shots come.
Aim hold_and_throw(const BotTurn& turn, const Lifter& lifter) {
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill.lift;
    auto& mind = turn.mind;
    const Tick tick = turn.tick;
    const Aim as_it_is{self.yaw, self.pitch};
    if (!in_hand(self, mind) || !self.held || tick >= turn.lift_plan.until + last_chance) {
        end_lifting(turn);
        return as_it_is;
    }
    const bool waits = tick < turn.lift_plan.until;
    const bool guards = skill.guards != 0 && under_fire(turn);
    if (guards && waits) return aim_to_guard(turn);
    const vec3 thing = *self.held;
    const auto t = plan_throw(turn, lifter);
    if (t.harm < min_harm) {  // carrying has cost so much energy that no useful throw is left
        end_lifting(turn);
        return as_it_is;
    }
    const bool sees = mind.foe_seen_at != 0 && tick <= mind.foe_seen_at + ticks(0.4);
    const double off = det::acos(std::clamp(glm::dot(t.wanted, t.actual), -1.0, 1.0));
    if (sees && off < skill.within * (waits ? 1 : 2) &&
        !turn.match.physics().ray(thing, t.target, layer::ground))
        mind.buttons |= bit(Button::throw_);
    const double left_to_cross = lifter.grasp.crossing - glm::distance(thing, self.eye);
    return aim_at(self.eye, thing + t.wanted * std::max(1.0, left_to_cross));
}

}  // namespace

void plan_to_lift(const BotTurn& turn) {
    const auto& skill = turn.seat.skill.lift;
    const auto& stage = turn.lift_plan.stage;
    if (skill.share <= 0) return;
    if (skill.guards != 0) note_shots(turn);
    if (stage == LiftStage::none) consider_lifting(turn);
    if (stage == LiftStage::approach) come_nearer(turn);
}

Aim handle_thing(const BotTurn& turn) {
    const auto lifter = lifter_of(turn);
    if (!lifter || !turn.match.world().alive(turn.lift_plan.thing)) {
        end_lifting(turn);
        return {turn.self.yaw, turn.self.pitch};
    }
    return turn.lift_plan.stage == LiftStage::take ? take_up(turn, *lifter) : hold_and_throw(turn, *lifter);
}

}  // namespace thaum::game::inline bots
