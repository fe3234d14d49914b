#include "game/bots/swinging.h"

#include <algorithm>
#include <cmath>

#include "game/bots/armoury.h"

namespace thaum::game::inline bots {
namespace {

using input::bit;
using input::Button;

/// Distance along the ground from below the anchor, the point to which the rope attaches, to the take-off and
/// to the landing (m).
constexpr double half_gap = 4;
constexpr double level_ground = 0.3;  ///< largest height difference between take-off and landing (m)
constexpr double deep = 1.5;          ///< least depth of a gap (m); the bot walks through a shallower one
constexpr double knee = 0.9;          ///< height above the feet at which nothing may be in the way (m)
/// A ray from the take-off towards the rope's anchor counts as meeting the anchor itself if it ends within
/// this distance of it (m). Otherwise something is in the way.
constexpr double near_anchor = 0.5;
constexpr double walk_to_edge = 7;  ///< largest distance that the bot walks to the edge (m)
constexpr double at_edge = 0.5;  ///< distance from the edge at which the bot counts as having reached it (m)
constexpr double costs_as = 9;   ///< walking distance that takes as long as a swing (m)
constexpr double let_go_past = 2.2;  ///< distance beyond the rope's anchor at which the bot lets go (m)
/// Largest angle between aim and anchor (the point for the rope) at which the bot fires, as a share of the
/// largest angle at which the rope attaches.
constexpr double aim_share = 0.7;
constexpr double energy_needed = 20;
constexpr double min_health = 35;  ///< least health for a swing (HP): a fall into the gap must not kill
constexpr Tick again_after = ticks(2.0), look_again = ticks(0.1);
constexpr Tick edge_time = ticks(3.0), latch_time = ticks(1.5), hang_time = ticks(4.0), fly_time = ticks(1.5);
constexpr Tick tug_time = ticks(0.03);

vec3 flat(vec3 v) { return {v.x, 0, v.z}; }

vec3 across(const SwingPlan& c) {
    const vec3 way = flat(c.to - c.from);
    return way / std::max(1e-9, glm::length(way));
}

const LoadedWand* roper_of(const Simulation& match) {
    for (const auto& wand : match.data().wands) {
        if (wand.rules->rope()) return &wand;
    }
    return nullptr;
}

bool spans_a_gap(const Simulation& match, const WalkGrid& grid, const RopeKind& rope, const Crossing& c) {
    const int from = grid.cell_at(c.from), to = grid.cell_at(c.to);
    if (!grid.walkable(from) || !grid.walkable(to)) return false;
    const int under = grid.cell_at(c.anchor);
    const bool gap = !grid.walkable(under) || grid.height(under) < grid.height(from) - deep;
    if (!gap || std::abs(grid.height(from) - grid.height(to)) > level_ground) return false;
    const vec3 low = c.from + vec3(0, knee, 0);
    const vec3 eye = c.from + vec3(0, match.data().wizard.eye, 0);
    const auto seen = match.physics().ray(eye, c.anchor, layer::ground);
    return glm::distance(eye, c.anchor) < rope.reach &&
           !match.physics().ray(low, c.to + vec3(0, knee, 0), layer::ground) &&
           (!seen || glm::distance(seen->point, c.anchor) < near_anchor);
}

void begin(SwingPlan& swing_plan, SwingStage stage, Tick until) {
    swing_plan.stage = stage;
    swing_plan.until = until;
}

void end_swinging(const BotTurn& turn) {
    turn.mind.buttons &= ~bit(Button::fire);
    turn.mind.wand_until = turn.tick;
    turn.swing_plan.stage = SwingStage::none;
    turn.swing_plan.not_before = turn.tick + again_after;
}

/// Selects the rope's wand. Presses fire when the crosshair is so near the anchor (the point for the rope)
/// that the rope attaches to it.
void latch(const BotTurn& turn, const LoadedWand& roper) {
    const auto& self = turn.self;
    auto& mind = turn.mind;
    auto& swing_plan = turn.swing_plan;
    const Tick tick = turn.tick;
    const auto fire = bit(Button::fire);
    mind.wand = roper.stats.slot;
    if (!in_hand(self, mind)) return;
    if (self.held) return begin(swing_plan, SwingStage::hang, tick + hang_time);
    if ((mind.buttons & fire) != 0) {
        if (tick >= mind.fire_from + tug_time) mind.buttons &= ~fire;
        return;
    }
    const vec3 to = swing_plan.anchor - self.eye;
    const vec3 ahead = look_rotation(self.yaw, self.pitch) * vec3(0, 0, -1);
    const double aim = det::acos(roper.rules->rope()->aim_cos) * aim_share;
    if (glm::dot(to, ahead) < glm::length(to) * det::cos(aim)) return;
    mind.buttons |= fire;
    mind.fire_from = tick;
}

}  // namespace

std::vector<Crossing> find_crossings(const Simulation& match, const WalkGrid& grid) {
    std::vector<Crossing> crossings;
    const auto* roper = roper_of(match);
    if (roper == nullptr) return crossings;
    const auto rope = *roper->rules->rope();
    for (const vec3 anchor : match.data().arena.anchors) {
        for (const vec3 way : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            Crossing c{flat(anchor) - way * half_gap, anchor, flat(anchor) + way * half_gap};
            const int cell = grid.cell_at(c.from);
            if (!grid.covers(c.from) || !grid.covers(c.to) || !grid.walkable(cell)) continue;
            c.from.y = c.to.y = grid.height(cell);
            if (spans_a_gap(match, grid, rope, c)) crossings.push_back(c);
        }
    }
    return crossings;
}

void plan_to_swing(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    const auto& grid = turn.grid;
    const auto& to_goal = turn.ways.to_goal;
    const auto& mind = turn.mind;
    auto& swing_plan = turn.swing_plan;
    const Tick tick = turn.tick;
    if (seat.skill.swing_gain <= 0 || roped(swing_plan) || tick < swing_plan.not_before) return;
    swing_plan.not_before = tick + look_again;
    const bool hunts = mind.foe_seen_at == 0 || tick > mind.foe_seen_at + ticks(1.0);
    const bool errand = mind.errand == Errand::fetch || mind.errand == Errand::hide;
    const auto* roper = roper_of(match);
    if (roper == nullptr || self.health < min_health || (!hunts && !errand)) return;
    const auto& belt = match.world().get<WandBelt>(wizard_of(match.world(), seat.player));
    if (belt.energy[roper->stats.energy_slot] < energy_needed) return;
    if (to_goal.goal != grid.cell_at(mind.goal)) return;
    const auto steps = [&](vec3 place) {
        return static_cast<double>(to_goal.steps[static_cast<std::size_t>(grid.cell_at(place))]);
    };
    double most = seat.skill.swing_gain;
    for (const auto& c : turn.crossings) {
        const double walk = glm::length(flat(c.from - self.centre));
        const double gain = steps(self.centre) - (walk + costs_as + steps(c.to));
        if (walk > walk_to_edge || gain < most || !grid.straight(self.centre, c.from)) continue;
        most = gain;
        swing_plan.from = c.from;
        swing_plan.anchor = c.anchor;
        swing_plan.to = c.to;
        begin(swing_plan, SwingStage::approach, tick + edge_time);
    }
}

vec3 swing_over(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    auto& mind = turn.mind;
    auto& swing_plan = turn.swing_plan;
    const Tick tick = turn.tick;
    const auto* roper = roper_of(match);
    if (roper == nullptr || tick >= swing_plan.until) {
        end_swinging(turn);
        return {};
    }
    const vec3 to_edge = flat(swing_plan.from - self.centre);
    switch (swing_plan.stage) {
        case SwingStage::approach:
            if (glm::length(to_edge) > at_edge) return to_edge;
            mind.buttons &= ~bit(Button::fire);
            begin(swing_plan, SwingStage::aim, tick + latch_time);
            return {};
        case SwingStage::aim: latch(turn, *roper); return {};
        case SwingStage::hang:
            mind.buttons |= bit(Button::fire);
            if (!self.held || glm::dot(self.centre - swing_plan.anchor, across(swing_plan)) > let_go_past) {
                mind.buttons &= ~bit(Button::fire);
                begin(swing_plan, SwingStage::fly, tick + fly_time);
            }
            return across(swing_plan);
        default: break;
    }
    const auto& stance = match.world().get<Stance>(wizard_of(match.world(), turn.seat.player));
    if (stance.grounded != 0) end_swinging(turn);
    return across(swing_plan);
}

Aim aim_on_rope(const Self& self, const SwingPlan& swing_plan) {
    if (swing_plan.stage == SwingStage::aim) return aim_at(self.eye, swing_plan.anchor);
    return aim_at(self.eye, self.eye + across(swing_plan));
}

}  // namespace thaum::game::inline bots
