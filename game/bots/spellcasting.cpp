#include "game/bots/spellcasting.h"

#include <algorithm>
#include <cmath>

#include "game/bots/aim.h"
#include "game/components/casting.h"

namespace thaum::game::inline bots {
namespace {

using input::bit;
using input::Button;
namespace hand = input::hand;

constexpr Tick consider_again = ticks(0.5);  ///< time between two decisions whether to cast
constexpr Tick after_spell = ticks(1.0);     ///< time after a stroke for which the bot draws no other
constexpr Tick after_thing = ticks(20.0);    ///< minimum time from calling one thing back to calling the next
/// Time for which the button Trace is held before and after the stroke itself.
constexpr Tick pause = ticks(0.03);
constexpr Tick recent = ticks(1.2);    ///< time for which the bot counts as under fire after a hit
constexpr Tick in_sight = ticks(0.3);  ///< time after a look at the foe for which the foe counts as in sight
constexpr double pushed_way = 2.5;   ///< distance that a push moves a foe (m); an edge within it makes a push
                                     ///< worthwhile
constexpr double harsh_force = 1.9;  ///< mean force of a harsh stroke (N)

// ---- which spell ------------------------------------------------------------------------------------------

/// Distance of the loose thing that the wizard lifted last (m); 0 if there is none.
double distance_of_last_thing(const Simulation& match, ecs::Entity wizard, vec3 eye) {
    const auto* last = match.world().find<LastProp>(wizard);
    if (last == nullptr || !last->thing || !match.world().alive(last->thing)) return 0;
    return glm::distance(match.world().get<Motion>(last->thing).position, eye);
}

SpellOccasion occasion_of(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& mind = turn.mind;
    const Tick tick = turn.tick;
    const auto wizard = wizard_of(match.world(), turn.seat.player);
    const auto& health = match.world().get<Health>(wizard);
    const Aim to_foe = aim_at(self.eye, mind.foe);
    const vec3 way = mind.foe - self.eye;
    const vec3 flat(way.x, 0, way.z);
    const double far = glm::length(flat);
    const vec3 behind = far > 1e-6 ? mind.foe + flat / far * pushed_way : mind.foe;
    const double focus = match.world().get<Focus>(wizard).points;
    return {.focus = focus / std::max(1.0, match.data().casting->focus_cap),
            .health = self.health / match.data().wizard.health,
            .under_fire = self.hit_at != 0 && tick < self.hit_at + recent,
            .warded = tick < health.ward_until && health.ward > 0,
            .sees_foe = mind.foe_seen_at != 0 && tick <= mind.foe_seen_at + in_sight,
            .foe_distance = glm::length(way),
            .foe_aside = std::abs(angle_between(self.yaw, to_foe.yaw)),
            .foe_at_edge = turn.grid.over_edge(mind.foe, behind),
            .thing_distance = distance_of_last_thing(match, wizard, self.eye)};
}

/// Index of the spell that is worth most to the bot, of those for which it has enough focus (what spells
/// cost); the number of spells if there is none.
std::size_t best_spell(const BotTurn& turn, const SpellOccasion& occasion, double cost) {
    const auto& world = turn.match.world();
    const auto& spells = turn.match.data().spells;
    const bool wants_thing = turn.tick >= turn.cast_plan.no_thing_before;
    const double focus = world.get<Focus>(wizard_of(world, turn.seat.player)).points;
    std::size_t best = spells.size();
    double most = 0;
    for (std::size_t i = 0; i < spells.size(); ++i) {
        if (focus < spells[i].stats.focus * cost) continue;
        if (!wants_thing && spells[i].rules->brings_thing()) continue;
        const double worth = spells[i].rules->worth(occasion);
        if (worth > most) most = worth, best = i;
    }
    return best;
}

// ---- the stroke -------------------------------------------------------------------------------------------

gesture::Points template_of(const Simulation& match, const Seat& seat, const CastPlan& cast_plan) {
    const auto* gestures = gestures_of(match.context(), seat.player);
    if (cast_plan.spell >= match.data().spells.size()) return {};
    const auto& spell = match.data().spells[cast_plan.spell];
    const auto number = gestures != nullptr ? gestures->number(spell.stats.gesture) : std::nullopt;
    if (!number) return {};
    const auto& strokes = gestures->gestures()[*number].strokes;
    return strokes[cast_plan.stroke % strokes.size()];
}

double length_of(gesture::Points points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const vec3 step = points[i].at - points[i - 1].at;
        length += std::sqrt(step.x * step.x + step.y * step.y);
    }
    return length;
}

Wobble random_wobble(Random& random, double size) {
    return {.size = size * random.uniform(-1, 1),
            .waves = random.uniform(0.7, 2.5),
            .begins = random.uniform(0, 2 * pi)};
}

/// Deviation of the hand by a wave after a share of the stroke, 0 to 1 (m); 0 at the stroke's start.
double deviation(const Wobble& wobble, double share) {
    return wobble.size * (det::sin(2 * pi * wobble.waves * share + wobble.begins) - det::sin(wobble.begins));
}

/// Place of the hand after a share of the stroke's time, relative to its start (m).
vec2 place_at(gesture::Points points, const CastPlan& cast_plan, double share) {
    const double time = points.front().t + share * (points.back().t - points.front().t);
    std::size_t next = 1;
    while (next + 1 < points.size() && points[next].t < time) ++next;
    const auto &a = points[next - 1], &b = points[next];
    const double between = b.t > a.t ? std::clamp((time - a.t) / (b.t - a.t), 0.0, 1.0) : 1;
    const vec3 at = (a.at + between * (b.at - a.at) - points.front().at) * cast_plan.scale;
    const auto& style = cast_plan.style;
    const double x = style.aspect * at.x + style.slant * at.y, y = at.y;
    return {style.cos_tilt * x - style.sin_tilt * y + deviation(cast_plan.right, share),
            style.sin_tilt * x + style.cos_tilt * y + deviation(cast_plan.up, share)};
}

void begin_stroke(const BotTurn& turn, std::size_t spell, bool harsh) {
    const auto& match = turn.match;
    const auto& skill = turn.seat.skill.cast;
    auto& mind = turn.mind;
    auto& cast_plan = turn.cast_plan;
    cast_plan = {.style = cast_plan.style,
                 .began = turn.tick,
                 .no_thing_before = cast_plan.no_thing_before,
                 .spell = static_cast<std::uint32_t>(spell)};
    cast_plan.stroke = static_cast<std::uint32_t>(mind.random.below(64));
    cast_plan.scale = cast_plan.style.size * mind.random.uniform(0.9, 1.1);
    const auto points = template_of(match, turn.seat, cast_plan);
    if (points.size() < 2) return;
    const double length = length_of(points) * cast_plan.scale;
    const double force = harsh ? harsh_force : skill.force;
    constexpr double usual_size = 0.065;  // height of the recorded strokes (m)
    cast_plan.right = random_wobble(mind.random, skill.jitter * usual_size);
    cast_plan.up = random_wobble(mind.random, skill.jitter * usual_size);
    cast_plan.lasts =
        std::max<Tick>(1, ticks(match.data().casting->viscosity * length / std::max(0.1, force)));
    mind.buttons &= ~(bit(Button::fire) | bit(Button::throw_));
    mind.right_left = mind.up_left = 0;
}

/// Plans to catch the thing that a spell makes fly to the bot (LiftPlan).
void expect_thing(const BotTurn& turn) {
    constexpr Tick flight = ticks(2.0);
    const auto& match = turn.match;
    const auto wizard = wizard_of(match.world(), turn.seat.player);
    for (const auto& wand : match.data().wands) {
        if (!wand.rules->grasp()) continue;
        turn.cast_plan.no_thing_before = turn.tick + after_thing;
        turn.mind.wand = wand.stats.slot;
        turn.lift_plan = {.thing = match.world().get<LastProp>(wizard).thing,
                          .until = turn.tick + turn.cast_plan.lasts + flight,
                          .stage = LiftStage::take};
        return;
    }
}

}  // namespace

DrawingStyle random_drawing_style(Random& random) {
    const double tilt = random.uniform(-8, 8) * radians_per_degree;
    return {.size = random.uniform(0.85, 1.2),
            .aspect = random.uniform(0.85, 1.15),
            .slant = random.uniform(-0.12, 0.12),
            .cos_tilt = det::cos(tilt),
            .sin_tilt = det::sin(tilt)};
}

void plan_to_cast(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& skill = turn.seat.skill.cast;
    auto& mind = turn.mind;
    auto& cast_plan = turn.cast_plan;
    if (!(skill.share > 0) || match.data().spells.empty() || draws(cast_plan)) return;
    if (turn.tick < cast_plan.not_before) return;
    cast_plan.not_before = turn.tick + consider_again;
    const bool readying = turn.self.shot.held && (mind.buttons & bit(Button::fire)) != 0;
    if (readying) return;
    const bool harsh = mind.random.uniform() < skill.harsh;
    const double cost = harsh ? match.data().casting->harsh_cost : 1;
    const auto spell = best_spell(turn, occasion_of(turn), cost);
    if (spell == match.data().spells.size() || mind.random.uniform() >= skill.share) return;
    begin_stroke(turn, spell, harsh);
    if (draws(cast_plan) && match.data().spells[spell].rules->brings_thing()) expect_thing(turn);
}

void draw_stroke(const Simulation& match, const Seat& seat, Tick tick, CastPlan& cast_plan,
                 input::DeviceSample& sample) {
    constexpr double micrometres = 1e6;
    const Tick since = tick - std::min(tick, cast_plan.began);
    const auto points = template_of(match, seat, cast_plan);
    if (since >= cast_plan.lasts + 2 * pause || points.size() < 2) {
        cast_plan.lasts = 0;
        cast_plan.not_before = tick + after_spell;
        return;
    }
    sample.press(Button::trace);
    const double drawn = static_cast<double>(since) - static_cast<double>(pause);
    const double share = std::clamp(drawn / static_cast<double>(cast_plan.lasts), 0.0, 1.0);
    const vec2 at = place_at(points, cast_plan, share);
    const double per_metre = micrometres / match.data().haptic_rules.clutch_per_count *
                             input::DeviceSpec{}.look_rad_per_count / rad_per_count;
    const auto right = static_cast<std::int32_t>(std::lround(at.x * per_metre));
    const auto up = static_cast<std::int32_t>(std::lround(at.y * per_metre));
    sample.counts[hand::look_right] = right - cast_plan.given_right;
    sample.counts[hand::look_up] = up - cast_plan.given_up;
    cast_plan.given_right = right;
    cast_plan.given_up = up;
}

}  // namespace thaum::game::inline bots
