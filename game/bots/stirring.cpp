#include "game/bots/stirring.h"

#include <cmath>

#include "game/bots/brewing.h"
#include "game/stations/cauldron/ladle.h"
#include "game/stations/cauldron/potions.h"

namespace thaum::game::inline bots {
namespace {

namespace hand = input::hand;

constexpr double beside_rim = 0.75;  ///< distance from the rim at which a bot stands (m)
/// Share of the wand's energy below which stirring, which refills it, is worth the time
constexpr double needs_energy = 0.6;
constexpr double has_enough = 0.97;
constexpr double unnerved = 8;  ///< loss of health at the rim after which the bot stops stirring and fights
                                ///< back (HP)
constexpr double well = 50;     ///< health above which the bot goes for a potion (HP)
constexpr Tick brew_limit = ticks(40.0);
constexpr Tick between_strokes = ticks(0.2);
constexpr Tick way_limit = ticks(6.0);
constexpr Tick unseen = ticks(1.5);
constexpr Tick period = ticks(1.1);  ///< time in which a stirring hand draws one circle
/// Mouse counts per tick while the hand draws a circle. With this number the circle uses the whole reach of
/// the hand.
constexpr double counts = 2.6;

bool foe_stirs(const BotTurn& turn) {
    const auto& world = turn.match.world();
    const Tick seen_at = turn.mind.foe_seen_at;
    const bool seen = seen_at != 0 && turn.tick - seen_at < unseen;
    return seen && world.has<Ladle>(wizard_of(world, 1 - turn.seat.player));
}

/// Whether the bot has not seen the foe for a while.
bool is_alone(const BotTurn& turn) {
    const Tick seen_at = turn.mind.foe_seen_at;
    return seen_at == 0 || turn.tick - seen_at > unseen;
}

bool is_worth_it(const BotTurn& turn) {
    if (foe_stirs(turn)) return true;
    return is_alone(turn) && turn.self.energy_share < needs_energy;
}

vec3 place_at_rim(const BotTurn& turn, const Cauldron& cauldron) {
    const vec3 way = turn.self.centre - cauldron.middle;
    const double far = turn.match.data().arena.bowl->size.radius + beside_rim;
    return cauldron.middle + vec3(way.x, 0, way.z) * (far / std::max(1e-6, off_axis(way)));
}

void end_stirring(const BotTurn& turn) {
    turn.stir_plan = {.not_before = turn.tick + turn.seat.skill.stir.rest};
    if (turn.mind.errand == Errand::stir) turn.mind.errand = Errand::none;
}

bool carries(const BotTurn& turn) {
    const auto& world = turn.match.world();
    return world.has<Pouch>(wizard_of(world, turn.seat.player));
}

// ---- potions ----------------------------------------------------------------------------------------------

/// Whether the bot starts a potion now: no foe is in sight, its health is good, and nobody has begun a
/// brew.
bool begins_to_brew(const BotTurn& turn, const Cauldron& cauldron) {
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill.stir;
    auto& stir_plan = turn.stir_plan;
    auto& random = turn.mind.random;
    if (!(skill.brew > 0) || !is_alone(turn) || cauldron.begun != 0 || self.health < well) return false;
    if (off_axis(self.centre - cauldron.middle) > skill.seek || random.uniform() >= skill.brew) return false;
    stir_plan.recipe = choose_recipe(turn.match, turn.seat, random);
    if (stir_plan.recipe == no_potion) return false;
    stir_plan.stage = StirStage::fetch;
    stir_plan.until = turn.tick + brew_limit;
    stir_plan.health = self.health;
    return true;
}

/// Begins the next stroke of the recipe. The bot stands at the cauldron's rim.
void begin_drawing(const BotTurn& turn, const Cauldron& cauldron) {
    auto& stir_plan = turn.stir_plan;
    const Tick tick = turn.tick;
    stir_plan.stroke = cauldron.strokes_done;
    stir_plan.drawing_from = std::max<Tick>(tick, 1);
    stir_plan.drawing_until = tick + stroke_length(turn.match, turn.seat, stir_plan);
}

/// Goes on with the brewing of a potion, one gameplay tick.
void brew(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& seat = turn.seat;
    auto& mind = turn.mind;
    auto& stir_plan = turn.stir_plan;
    const Tick tick = turn.tick;
    const auto& cauldron = match.world().single<Cauldron>();
    if (stir_plan.drawing_from != 0 && tick < stir_plan.drawing_until) return;
    if (stir_plan.drawing_from != 0) stir_plan.hands_off_until = tick + between_strokes;
    stir_plan.drawing_from = 0;
    stir_plan.drops = 0;
    stir_plan.dropped = static_cast<std::uint32_t>(ingredients_in(cauldron)) > stir_plan.dropped
                            ? static_cast<std::uint32_t>(ingredients_in(cauldron))
                            : stir_plan.dropped;
    // The bot begins a potion with the ingredient that it has picked up.
    if (stir_plan.dropped == 0 && carries(turn)) {
        stir_plan.recipe = choose_recipe(match, seat, mind.random);
        if (stir_plan.recipe == no_potion) return end_stirring(turn);
    }
    const auto step = next_brew_step(turn);
    const bool badly_hurt = self.health < stir_plan.health - unnerved;
    if (step.task == BrewTask::done || tick >= stir_plan.until || badly_hurt) return end_stirring(turn);
    const bool there = within_reach(match.data(), cauldron, self.centre);
    if (step.task == BrewTask::fetch || !there) {
        stir_plan.stage = StirStage::fetch;
        mind.errand = Errand::stir;
        mind.goal = step.task == BrewTask::fetch ? step.place : place_at_rim(turn, cauldron);
        return;
    }
    stir_plan.stage = StirStage::stir;
    const bool holds_ladle = match.world().has<Ladle>(wizard_of(match.world(), seat.player));
    if (!holds_ladle || tick < stir_plan.hands_off_until) return;
    if (step.task == BrewTask::drop) {
        stir_plan.drops = 1;
        stir_plan.hands_off_until = tick + between_strokes;
    } else if (step.task == BrewTask::draw) {
        begin_drawing(turn, cauldron);
    }
}

/// Stirs until the bot has enough energy, was hurt too much, or has stirred for long. If the bot has picked
/// up an ingredient on its way, it drops it into the brew, so that its hands are free.
void stir_on(const BotTurn& turn) {
    auto& stir_plan = turn.stir_plan;
    const auto& self = turn.self;
    stir_plan.drops = carries(turn) && turn.tick / gameplay_period % 8 == 0 ? 1 : 0;
    const bool full = self.energy_share > has_enough && !foe_stirs(turn);
    if (turn.tick >= stir_plan.until || full || self.health < stir_plan.health - unnerved) end_stirring(turn);
}

}  // namespace

void plan_to_stir(const BotTurn& turn) {
    const auto& match = turn.match;
    const auto& self = turn.self;
    const auto& skill = turn.seat.skill.stir;
    auto& mind = turn.mind;
    auto& stir_plan = turn.stir_plan;
    const Tick tick = turn.tick;
    if (!(skill.share > 0) || !match.data().cauldron || match.world().count<Cauldron>() == 0) return;
    const auto& cauldron = match.world().single<Cauldron>();
    const bool wanted = is_worth_it(turn);
    if (stir_plan.recipe != no_potion) return brew(turn);
    switch (stir_plan.stage) {
        case StirStage::none:
            if (tick < stir_plan.not_before || mind.errand != Errand::none) return;
            if (!wanted && !(skill.brew > 0)) return;
            stir_plan.not_before = tick + ticks(0.5);
            if (begins_to_brew(turn, cauldron) || !wanted) return;
            if (off_axis(self.centre - cauldron.middle) > skill.seek || mind.random.uniform() >= skill.share)
                return;
            stir_plan.stage = StirStage::approach;
            stir_plan.until = tick + way_limit;
            [[fallthrough]];
        case StirStage::approach:
            if (tick >= stir_plan.until || !wanted) return end_stirring(turn);
            mind.errand = Errand::stir;
            mind.goal = place_at_rim(turn, cauldron);
            if (!within_reach(match.data(), cauldron, self.centre)) return;
            stir_plan.stage = StirStage::stir;
            stir_plan.until = tick + skill.hold;
            stir_plan.health = self.health;
            return;
        case StirStage::fetch: return;
        case StirStage::stir: return stir_on(turn);
    }
}

void stir_hand(Tick tick, input::DeviceSample& sample) {
    sample = {};
    const double angle = 2 * pi * static_cast<double>(tick % period) / static_cast<double>(period);
    sample.press(input::Button::stir);
    sample.counts[hand::look_right] = static_cast<std::int32_t>(std::lround(counts * det::cos(angle)));
    sample.counts[hand::look_up] = static_cast<std::int32_t>(std::lround(counts * det::sin(angle)));
}

void brew_hand(const Simulation& match, const Seat& seat, const StirPlan& stir_plan, Tick tick,
               input::DeviceSample& sample) {
    const bool draws = stir_plan.drawing_from != 0;
    const bool rests = tick < stir_plan.hands_off_until && stir_plan.stroke > 0;
    stir_hand(tick, sample);
    if (draws || rests) sample.counts = {};
    if (stir_plan.drops != 0) sample.press(input::Button::fire);
    if (draws) draw_hand(match, seat, stir_plan, tick, sample);
}

}  // namespace thaum::game::inline bots
