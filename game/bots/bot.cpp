#include "game/bots/bot.h"

#include <algorithm>
#include <cmath>

#include "core/file.h"
#include "core/text.h"
#include "ecs/snapshot.h"
#include "game/bots/aim.h"
#include "game/bots/armoury.h"
#include "game/bots/errands.h"
#include "game/bots/lifting.h"
#include "game/bots/senses.h"
#include "game/bots/spellcasting.h"
#include "game/bots/stirring.h"
#include "game/bots/swinging.h"
#include "game/bots/turn.h"

// Bots act in every gameplay tick, which is every 8 ms. A bot looks, chooses an aim and a way, and spreads
// its turn over the ticks until the next gameplay tick.
namespace thaum::game::inline bots {
namespace {

using input::Button;
namespace hand = input::hand;

constexpr double reached = 1.2;      ///< distance from mind.goal at which the bot counts it as reached (m)
constexpr double stuck_speed = 0.4;  ///< speed below which a walking bot counts as stuck (m/s)
/// Time outside of the large connected regions of the ground (WalkGrid) after which a bot walks straight to
/// the nearest region. A bot that only passes through such a place is out of it sooner.
constexpr Tick stranded_after = ticks(2.0);
constexpr Tick forget_after = ticks(4.0);
/// Time after a hit by the foe for which a bot is under fire.
constexpr Tick under_fire_for = ticks(1.5);
constexpr double side_step = 1.2;  ///< distance to the side within which a step must be safe (m)

/// A random walkable place in the arena.
vec3 random_place(const WalkGrid& grid, Random& random) {
    for (int tries = 0; tries < 50; ++tries) {
        const int cell = static_cast<int>(random.below(static_cast<std::uint64_t>(grid.cells())));
        if (grid.walkable(cell)) return grid.centre_of(cell);
    }
    int first = 0;
    while (first + 1 < grid.cells() && !grid.walkable(first)) ++first;
    return grid.centre_of(first);
}

void set_move(const Self& self, vec3 direction, Mind& mind) {
    const vec3 local = glm::conjugate(rotation({0, 1, 0}, self.yaw)) * vec3(direction.x, 0, direction.z);
    const double length = glm::length(local);
    if (length < 1e-6) {
        mind.move_strafe = mind.move_forward = 0;
        return;
    }
    mind.move_strafe = static_cast<std::int32_t>(std::lround(127 * local.x / length));
    mind.move_forward = static_cast<std::int32_t>(std::lround(-127 * local.z / length));
}

/// Frees a bot that something blocks: after a while it jumps and perhaps steps sideways.
void unstick(const Self& self, Mind& mind, Tick tick) {
    mind.buttons &= ~static_cast<std::uint32_t>(Button::jump);
    const bool slow = glm::length(vec2(self.velocity.x, self.velocity.z)) < stuck_speed;
    if (!slow || mind.wishes_to_move == 0) mind.slow_since = tick;
    if (tick - mind.slow_since < ticks(0.4)) return;
    mind.slow_since = tick;
    if (mind.random.below(2) == 0) {  // otherwise it jumps straight on, perhaps onto a ledge
        mind.dodge_until = tick + ticks(0.5);
        mind.strafe = mind.random.below(2) == 0 ? -1 : 1;
    }
    mind.buttons |= static_cast<std::uint32_t>(Button::jump);
}

/// Whether the next side step may go over an edge. A bot that is badly hurt and under fire may panic.
bool forgets_edges(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill.edge;
    const bool is_shot_at = self.hit_at != 0 && turn.tick < self.hit_at + under_fire_for;
    const double share = skill.heedless;
    const bool panics = is_shot_at && share > 0 && self.health < skill.panic;
    return panics && turn.mind.random.uniform() < share;
}

void choose_step(const BotTurn& turn) {
    const auto& seat = turn.seat;
    auto& mind = turn.mind;
    const Tick tick = turn.tick;
    if (tick >= mind.strafe_until) {
        const bool steps = mind.random.uniform() < seat.skill.strafe;
        mind.strafe = !steps ? 0 : mind.random.below(2) == 0 ? -1 : 1;
        mind.strafe_until = tick + ticks(seconds(seat.skill.strafe_step) * mind.random.uniform(0.6, 1.4));
        mind.heedless = forgets_edges(turn) ? 1 : 0;
    }
    const auto aside = seat.skill.dodges != 0 ? step_aside(turn.match, turn.self, seat, mind) : 0;
    if (aside == 0) return;
    mind.strafe = aside;
    mind.strafe_until = tick + ticks(0.25);
}

vec3 unit_or_zero(vec3 v) {
    const double length = glm::length(v);
    return length > 1e-6 ? v / length : vec3(0);
}

/// Displacement to the middle of the next cell on the way to `goal`. Zero at the goal, or if there is no way.
vec3 next_step(const BotTurn& turn, vec3 goal) {
    const auto& self = turn.self;
    const auto& grid = turn.grid;
    auto& ways = turn.ways.to_goal;
    const int to = grid.cell_at(goal);
    if (ways.goal != to) grid.find_ways(to, ways);
    const int cell = grid.cell_at(self.centre);
    const int next = grid.next(cell, ways);
    return next == cell ? vec3(0) : grid.centre_of(next) - vec3(self.centre.x, 0, self.centre.z);
}

/// Direction of the next step to mind.goal; zero at the goal, or if there is no way.
vec3 way_to_goal(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& grid = turn.grid;
    auto& mind = turn.mind;
    const vec3 step = next_step(turn, mind.goal);
    if (glm::length(step) > 0) return step;
    mind.goal_until = turn.tick;  // now another goal is chosen: this one is reached, or has no way
    const vec3 last = vec3(mind.goal.x, 0, mind.goal.z) - vec3(self.centre.x, 0, self.centre.z);
    const bool same_cell = grid.cell_at(mind.goal) == grid.cell_at(self.centre);
    return same_cell && glm::length(last) > 0.3 ? last : vec3(0, 0, 0);
}

/// Direction of walking in a fight. The bot comes nearer along walkable cells up to its preferred distance,
/// steps sideways, and never steps over an edge, except in a panic.
vec3 way_in_a_fight(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& grid = turn.grid;
    auto& mind = turn.mind;
    const vec3 to_foe = vec3(mind.foe.x - self.centre.x, 0, mind.foe.z - self.centre.z);
    const double distance = glm::length(to_foe);
    if (distance < 1e-6) return {0, 0, 0};
    const double keep = turn.seat.skill.keep;
    vec3 way{0, 0, 0}, next{0, 0, 0};
    if (distance > 1.3 * keep) next = way = unit_or_zero(next_step(turn, mind.foe));
    if (distance < 0.6 * keep) way = -to_foe / distance;
    const vec3 right = glm::cross(to_foe / distance, vec3(0, 1, 0)) * static_cast<double>(mind.strafe);
    const auto safe = [&](vec3 by) {
        return glm::length(by) > 1e-6 &&
               grid.straight(self.centre, self.centre + unit_or_zero(by) * side_step);
    };
    if (safe(way + right)) return way + right;
    if (mind.heedless != 0 && mind.strafe != 0 &&
        grid.over_edge(self.centre, self.centre + unit_or_zero(way + right) * side_step))
        return way + right;
    if (safe(way - right)) {
        mind.strafe = -mind.strafe;
        return way - right;
    }
    // The next cell of the way to the goal is safe, even if the ground beyond that cell is not.
    return safe(way) ? way : next;
}

/// Direction of walking. An errand, such as to fetch a power-up or to hide, comes first. In sight of the foe
/// the bot fights. Otherwise it goes to the foe's last known place, then to random places.
vec3 choose_way(const BotTurn& turn) {
    const auto& self = turn.self;
    auto& mind = turn.mind;
    const Tick tick = turn.tick;
    if (mind.errand != Errand::none) return way_to_goal(turn);
    const bool knows = mind.foe_seen_at != 0 && tick - mind.foe_seen_at < forget_after;
    if (knows && tick - mind.foe_seen_at < ticks(0.5)) return way_in_a_fight(turn);
    const bool there =
        glm::distance(vec2(mind.goal.x, mind.goal.z), vec2(self.centre.x, self.centre.z)) < reached;
    if (there || tick >= mind.goal_until) {
        mind.goal = knows ? mind.foe : random_place(turn.grid, mind.random);
        mind.goal_until = tick + ticks(8.0);
        // The bot goes to the foe's last known place only once, so it forgets that place now.
        if (knows) mind.foe_seen_at = tick - std::min(tick, forget_after);
    }
    return way_to_goal(turn);
}

/// Direction in which the bot leaves a place outside of the large connected regions of walkable ground
/// (WalkGrid). It is zero until the bot has stood at such a place for a while.
vec3 way_out(const BotTurn& turn) {
    const auto& self = turn.self;
    const auto& grid = turn.grid;
    auto& mind = turn.mind;
    const int cell = grid.cell_at(self.centre);
    if (grid.in_large_region(cell)) mind.stranded_since = turn.tick;
    if (turn.tick - mind.stranded_since < stranded_after) return {0, 0, 0};
    const vec3 feet = self.centre - vec3(0, turn.match.data().wizard.height / 2, 0);
    const int to = grid.nearest_way(cell, feet);
    return to == cell ? vec3(0) : grid.centre_of(to) - vec3(self.centre.x, 0, self.centre.z);
}

/// Forgets everything at the beginning of a round.
void begin_anew(const BotTurn& turn) {
    turn.eyes.looks = 0;
    turn.eyes.back_at = {};
    turn.eyes.things = {};
    turn.mind = {.random = turn.mind.random, .stranded_since = turn.tick, .round = turn.match.match().round};
    turn.lift_plan = {};
    turn.swing_plan = {};
    turn.stir_plan = {};
    turn.cast_plan = {.style = turn.cast_plan.style};
}

/// Releases all buttons and ends all plans while the wizard is dead.
void end_plans(const BotTurn& turn) {
    auto& mind = turn.mind;
    turn.eyes.looks = 0;
    mind.right_left = mind.up_left = mind.move_strafe = mind.move_forward = 0;
    mind.buttons = mind.wand_key = 0;
    mind.foe_seen_at = 0;
    mind.stranded_since = turn.tick;
    mind.errand = Errand::none;
    turn.lift_plan = {};
    turn.swing_plan = {};
    turn.stir_plan = {};
    turn.cast_plan = {.style = turn.cast_plan.style};
}

/// Aims and shoots at a known foe. Returns the wanted direction of view; std::nullopt if the bot has nothing
/// to look at.
std::optional<Aim> shoot(const BotTurn& turn, vec3 way) {
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    auto& mind = turn.mind;
    const bool watches = mind.foe_seen_at != 0 && turn.tick - mind.foe_seen_at < ticks(1.5);
    auto aim = watches ? aim_of_shot(self, aim_point(self, seat, mind, seat.skill.lead))
                       : aim_at(self.eye, self.eye + way);
    if (!watches) aim.pitch = 0;
    if (choose_wand(turn)) choose_fire(self, seat, aim, mind, turn.tick);
    return watches || glm::length(way) > 0 ? std::optional(aim) : std::nullopt;
}

/// Uses the hands for a rope, a held thing or a shot. Returns the wanted direction of view.
std::optional<Aim> use_hands(const BotTurn& turn, vec3 way) {
    if (draws(turn.cast_plan)) {
        // While the button Trace is held, the key of a wand would cast a spell, so it is released.
        turn.mind.wand_key = 0;
        return std::nullopt;
    }
    if (hands_full(turn.swing_plan)) return aim_on_rope(turn.self, turn.swing_plan);
    if (hands_full(turn.lift_plan)) return handle_thing(turn);
    return shoot(turn, way);
}

void look_around(const BotTurn& turn) {
    see_foe(turn.match, turn.self, turn.seat, turn.eyes, turn.mind, turn.tick);
    see_power_ups(turn.match, turn.self, turn.seat, turn.eyes);
    if (turn.seat.skill.lift.share > 0) see_things(turn.match, turn.self, turn.seat, turn.eyes);
}

/// Makes plans other than fighting, in order of importance. A plan is made only if no earlier one keeps the
/// bot busy.
void make_plans(const BotTurn& turn) {
    choose_errand(turn);
    if (!roped(turn.swing_plan)) plan_to_lift(turn);
    if (!roped(turn.swing_plan) && turn.lift_plan.stage == LiftStage::none) plan_to_stir(turn);
    const bool hands_free =
        !roped(turn.swing_plan) && !hands_full(turn.lift_plan) && turn.stir_plan.stage == StirStage::none;
    if (hands_free) plan_to_cast(turn);
}

/// Direction of walking, also for a bot that crosses a gap on a rope.
vec3 walk(const BotTurn& turn) {
    choose_step(turn);
    vec3 way = choose_way(turn);
    if (const vec3 out = way_out(turn); glm::length(out) > 0) way = out;
    if (turn.lift_plan.stage == LiftStage::none && !draws(turn.cast_plan)) plan_to_swing(turn);
    return roped(turn.swing_plan) ? swing_over(turn) : way;
}

/// One gameplay tick of a bot: senses, plans, then the device's controls until the next gameplay tick.
void think(BotTurn turn) {
    auto& mind = turn.mind;
    if (mind.round != turn.match.match().round) begin_anew(turn);
    turn.self = self_of(turn.match, turn.seat.player, mind.readiness);
    const auto& self = turn.self;
    if (!self.alive) return end_plans(turn);
    look_around(turn);
    wander_aim(turn.seat, mind);
    make_plans(turn);
    const vec3 way = walk(turn);
    if (auto aim = use_hands(turn, way)) {
        aim->yaw += mind.error_right;
        aim->pitch += mind.error_up;
        turn_towards(self, turn.seat, *aim, mind);
    }
    set_move(self, way, mind);
    mind.wishes_to_move = glm::length(way) > 0 ? 1 : 0;
    if (hands_full(turn.swing_plan)) return;
    unstick(self, mind, turn.tick);
    if (turn.tick < mind.dodge_until) mind.move_strafe = mind.strafe > 0 ? 127 : -127;
}

}  // namespace

input::DeviceSpec bot_device(std::uint32_t player, std::string_view name) {
    return {.player = player,
            .kind = input::DeviceKind::bot,
            .name = text("bot ", name),
            .look_rad_per_count = rad_per_count};
}

struct Bots::Inside {
    ecs::World minds;
    std::unique_ptr<WalkGrid> grid;
    std::vector<Crossing> crossings;
    std::vector<BotWays> ways;  // a cache, indexed by the entity of the bot

    Inside() {
        minds.declare<Seat>();
        minds.declare<Eyes>();
        minds.declare<Mind>();
        minds.declare<LiftPlan>();
        minds.declare<SwingPlan>();
        minds.declare<StirPlan>();
        minds.declare<CastPlan>();
    }
};

Bots::Bots() : inside_(std::make_unique<Inside>()) {}
Bots::~Bots() = default;
Bots::Bots(Bots&&) noexcept = default;
Bots& Bots::operator=(Bots&&) noexcept = default;

void Bots::add(const Simulation& match, std::size_t device, std::uint32_t player, const BotSkill& skill,
               std::uint64_t seed) {
    auto& in = *inside_;
    if (!in.grid) {
        in.grid = std::make_unique<WalkGrid>(match.physics(), ground_bounds(match.data().arena));
        in.crossings = find_crossings(match, *in.grid);
    }
    const Seat seat{.device = device, .player = player, .skill = skill};
    auto style_of_drawing = random_stream(seed, 200 + player);
    in.minds.create(seat, Eyes{}, Mind{.random = random_stream(seed, 100 + player)}, LiftPlan{}, SwingPlan{},
                    StirPlan{}, CastPlan{.style = random_drawing_style(style_of_drawing)});
    in.ways.emplace_back();
    in.grid->find_ways(0, in.ways.back().from_here);
    // Reserves the memory, so that nothing is allocated during the match.
    in.grid->find_ways(0, in.ways.back().to_goal);
}

bool Bots::empty() const { return inside_->minds.size() == 0; }

void Bots::sample(const Simulation& match, input::InputFrame& frame) {
    if (match.match().paused != 0 || match.match().phase != Phase::playing) return;
    const Tick phase = match.match().played % gameplay_period;
    auto& in = *inside_;
    in.minds.view<const Seat, Eyes, Mind, LiftPlan, SwingPlan, StirPlan, CastPlan>().each(
        [&](ecs::Entity e, const Seat& seat, Eyes& eyes, Mind& mind, LiftPlan& lift_plan,
            SwingPlan& swing_plan, StirPlan& stir_plan, CastPlan& cast_plan) {
            if (phase == 0) {
                think({.match = match,
                       .seat = seat,
                       .grid = *in.grid,
                       .crossings = in.crossings,
                       .tick = match.match().played,
                       .self = {},
                       .eyes = eyes,
                       .mind = mind,
                       .lift_plan = lift_plan,
                       .swing_plan = swing_plan,
                       .stir_plan = stir_plan,
                       .cast_plan = cast_plan,
                       .ways = in.ways[e.index]});
            }
            auto& sample = frame.devices[seat.device];
            if (stirs(stir_plan)) return brew_hand(match, seat, stir_plan, match.match().played, sample);
            sample = {};
            turn_hand(mind, gameplay_period - phase, sample);
            sample.counts[hand::strafe] = mind.move_strafe;
            sample.counts[hand::forward] = mind.move_forward;
            sample.buttons = mind.buttons;
            sample.wand = static_cast<std::uint8_t>(mind.wand_key);
            if (sample.down(Button::fire)) sample.counts[hand::trigger] = mind.trigger;
            if (draws(cast_plan)) draw_stroke(match, seat, match.match().played, cast_plan, sample);
        });
}

void Bots::save(Bytes& out) const { ecs::save(inside_->minds, out); }

Expected<void> Bots::restore(std::span<const std::byte> snapshot) {
    return ecs::restore(inside_->minds, snapshot);
}

}  // namespace thaum::game::inline bots
